//! The map of the world and nothing else, with all of its memory static: does it fit into a chip with 48 kB of RAM?
#![no_std]
#![no_main]

use core::cell::UnsafeCell;

use board::{crc32, println, stack};
use embedded_raster::EdgeSlot;
use scene::{map, EDGES};

struct Memory(UnsafeCell<(Frame, [EdgeSlot; EDGES])>);

/// Aligned to words, as a display's DMA would want it.
#[repr(align(4))]
struct Frame([u8; map::BYTES]);

// SAFETY: this program has one thread.
unsafe impl Sync for Memory {}

static MEMORY: Memory = Memory(UnsafeCell::new((Frame([0; map::BYTES]), [EdgeSlot::EMPTY; EDGES])));

board::entry!(main);

fn main() {
    // SAFETY: the only reference.
    let (frame, table) = unsafe { &mut *MEMORY.0.get() };
    let stack = stack::depth(&mut || map::draw(&mut frame.0, table).unwrap());
    println!("map;index4;-;0.0;{stack};{:08x}", crc32(&frame.0));
}
