//! How many instructions a piece of work takes.

use core::fmt;

use crate::chip;

/// Work is repeated until it takes about this many instructions: one tick of SysTick is then less
/// than a part in 25,000.
const ENOUGH: u64 = 1_000_000;
/// Very short work ends here.
const MOST_REPEATS: u64 = 10_000;

/// A number of instructions in tenths, because repeated work is divided.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Tenths(pub u64);

impl fmt::Display for Tenths {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}", self.0 / 10, self.0 % 10)
    }
}

/// Instructions of one run of `work`, without the loop and the call around it.
///
/// `work` must do the same each time: short work is repeated and the sum divided. On Cortex-M the
/// result is exact to 40 instructions divided by the repeats, on RISC-V to one divided by them.
pub fn instructions(work: &mut dyn FnMut()) -> Tenths {
    let once = repeat(1, work);
    let repeats = (ENOUGH / once.max(1)).clamp(1, MOST_REPEATS);
    let with = repeat(repeats, work);
    let without = repeat(repeats, &mut || ());
    Tenths((with.saturating_sub(without) * 10 + repeats / 2) / repeats)
}

/// Never inlined, so that the empty work runs through the same instructions.
#[inline(never)]
fn repeat(times: u64, work: &mut dyn FnMut()) -> u64 {
    let mut left = times as u32;
    chip::restart();
    while left > 0 {
        work();
        left -= 1;
    }
    chip::elapsed()
}
