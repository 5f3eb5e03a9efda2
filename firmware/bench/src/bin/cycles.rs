//! Checks the model of cycles on loops whose cycles the manuals give: `loop;cycles of the manual;modelled cycles`, one line
//! each. `cargo xtask budget` fails where they differ.
#![no_std]
#![no_main]

#[cfg(target_arch = "arm")]
use core::arch::asm;

use board::counter::cycles;
use board::println;

board::entry!(main);

/// Turns of each loop.
const TURNS: u32 = 1_000;
/// Cycles of `subs` and of `bne` that is taken.
const TURN: u32 = if cfg!(target_feature = "dsp") { 1 + 3 } else { 1 + 2 };

/// A loop of some instructions, with what they cost on Cortex-M4 and on Cortex-M0+. `r1` is free, `r2` is the address of 16
/// words, of which the first one is its own address.
macro_rules! check {
    ($name:literal, $m4:expr, $m0:expr, $($code:literal),+) => {{
        let expected = if cfg!(target_feature = "dsp") { $m4 } else { $m0 };
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
        });
        core::hint::black_box(words);
        println!("{};{};{section}", $name, TURNS * (expected + TURN));
    }};
}

fn main() {
    check!("nothing", 1, 1, "nop");
    check!(
        "four words, one by one",
        4,
        8,
        "str r1, [r2, #4]",
        "str r1, [r2, #8]",
        "str r1, [r2, #12]",
        "str r1, [r2, #16]"
    );
    check!("four words, as one", 5 + 1, 5 + 1, "stm r2!, {{r0, r1, r3, r4}}", "subs r2, #16");
    check!("four loads", 5, 8, "ldr r1, [r2]", "ldr r1, [r2, #4]", "ldr r1, [r2]", "ldr r1, [r2, #4]");
    check!("a list", 8, 8, "ldr r2, [r2]", "ldr r2, [r2]", "ldr r2, [r2]", "ldr r2, [r2]");
    check!("a computed address", 1 + 2, 1 + 2, "adds r2, #0", "str r1, [r2, #4]");
    check!("a call", 3 + 3 + 3, 3 + 2 + 2, "bl 3f", "b 4f", "3: bx lr", "4:");
    #[cfg(target_feature = "dsp")]
    {
        check!("a pair", 3, 0, "strd r0, r1, [r2, #8]");
        check!("an odd address", 3, 0, "str r1, [r2, #5]");
        check!("a division", 12, 0, "udiv r1, r1, r0");
        check!("a load that is skipped", 3, 0, "cmp r0, #0", "it eq", "ldreq r1, [r2]");
    }
}
