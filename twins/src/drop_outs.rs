//! Drop-out control by its rules, word for word, with crossings as ratios of wide integers.

use std::collections::BTreeSet;

use embedded_raster::{raster::polygon::drop_out::DropOut, FillRule, Rect};

use crate::Units;

/// A crossing: a ratio, in 1/256 pixel, and which way its side goes.
#[derive(Copy, Clone, Debug)]
struct Crossing {
    n: i128,
    d: i128,
    winding: i32,
}

/// A shape, and the same with x and y exchanged for what is asked along columns.
struct Lines<'a> {
    contours: &'a [Vec<Units>],
    is_column: bool,
}

fn centre(pixel: i32) -> i128 {
    i128::from(pixel) * 256 + 128
}

impl Lines<'_> {
    /// All crossings of the scan line through the centres of a row, or of a column.
    fn crossings(&self, line: i32) -> Vec<Crossing> {
        let flip = |(x, y): Units| if self.is_column { (i128::from(y), i128::from(x)) } else { (x.into(), y.into()) };
        let y = centre(line);
        let mut found = vec![];
        for contour in self.contours {
            for (i, &b) in contour.iter().enumerate() {
                let (a, b) = (flip(contour[(i + contour.len() - 1) % contour.len()]), flip(b));
                if (a.1 <= y) != (b.1 <= y) {
                    let (upper, lower, winding) = if a.1 < b.1 { (a, b, 1) } else { (b, a, -1) };
                    let d = lower.1 - upper.1;
                    found.push(Crossing { n: upper.0 * d + (y - upper.1) * (lower.0 - upper.0), d, winding });
                }
            }
        }
        found
    }

    /// Whether the centre of a pixel of a line is inside: a crossing on it is left of it.
    fn is_inside(&self, line: i32, pixel: i32, rule: FillRule) -> bool {
        let winding: i32 = self.crossings(line).iter().filter(|c| c.n <= centre(pixel) * c.d).map(|c| c.winding).sum();
        match rule {
            FillRule::NonZero => winding != 0,
            FillRule::EvenOdd => winding % 2 != 0,
        }
    }

    /// The crossings between the centre of the pixel before and that of the pixel.
    fn gap(&self, line: i32, pixel: i32) -> Vec<Crossing> {
        let mut all = self.crossings(line);
        all.retain(|c| centre(pixel - 1) * c.d < c.n && c.n <= centre(pixel) * c.d);
        all
    }

    /// The pixel that is turned on in the gap before a pixel.
    fn turned_on(&self, line: i32, pixel: i32, rule: FillRule, drop_out: DropOut) -> Option<i32> {
        let gap = self.gap(line, pixel);
        if gap.is_empty() || self.is_inside(line, pixel - 1, rule) || self.is_inside(line, pixel, rule) {
            return None;
        }
        if !drop_out.stubs {
            // The other sides of the squares before and behind the line.
            let other = Lines { contours: self.contours, is_column: !self.is_column };
            let square = |next: i32, across: i32| {
                let sides = [self.gap(next, pixel), other.gap(pixel - 1, across), other.gap(pixel, across)];
                sides.iter().map(Vec::len).sum::<usize>()
            };
            if square(line - 1, line) < 2 || square(line + 1, line + 1) < 2 {
                return None;
            }
        }
        if !drop_out.smart {
            return Some(if self.is_column { pixel } else { pixel - 1 });
        }
        let less = |a: &&Crossing, b: &&Crossing| (a.n * b.d).cmp(&(b.n * a.d));
        let (first, last) = (gap.iter().min_by(less)?, gap.iter().max_by(less)?);
        // The sum of both against twice the place between the centres.
        let sum = first.n * last.d + last.n * first.d;
        let is_second = sum > 2 * (i128::from(pixel) * 256) * first.d * last.d;
        Some(if is_second { pixel } else { pixel - 1 })
    }
}

/// The pixels of a window that are inside, or that drop-out control turns on; those that are inside first.
pub fn pixels(contours: &[Vec<Units>], rule: FillRule, drop_out: DropOut, window: Rect) -> [BTreeSet<(i32, i32)>; 2] {
    let (rows, columns) = (Lines { contours, is_column: false }, Lines { contours, is_column: true });
    let (mut inside, mut on) = (BTreeSet::new(), BTreeSet::new());
    for y in window.y0..window.y1 {
        inside.extend((window.x0..window.x1).filter(|&x| rows.is_inside(y, x, rule)).map(|x| (y, x)));
        on.extend((window.x0..=window.x1).filter_map(|x| Some((y, rows.turned_on(y, x, rule, drop_out)?))));
    }
    for x in window.x0..window.x1 {
        on.extend((window.y0..=window.y1).filter_map(|y| Some((columns.turned_on(x, y, rule, drop_out)?, x))));
    }
    on.retain(|&(y, x)| (window.x0..window.x1).contains(&x) && (window.y0..window.y1).contains(&y));
    [inside, on]
}
