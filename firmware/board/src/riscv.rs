//! RISC-V: the `minstret` counter.

use core::arch::asm;
use core::ptr::addr_of;
use core::sync::atomic::{AtomicU32, Ordering};

use riscv_rt::TrapFrame;

pub(crate) const NAME: &str = "rv32imc";

/// `minstret` at `restart`, as two halves: there is no 64-bit atomic, and only one thread.
static START: [AtomicU32; 2] = [AtomicU32::new(0), AtomicU32::new(0)];

/// Starts counting at zero.
pub(crate) fn restart() {
    let now = retired();
    START[1].store((now >> 32) as u32, Ordering::Relaxed);
    START[0].store(now as u32, Ordering::Relaxed);
}

/// Instructions since `restart`.
pub(crate) fn elapsed() -> u64 {
    let now = retired();
    let [low, high] = START.each_ref().map(|half| u64::from(half.load(Ordering::Relaxed)));
    now.wrapping_sub(high << 32 | low)
}

/// Instructions since reset. Reads the high half twice, in case the low half wraps in between.
fn retired() -> u64 {
    loop {
        let (before, low, after): (u32, u32, u32);
        // SAFETY: only reads machine counters.
        unsafe {
            asm!(
                "csrr {}, minstreth",
                "csrr {}, minstret",
                "csrr {}, minstreth",
                out(reg) before, out(reg) low, out(reg) after,
                options(nomem, nostack),
            );
        }
        if before == after {
            return u64::from(after) << 32 | u64::from(low);
        }
    }
}

/// The lowest address that the stack may use.
pub(crate) fn stack_end() -> usize {
    extern "C" {
        static __eheap: u32;
    }
    addr_of!(__eheap) as usize
}

/// The stack pointer here: inlined, so that it is the caller's.
#[inline(always)]
pub(crate) fn stack_pointer() -> usize {
    let sp: usize;
    // SAFETY: only reads a register.
    unsafe { asm!("mv {}, sp", out(reg) sp, options(nomem, nostack, preserves_flags)) };
    sp
}

#[unsafe(no_mangle)]
extern "C" fn ExceptionHandler(_: &TrapFrame) -> ! {
    crate::fault()
}
