//! What is known of the chip and of the build, and what the compiler is told. Hints for speed and size only: they choose
//! between ways to the same pixels.
//!
//! Two switches say what is not known of the chip.
//!
//! - `embedded_raster_compact`, the ways for size. `build.rs` sets it where this crate is built at opt-level "s" or "z".
//!   Most of the crate is generic, so it is compiled with the firmware, at the opt-level of the firmware. A profile that gives
//!   this package another opt-level than the firmware takes the ways of the wrong one. A user who does that sets the variable
//!   `EMBEDDED_RASTER_TUNE` to `size` or `speed`, for instance in the firmware's `.cargo/config.toml`:
//!   ```toml
//!   [env]
//!   EMBEDDED_RASTER_TUNE = "size"
//!   ```
//! - `embedded_raster_small_core`, the ways of a chip that neither divides nor stores words at any address. Such chips take
//!   them without it. It is there for tests: `build.rs` sets it where `EMBEDDED_RASTER_CORE` is `small`.
//!
//! `EMBEDDED_RASTER_CORE=small EMBEDDED_RASTER_TUNE=size cargo test` takes both ways on any machine.
//!
//! A module that has two ways chooses between them once, at its head: by a constant that is named for what it means there, or
//! by the module that it uses.
//!
//! What a hint says that it saves are instructions, counted without it when it was written. To see what it saves now, take it
//! out and compare: `cargo xtask table` prints modelled cycles, and instructions beside them.

#![cfg_attr(
    embedded_raster_compact,
    allow(dead_code, reason = "the ways for size do without what only those for speed are told")
)]

use core::hint::black_box;

/// Any Cortex-M.
pub(crate) const ARM: bool = cfg!(target_arch = "arm");

/// Armv7-M and later: Cortex-M3 and up. Among the Cortex-M, atomic compare-and-swap tells them from Armv6-M.
pub(crate) const ARMV7: bool = ARM && cfg!(target_has_atomic = "32");

/// Armv6-M: Cortex-M0 and M0+.
pub(crate) const ARMV6: bool = ARM && !ARMV7;

/// RISC-V of 32 bits.
pub(crate) const RISCV: bool = cfg!(target_arch = "riscv32");

/// Takes the ways of small cores on any machine.
const SMALL_CORE: bool = cfg!(embedded_raster_small_core);

/// Whether the chip divides in hardware. Armv6-M does not.
pub(crate) const DIVIDES: bool = !SMALL_CORE && !ARMV6;

/// Whether the product of two words is left to the compiler. On Armv6-M that is a call, which a build for size keeps.
pub(crate) const LONG_PRODUCTS: bool = !SMALL_CORE && (!ARMV6 || COMPACT);

/// Computers whose registers have 64 bits, and divide in them.
pub(crate) const WORDS: bool = !SMALL_CORE && cfg!(target_pointer_width = "64");

/// Cores that load and store words at any address.
pub(crate) const UNALIGNED: bool = !SMALL_CORE
    && (ARMV7
        || cfg!(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")));

/// Armv6-M, where a multiple store moves on by itself.
pub(crate) const MULTIPLE: bool = !UNALIGNED && (SMALL_CORE || ARM);

/// Computers, which have vector registers: a choice without a branch is made for many pixels at once. `build.rs` sets it where the ways
/// for speed are taken, but not those of a small core.
pub(crate) const VECTORS: bool = cfg!(embedded_raster_vectors);

/// Built for size: one short loop is better than three fast ones.
pub(crate) const COMPACT: bool = cfg!(embedded_raster_compact);

/// The loop around it stays as it is written, on the chips where that pays. Unrolled, a loop has some ten instructions of
/// prologue, and its addresses and counters take the registers that the caller's loop needs.
///
/// What the workloads of `firmware/bench` would cost without it, at opt-level 3, in instructions:
/// - Armv7-M: vertical runs +68 %, wide rectangles +41 %, discs +5 %, triangles of 20,000 pixels +5 % (RGB565).
/// - Armv6-M: 24-bit rows +20 %, triangles of 20,000 pixels +4 %, discs +8 % (4 bits), polygons +2 %, vertical runs +1 %.
/// - RV32IMC: short runs of 24 bits +5 %.
#[inline(always)]
pub(crate) fn keep_rolled(on: bool) {
    if on {
        black_box(());
    }
}

/// The loop around it, which copies, does not become a call of `memcpy`, and is not unrolled.
///
/// - Armv6-M, built for size: blits would be 316 bytes larger. Built for speed it would cost 5 % of a blit.
/// - RV32IMC: blits would cost 12 % more instructions.
#[inline(always)]
pub(crate) fn keep_copying() {
    if RISCV || ARMV6 && COMPACT {
        black_box(());
    }
}

/// The branch that it stands in stays a branch. Made conditional, the instructions before it would cost both ways: instead of
/// every now and then, at every pixel.
///
/// Without it lines cost 21 to 32 % more instructions on Cortex-M4, 23 to 35 % on Cortex-M0+ and 19 to 24 % on RV32IMC;
/// circles 27, 20 and 12 %.
#[inline(always)]
pub(crate) fn keep_branch() {
    if ARM || RISCV {
        black_box(());
    }
}

/// Loads and stores before it stay before it, and those after it after it. Armv7-M only: without it all values of a round
/// are loaded first, for which there are not enough registers. Expanding rows of indices would cost 11 % more instructions,
/// blits 10 %.
#[inline(always)]
pub(crate) fn keep_order() {
    if ARMV7 {
        black_box(());
    }
}

/// A zero that the compiler does not know, for values that it must not know to be equal. Without it a multiple store has
/// nothing to store: clears would cost 75 % more instructions on Cortex-M0+.
#[inline(always)]
pub(crate) fn hidden_zero() -> u32 {
    if ARM {
        black_box(0)
    } else {
        0
    }
}

/// The same number, of which the compiler does not know that it is counted up. If it did, it would count an address beside
/// it, and there are not enough registers: triangles would cost 7 to 10 % more instructions on RV32IMC. On Cortex-M they do
/// not.
#[inline(always)]
pub(crate) fn not_counted(n: i32) -> i32 {
    if RISCV {
        black_box(n)
    } else {
        n
    }
}

/// The same slice, of which the compiler knows no more than where it is. Knowing how its start was found, LLVM finds that
/// anew for every loop on Armv7-M: eight instructions where a register holds it already. Rectangles of 4 bits would cost
/// 12 % more instructions on Cortex-M4, triangles of 20,000 pixels 5 %.
#[inline(always)]
pub(crate) fn of_no_origin<T>(slice: &mut [T]) -> &mut [T] {
    if ARMV7 {
        black_box(slice)
    } else {
        slice
    }
}
