//! Checks the model of cycles on loops whose cycles the manuals give: `loop;cycles of the manual;modelled cycles`, one line
//! each. `cargo xtask budget` fails where they differ.
#![no_std]
#![no_main]

use core::arch::asm;

use board::counter::cycles;
use board::println;

board::entry!(main);

/// Turns of each loop.
const TURNS: u32 = 1_000;
/// A loop of some instructions. Register `0` counts turns, register `1` is free, and register `2` is the address of 16 words, of
/// which the first one is its own address: `r0` to `r2`, or `a0` to `a2`.
macro_rules! check {
    ($name:literal, $cycles:expr, $($code:literal),+) => {{
        let mut words = [0_u32; 16];
        words[0] = words.as_ptr() as u32;
        let at = words.as_mut_ptr();
        let section = cycles(&mut || {
            // SAFETY: the code keeps to the registers and the memory that it is given.
            #[cfg(target_arch = "arm")]
            unsafe {
                asm!("2:", $($code),+, "subs r0, #1", "bne 2b",
                    inout("r0") TURNS => _, out("r1") _, inout("r2") at => _, out("lr") _)
            };
            // SAFETY: as above. Nothing is compressed, so that every jump is to an instruction that begins at a word.
            #[cfg(target_arch = "riscv32")]
            unsafe {
                asm!(".option push", ".option norvc", ".p2align 2", "2:", $($code),+, "addi a0, a0, -1", "bnez a0, 2b",
                    ".option pop",
                    inout("a0") TURNS => _, out("a1") _, inout("a2") at => _, out("ra") _)
            };
        });
        core::hint::black_box(words);
        println!("{};{};{section}", $name, TURNS * ($cycles + TURN));
    }};
}

#[cfg(target_arch = "arm")]
fn main() {
    /// What the loop costs on Cortex-M4, and on Cortex-M0+.
    const fn on(m4: u32, m0: u32) -> u32 {
        if cfg!(target_feature = "dsp") {
            m4
        } else {
            m0
        }
    }
    /// Cycles of `subs` and of `bne` that is taken.
    const TURN: u32 = on(1 + 3, 1 + 2);
    check!("nothing", on(1, 1), "nop");
    check!(
        "four words, one by one",
        on(4, 8),
        "str r1, [r2, #4]",
        "str r1, [r2, #8]",
        "str r1, [r2, #12]",
        "str r1, [r2, #16]"
    );
    check!("four words, as one", on(5 + 1, 5 + 1), "stm r2!, {{r0, r1, r3, r4}}", "subs r2, #16");
    check!("four loads", on(5, 8), "ldr r1, [r2]", "ldr r1, [r2, #4]", "ldr r1, [r2]", "ldr r1, [r2, #4]");
    check!("a list", on(8, 8), "ldr r2, [r2]", "ldr r2, [r2]", "ldr r2, [r2]", "ldr r2, [r2]");
    check!("a computed address", on(1 + 2, 1 + 2), "adds r2, #0", "str r1, [r2, #4]");
    check!("a call", on(3 + 3 + 3, 3 + 2 + 2), "bl 3f", "b 4f", "3: bx lr", "4:");
    #[cfg(target_feature = "dsp")]
    {
        check!("a pair", 3, "strd r0, r1, [r2, #8]");
        check!("an odd address", 3, "str r1, [r2, #5]");
        check!("a division", 12, "udiv r1, r1, r0");
        check!("a load that is skipped", 3, "cmp r0, #0", "it eq", "ldreq r1, [r2]");
    }
}

#[cfg(target_arch = "riscv32")]
fn main() {
    /// Cycles of `addi` and of `bnez` that is taken and foreseen.
    const TURN: u32 = 1 + 1;
    check!("nothing", 1, "nop");
    check!("four words", 4, "sw a1, 4(a2)", "sw a1, 8(a2)", "sw a1, 12(a2)", "sw a1, 16(a2)");
    check!("four loads", 4, "lw a1, (a2)", "lw a1, 4(a2)", "lw a1, (a2)", "lw a1, 4(a2)");
    check!("a list", 4 + 4 - 1, "lw a2, (a2)", "lw a2, (a2)", "lw a2, (a2)", "lw a2, (a2)");
    check!("a load that is waited for", 1 + 1 + 1, "lw a1, 4(a2)", "add a1, a1, a0");
    check!("a load that is stored", 1 + 1, "lw a1, 4(a2)", "sw a1, 8(a2)");
    check!("a call", 2 + 2 + 2, "jal ra, 3f", "j 4f", "3: ret", "4:");
    check!("a division", 18, "divu a1, a1, a0");
    check!("a signed division", 19, "div a1, a1, a0");
    check!("a product of 64 bits", 1, "mulhu a1, a1, a0");
}
