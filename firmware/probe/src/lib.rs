//! Every drawing call, exported with arguments that the optimiser cannot know.
//!
//! The panic handler calls a function that does not exist. If any panic path survives optimisation, linking fails;
//! if it links, these calls cannot panic in this build configuration, whatever they are given.
#![no_std]
#![allow(clippy::missing_safety_doc, clippy::too_many_arguments)]
#![allow(improper_ctypes_definitions)] // nobody calls them

#[cfg(not(feature = "panics"))]
mod entries;

#[panic_handler]
fn panic(_: &core::panic::PanicInfo) -> ! {
    extern "C" {
        fn a_panic_can_be_reached() -> !;
    }
    unsafe { a_panic_can_be_reached() }
}

#[link(name = "c")]
extern "C" {}

/// What the proof must refuse.
#[cfg(feature = "panics")]
#[no_mangle]
pub extern "C" fn panics(bytes: &[u8; 8], at: usize) -> u8 {
    bytes[at]
}
