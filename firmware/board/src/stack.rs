//! How deep the stack gets, by painting it.

use core::ptr::{read_volatile, write_volatile};

use crate::chip;

/// A word that drawing code is unlikely to leave behind.
const PAINT: u32 = 0xA5C3_5A3C;
/// Painted bytes: far more than any drawing code may need, and painted quickly.
const DEPTH: usize = 64 * 1024;
const WORD: usize = size_of::<u32>();

/// Bytes of stack that `work` wrote to, counted from its call.
///
/// The stack below this function is painted, and afterwards searched from below for the first word
/// that changed. A frame whose lowest words are reserved but never written shows smaller than it is;
/// summing the frame sizes finds those. Work that needs more than 64 kB shows as 64 kB.
#[inline(never)]
pub fn depth(work: &mut dyn FnMut()) -> usize {
    let top = chip::stack_pointer() & !(WORD - 1);
    let bottom = chip::stack_end().max(top - DEPTH);
    // SAFETY: bottom..top is free stack: above the end that the linker reserved, below this frame,
    // and nothing is called while it is painted (the volatile write is inlined in every profile).
    for address in (bottom..top).step_by(WORD) {
        unsafe { write_volatile(address as *mut u32, PAINT) };
    }
    work();
    // SAFETY: as above; reading memory that is mapped.
    let untouched = (bottom..top)
        .step_by(WORD)
        .take_while(|&address| unsafe { read_volatile(address as *const u32) } == PAINT)
        .count();
    top - bottom - untouched * WORD
}
