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
//!   them without it. It is there for tests.
//!
//! `RUSTFLAGS="--cfg embedded_raster_small_core --cfg embedded_raster_compact" cargo test` takes both ways on any machine.
//!
//! A module that has two ways chooses between them once, at its head: by a constant that is named for what it means there, or
//! by the module that it uses.

#![cfg_attr(
    embedded_raster_compact,
    allow(dead_code, reason = "the ways for size do without what only those for speed are told")
)]

use core::hint::black_box;

/// Armv7-M and later. Among the Cortex-M, atomic compare-and-swap tells them from Armv6-M.
const ARMV7: bool = cfg!(all(target_arch = "arm", target_has_atomic = "32"));

/// Takes the ways of small cores on any machine.
const SMALL_CORE: bool = cfg!(embedded_raster_small_core);

/// Whether the chip divides in hardware. Armv6-M does not.
pub(crate) const DIVIDES: bool = !SMALL_CORE && (ARMV7 || cfg!(not(target_arch = "arm")));

/// Cores that load and store words at any address.
pub(crate) const UNALIGNED: bool = !SMALL_CORE
    && (ARMV7
        || cfg!(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")));

/// Armv6-M, where a multiple store moves on by itself.
pub(crate) const MULTIPLE: bool = !UNALIGNED && (SMALL_CORE || cfg!(target_arch = "arm"));

/// Computers, which have vector registers: a choice without a branch is made for many pixels at once.
pub(crate) const VECTORS: bool = !SMALL_CORE && !COMPACT && cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

/// Built for size: one short loop is better than three fast ones.
pub(crate) const COMPACT: bool = cfg!(embedded_raster_compact);

/// Keeps the loop around it as it is written: an empty piece of assembly, without instructions. Unrolled at run time, a
/// loop of four instructions gets ten of prologue, and multiple stores are taken apart.
#[inline(always)]
pub(crate) fn keep_rolled() {
    black_box(());
}

/// The same slice, of which the compiler knows no more than where it is. Knowing how its start was found, LLVM finds that anew for
/// every loop on Armv7-M: eight instructions where a register holds it already.
#[inline(always)]
pub(crate) fn of_no_origin<T>(slice: &mut [T]) -> &mut [T] {
    if ARMV7 {
        black_box(slice)
    } else {
        slice
    }
}
