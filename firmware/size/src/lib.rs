//! What the minimal firmwares share: one static framebuffer, arguments that the optimiser cannot know, and a byte that is
//! read back so that nothing is optimised away. No formatting: that alone would be larger than any feature.
#![no_std]

use core::cell::UnsafeCell;
use core::hint::black_box;

use embedded_graphics::framebuffer::Framebuffer as EgFramebuffer;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::Point;
use embedded_raster::raster::flood::FloodSlot;
use embedded_raster::{
    buffer_bytes, pixel::Depth16, surface::DepthBuffer, Bitmap, EdgeSlot, Framebuffer, PixelFormat, PointFx, Rect, Vec4,
};

/// Columns of the screen.
pub const WIDTH: u16 = 320;
/// Rows of the screen.
pub const HEIGHT: u16 = 240;
/// Bytes of the static framebuffer, whatever the format: 153,600.
pub const BYTES: usize = buffer_bytes::<Rgb565>(WIDTH, HEIGHT);

/// Aligned to words, as a display's DMA would want it.
#[repr(align(4))]
struct Memory<T>(UnsafeCell<T>);

// SAFETY: these programs have one thread.
unsafe impl<T> Sync for Memory<T> {}

/// By its name the tool finds it, and takes it away from the RAM of the feature.
#[unsafe(no_mangle)]
static FRAMEBUFFER: Memory<[u8; BYTES]> = Memory(UnsafeCell::new([0; BYTES]));

/// The same for embedded-graphics, whose framebuffer owns its bytes. A program has one of the two.
#[unsafe(no_mangle)]
static EG_FRAMEBUFFER: Memory<EgFrame> = Memory(UnsafeCell::new(EgFrame::new()));

/// The framebuffer of embedded-graphics, as large as the one of this crate.
pub type EgFrame = EgFramebuffer<Rgb565, RawU16, LittleEndian, { WIDTH as usize }, { HEIGHT as usize }, BYTES>;

/// Lets a function draw on the bytes of the framebuffer, once. A program calls this in one place only.
#[inline]
pub fn on_memory(draw: impl Fn(&mut [u8; BYTES])) {
    let mut draw = || {
        // SAFETY: the only reference, in the only place.
        let memory = unsafe { &mut *FRAMEBUFFER.0.get() };
        draw(memory);
        black_box(memory[0]);
    };
    run(&mut draw);
}

/// Lets a function draw on the framebuffer in format `F`, once.
#[inline]
pub fn on_frame<F: PixelFormat>(draw: impl Fn(&mut Framebuffer<'_, F>)) {
    on_memory(|memory| {
        if let Ok(mut frame) = Framebuffer::new(memory, WIDTH, HEIGHT) {
            draw(&mut frame);
        }
    });
}

/// Lets a function draw on the upper half of the framebuffer in format `F`, once, with the lower half as its depth buffer.
#[inline]
pub fn on_depth<F: PixelFormat>(draw: impl Fn(&mut Framebuffer<'_, F>, &mut DepthBuffer<'_, Depth16>)) {
    on_memory(|memory| {
        let (colors, depths) = memory.split_at_mut(BYTES / 2);
        let (frame, depths) =
            (Framebuffer::new(colors, WIDTH, HEIGHT / 2), DepthBuffer::new(depths, WIDTH, HEIGHT / 2));
        if let (Ok(mut frame), Ok(mut depths)) = (frame, depths) {
            draw(&mut frame, &mut depths);
        }
    });
}

/// Lets a function draw on the framebuffer in format `F`, once, with scratch memory for polygons and for floods.
#[inline]
pub fn on_frame_and_tables<F: PixelFormat>(draw: impl Fn(&mut Framebuffer<'_, F>, &mut [EdgeSlot], &mut [FloodSlot])) {
    static TABLES: Memory<([EdgeSlot; 64], [FloodSlot; 16])> =
        Memory(UnsafeCell::new(([EdgeSlot::EMPTY; 64], [FloodSlot::EMPTY; 16])));
    on_frame::<F>(|frame| {
        // SAFETY: the only reference, in the only place.
        let (table, slots) = unsafe { &mut *TABLES.0.get() };
        draw(frame, table, slots);
    });
}

/// Lets a function draw on the framebuffer of embedded-graphics, once.
#[inline]
pub fn on_eg(draw: impl Fn(&mut EgFrame)) {
    run(&mut || {
        // SAFETY: the only reference, in the only place.
        let frame = unsafe { &mut *EG_FRAMEBUFFER.0.get() };
        draw(frame);
        black_box(frame.data()[0]);
    });
}

#[cfg(not(feature = "stack"))]
fn run(work: &mut dyn FnMut()) {
    work();
}

#[cfg(feature = "stack")]
fn run(work: &mut dyn FnMut()) {
    board::println!("{}", board::stack::depth(work));
}

/// A colour that is not known when the program is compiled.
#[inline]
pub fn color<F: PixelFormat>() -> F::Color {
    F::unpack(black_box(9))
}

/// Lets a function draw a picture of 16 x 16 pixels on the framebuffer, at a place that is not known either.
#[inline]
pub fn on_picture(draw: impl Fn(&mut Framebuffer<'_, Rgb565>, Point, &Bitmap<'_, Rgb565>)) {
    static PICTURE: [u8; 2 * 16 * 16] = [7; 2 * 16 * 16];
    on_frame::<Rgb565>(|frame| {
        let Ok(picture) = Bitmap::new(black_box(&PICTURE), 16, 16) else { return };
        let [at, _] = points();
        draw(frame, at, &picture);
    });
}

/// Two pixels, not known either.
#[inline]
pub fn points() -> [Point; 2] {
    black_box([Point::new(-5, 7), Point::new(300, 200)])
}

/// Three places, not known either.
#[inline]
pub fn corners() -> [PointFx; 3] {
    black_box([PointFx::from_bits(1_000, 2_000), PointFx::from_bits(80_000, 9_000), PointFx::from_bits(-3_000, 60_000)])
}

/// Three places in clip coordinates, not known either: the near plane cuts their triangle.
#[inline]
pub fn places() -> [Vec4; 3] {
    black_box([Vec4::whole(-2, -1, 1, 3), Vec4::whole(3, 0, 2, 4), Vec4::whole(0, 2, -1, 1)])
}

/// Three colours, not known either.
#[inline]
pub fn colors() -> [Rgb565; 3] {
    black_box([Rgb565::new(31, 5, 0), Rgb565::new(0, 63, 7), Rgb565::new(9, 0, 30)])
}

/// Three times three numbers, not known either.
#[inline]
pub fn values() -> [[u16; 3]; 3] {
    black_box([[7, 60_000, 900], [40_000, 3, 1_000], [20_000, 30_000, 65_535]])
}

/// A box, not known either.
#[inline]
pub fn area() -> Rect {
    black_box(Rect::new(-5, 7, 96, 108))
}
