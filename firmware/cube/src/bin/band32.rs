//! The cube in bands of 32 rows, on a chip with 48 kB of RAM.
#![no_std]
#![no_main]

const ROWS: u16 = 32;

static MEMORY: cube::Memory<{ scene::cube_bytes(ROWS) }> = cube::Memory::new();

board::entry!(main);

fn main() {
    cube::run(&MEMORY, ROWS);
}
