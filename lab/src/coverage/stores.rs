//! Soft rims beside a loop that stores a byte for each pixel that is touched, row by row: how many times its time they take.

use std::{
    hint::black_box,
    sync::atomic::{AtomicU8, Ordering},
    time::Instant,
};

use super::{coverage, engine::PIXELS, shape::Soft, truth::Areas};
use crate::{cost::measured, frame::WIDTH, report::table};

/// Runs of each, and how many pixels one of them has at least.
const RUNS: usize = 61;
const RUN_PIXELS: usize = 40_000;

/// What this crate should take at most, of the workloads of these names.
const LIMITS: [(&str, f64); 3] = [("20,000 px", 2.5), ("lines", 1.3), ("circles", 5.0)];

/// Rows of pixels that are touched: where they start in the frame, and how many there are.
fn rows(shape: &Soft) -> Vec<(usize, usize)> {
    let Areas { x0, y0, width, areas } = Areas::of(shape);
    let mut rows = Vec::new();
    for (y, row) in (y0..).zip(areas.chunks(width.max(1) as usize)) {
        let mut x = 0;
        while x < row.len() {
            let len = row[x..].iter().take_while(|&&area| area > 1e-9).count();
            if len > 0 {
                rows.push(((y * WIDTH + x0) as usize + x, len));
            }
            x += len.max(1);
        }
    }
    rows
}

/// Of a row of a table: a name, and its cells.
pub(crate) type Row = (&'static str, Vec<String>);

/// A table of all engines and workloads: multiples of the time of the loop.
pub(crate) fn report(quick: bool) -> String {
    let runs = if quick { 3 } else { RUNS };
    let mut family = coverage(true);
    let names: Vec<_> = family.workloads.iter().map(|workload| workload.name).collect();
    let frame: Vec<AtomicU8> = (0..PIXELS).map(|_| AtomicU8::new(0)).collect();
    let mut table_rows: Vec<Row> = family.entries.iter().map(|entry| (entry.name, Vec::new())).collect();
    let mut limits = Vec::new();
    for workload in &family.workloads {
        let shapes = workload.measured();
        let rows: Vec<_> = shapes.iter().flat_map(rows).collect();
        let pixels: usize = rows.iter().map(|row| row.1).sum();
        let times = RUN_PIXELS.div_ceil(pixels.max(1));
        let time = |work: &mut dyn FnMut()| {
            let start = Instant::now();
            (0..times).for_each(|_| work());
            start.elapsed().as_nanos() as f64
        };
        // Atomic stores are plain ones to a processor, but a compiler does not put several into one.
        let mut store = || {
            let level = black_box(200);
            for &(start, len) in black_box(&rows) {
                frame[start..start + len].iter().for_each(|pixel| pixel.store(level, Ordering::Relaxed));
            }
        };
        let mut best = (f64::INFINITY, vec![f64::INFINITY; family.entries.len()]);
        for _ in 0..runs {
            best.0 = best.0.min(time(&mut store));
            for (entry, best) in family.entries.iter_mut().zip(&mut best.1).filter(|(e, _)| e.can(workload)) {
                *best = best.min(time(&mut || measured(entry.engine.as_mut(), black_box(shapes))));
            }
        }
        for (row, time) in table_rows.iter_mut().zip(best.1) {
            row.1.push(if time.is_finite() { format!("{:.2}", time / best.0) } else { "-".into() });
        }
        let limit = LIMITS.iter().find(|limit| limit.0 == workload.name);
        limits.push(limit.map_or("-".into(), |limit| limit.1.to_string()));
    }
    table_rows.push(("asked of this crate", limits));
    table("Times a loop of stores", &names, &table_rows)
}
