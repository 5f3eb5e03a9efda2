//! What is known of the chip and of the build, and what the compiler is told. Hints for speed and size only: they choose
//! between ways to the same pixels.
//!
//! `RUSTFLAGS="--cfg small_core --cfg compact" cargo test` takes the ways of small cores and small images on any machine.

use core::hint::black_box;

/// Armv7-M and later. Among the Cortex-M, atomic compare-and-swap tells them from Armv6-M.
const ARMV7: bool = cfg!(all(target_arch = "arm", target_has_atomic = "32"));

/// Whether the chip divides in hardware. Armv6-M does not.
pub(crate) const DIVIDES: bool = cfg!(not(any(small_core, target_arch = "arm"))) || !cfg!(small_core) && ARMV7;

/// Cores that load and store words at any address.
pub(crate) const UNALIGNED: bool = !cfg!(small_core)
    && (ARMV7
        || cfg!(any(target_arch = "x86", target_arch = "x86_64", target_arch = "aarch64", target_arch = "wasm32")));

/// Armv6-M, where a multiple store moves on by itself.
pub(crate) const MULTIPLE: bool = !UNALIGNED && cfg!(any(small_core, target_arch = "arm"));

/// Computers, which have vector registers: a choice without a branch is made for many pixels at once.
pub(crate) const VECTORS: bool =
    !cfg!(small_core) && !COMPACT && cfg!(any(target_arch = "x86_64", target_arch = "aarch64"));

/// Built for size, at opt-level "s" or "z" (see `build.rs`): one short loop is better than three fast ones.
pub(crate) const COMPACT: bool = cfg!(compact);

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
