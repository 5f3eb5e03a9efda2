//! Scenes of a whole screen, drawn in bands of several heights: the cycles of each band, one line each.
//!
//! A part of a frame that was split between cores is a band like those of a screen that does not fit into RAM, so the same lines say
//! how even such a split is.
#![no_std]
#![no_main]

use core::hint::black_box;

use board::{counter, crc32_with, println, stack, CHIP};
use embedded_raster::EdgeSlot;
use scene::bands::{bands, Banded, BANDED, WHOLE};
use scene::{EDGES, HEIGHT};

/// Rows of a band: the whole, its halves, thirds and quarters, and what fits into little RAM.
const ROWS: [u16; 7] = [HEIGHT, HEIGHT / 2, HEIGHT / 3, HEIGHT / 4, 30, 16, 8];

board::entry!(main);

fn main() {
    println!("# {CHIP}: modelled cycles; stack in bytes below the call; the checksum is that of all bands so far");
    println!("# scene;format;rows;first row;bytes;cycles;stack;crc32");
    let mut memory = [0; WHOLE];
    let mut table = [EdgeSlot::EMPTY; EDGES];
    for scene in BANDED {
        for rows in ROWS {
            measure(&scene, rows, &mut memory, &mut table);
        }
    }
}

fn measure(scene: &Banded, rows: u16, memory: &mut [u8], table: &mut [EdgeSlot]) {
    let mut crc32 = 0;
    let bytes = (scene.memory)(rows);
    for band in bands(rows) {
        // Scenes begin with a clear: a band is the same however often it is drawn.
        let height = band.end - band.start;
        let memory = &mut memory[..(scene.memory)(height)];
        let mut draw = || (scene.draw)(black_box(&mut *memory), black_box(band.clone()), &mut *table).unwrap();
        let cycles = counter::cycles(&mut draw);
        let stack = stack::depth(&mut draw);
        crc32 = crc32_with(crc32, &memory[..(scene.pixels)(height)]);
        let Banded { name, format, .. } = scene;
        println!("{name};{format};{rows};{};{bytes};{cycles};{stack};{crc32:08x}", band.start);
    }
}
