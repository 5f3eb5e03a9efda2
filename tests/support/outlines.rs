//! Outlines of paths, one pixel wide, pixel by pixel.

use super::{
    curves::{outlines, Outline, Piece},
    Units,
};

/// Thin outlines are flattened within 2^3 units.
const FINER: u32 = 3;

/// The pixels of one line: along the longer axis one a column, where the line is at its centre or ends before.
fn line_pixels(a: Units, b: Units) -> Vec<(i32, i32)> {
    let wide = |p: Units| (i128::from(p.0), i128::from(p.1));
    let ((ax, ay), (bx, by)) = (wide(a), wide(b));
    if (by - ay).abs() > (bx - ax).abs() {
        return line_pixels((a.1, a.0), (b.1, b.0)).into_iter().map(|(y, x)| (x, y)).collect();
    }
    let (first, last) = (ax.div_euclid(256), bx.div_euclid(256));
    let pixel = |x: i128| {
        let place = (256 * x + 128).clamp(ax.min(bx), ax.max(bx));
        // 256 (ay + (place - ax) (by - ay) / (bx - ax)), rounded down.
        let (n, d) = (ay * (bx - ax) + (place - ax) * (by - ay), 256 * (bx - ax));
        let y = if d == 0 { ay.div_euclid(256) } else { (n * d.signum()).div_euclid(d.abs()) };
        (x as i32, y as i32)
    };
    let mut pixels: Vec<_> = (first.min(last)..=first.max(last)).map(pixel).collect();
    if first > last {
        pixels.reverse();
    }
    pixels
}

/// All pixels of an outline, contour by contour.
pub(crate) fn outline_pixels(path: &[Piece]) -> Vec<Vec<(i32, i32)>> {
    let pixels = |contour: Outline| {
        let mut places = contour.places;
        if contour.closed {
            places.push(places[0]);
        }
        let mut all = vec![(places[0].0 >> 8, places[0].1 >> 8)];
        all.extend(places.windows(2).flat_map(|p| line_pixels(p[0], p[1])));
        all.dedup();
        let touch = |i: usize| {
            let (Some(p), Some(q)) = (all.get(i.wrapping_sub(1)), all.get(i + 1)) else { return false };
            p != q && (p.0 - q.0).abs() <= 1 && (p.1 - q.1).abs() <= 1
        };
        (0..all.len()).filter(|&i| !touch(i) || (i > 0 && touch(i - 1))).map(|i| all[i]).collect()
    };
    outlines(path, FINER).into_iter().map(pixels).collect()
}
