//! Levels against areas.

use super::{shape::Soft, truth::Areas, Levels};
use crate::{
    frame::WIDTH,
    judge::{Judge, Verdict},
};

/// Areas below are nothing, and those above one less this are all. The sums in double precision are this good.
const TINY: f64 = 1e-9;

impl Judge for Soft {
    type Truth = Areas;
    type Drawn = Levels;

    fn truth(&self) -> Areas {
        Areas::of(self)
    }

    /// Those that are touched.
    fn pixels(truth: &Areas) -> usize {
        truth.areas.iter().filter(|&&area| area > TINY).count()
    }

    /// `values` are the pixels that are covered in part, `wrong` those that are tinted and should be empty or full.
    fn verdict(&self, truth: &Areas, _: &str, drawn: &Levels) -> Verdict {
        let mut verdict = Verdict { pixels: Self::pixels(truth), ..Verdict::default() };
        let mut tinted = drawn.iter().filter(|&&level| level != 0).count();
        for (i, &area) in truth.areas.iter().enumerate() {
            let (x, y) = (truth.x0 + i as i32 % truth.width, truth.y0 + i as i32 / truth.width);
            let level = drawn[(y * WIDTH + x) as usize];
            tinted -= usize::from(level != 0);
            if area <= TINY || area >= 1.0 - TINY {
                verdict.wrong += usize::from(level != if area <= TINY { 0 } else { 255 });
                continue;
            }
            let off = (f64::from(level) - area * 255.0).abs();
            verdict.values += 1;
            verdict.not_nearest += usize::from(off > 0.5 + 255.0 * TINY);
            verdict.off += off;
            verdict.worst = verdict.worst.max(off);
        }
        verdict.wrong += tinted;
        verdict
    }
}
