//! Checks the instruments themselves against work of a known size.
#![no_std]
#![no_main]

use core::arch::asm;
use core::hint::black_box;

use board::counter::{instructions, Tenths};
use board::{crc32, exit, println, stack};

board::entry!(main);

fn main() {
    let cases = [
        ("CRC-32 of its check string", crc32(black_box(b"123456789")) == 0xCBF4_3926),
        ("1,000 instructions", near(measured(500), 1_000)),
        ("1,000,000 instructions", near(measured(500_000), 1_000_000)),
        // Beyond the 24 bits of SysTick, which wrap at 671 million.
        ("700,000,000 instructions", near(measured(350_000_000), 700_000_000)),
        ("no stack", stack::depth(&mut || ()) <= 16),
        ("1,000 bytes of stack", (1_000..1_100).contains(&stack::depth(&mut deep))),
    ];
    let failed = cases.iter().filter(|(_, ok)| !ok).count();
    for (name, _) in cases.iter().filter(|(_, ok)| !ok) {
        println!("failed: {name}");
    }
    println!("{} passed, {failed} failed", cases.len() - failed);
    exit(i32::from(failed != 0));
}

fn measured(turns: u32) -> Tenths {
    instructions(&mut || spin(turns))
}

/// A count is right to a few instructions of call and return, and to one tick where one run is
/// enough and nothing is divided.
fn near(count: Tenths, expected: u64) -> bool {
    println!("# {expected} counted as {count}");
    count.0.abs_diff(expected * 10) <= 10 * (8 + expected / 20_000)
}

/// Two instructions a turn.
#[inline(never)]
fn spin(turns: u32) {
    // SAFETY: counts a register down.
    #[cfg(target_arch = "arm")]
    unsafe {
        asm!("2: subs {0}, {0}, #1", "bne 2b", inout(reg) turns => _, options(nomem, nostack))
    };
    // SAFETY: as above.
    #[cfg(target_arch = "riscv32")]
    unsafe {
        asm!("2: addi {0}, {0}, -1", "bnez {0}, 2b", inout(reg) turns => _, options(nomem, nostack))
    };
}

fn deep() {
    black_box([1_u8; 1_000]);
}
