//! Cortex-M: SysTick on the processor clock as a counter of instructions.

use core::ptr::addr_of;
use core::sync::atomic::{AtomicU32, Ordering};

use cortex_m::peripheral::syst::RegisterBlock;
use cortex_m::peripheral::SYST;
use cortex_m_rt::{exception, ExceptionFrame};

#[cfg(target_feature = "dsp")]
pub(crate) const NAME: &str = "cortex-m4";
#[cfg(not(target_feature = "dsp"))]
pub(crate) const NAME: &str = "cortex-m0plus";

/// The processor clock of mps2 is 25 MHz, an instruction is 1 ns: 40 of them to a tick.
const INSTRUCTIONS_PER_TICK: u64 = 40;
/// SysTick counts down through 24 bits, which is 671 million instructions.
const PERIOD: u32 = 1 << 24;

/// Enable, interrupt at zero, processor clock.
const CONTROL: u32 = 0b111;

/// Periods since `restart`. The interrupt itself costs some ten instructions in 671 million.
static PERIODS: AtomicU32 = AtomicU32::new(0);

fn timer() -> &'static RegisterBlock {
    // SAFETY: a fixed address on every Cortex-M, and nothing else in this program uses SysTick.
    unsafe { &*SYST::PTR }
}

/// Starts counting at zero. Writing the counter also restarts the tick, so equal work gives equal
/// counts.
pub(crate) fn restart() {
    // SAFETY: any value may be written to these three registers.
    unsafe {
        timer().csr.write(0);
        timer().rvr.write(PERIOD - 1);
        timer().cvr.write(0);
        PERIODS.store(0, Ordering::Relaxed);
        timer().csr.write(CONTROL);
    }
}

/// Instructions since `restart`, rounded to ticks.
pub(crate) fn elapsed() -> u64 {
    loop {
        let periods = PERIODS.load(Ordering::Relaxed);
        let ticks = PERIOD.wrapping_sub(timer().cvr.read()) % PERIOD;
        // An interrupt between the two reads would count a period twice or not at all.
        if periods == PERIODS.load(Ordering::Relaxed) {
            let ticks = u64::from(periods) * u64::from(PERIOD) + u64::from(ticks);
            return ticks * INSTRUCTIONS_PER_TICK;
        }
    }
}

/// The lowest address that the stack may use.
pub(crate) fn stack_end() -> usize {
    extern "C" {
        static _stack_end: u32;
    }
    addr_of!(_stack_end) as usize
}

/// The stack pointer here: inlined, so that it is the caller's.
#[inline(always)]
pub(crate) fn stack_pointer() -> usize {
    let sp: usize;
    // SAFETY: only reads a register.
    unsafe { core::arch::asm!("mov {}, sp", out(reg) sp, options(nomem, nostack, preserves_flags)) };
    sp
}

#[exception]
fn SysTick() {
    // Not `fetch_add`, which Armv6-M lacks; nobody else writes while the timer runs.
    PERIODS.store(PERIODS.load(Ordering::Relaxed).wrapping_add(1), Ordering::Relaxed);
}

#[exception]
unsafe fn HardFault(_: &ExceptionFrame) -> ! {
    crate::fault()
}
