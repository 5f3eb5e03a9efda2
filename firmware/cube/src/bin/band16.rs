//! The cube in bands of 16 rows, on a chip with 16 kB of RAM.
#![no_std]
#![no_main]

const ROWS: u16 = 16;

static MEMORY: cube::Memory<{ scene::cube_bytes(ROWS) }> = cube::Memory::new();

board::entry!(main);

fn main() {
    cube::run(&MEMORY, ROWS);
}
