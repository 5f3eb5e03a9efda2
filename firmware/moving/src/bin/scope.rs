//! The oscilloscope: two buffers of 4-bit pixels, of which only what has changed is drawn and sent.
#![no_std]
#![no_main]

use scene::moving::{Scope, LINE, SCOPE_BYTES};

static FIRST: moving::Memory<SCOPE_BYTES> = moving::Memory::new();
static SECOND: moving::Memory<SCOPE_BYTES> = moving::Memory::new();
static ROW: moving::Memory<LINE> = moving::Memory::new();

board::entry!(main);

fn main() {
    moving::run("scope", Scope::new([FIRST.bytes(), SECOND.bytes()], ROW.bytes()));
}
