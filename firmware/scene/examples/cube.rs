//! Draws the cube at all moments on this computer and prints the checksums, in the form of the programs on the chips.

#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../board/src/crc.rs"]
mod crc;

use scene::{cube, cube_bytes, draw_cube, MOMENTS};

fn main() -> Result<(), embedded_raster::Error> {
    let (mut colors, mut depths) = (vec![0; cube_bytes(cube::HEIGHT)], vec![0; cube_bytes(cube::HEIGHT)]);
    for moment in 0..MOMENTS {
        let mut crc32 = 0;
        draw_cube(moment, cube::HEIGHT, &mut colors, &mut depths, |rows| crc32 = crc::crc32_with(crc32, rows))?;
        println!("cube-{moment};rgb565;-;0.0;0;{crc32:08x}");
    }
    Ok(())
}
