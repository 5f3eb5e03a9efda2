//! Draws all frames on this computer and prints their checksums, in the form of the programs on the chips.

#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../board/src/crc.rs"]
mod crc;

use embedded_raster::EdgeSlot;
use scene::{EDGES, FRAMES};

fn main() -> Result<(), embedded_raster::Error> {
    for frame in FRAMES {
        let mut memory = vec![0; frame.bytes];
        (frame.draw)(&mut memory, &mut [EdgeSlot::EMPTY; EDGES])?;
        println!("{};{};-;0.0;0;{:08x}", frame.name, frame.format, crc::crc32(&memory));
    }
    Ok(())
}
