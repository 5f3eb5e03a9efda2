//! Fills and copies beside those of the standard library, which are `memset`, `memcpy` and loops of vectors: how many times
//! their time and their instructions this crate takes.
//!
//! `cargo run --release -p lab -- --plain` prints it.

use std::{fmt::Write, hint::black_box, time::Instant};

use anyhow::{Context, Result};
use bytemuck::{cast_slice, cast_slice_mut, Pod};
use embedded_graphics::{
    geometry::Point,
    pixelcolor::{raw::RawU16, Gray8, Rgb565, Rgb888},
    prelude::*,
};
use embedded_raster::{Bitmap, Canvas, Framebuffer, Index4, PixelFormat, Rect, Surface};
use indicatif::ProgressBar;

use crate::cost::{measured_work, Counter};

/// What must not be exceeded.
const LIMIT: f64 = 1.15;

/// Sides of the squares: 64 fits into the first cache, 1,024 into none.
const SIDES: [u16; 3] = [64, 320, 1024];

/// Runs of each, and the bytes that one of them writes at least.
const RUNS: usize = 101;
const RUN_BYTES: usize = 1 << 18;

/// The same work, done by this crate or by the standard library.
type Work = Box<dyn FnMut(bool)>;

struct Case {
    name: &'static str,
    format: &'static str,
    side: u16,
    bytes: usize,
    work: Work,
}

impl Case {
    fn child(&self, own: bool) -> String {
        format!("plain/{}/{}/{}/{own}", self.name, self.format, self.side)
    }
}

/// All of one format, whose pixels, or bytes of them, are a `P`: in black, and in an ink.
fn cases<F: PixelFormat, P: Pod>(format: &'static str, side: u16, [black, ink]: [(F::Color, P); 2]) -> Vec<Case> {
    let per_pixel = f64::from(F::BITS) / 8.0 / size_of::<P>() as f64;
    let columns = |x: u16| (f64::from(x) * per_pixel) as usize;
    let stride = columns(side);
    let len = stride * usize::from(side);
    // Within the frame: two pixels from its sides, a pixel below its top and above its bottom.
    let inner = Rect::new(2, 1, i32::from(side) - 2, i32::from(side) - 1);
    let (left, width, height) = (columns(2), columns(side - 4), side - 2);
    let case = |name, work| Case { name, format, side, bytes: len * size_of::<P>(), work };
    let frame = move |memory: &mut Vec<P>, draw: &dyn Fn(&mut Framebuffer<F>)| {
        let bytes = cast_slice_mut(black_box(memory.as_mut_slice()));
        draw(&mut Framebuffer::new(bytes, side, side).expect("made for this size"));
    };
    let clear = |(color, pixel): (F::Color, P)| -> Work {
        let mut memory = vec![P::zeroed(); len];
        Box::new(move |own| {
            if own {
                frame(&mut memory, &|frame| frame.clear(black_box(color)));
            } else {
                black_box(memory.as_mut_slice()).fill(black_box(pixel));
            }
        })
    };
    let rectangle = |(color, pixel): (F::Color, P)| -> Work {
        let mut memory = vec![P::zeroed(); len];
        Box::new(move |own| {
            if own {
                frame(&mut memory, &|frame| frame.fill_area(black_box(inner), black_box(color)));
                return;
            }
            let pixel = black_box(pixel);
            let rows = black_box(memory.as_mut_slice()).chunks_exact_mut(stride);
            rows.skip(1).take(usize::from(height)).for_each(|row| row[left..left + width].fill(pixel));
        })
    };
    let blit: Work = {
        let (mut memory, picture) = (vec![P::zeroed(); len], vec![ink.1; len]);
        Box::new(move |own| {
            let picture = black_box(picture.as_slice());
            if own {
                let picture = Bitmap::<F>::new(cast_slice(picture), side, side).expect("made for this size");
                frame(&mut memory, &|frame| frame.blit(black_box(Point::zero()), &picture));
            } else {
                black_box(memory.as_mut_slice()).copy_from_slice(picture);
            }
        })
    };
    let blit_rows: Work = {
        let (mut memory, picture) = (vec![P::zeroed(); len], vec![ink.1; width * usize::from(height)]);
        Box::new(move |own| {
            let picture = black_box(picture.as_slice());
            if own {
                let picture = Bitmap::<F>::new(cast_slice(picture), side - 4, height).expect("made for this size");
                frame(&mut memory, &|frame| frame.blit(black_box(Point::new(2, 1)), &picture));
                return;
            }
            let rows = black_box(memory.as_mut_slice()).chunks_exact_mut(stride).skip(1);
            for (row, source) in rows.zip(picture.chunks_exact(width)) {
                row[left..left + width].copy_from_slice(source);
            }
        })
    };
    vec![
        case("clear, black", clear(black)),
        case("clear", clear(ink)),
        case("rectangle, black", rectangle(black)),
        case("rectangle", rectangle(ink)),
        case("blit", blit),
        case("blit, by rows", blit_rows),
    ]
}

