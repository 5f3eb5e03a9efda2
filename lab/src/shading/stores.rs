//! Shaded triangles beside loops that store as many pixels one by one: how many times their time they take. One loop knows the rows;
//! the other one finds them, going down the sides of each triangle by additions, as anybody has to who draws it.
//!
//! `cargo run --release -p lab --features peers-3d -- --stores` prints it.

use std::{
    fmt::Write,
    hint::black_box,
    sync::atomic::{AtomicU16, Ordering},
    time::Instant,
};

use textbook::fixed;
use twins::Run;

use super::{
    depth16,
    engine::{PIXELS, SIZE},
    gouraud, Shaded,
};
use crate::{
    bench::Family,
    cost::measured,
    frame::{INK, WIDTH},
    judge::Judge,
};

/// Runs of each, and how many pixels one of them has at least.
const RUNS: usize = 101;
const RUN_PIXELS: usize = 100_000;

/// What this crate should not exceed: with one large triangle, and with a mesh and depths.
const LIMITS: [f64; 2] = [5.0, 2.5];

/// One store of 16 bits for each pixel. Atomic stores are plain ones to a processor, but a compiler does not put several into one.
struct Stores {
    rows: Vec<Run>,
    frame: Vec<AtomicU16>,
}

impl Stores {
    fn new(shapes: &[Shaded]) -> Self {
        let rows = shapes.iter().flat_map(Judge::truth).collect();
        Self { rows, frame: (0..PIXELS).map(|_| AtomicU16::new(0)).collect() }
    }

    #[inline(always)]
    fn row(&self, start: usize, len: usize, ink: u16) {
        self.frame[start..start + len].iter().for_each(|pixel| pixel.store(ink, Ordering::Relaxed));
    }

    /// The rows are known.
    #[inline(never)]
    fn draw_rows(&self, ink: u16) {
        self.rows.iter().for_each(|&(y, x0, x1)| self.row((y * WIDTH + x0) as usize, (x1 - x0) as usize, ink));
    }

    /// They are found.
    #[inline(never)]
    fn draw_triangles(&self, shapes: &[Shaded], ink: u16) {
        for Shaded { corners, .. } in shapes {
            fixed::rows::<16, 0>(corners.map(|corner| corner.at), [[]; 3], SIZE, |s| self.row(s.start, s.len, ink));
        }
    }
}

/// The best times of both loops of stores, and of each engine, in nanoseconds for all shapes. All take turns.
fn nanoseconds(family: &mut Family<Shaded>, workload: usize, runs: usize) -> ([f64; 2], Vec<f64>, usize) {
    let shapes = family.workloads[workload].measured();
    let stores = Stores::new(shapes);
    let pixels: usize = shapes.iter().map(|shape| Shaded::pixels(&shape.truth())).sum();
    let times = RUN_PIXELS.div_ceil(pixels);
    let time = |work: &mut dyn FnMut()| {
        let start = Instant::now();
        (0..times).for_each(|_| work());
        start.elapsed().as_nanos() as f64 / times as f64
    };
    let mut best = ([f64::INFINITY; 2], vec![f64::INFINITY; family.entries.len()]);
    for _ in 0..runs {
        best.0[0] = best.0[0].min(time(&mut || stores.draw_rows(black_box(INK))));
        best.0[1] = best.0[1].min(time(&mut || stores.draw_triangles(black_box(shapes), black_box(INK))));
        for (entry, best) in family.entries.iter_mut().zip(&mut best.1) {
            *best = best.min(time(&mut || measured(entry.engine.as_mut(), black_box(shapes))));
        }
    }
    (best.0, best.1, pixels)
}

/// The tables.
pub(crate) fn report(quick: bool) -> String {
    let runs = if quick { 5 } else { RUNS };
    let mut text = String::from(
        "Times that of a loop that stores each pixel: of one that is given the rows, and of one that goes down the sides.\n",
    );
    for ((mut family, workload), limit) in [(gouraud(true), 0), (depth16(true), 1)].into_iter().zip(LIMITS) {
        let name = family.workloads[workload].name;
        let (loops, best, pixels) = nanoseconds(&mut family, workload, runs);
        let each = |time: f64| time / pixels as f64;
        // Writing to a string cannot fail.
        let _ = write!(
            text,
            "\n{}, {name}: {pixels} pixels; the loops take {:.3} and {:.3} ns for each. This crate should take at most {limit} \
             times the first.\n\n| way | given rows | with sides | ns a pixel |\n|---|---:|---:|---:|\n",
            family.title,
            each(loops[0]),
            each(loops[1]),
        );
        for (entry, time) in family.entries.iter().zip(best) {
            let [rows, sides] = loops.map(|stores| time / stores);
            let _ = writeln!(text, "| {} | {rows:.2} | {sides:.2} | {:.3} |", entry.name, each(time));
        }
    }
    text
}
