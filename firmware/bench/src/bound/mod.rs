//! Lower bounds: hand-written loops without any clipping, for a frame of exactly this size.
//!
//! They are not an engine that anybody would use; they say how close to the chip the others are.
//! Colours and places come from the same data, so their frames must have the same checksums.

use core::arch::global_asm;

use crate::engine::Engine;
use crate::scene::{Format, Ink, Rect, HEIGHT, WIDTH};

#[cfg(target_feature = "dsp")]
global_asm!(include_str!("armv7em.s"), options(raw));
#[cfg(all(target_arch = "arm", not(target_feature = "dsp")))]
global_asm!(include_str!("armv6m.s"), options(raw));
#[cfg(target_arch = "riscv32")]
global_asm!(include_str!("riscv.s"), options(raw));

extern "C" {
    fn bound_fill(first: *mut u32, end: *mut u32, value: u32);
    fn bound_rect(first: *mut u16, value: u32, width: u32, rows: u32, stride: usize);
    fn bound_column(first: *mut u16, value: u32, rows: u32);
}

/// A frame in whole words, as long as the largest format needs.
pub struct Frame {
    words: [u32; Format::Rgb565.frame_bytes() / 4],
    used: usize,
}

impl Frame {
    /// A black frame for this format.
    pub const fn new(format: Format) -> Self {
        Self { words: [0; Format::Rgb565.frame_bytes() / 4], used: format.frame_bytes() / 4 }
    }

    fn blacken(&mut self) {
        self.words.fill(0);
    }

    fn bytes(&self) -> &[u8] {
        let words = &self.words[..self.used];
        // SAFETY: the same memory as bytes, which have no alignment and no invalid values.
        unsafe { core::slice::from_raw_parts(words.as_ptr().cast(), words.len() * 4) }
    }

    /// The address of a rectangle's first pixel, at 16 bits.
    fn pixel(&mut self, rect: &Rect) -> *mut u16 {
        let at = rect.area.top_left;
        let index = at.y as usize * WIDTH + at.x as usize;
        debug_assert!(index < WIDTH * HEIGHT, "workloads lie inside the frame");
        self.words.as_mut_ptr().cast::<u16>().wrapping_add(index)
    }
}

/// What has a lower bound in this format.
pub const fn engine(format: Format) -> Engine<Frame> {
    let mut engine = Engine::new("bound", format, Frame::blacken, Frame::bytes);
    match format {
        Format::Rgb565 => {
            engine.clear = Some(|frame, ink| fill(frame, u32::from(ink.0) * 0x1_0001));
            engine.rects = Some(rects);
            engine.rows = Some(rects);
            engine.columns = Some(columns);
        }
        Format::Gray8 => {
            engine.clear = Some(|frame, ink| fill(frame, u32::from(ink.0 & 255) * 0x0101_0101));
        }
        Format::Gray4 => {
            engine.clear = Some(|frame, ink| fill(frame, u32::from(ink.0 & 15) * 0x1111_1111));
        }
        Format::Binary => {
            engine.clear = Some(|frame, ink| fill(frame, u32::from(ink.0 & 1) * 0xFFFF_FFFF));
        }
    }
    engine
}

fn fill(frame: &mut Frame, value: u32) {
    let words = frame.words[..frame.used].as_mut_ptr_range();
    // SAFETY: the frame's own words; every format has a multiple of 96 of them.
    unsafe { bound_fill(words.start, words.end, value) };
}

fn rects(frame: &mut Frame, rects: &[Rect]) {
    for rect in rects {
        let size = rect.area.size;
        let value = doubled(rect.ink);
        // SAFETY: workloads lie inside the frame.
        unsafe { bound_rect(frame.pixel(rect), value, size.width, size.height, WIDTH * 2) };
    }
}

fn columns(frame: &mut Frame, columns: &[Rect]) {
    for column in columns {
        // SAFETY: workloads lie inside the frame, and columns are 150 pixels high.
        unsafe { bound_column(frame.pixel(column), doubled(column.ink), column.area.size.height) };
    }
}

/// Two pixels at once.
fn doubled(ink: Ink) -> u32 {
    u32::from(ink.0) * 0x1_0001
}
