//! Counts of values: how many of tens of millions are not what is promised. `cargo run --release -p lab -- --samples` prints them,
//! and fails where a promise does not hold.
//!
//! Triangles are of all kinds: tiny ones, slivers, such that reach thousands of pixels out of what is looked at, and the largest
//! that are allowed. What a value should be is a ratio of integers of 128 bits.

use std::fmt::Write;

use anyhow::{ensure, Result};
use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use embedded_raster::{
    geom::{Facet, Fast, Perspective, Plane, Varying},
    raster::triangle,
    ClippedSpan,
};
use fixed::types::I16F16;
use indicatif::{ProgressBar, ProgressStyle};
use twins::{
    corners,
    planes::{ratio, triangle_of_kind},
    rng::Rng,
    Units,
};

/// Pixels of each row of the table.
const SAMPLES: u64 = 20_000_000;
const QUICK_SAMPLES: u64 = 200_000;

/// What was found.
#[derive(Copy, Clone, Debug, Default)]
struct Found {
    /// Values that were looked at.
    values: u64,
    /// Those that are not the nearest ones, halves upwards.
    not_nearest: u64,
    /// Those that are further away than is promised.
    beyond: u64,
    /// How far away the worst one is, in its own steps.
    worst: f64,
}

impl Found {
    /// A value that should be `n / d`, and may be off by a half and `more.0 / more.1` steps.
    fn add(&mut self, got: i128, (n, d): (i128, i128), more: (i128, i128)) {
        let off = (got * d - n).abs();
        self.values += 1;
        // floor(n / d + 1/2) = got
        let low = 2 * n - 2 * d * got + d;
        self.not_nearest += u64::from(low < 0 || low >= 2 * d);
        // off / d <= 1/2 + more.0 / more.1
        self.beyond += u64::from(2 * off * more.1 > d * (more.1 + 2 * more.0));
        self.worst = self.worst.max(off as f64 / d as f64);
    }
}

/// Adds the values of a triangle of some kind to what was found.
trait Count: Fn(&mut Found, &mut Rng, usize) {}

impl<F: Fn(&mut Found, &mut Rng, usize)> Count for F {}

/// A row of the table.
struct Row {
    what: &'static str,
    promise: &'static str,
    /// Whether each value must be the nearest one.
    is_exact: bool,
    run: Box<dyn Count>,
}

/// Values of whole numbers at the corners: anything in a range, and its ends.
fn numbers(rng: &mut Rng, low: i64, high: i64) -> [i64; 3] {
    [(); 3].map(|()| {
        let any = rng.range(low, high);
        rng.pick(&[low, high, any, any, any])
    })
}

/// The rows of a triangle of some kind.
fn each_row(rng: &mut Rng, kind: usize, mut row: impl FnMut(&Facet, [Units; 3], ClippedSpan)) {
    let (units, window) = triangle_of_kind(rng, kind);
    let facet = Facet::new(corners(units)).expect("within the bounds");
    triangle::fill(corners(units), window, |span: ClippedSpan| row(&facet, units, span));
}

/// Values of one number, each the nearest one, or off by as many units of 2^-16 as it is pixels from where its row began.
fn number<V: Varying + 'static>(
    what: &'static str,
    is_exact: bool,
    (low, high): (i64, i64),
    from: fn(i64) -> V,
    to: fn(V) -> i64,
) -> Row {
    let run = move |found: &mut Found, rng: &mut Rng, kind: usize| {
        let values = numbers(rng, low, high);
        each_row(rng, kind, |facet, units, span| {
            let plane = Plane::new(facet, values.map(from));
            let mut columns = (span.x0()..span.x1()).zip(0..);
            plane.each(span.x0(), span.y(), span.len(), |got| {
                let (x, steps) = columns.next().unwrap_or_default();
                let more = if is_exact { (0, 1) } else { (steps + 1, 1 << 16) };
                found.add(to(got).into(), ratio(units, values, x, span.y()), more);
            });
        });
    };
    let promise = if is_exact { EXACT } else { FAST };
    Row { what, promise, is_exact, run: Box::new(run) }
}

