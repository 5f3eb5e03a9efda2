//! Drawing calls as an image for a chip: it links only if nothing can panic. It is never run, so it has no start; the linker
//! is told to keep the calls.
//!
//! The entries are those of the probe in `../..`, which proves the same for the computer that builds it, but with a format of
//! each kind only (bits in bytes, words, odd numbers of bytes, pages), as they are built four times for each chip.
#![no_std]
#![no_main]
#![allow(clippy::missing_safety_doc, clippy::too_many_arguments)]
#![allow(improper_ctypes_definitions)] // nobody calls them

#[cfg(not(feature = "panics"))]
#[path = "../../src/entries.rs"]
mod entries;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    extern "C" {
        fn a_panic_can_be_reached() -> !;
    }
    unsafe { a_panic_can_be_reached() }
}

/// What the proof must refuse.
#[cfg(feature = "panics")]
#[no_mangle]
pub extern "C" fn panics(bytes: &[u8; 8], at: usize) -> u8 {
    bytes[at]
}
