//! What the programs share: the cube, drawn on static memory at all moments.
#![no_std]

use core::cell::UnsafeCell;
use core::hint::black_box;

use scene::{draw_cube, MOMENTS};

/// Colours and depths of a band.
pub struct Memory<const BYTES: usize>(UnsafeCell<Buffers<BYTES>>);

/// Aligned to words, as a display's DMA would want it.
#[repr(align(4))]
struct Buffers<const BYTES: usize> {
    colors: [u8; BYTES],
    depths: [u8; BYTES],
}

// SAFETY: these programs have one thread.
unsafe impl<const BYTES: usize> Sync for Memory<BYTES> {}

impl<const BYTES: usize> Memory<BYTES> {
    /// For a static.
    #[expect(clippy::new_without_default, reason = "there is one in each program")]
    pub const fn new() -> Self {
        Self(UnsafeCell::new(Buffers { colors: [0; BYTES], depths: [0; BYTES] }))
    }
}

/// Draws the cube at all moments in bands of `rows` rows: cycles, instructions, stack and checksum of each, one line each. A program
/// calls this once.
pub fn run<const BYTES: usize>(memory: &'static Memory<BYTES>, rows: u16) {
    // SAFETY: the only reference.
    let Buffers { colors, depths } = unsafe { &mut *memory.0.get() };
    for moment in 0..MOMENTS {
        measure(moment, |send| {
            if draw_cube(black_box(moment), rows, colors, depths, |band| send(band)).is_err() {
                board::exit(1);
            }
        });
    }
}

#[cfg(not(feature = "print"))]
fn measure(_: u16, mut draw: impl FnMut(fn(&[u8]))) {
    draw(|band| _ = black_box(band));
}

#[cfg(feature = "print")]
fn measure(moment: u16, mut draw: impl FnMut(&mut dyn FnMut(&[u8]))) {
    use board::counter::{count, Count};

    let mut crc32 = 0;
    draw(&mut |band| crc32 = board::crc32_with(crc32, band));
    let mut work = || draw(&mut |band| _ = black_box(band));
    let Count { cycles, instructions } = count(&mut work);
    let stack = board::stack::depth(&mut work);
    board::println!("cube-{moment};rgb565;{cycles};{instructions};{stack};{crc32:08x}");
}
