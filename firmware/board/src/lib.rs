//! What every program on an emulated chip needs: an entry point, output, an exit code, a count of
//! cycles and instructions and the depth of the stack.
//!
//! | chip | machine of QEMU | count of instructions from |
//! |---|---|---|
//! | Cortex-M0+ | `mps2-an385` | SysTick, 40 instructions a tick |
//! | Cortex-M4F | `mps2-an386` | SysTick, 40 instructions a tick |
//! | RV32IMC | `virt` | the `minstret` counter |
//!
//! Instructions hold only under `-icount shift=0`, where one instruction takes one nanosecond of
//! virtual time. A store-multiple counts once, however many words; so on Cortex-M a plugin of the
//! emulator, `cycles/`, models cycles beside them, between two calls of a function that it knows.
//!
//! `unsafe` is at home here (registers, the stack) and in hand-written lower bounds; the crate that
//! is measured has none.
#![no_std]

#[cfg_attr(target_arch = "arm", path = "arm.rs")]
#[cfg_attr(target_arch = "riscv32", path = "riscv.rs")]
mod chip;
pub mod counter;
mod crc;
pub mod stack;

pub use crc::{crc32, crc32_with};
/// Prints a line to the output of the emulator.
#[cfg(feature = "print")]
pub use semihosting::println;

/// The processor, as the first column of every table.
pub const CHIP: &str = chip::NAME;

/// Ends the emulator with this exit code.
pub fn exit(code: i32) -> ! {
    semihosting::process::exit(code)
}

/// Makes a function the program: `board::entry!(main)`. When it returns, the emulator exits with 0.
#[macro_export]
macro_rules! entry {
    ($main:path) => {
        #[unsafe(export_name = "main")]
        extern "C" fn board_main() -> ! {
            let main: fn() = $main;
            main();
            $crate::exit(0)
        }
    };
}

/// The exit code of a processor fault, apart from 101 for a panic.
const FAULT: i32 = 102;

/// Ends the emulator after a fault: without it a broken program would spin until the time limit.
fn fault() -> ! {
    #[cfg(feature = "print")]
    println!("processor fault");
    exit(FAULT)
}
