//! Draws the scenes of which bands are measured on this computer, at once, and prints the checksums, in the form of the programs on the
//! chips.

#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../board/src/crc.rs"]
mod crc;

use embedded_raster::EdgeSlot;
use scene::bands::BANDED;
use scene::{EDGES, HEIGHT};

fn main() -> Result<(), embedded_raster::Error> {
    for scene in BANDED {
        let mut memory = vec![0; (scene.memory)(HEIGHT)];
        (scene.draw)(&mut memory, 0..HEIGHT, &mut [EdgeSlot::EMPTY; EDGES])?;
        let crc32 = crc::crc32(&memory[..(scene.pixels)(HEIGHT)]);
        println!("{};{};-;0.0;0;{crc32:08x}", scene.name, scene.format);
    }
    Ok(())
}
