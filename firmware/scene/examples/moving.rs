//! Draws the frames of the scenes that move on this computer and prints the checksums, in the form of the programs on the chips.

#[expect(unreachable_pub, reason = "it is public in its own crate")]
#[path = "../../board/src/crc.rs"]
mod crc;

use scene::moving::{Moving, Plasma, Scope, FRAMES, LINE, PLASMA_BYTES, SCOPE_BYTES};

fn run(name: &str, mut scene: impl Moving) -> Result<(), embedded_raster::Error> {
    for frame in 0..FRAMES {
        scene.next(|_| ())?;
        let mut crc32 = 0;
        scene.whole(|row| crc32 = crc::crc32_with(crc32, row));
        println!("{name}-{frame};{};-;0.0;0;{crc32:08x}", scene.format());
    }
    Ok(())
}

fn main() -> Result<(), embedded_raster::Error> {
    let (mut pixels, mut line) = (vec![0; PLASMA_BYTES], vec![0; LINE]);
    run("plasma", Plasma::new(&mut pixels, &mut line)?)?;
    let mut buffers = [vec![0; SCOPE_BYTES], vec![0; SCOPE_BYTES]];
    let [first, second] = &mut buffers;
    run("scope", Scope::new([first, second], &mut line))
}
