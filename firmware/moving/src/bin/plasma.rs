//! The plasma: 8-bit pixels that are drawn once, and a palette that turns.
#![no_std]
#![no_main]

use scene::moving::{Plasma, LINE, PLASMA_BYTES};

static PIXELS: moving::Memory<PLASMA_BYTES> = moving::Memory::new();
static ROW: moving::Memory<LINE> = moving::Memory::new();

board::entry!(main);

fn main() {
    let Ok(plasma) = Plasma::new(PIXELS.bytes(), ROW.bytes()) else { board::exit(1) };
    moving::run("plasma", plasma);
}
