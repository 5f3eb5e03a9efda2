//! The cube whole, on a chip with 96 kB of RAM.
#![no_std]
#![no_main]

const ROWS: u16 = scene::cube::HEIGHT;

static MEMORY: cube::Memory<{ scene::cube_bytes(ROWS) }> = cube::Memory::new();

board::entry!(main);

fn main() {
    cube::run(&MEMORY, ROWS);
}
