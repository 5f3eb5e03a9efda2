//! How many instructions a piece of work takes, and how many cycles.

use core::arch::asm;
use core::fmt;
use core::sync::atomic::{AtomicU32, Ordering};

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

/// What a piece of work takes.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Count {
    /// Modelled cycles: a placeholder of them.
    pub cycles: Section,
    /// Instructions.
    pub instructions: Tenths,
}

/// A section of the program whose cycles are modelled: the plugin of the emulator adds them up, which the program cannot see.
/// It prints as `@n`. `cargo xtask` puts there what the plugin printed for the `n`-th section.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Section(u32);

impl fmt::Display for Section {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "@{}", self.0)
    }
}

/// Cycles and instructions of one run of `work`, without the call around it. `work` must do the same each time.
pub fn count(work: &mut dyn FnMut()) -> Count {
    Count { cycles: cycles(work), instructions: instructions(work) }
}

/// Cycles of one run of `work`.
pub fn cycles(work: &mut dyn FnMut()) -> Section {
    static SECTIONS: AtomicU32 = AtomicU32::new(0);
    let section = SECTIONS.load(Ordering::Relaxed);
    // Not `fetch_add`, which Armv6-M lacks; there is one thread.
    SECTIONS.store(section + 1, Ordering::Relaxed);
    // Two marks each: those of the call around no work, and those with it. The tool subtracts.
    between_marks(&mut || ());
    between_marks(work);
    Section(section)
}

/// Never inlined, so that the empty work runs through the same instructions.
#[inline(never)]
fn between_marks(work: &mut dyn FnMut()) {
    board_mark();
    work();
    board_mark();
}

/// Where the plugin of the emulator begins to count, and where it ends. Its address is found by its name.
#[unsafe(no_mangle)]
#[inline(never)]
extern "C" fn board_mark() {
    // SAFETY: does nothing. Without it the call would be left out.
    unsafe { asm!("nop", options(nomem, nostack, preserves_flags)) };
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
