//! What was shaded against the exact values, which are ratios of wide integers.

use twins::{planes::ratio, Run, Units};

use super::{engine::TEXTURE, Drawn, Kind, Shaded, UNPAINTED};
use crate::{
    frame::{HEIGHT, WIDTH, WINDOW},
    judge::{Judge, Verdict},
    oracle::triangle_has,
    shape::BITS,
};

impl Judge for Shaded {
    type Truth = Vec<Run>;
    type Drawn = Drawn;

    fn truth(&self) -> Vec<Run> {
        let corners = self.corners.map(|corner| corner.at.map(|n| i64::from(n) << (BITS - 8))).map(|[x, y]| (x, y));
        let of = |i: usize, most: i32| {
            let bounds = self.corners.map(|corner| corner.at[i] >> 8);
            let (low, high) = (bounds.into_iter().min().unwrap_or(0), bounds.into_iter().max().unwrap_or(0));
            (low.clamp(0, most), (high + 1).clamp(0, most))
        };
        let ((x0, x1), (y0, y1)) = (of(0, WIDTH), of(1, HEIGHT));
        let window = embedded_raster::Rect::new(x0, y0, x1, y1).intersection(WINDOW);
        twins::runs_where(window, |x, y| triangle_has(corners, x, y))
    }

    fn pixels(truth: &Vec<Run>) -> usize {
        truth.iter().map(|&(_, x0, x1)| (x1 - x0) as usize).sum()
    }

    fn verdict(&self, truth: &Vec<Run>, _: &str, drawn: &Drawn) -> Verdict {
        let mut verdict = Verdict { pixels: Self::pixels(truth), ..Verdict::default() };
        let mut painted = drawn.iter().filter(|&&number| number != UNPAINTED).count();
        for &run in truth {
            let (y, x0, x1) = run;
            let start = (y * WIDTH + x0) as usize;
            let row = &drawn[start..start + (x1 - x0) as usize];
            let missing = row.iter().filter(|&&number| number == UNPAINTED).count();
            verdict.wrong += missing;
            painted -= row.len() - missing;
            self.row(run, row, &mut verdict);
        }
        verdict.wrong += painted;
        verdict
    }
}

/// A ratio whose parts change evenly along a row.
struct Ratio {
    at: (i128, i128),
    by: (i128, i128),
}

impl Ratio {
    fn new(of: impl Fn(i32) -> (i128, i128), x: i32) -> Self {
        let (at, next) = (of(x), of(x + 1));
        Self { at, by: (next.0 - at.0, next.1 - at.1) }
    }

    fn next(&mut self) -> (i128, i128) {
        let at = self.at;
        (self.at.0, self.at.1) = (at.0 + self.by.0, at.1 + self.by.1);
        at
    }
}

impl Shaded {
    fn row(&self, (y, x0, _): Run, row: &[u32], verdict: &mut Verdict) {
        let units: [Units; 3] = self.corners.map(|corner| (corner.at[0], corner.at[1]));
        let even = |values: [i64; 3]| Ratio::new(|x| ratio(units, values, x, y), x0);
        match self.kind {
            Kind::Levels => {
                let mut levels = [0, 1, 2].map(|i| even(self.corners.map(|corner| corner.levels[i].into())));
                for &pixel in row {
                    let parts = [pixel >> 11 & 31, pixel >> 5 & 63, pixel & 31];
                    for (exact, got) in levels.iter_mut().zip(parts) {
                        add(verdict, pixel, got, exact.next());
                    }
                }
            }
            Kind::Depth => {
                let mut depths = even(self.corners.map(|corner| corner.depth.into()));
                for &depth in row {
                    add(verdict, depth, depth, depths.next());
                }
            }
            Kind::Texels => {
                let [a, b, c] = self.corners.map(|corner| i64::from(corner.w));
                let others = [b * c, c * a, a * b];
                let seen = |i: usize| {
                    let of = |at: usize| i64::from(self.corners[at].texel[i]) * others[at];
                    let values = [of(0), of(1), of(2)];
                    Ratio::new(|x| (ratio(units, values, x, y).0, ratio(units, others, x, y).0), x0)
                };
                let (mut columns, mut rows) = (seen(0), seen(1));
                for &texel in row {
                    let off = |exact: (i128, i128), got: u32| (exact.0.div_euclid(exact.1) - i128::from(got)).abs();
                    let mask = (1 << TEXTURE) - 1;
                    let away = off(columns.next(), texel & mask).max(off(rows.next(), texel >> TEXTURE & mask));
                    count(verdict, texel, away as f64, away != 0);
                }
            }
        }
    }
}