const EXACT: &str = "the nearest";
const FAST: &str = "1/2 + (n + 1) / 65,536, n pixels along a row";

/// The same of three channels.
fn color<C: RgbColor + 'static, V: Varying + 'static>(
    what: &'static str,
    is_exact: bool,
    from: fn([u8; 3]) -> C,
    wrap: fn(C) -> V,
    unwrap: fn(V) -> C,
) -> Row {
    let run = move |found: &mut Found, rng: &mut Rng, kind: usize| {
        let colors = [(); 3].map(|()| from([(); 3].map(|()| rng.int(0, 255) as u8)));
        let channels = [C::r, C::g, C::b];
        let values = channels.map(|channel| colors.each_ref().map(|color| i64::from(channel(color))));
        each_row(rng, kind, |facet, units, span| {
            let plane = Plane::new(facet, colors.map(wrap));
            let mut columns = (span.x0()..span.x1()).zip(0..);
            plane.each(span.x0(), span.y(), span.len(), |got| {
                let ((x, steps), got) = (columns.next().unwrap_or_default(), unwrap(got));
                let more = if is_exact { (0, 1) } else { (steps + 1, 1 << 16) };
                for (channel, values) in channels.iter().zip(values) {
                    found.add(channel(&got).into(), ratio(units, values, x, span.y()), more);
                }
            });
        });
    };
    let promise = if is_exact { EXACT } else { FAST };
    Row { what, promise, is_exact, run: Box::new(run) }
}

/// Bytes in perspective, for distances that differ by up to 16 times.
fn perspective() -> Row {
    let run = |found: &mut Found, rng: &mut Rng, kind: usize| {
        let (values, near) = (numbers(rng, 0, 255), rng.range(1, 4_000));
        let w = [(); 3].map(|()| {
            let any = rng.range(near, near * 16);
            rng.pick(&[near, near * 16, any])
        });
        let others = [w[1] * w[2], w[2] * w[0], w[0] * w[1]];
        let shares = [0, 1, 2].map(|i| values[i] * others[i]);
        each_row(rng, kind, |facet, units, span| {
            let at = [0, 1, 2].map(|i| Perspective { w: I16F16::from_bits(w[i] as i32), value: values[i] as u8 });
            let mut columns = span.x0()..span.x1();
            Plane::new(facet, at).each(span.x0(), span.y(), span.len(), |got| {
                let x = columns.next().unwrap_or_default();
                let (n, _) = ratio(units, shares, x, span.y());
                let (d, _) = ratio(units, others, x, span.y());
                found.add(got.value.into(), (n, d), (1, 256));
            });
        });
    };
    let (what, promise) = ("bytes in perspective, w from 1 to 16", "1/2 + 1/256");
    Row { what, promise, is_exact: false, run: Box::new(run) }
}

/// All places in a texture that there are, in 1/65,536 texel, and those of a texture of 256 x 256.
const PLACES: (i64, i64) = (-(1 << 31), (1 << 31) - 1);
const NEAR_PLACES: (i64, i64) = (-(1 << 24), 1 << 24);

fn rows() -> Vec<Row> {
    let place = |n: i64| I16F16::from_bits(n as i32);
    vec![
        number("bytes", true, (0, 255), |n| n as u8, i64::from),
        color("Rgb888", true, |[r, g, b]| Rgb888::new(r, g, b), |c| c, |c| c),
        color("Rgb565", true, |[r, g, b]| Rgb565::new(r, g, b), |c| c, |c| c),
        number("depths of 16 bits", true, (0, 65_535), |n| n as u16, i64::from),
        number("depths of 32 bits", true, (0, u32::MAX.into()), |n| n as u32, i64::from),
        number("coordinates in 1/65,536 texel", true, PLACES, place, |n: I16F16| n.to_bits().into()),
        number("bytes, `Fast`", false, (0, 255), |n| Fast(n as u8), |Fast(n)| n.into()),
        color("Rgb565, `Fast`", false, |[r, g, b]| Rgb565::new(r, g, b), Fast, |Fast(c)| c),
        number("numbers of 16 bits, `Fast`", false, (0, 65_535), |n| Fast(n as u16), |Fast(n)| n.into()),
        perspective(),
        texels(NEAR_PLACES),
    ]
}

