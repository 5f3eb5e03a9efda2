//! What tests, lab and fuzz targets share: naive twins of everything clever, random numbers and shapes, and surfaces that
//! notice mistakes.
//!
//! A twin follows the rule of the documentation word for word, pixel by pixel, in integers so wide that nothing can
//! overflow. It shares no arithmetic with the crate: where both agree, both are right, or wrong in the same way twice.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    reason = "tests mix widths on purpose; the wide side is checked where it matters"
)]
#![allow(
    clippy::missing_errors_doc,
    clippy::missing_panics_doc,
    clippy::return_self_not_must_use,
    reason = "a panic is how a test fails"
)]

pub mod arcs;
pub mod arguments;
pub mod clipping;
pub mod coverage;
pub mod curves;
pub mod drop_outs;
pub mod frame;
pub mod gradients;
pub mod hits;
pub mod input;
pub mod letters;
pub mod lines;
pub mod memory;
pub mod meshes;
pub mod offsets;
pub mod outlines;
pub mod packed;
pub mod pictures;
pub mod planes;
pub mod relay;
pub mod rng;
pub mod rounds;
pub mod scenes;
pub mod sequences;
mod shapes;
pub mod strokes;
pub mod svgs;
pub mod targets;
pub mod texts;
pub mod textures;
pub mod tools;
pub mod watched;

use embedded_raster::{ClippedSpan, PointFx, Rect};
pub use shapes::*;

/// Whether tests take every layout, as with the feature of this name. Else they take some of each kind: all calls on all layouts
/// take minutes to compile.
pub const ALL_LAYOUTS: bool = cfg!(feature = "all-layouts");

/// A place in 24.8 units: what a [`PointFx`] is made of.
pub type Units = (i32, i32);

/// A place in numbers so wide that nothing overflows.
pub type Place = (i128, i128);

/// A span as numbers: row, first pixel, the pixel after the last.
pub type Run = (i32, i32, i32);

/// The same place in wide numbers.
pub fn wide(p: Units) -> Place {
    (p.0.into(), p.1.into())
}

/// Vertices of places in 24.8 units.
pub fn vertices(units: &[Units]) -> Vec<PointFx> {
    units.iter().map(|&(x, y)| PointFx::from_bits(x, y)).collect()
}

/// Three vertices.
pub fn corners(units: [Units; 3]) -> [PointFx; 3] {
    units.map(|(x, y)| PointFx::from_bits(x, y))
}

/// What a filler emits, checked on the way: inside the window, not empty, top row first, left to right, no overlap. Spans
/// that touch become one, so that two lists are equal exactly when they cover the same pixels.
pub fn collect(window: Rect, fill: impl FnOnce(&mut dyn FnMut(ClippedSpan))) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    fill(&mut |span| {
        let (y, x0, x1) = (span.y(), span.x0(), span.x1());
        assert!(x0 < x1, "empty span {span:?}");
        assert!(window.contains(x0, y) && window.contains(x1 - 1, y), "{span:?} leaves {window:?}");
        match runs.last_mut() {
            Some(last) if last.0 == y => {
                assert!(last.2 <= x0, "{span:?} after {last:?}: not from left to right");
                if last.2 == x0 {
                    last.2 = x1;
                    return;
                }
            }
            Some(last) => assert!(last.0 < y, "{span:?} after {last:?}: not top row first"),
            None => {}
        }
        runs.push((y, x0, x1));
    });
    runs
}

/// The pixels of a window for which `inside` holds, as the longest runs, top row first.
pub fn runs_where(window: Rect, mut inside: impl FnMut(i32, i32) -> bool) -> Vec<Run> {
    let mut runs: Vec<Run> = Vec::new();
    for y in window.y0..window.y1 {
        for x in window.x0..window.x1 {
            if inside(x, y) {
                match runs.last_mut() {
                    Some(last) if last.0 == y && last.2 == x => last.2 = x + 1,
                    _ => runs.push((y, x, x + 1)),
                }
            }
        }
    }
    runs
}

/// A picture of runs, to read in a failure: `#` painted, `.` not.
pub fn picture(window: Rect, runs: &[Run]) -> String {
    let mut text = String::new();
    for y in window.y0..window.y1 {
        for x in window.x0..window.x1 {
            text.push(if runs.iter().any(|r| r.0 == y && r.1 <= x && x < r.2) { '#' } else { '.' });
        }
        text.push('\n');
    }
    text
}

/// Fails with both pictures when they differ.
pub fn assert_runs(window: Rect, got: &[Run], wanted: &[Run], what: impl FnOnce() -> String) {
    assert!(
        got == wanted,
        "{}\nin {window:?}\ngot\n{}wanted\n{}",
        what(),
        picture(window, got),
        picture(window, wanted)
    );
}

/// A window in pieces of `width` x `height`, the last ones smaller.
pub fn tiles(whole: Rect, (width, height): (i32, i32)) -> Vec<Rect> {
    let starts = |from: i32, to: i32, step: i32| (from..to).step_by(step.unsigned_abs() as usize);
    starts(whole.y0, whole.y1, height)
        .flat_map(|y| starts(whole.x0, whole.x1, width).map(move |x| Rect::new(x, y, x + width, y + height)))
        .map(|tile| tile.intersection(whole))
        .collect()
}

/// Sizes of tiles that make trouble: single pixels, columns, rows, odd ones.
pub const TILE_SIZES: [(i32, i32); 6] = [(1, 1), (1, 40), (48, 1), (2, 3), (5, 4), (17, 9)];
