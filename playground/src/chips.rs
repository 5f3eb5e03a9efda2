//! The frames that the firmwares of `firmware/` draw on chips, and their checksums there: `cargo xtask scene` compares chips with this
//! computer, and the page in the browser is compared with the same.

use embedded_raster::EdgeSlot;
use scene::moving::{Failed, Moving, Plasma, Scope, LINE, PLASMA_BYTES, SCOPE_BYTES};
use scene::{cube, cube_bytes, draw_cube, EDGES, FRAMES, MOMENTS};

use crate::crc::{crc32, crc32_with};

/// Bytes of memory that the frames take.
pub const BYTES: usize = 2 * SCOPE_BYTES + 2 * cube_bytes(cube::HEIGHT) + PLASMA_BYTES + 320 * 240 * 2;

/// Draws all of them, and calls `tell` with the name, the number among those of that name, and the checksum of each.
///
/// # Errors
/// `memory` is shorter than [`BYTES`].
pub fn draw(memory: &mut [u8], mut tell: impl FnMut(&str, u32, u32)) -> Result<(), Failed> {
    for (number, frame) in (0..).zip(FRAMES) {
        (frame.draw)(memory, &mut [EdgeSlot::EMPTY; EDGES]).map_err(|_| Failed)?;
        tell(frame.name, number, crc32(memory.get(..frame.bytes).unwrap_or(memory)));
    }
    let (colors, depths) = memory.split_at_mut(cube_bytes(cube::HEIGHT).min(memory.len()));
    for moment in 0..MOMENTS {
        let mut sum = 0;
        draw_cube(moment, cube::HEIGHT, colors, depths, |rows| sum = crc32_with(sum, rows)).map_err(|_| Failed)?;
        tell("cube", moment.into(), sum);
    }
    let mut line = [0; LINE];
    move_on("plasma", Plasma::new(memory, &mut line)?, &mut tell)?;
    let (first, second) = memory.split_at_mut(SCOPE_BYTES.min(memory.len()));
    let (second, _) = second.split_at_mut(SCOPE_BYTES.min(second.len()));
    move_on("scope", Scope::new([first, second], &mut line), &mut tell)
}

/// Frame after frame.
fn move_on(name: &str, mut scene: impl Moving, tell: &mut impl FnMut(&str, u32, u32)) -> Result<(), Failed> {
    for number in 0..scene::moving::FRAMES {
        scene.draw()?;
        let mut sum = 0;
        scene.whole(|row| sum = crc32_with(sum, row));
        tell(name, number, sum);
    }
    Ok(())
}
