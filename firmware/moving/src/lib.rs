//! What the programs share: static memory, and frames that are drawn one after the other, each of them once.
#![no_std]

use core::cell::UnsafeCell;
use core::hint::black_box;

use scene::moving::{Moving, FRAMES};
use scene::wire::Wire;

/// Bytes for the one who asks first: aligned to words, as a display's DMA would want them.
#[repr(align(4))]
pub struct Memory<const BYTES: usize>(UnsafeCell<[u8; BYTES]>);

// SAFETY: these programs have one thread.
unsafe impl<const BYTES: usize> Sync for Memory<BYTES> {}

impl<const BYTES: usize> Memory<BYTES> {
    /// For a static.
    #[expect(clippy::new_without_default, reason = "there are some in each program")]
    pub const fn new() -> Self {
        Self(UnsafeCell::new([0; BYTES]))
    }

    /// The bytes. A program calls this once.
    #[expect(clippy::mut_from_ref, reason = "it is called once")]
    pub fn bytes(&'static self) -> &'static mut [u8; BYTES] {
        // SAFETY: the only reference.
        unsafe { &mut *self.0.get() }
    }
}

/// Draws and sends all frames, one after the other: modelled cycles of each, and the checksums of what is shown and of what was sent, two
/// lines each.
pub fn run(name: &str, mut scene: impl Moving) {
    for frame in 0..FRAMES {
        measure(name, frame, &mut scene);
    }
}

/// Draws and sends a frame. Nobody looks at the bytes on the wire, which take no time so.
fn go(scene: &mut impl Moving) {
    let wire = Wire::new(|sum, bytes| {
        black_box(bytes);
        sum
    });
    if scene.draw().and_then(|()| scene.send(&mut wire.spi())).is_err() {
        board::exit(1);
    }
}

#[cfg(not(feature = "print"))]
fn measure(_: &str, _: u32, scene: &mut impl Moving) {
    go(scene);
}

#[cfg(feature = "print")]
fn measure(name: &str, frame: u32, scene: &mut impl Moving) {
    let format = scene.format();
    // The next frame is another one, so each is drawn once: nothing is repeated to count instructions.
    let mut cycles = None;
    let stack = board::stack::depth(&mut || cycles = Some(board::counter::cycles(&mut || go(scene))));
    let mut crc32 = 0;
    scene.whole(|row| crc32 = board::crc32_with(crc32, row));
    let wire = Wire::new(board::crc32_with);
    if scene.send(&mut wire.spi()).is_err() {
        board::exit(1);
    }
    if let Some(cycles) = cycles {
        board::println!("{name}-{frame};{format};{cycles};0.0;{stack};{crc32:08x}");
        board::println!("{name}-wire-{frame};{format};-;0.0;0;{:08x}", wire.sum());
    }
}
