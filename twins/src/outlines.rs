//! Outlines of paths, one pixel wide, pixel by pixel.

use super::{
    curves::{outlines, Outline, Piece},
    Units,
};

/// Along which axis a line is longer, and whether it goes up that axis.
type Way = (bool, bool);

/// A line as places along its axis and across it.
fn turned(p: Units, steep: bool) -> (i128, i128) {
    let (x, y) = (i128::from(p.0), i128::from(p.1));
    if steep {
        (y, x)
    } else {
        (x, y)
    }
}

fn way(a: Units, b: Units) -> Way {
    let steep = (i64::from(b.1) - i64::from(a.1)).abs() > (i64::from(b.0) - i64::from(a.0)).abs();
    (steep, turned(a, steep).0 < turned(b, steep).0)
}

/// Which side of the centre of its column a place has, seen along a way: -1 before, 1 behind.
fn side(p: Units, (steep, up): Way) -> i128 {
    let beyond = (turned(p, steep).0.rem_euclid(256) - 128).signum();
    if up {
        beyond
    } else {
        -beyond
    }
}

fn pixel_of(p: Units) -> (i32, i32) {
    (p.0 >> 8, p.1 >> 8)
}

/// One pixel for each column whose centre the line passes, from its start up to but without its end.
fn line_pixels(a: Units, b: Units) -> Vec<(i32, i32)> {
    let (steep, up) = way(a, b);
    let ((a, m), (b, n)) = (turned(a, steep), turned(b, steep));
    let passed = |centre: i128| if up { a <= centre && centre < b } else { b < centre && centre <= a };
    let mut columns: Vec<i128> = (a.min(b).div_euclid(256)..=a.max(b).div_euclid(256)).collect();
    columns.retain(|column| passed(256 * column + 128));
    if !up {
        columns.reverse();
    }
    let pixel = |column: i128| {
        // (m + (centre - a) (n - m) / (b - a)) / 256, rounded down.
        let (over, under) = (m * (b - a) + (256 * column + 128 - a) * (n - m), 256 * (b - a));
        let row = (over * under.signum()).div_euclid(under.abs());
        if steep {
            (row as i32, column as i32)
        } else {
            (column as i32, row as i32)
        }
    };
    columns.into_iter().map(pixel).collect()
}

/// All pixels of an outline, contour by contour.
pub fn outline_pixels(path: &[Piece]) -> Vec<Vec<(i32, i32)>> {
    let pixels = |contour: Outline| {
        let mut places = contour.places;
        if contour.closed {
            places.push(places[0]);
        }
        let lines: Vec<_> = places.windows(2).map(|p| (p[0], p[1])).filter(|(a, b)| a != b).collect();
        let mut all = vec![];
        for run in lines.chunk_by(|p, q| way(p.0, p.1) == way(q.0, q.1)) {
            let (start, end) = (run[0].0, run[run.len() - 1].1);
            let way = way(run[0].0, run[0].1);
            all.extend((side(start, way) > 0).then(|| pixel_of(start)));
            all.extend(run.iter().flat_map(|&(a, b)| line_pixels(a, b)));
            all.extend((side(end, way) <= 0).then(|| pixel_of(end)));
        }
        if lines.is_empty() {
            all.push(pixel_of(places[0]));
        }
        all.dedup();
        let corner = |i: usize| {
            let (Some(p), q, Some(r)) = (all.get(i.wrapping_sub(1)), all[i], all.get(i + 1)) else { return false };
            let diagonal = (p.0 - r.0).abs() == 1 && (p.1 - r.1).abs() == 1;
            diagonal && (q == (p.0, r.1) || q == (r.0, p.1))
        };
        (0..all.len()).filter(|&i| !corner(i) || (i > 0 && corner(i - 1))).map(|i| all[i]).collect()
    };
    outlines(path).into_iter().map(pixels).collect()
}