fn all() -> Vec<Case> {
    let colors = |side| {
        let (b16, b24) = (RawU16::new(crate::frame::INK), Rgb888::new(1, 2, 3));
        let mut all = cases::<Index4, u8>("4 bits", side, [(Index4::new(0), 0), (Index4::new(6), 0x66)]);
        all.extend(cases::<Gray8, u8>("8 bits", side, [(Gray8::new(0), 0), (Gray8::new(77), 77)]));
        all.extend(cases::<Rgb565, u16>("16 bits", side, [(Rgb565::BLACK, 0), (b16.into(), crate::frame::INK)]));
        all.extend(cases::<Rgb888, [u8; 3]>("24 bits", side, [(Rgb888::BLACK, [0; 3]), (b24, [3, 2, 1])]));
        all.extend(cases::<embedded_raster::pixel::Xrgb8888, u32>(
            "32 bits",
            side,
            [
                (embedded_raster::pixel::Xrgb8888::BLACK, 0),
                (embedded_raster::pixel::Xrgb8888::new(1, 2, 3), 0x0001_0203),
            ],
        ));
        all
    };
    SIDES.into_iter().flat_map(colors).collect()
}

/// Does what callgrind is to count, if a case has this name.
pub(crate) fn child(name: &str) -> bool {
    for mut case in all() {
        for own in [true, false] {
            if case.child(own) == name {
                // The first time costs more: pages are touched.
                (case.work)(own);
                measured_work(&mut || (case.work)(own));
                return true;
            }
        }
    }
    false
}

/// Nanoseconds of each, in turns: the best of many runs, as what disturbs a run only makes it longer.
fn nanoseconds(case: &mut Case) -> [f64; 2] {
    let times = RUN_BYTES.div_ceil(case.bytes);
    let mut best = [f64::INFINITY; 2];
    for _ in 0..RUNS {
        for (own, best) in [true, false].into_iter().zip(&mut best) {
            let start = Instant::now();
            (0..times).for_each(|_| (case.work)(own));
            *best = best.min(start.elapsed().as_nanos() as f64 / times as f64);
        }
    }
    best
}

/// A table: time as many times that of the standard library, and instructions likewise.
pub(crate) fn report(counter: Option<&Counter>) -> Result<String> {
    let mut all = all();
    let children: Vec<_> = all.iter().flat_map(|case| [true, false].map(|own| case.child(own))).collect();
    let bar = ProgressBar::new(children.len() as u64);
    let counts = counter.map(|counter| counter.count(&children, &bar)).transpose()?.unwrap_or_default();
    let mut text =
        String::from("Times that of `slice::fill` and `copy_from_slice` (instructions):\n\n| side, format |");
    let names: Vec<_> = all.iter().take(6).map(|case| case.name).collect();
    for name in &names {
        let _ = write!(text, " {name} |");
    }
    let _ = write!(text, "\n|---|{}", "---:|".repeat(names.len()));
    let mut worst = (0.0, String::new());
    for case in &mut all {
        if case.name == names[0] {
            let _ = write!(text, "\n| {}, {} |", case.side, case.format);
        }
        let [own, plain] = nanoseconds(case);
        let ratio = own / plain;
        if ratio > worst.0 {
            worst = (ratio, case.child(true));
        }
        let counted = [true, false].map(|own| counts.get(&case.child(own)));
        let instructions = match counted {
            [Some(&own), Some(&plain)] => format!(" ({:.2})", own as f64 / plain as f64),
            _ => String::new(),
        };
        let _ = write!(text, " {ratio:.2}{instructions} |");
    }
    let (ratio, name) = worst;
    let name = name.strip_prefix("plain/").and_then(|name| name.strip_suffix("/true")).context("some case")?;
    let _ = write!(text, "\n\nThe most: {ratio:.2} x, {name}. The limit is {LIMIT} x.");
    Ok(text)
}