/// Whole units of 2^-16 texel are added: after n pixels both coordinates are off by n and a half of them.
fn texels((low, high): (i64, i64)) -> Row {
    let run = move |found: &mut Found, rng: &mut Rng, kind: usize| {
        let (u, v) = (numbers(rng, low, high), numbers(rng, low, high));
        each_row(rng, kind, |facet, units, span| {
            let place = |i: usize| Fast((I16F16::from_bits(u[i] as i32), I16F16::from_bits(v[i] as i32)));
            let mut columns = (span.x0()..span.x1()).zip(0..);
            Plane::new(facet, [place(0), place(1), place(2)]).each(span.x0(), span.y(), span.len(), |Fast(got)| {
                let (x, steps) = columns.next().unwrap_or_default();
                for (got, values) in [(got.0, u), (got.1, v)] {
                    found.add(got.to_bits().into(), ratio(units, values, x, span.y()), (steps, 1));
                }
            });
        });
    };
    let (what, promise) = ("coordinates in 1/65,536 texel, `Fast`", "1/2 + n, n pixels along a row");
    Row { what, promise, is_exact: false, run: Box::new(run) }
}

/// As many pixels of one row of the table.
fn count(row: &Row, seed: u64, samples: u64) -> Found {
    let (mut found, mut rng) = (Found::default(), Rng::new(seed));
    let mut kind = 0;
    while found.values < samples {
        (row.run)(&mut found, &mut rng, kind);
        kind += 1;
    }
    found
}

/// 1234567 as 1,234,567.
fn grouped(n: u64) -> String {
    let digits = n.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().map(|g| String::from_utf8_lossy(g).into_owned()).collect();
    groups.join(",")
}

/// Prints the table. Fails where a promise does not hold.
pub(crate) fn run(quick: bool) -> Result<()> {
    let (rows, samples) = (rows(), if quick { QUICK_SAMPLES } else { SAMPLES });
    let bar = ProgressBar::new(rows.len() as u64);
    bar.set_style(ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}")?);
    let mut broken = Vec::new();
    let mut text =
        String::from("| values | promise | looked at | not the nearest | beyond the promise | worst |\n|---|---|---:|---:|---:|---:|\n");
    for (seed, row) in (0..).zip(&rows) {
        bar.set_message(row.what);
        let Found { values, not_nearest, beyond, worst } = count(row, seed, samples);
        let Row { what, promise, .. } = row;
        let [values, wrong, over] = [values, not_nearest, beyond].map(grouped);
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {what} | {promise} | {values} | {wrong} | {over} | {worst:.6} |");
        if beyond > 0 || row.is_exact && not_nearest > 0 {
            broken.push(*what);
        }
        bar.inc(1);
    }
    bar.finish_and_clear();
    println!("{text}");
    ensure!(broken.is_empty(), "not as promised: {}", broken.join("; "));
    println!("All as promised.");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_beyond_their_promise_are_found() {
        let mut found = Found::default();
        found.add(3, (5, 2), (0, 1)); // 2.5, halves upwards
        assert_eq!((found.not_nearest, found.beyond), (0, 0));
        found.add(2, (5, 2), (0, 1));
        assert_eq!((found.not_nearest, found.beyond), (1, 0), "as near, and the wrong one");
        found.add(4, (13, 4), (0, 1)); // 3.25
        assert_eq!((found.values, found.not_nearest, found.beyond, found.worst), (3, 2, 1, 0.75));
        found.add(4, (13, 4), (1, 4));
        assert_eq!(found.beyond, 1, "just allowed");
    }
}
