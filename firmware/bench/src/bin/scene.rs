//! Draws the frames that are the same everywhere: cycles, instructions, stack and checksum of each, one line each.
#![no_std]
#![no_main]

use core::hint::black_box;

use board::counter::{count, Count};
use board::{crc32, println, stack, CHIP};
use embedded_raster::EdgeSlot;
use scene::{Frame, EDGES, FRAMES};

/// The largest frame: 16 bits a pixel.
const BYTES: usize = 2 * 320 * 240;

board::entry!(main);

fn main() {
    println!("# {CHIP}: modelled cycles; stack in bytes below the call");
    println!("# frame;format;cycles;instructions;stack;crc32");
    let mut memory = [0; BYTES];
    let mut table = [EdgeSlot::EMPTY; EDGES];
    for frame in FRAMES {
        measure(&frame, &mut memory[..frame.bytes], &mut table);
    }
}

fn measure(frame: &Frame, memory: &mut [u8], table: &mut [EdgeSlot]) {
    // Frames start with a clear: they are the same however often they are drawn.
    let mut draw = || (frame.draw)(black_box(&mut *memory), black_box(&mut *table)).unwrap();
    let Count { cycles, instructions } = count(&mut draw);
    let stack = stack::depth(&mut draw);
    println!("{};{};{cycles};{instructions};{stack};{:08x}", frame.name, frame.format, crc32(memory));
}
