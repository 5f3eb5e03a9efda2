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
use embedded_raster::{pixel::Xrgb8888, Bitmap, Canvas, Framebuffer, Index4, PixelFormat, Rect, Surface};
use indicatif::ProgressBar;

use crate::{
    cost::{measured_work, Counter},
    frame::INK,
};

/// What must not be exceeded.
const LIMIT: f64 = 1.15;

/// Sides of the squares: 64 fits into the first cache, 1,024 into none.
const SIDES: [u16; 3] = [64, 320, 1024];

/// Runs of each, and the bytes that one of them writes at least.
const RUNS: usize = 101;
const RUN_BYTES: usize = 1 << 18;

/// The same work, done by this crate (`true`) or by the standard library.
type Work = Box<dyn FnMut(bool)>;

struct Case {
    name: &'static str,
    format: &'static str,
    side: u16,
    bytes: usize,
    /// Takes memory, so only for what is run.
    make: Box<dyn Fn() -> Work>,
}

impl Case {
    fn child(&self, own: bool) -> String {
        format!("plain/{}/{}/{}/{own}", self.name, self.format, self.side)
    }
}

/// Memory of a frame for each of the two.
fn memories<F: PixelFormat, P: Pod>(side: u16, len: usize) -> (Framebuffer<'static, F>, &'static mut [P]) {
    // Never given back: there are few of them, and a frame and its memory cannot be moved into one closure.
    let [own, plain] = [(); 2].map(|()| vec![P::zeroed(); len].leak());
    (Framebuffer::new(cast_slice_mut(own), side, side).expect("made for this size"), plain)
}

/// A picture, and its pixels.
fn picture<F: PixelFormat, P: Pod>((width, height): (u16, u16), pixels: Vec<P>) -> (Bitmap<'static, F>, &'static [P]) {
    let pixels: &[P] = pixels.leak();
    (Bitmap::new(cast_slice(pixels), width, height).expect("made for this size"), pixels)
}

/// All of one format, whose pixels, or bytes of them, are a `P`: in black, and in an ink.
fn cases<F, P: Pod>(format: &'static str, side: u16, [black, ink]: [(F::Color, P); 2]) -> Vec<Case>
where
    F: PixelFormat,
{
    let columns = move |x: u16| usize::from(x) * F::BITS as usize / 8 / size_of::<P>();
    let stride = columns(side);
    let len = stride * usize::from(side);
    // Within the frame: two pixels from its sides, a pixel below its top and above its bottom.
    let inner = Rect::new(2, 1, i32::from(side) - 2, i32::from(side) - 1);
    let (left, width, height) = (columns(2), columns(side - 4), side - 2);
    let rows_of = move |memory: &mut [P], draw: &mut dyn FnMut(&mut [P])| {
        let rows = black_box(memory).chunks_exact_mut(stride).skip(1).take(usize::from(height));
        rows.for_each(|row| draw(&mut row[left..left + width]));
    };
    let clear = move |(color, pixel): (F::Color, P)| -> Work {
        let (mut frame, memory) = memories::<F, P>(side, len);
        Box::new(move |own| {
            if own {
                black_box(&mut frame).clear(black_box(color));
            } else {
                black_box(&mut *memory).fill(black_box(pixel));
            }
        })
    };
    let rectangle = move |(color, pixel): (F::Color, P)| -> Work {
        let (mut frame, memory) = memories::<F, P>(side, len);
        Box::new(move |own| {
            if own {
                black_box(&mut frame).fill_area(black_box(inner), black_box(color));
            } else {
                let pixel = black_box(pixel);
                rows_of(memory, &mut |row| row.fill(pixel));
            }
        })
    };
    let blit = move || -> Work {
        let (mut frame, memory) = memories::<F, P>(side, len);
        let (picture, pixels) = picture::<F, P>((side, side), vec![ink.1; len]);
        Box::new(move |own| {
            if own {
                black_box(&mut frame).blit(black_box(Point::zero()), black_box(&picture));
            } else {
                black_box(&mut *memory).copy_from_slice(black_box(pixels));
            }
        })
    };
    let blit_rows = move || -> Work {
        let (mut frame, memory) = memories::<F, P>(side, len);
        let (picture, pixels) = picture::<F, P>((side - 4, height), vec![ink.1; width * usize::from(height)]);
        Box::new(move |own| {
            if own {
                black_box(&mut frame).blit(black_box(Point::new(2, 1)), black_box(&picture));
            } else {
                let mut sources = black_box(pixels).chunks_exact(width);
                rows_of(memory, &mut |row| row.copy_from_slice(sources.next().expect("as many rows")));
            }
        })
    };
    let case = |name, make| Case { name, format, side, bytes: len * size_of::<P>(), make };
    vec![
        case("clear, black", Box::new(move || clear(black))),
        case("clear", Box::new(move || clear(ink))),
        case("rectangle, black", Box::new(move || rectangle(black))),
        case("rectangle", Box::new(move || rectangle(ink))),
        case("blit", Box::new(blit)),
        case("blit, by rows", Box::new(blit_rows)),
    ]
}

fn all() -> Vec<Case> {
    let colors = |side| {
        let (b16, b24, b32) = (RawU16::new(INK).into(), Rgb888::new(1, 2, 3), Xrgb8888::new(1, 2, 3));
        let mut all = cases::<Index4, u8>("4 bits", side, [(Index4::new(0), 0), (Index4::new(6), 0x66)]);
        all.extend(cases::<Gray8, u8>("8 bits", side, [(Gray8::new(0), 0), (Gray8::new(77), 77)]));
        all.extend(cases::<Rgb565, u16>("16 bits", side, [(Rgb565::BLACK, 0), (b16, INK)]));
        all.extend(cases::<Rgb888, [u8; 3]>("24 bits", side, [(Rgb888::BLACK, [0; 3]), (b24, [3, 2, 1])]));
        all.extend(cases::<Xrgb8888, u32>("32 bits", side, [(Xrgb8888::BLACK, 0), (b32, 0x0001_0203)]));
        all
    };
    SIDES.into_iter().flat_map(colors).collect()
}

/// Does what callgrind is to count, if a case has this name.
pub(crate) fn child(name: &str) -> bool {
    for case in all() {
        for own in [true, false] {
            if case.child(own) == name {
                let mut work = (case.make)();
                // The first time costs more: pages are touched.
                work(own);
                measured_work(&mut || work(own));
                return true;
            }
        }
    }
    false
}

/// Nanoseconds of each, in turns: the best of many runs, as what disturbs a run only makes it longer.
fn nanoseconds(case: &Case) -> [f64; 2] {
    let mut work = (case.make)();
    let times = RUN_BYTES.div_ceil(case.bytes);
    let mut best = [f64::INFINITY; 2];
    for _ in 0..RUNS {
        for (own, best) in [true, false].into_iter().zip(&mut best) {
            let start = Instant::now();
            (0..times).for_each(|_| work(own));
            *best = best.min(start.elapsed().as_nanos() as f64 / times as f64);
        }
    }
    best
}

/// A table: time as many times that of the standard library, and instructions likewise.
pub(crate) fn report(counter: Option<&Counter>, quick: bool) -> Result<String> {
    let mut all = all();
    all.retain(|case| !quick || case.side == SIDES[0]);
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
    for case in &all {
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