/// A number against a ratio. Of two that are equally near, either will do.
fn add(verdict: &mut Verdict, pixel: u32, got: u32, (n, d): (i128, i128)) {
    let off = (i128::from(got) * d - n).abs();
    count(verdict, pixel, off as f64 / d as f64, 2 * off > d);
}

fn count(verdict: &mut Verdict, pixel: u32, off: f64, is_wrong: bool) {
    if pixel != UNPAINTED {
        verdict.values += 1;
        verdict.not_nearest += usize::from(is_wrong);
        verdict.off += off;
        verdict.worst = verdict.worst.max(off);
    }
}

#[cfg(test)]
mod tests {
    use textbook::scene::Corner;

    use super::*;
    use crate::shading::{depth16, depth32, gouraud, perspective, Ways};

    /// A triangle of 6 pixels in whose centres all values are whole.
    fn easy(kind: Kind) -> Shaded {
        let corner = |x: i32, y: i32, n: i32| Corner {
            at: [256 * (3 + x), 256 * (2 + y)],
            levels: [10 + n, 20 + n, 30 - n],
            depth: (100 + n).unsigned_abs(),
            texel: [100 + n, 50 - n],
            w: 1,
        };
        // Even numbers, so that halves of pixels have whole ones.
        Shaded { kind, corners: [corner(0, 0, 0), corner(4, 0, 8), corner(0, 4, 16)] }
    }

    fn judged(ways: Ways, shape: Shaded) -> Vec<(&'static str, Verdict)> {
        let truth = shape.truth();
        let judge = |mut entry: crate::engine::Entry<Shaded, Drawn>| {
            entry.engine.clear();
            entry.engine.draw(&[shape]);
            (entry.key, shape.verdict(&truth, entry.key, &entry.engine.painted()))
        };
        ways.into_iter().map(judge).collect()
    }

    #[test]
    fn an_easy_triangle_is_right() {
        // These move corners, or take values beside the centres of pixels.
        let not_exact = ["3dgfx", "fixed8", "fixed16", "fixed14"];
        for (ways, kind, values) in [
            (gouraud(true).entries, Kind::Levels, 18),
            (depth16(true).entries, Kind::Depth, 6),
            (depth32(true).entries, Kind::Depth, 6),
        ] {
            for (key, verdict) in judged(ways, easy(kind)).into_iter().filter(|(key, _)| !not_exact.contains(key)) {
                assert_eq!((verdict.pixels, verdict.values, verdict.not_nearest), (6, values, 0), "{key}: {verdict:?}");
                // A test of each pixel takes those on the long side too.
                let more = if ["barycentric", "euc"].contains(&key) { 4 } else { 0 };
                assert_eq!(verdict.wrong, more, "{key}: {verdict:?}");
            }
        }
    }

    #[test]
    fn this_crate_is_exact_and_runs_are_not() {
        let shape = perspective(true).workloads.swap_remove(0).shapes.swap_remove(1);
        let verdicts = judged(perspective(true).entries, shape);
        let off = |key| verdicts.iter().find(|(name, _)| *name == key).expect("a way").1.not_nearest;
        assert_eq!(off("exact"), 0, "{verdicts:?}");
        assert!(off("affine") > off("runs32") && off("runs32") >= off("runs8"), "{verdicts:?}");
    }

    #[test]
    fn a_wrong_value_is_found() {
        let (shape, mut verdict) = (easy(Kind::Depth), Verdict::default());
        // 100 + 8 x / 4 + 16 y / 4 at the centre of the first pixel: 103.
        shape.row((2, 3, 6), &[103, 106, UNPAINTED], &mut verdict);
        assert_eq!((verdict.values, verdict.not_nearest, verdict.worst), (2, 1, 1.0), "106 should be 105");
    }
}
