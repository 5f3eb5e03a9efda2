//! A map of tiles that scrolls, and sixty sprites over it, in a palette of 16 colours: what a game draws in each frame.
//!
//! `cargo run --release --example sprites` writes `sprites.png`; `-- --frames N --out FILE.gif` (or `.apng`) a film, `-- --window` shows
//! it moving. The tiles and the sprites are small pictures of indices; index 0 of a sprite lets through what is under it.

use std::{error::Error, process::ExitCode};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    fixed::types::I16F16, surface::Sheet, Affine, Angle, Bitmap, Canvas, Framebuffer, Index4, Palette, Pictures,
};
use embedded_raster_simulator::{
    desktop::{Desktop, Options, USAGE},
    finish,
};

const WIDTH: u16 = 160;
const HEIGHT: u16 = 128;
/// Sprites.
const COUNT: i32 = 60;

/// Grass, flowers, water and stones, 8 x 8 pixels of four bits each.
const TILES: [u8; 128] = [
    0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x11, 0x33, 0x33, 0x33, 0x33, 0x78, 0x77, 0x77, 0x87, //
    0x11, 0x21, 0x11, 0x11, 0x11, 0x41, 0x11, 0x11, 0x33, 0x66, 0x33, 0x33, 0x77, 0x77, 0x87, 0x77, //
    0x11, 0x11, 0x11, 0x21, 0x14, 0xe4, 0x11, 0x21, 0x36, 0x33, 0x36, 0x63, 0x87, 0x77, 0x77, 0x78, //
    0x12, 0x11, 0x11, 0x11, 0x11, 0x41, 0x11, 0x11, 0x33, 0x33, 0x33, 0x33, 0x88, 0x88, 0x88, 0x88, //
    0x11, 0x11, 0x12, 0x11, 0x11, 0x11, 0x15, 0x11, 0x63, 0x33, 0x33, 0x36, 0x77, 0x87, 0x77, 0x78, //
    0x11, 0x11, 0x11, 0x11, 0x21, 0x11, 0x5e, 0x51, 0x33, 0x36, 0x63, 0x33, 0x77, 0x77, 0x78, 0x77, //
    0x21, 0x11, 0x11, 0x12, 0x11, 0x11, 0x15, 0x11, 0x33, 0x33, 0x33, 0x33, 0x77, 0x87, 0x77, 0x77, //
    0x11, 0x11, 0x21, 0x11, 0x11, 0x21, 0x11, 0x11, 0x36, 0x63, 0x33, 0x63, 0x88, 0x88, 0x88, 0x88, //
];

/// A bug in two steps, a star and a coin.
const SPRITES: [u8; 128] = [
    0x00, 0x09, 0x90, 0x00, 0x00, 0x09, 0x90, 0x00, 0x00, 0x0a, 0x00, 0x00, 0x00, 0xbb, 0xbb, 0x00, //
    0x00, 0x99, 0x99, 0x00, 0x00, 0x99, 0x99, 0x00, 0x00, 0x0a, 0xa0, 0x00, 0x0b, 0xbe, 0xeb, 0xb0, //
    0x09, 0xe9, 0x9e, 0x90, 0x09, 0xe9, 0x9e, 0x90, 0x00, 0xaa, 0xaa, 0x00, 0xbb, 0xeb, 0xbb, 0xbb, //
    0x99, 0x99, 0x99, 0x99, 0x99, 0x99, 0x99, 0x99, 0xaa, 0xae, 0xea, 0xaa, 0xbb, 0xeb, 0xbb, 0xcb, //
    0x0f, 0xff, 0xff, 0x00, 0x00, 0xff, 0xff, 0x00, 0x0a, 0xae, 0xea, 0xa0, 0xbb, 0xeb, 0xbb, 0xcb, //
    0x9f, 0x00, 0x00, 0xf9, 0x0f, 0x90, 0x09, 0xf0, 0x00, 0xaa, 0xaa, 0x00, 0xbb, 0xbb, 0xbb, 0xcb, //
    0x00, 0xf0, 0x0f, 0x00, 0x0f, 0x00, 0x00, 0xf0, 0x0a, 0xa0, 0x0a, 0xa0, 0x0b, 0xbc, 0xcb, 0xb0, //
    0x0f, 0x00, 0x00, 0xf0, 0x00, 0xf0, 0x0f, 0x00, 0x0a, 0x00, 0x00, 0xa0, 0x00, 0xbb, 0xbb, 0x00, //
];

/// The colours of both.
const PALETTE: Palette<Rgb888, 16> = Palette::new([
    Rgb888::BLACK,
    Rgb888::new(88, 160, 72),
    Rgb888::new(64, 128, 56),
    Rgb888::new(56, 104, 176),
    Rgb888::new(224, 88, 96),
    Rgb888::new(176, 104, 208),
    Rgb888::new(112, 160, 216),
    Rgb888::new(136, 136, 144),
    Rgb888::new(96, 96, 104),
    Rgb888::new(200, 48, 48),
    Rgb888::new(248, 208, 64),
    Rgb888::new(232, 168, 32),
    Rgb888::new(176, 112, 16),
    Rgb888::new(40, 40, 48),
    Rgb888::WHITE,
    Rgb888::new(72, 40, 32),
]);

fn main() -> ExitCode {
    finish("sprites", run(lexopt::Parser::from_env()))
}

fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    match Options::parse("sprites", arguments)? {
        Some(options) => Desktop::new("sprites", (WIDTH, HEIGHT), PALETTE)
            .run(&options, |frame, _, time| draw(frame, time.frame).map_err(Into::into)),
        None => Ok(format!("usage: sprites [--frames N] [--out FILE.png|.apng|.gif] [--window]\n\n{USAGE}")),
    }
}

/// Draws the picture at a time, in frames.
fn draw(frame: &mut Framebuffer<'_, Index4>, time: i32) -> Result<(), embedded_raster::Error> {
    let (ground, actors) = (Bitmap::<Index4>::new(&TILES, 32, 8)?, Bitmap::<Index4>::new(&SPRITES, 32, 8)?);
    let (tiles, sprites) = (Sheet::new(&ground, 8, 8), Sheet::new(&actors, 8, 8));

    // The ground goes by; a map without end, out of a formula.
    let (left, top) = (-time, -time / 2);
    let tile = |column: i32, row: i32| {
        let noise = (column.wrapping_mul(73) ^ row.wrapping_mul(151)).wrapping_mul(2_654_435) >> 8 & 15;
        let river = (row + column / 2).rem_euclid(14) < 3;
        Some(if river {
            2
        } else if noise == 0 {
            1
        } else if noise == 1 {
            3
        } else {
            0
        })
    };
    frame.draw_tile_map((left, top), &tiles, tile, Some);

    let seen = |index: Index4| (index.index() != 0).then_some(index);
    for number in 0..COUNT {
        let at = (number * 67 + time * (1 + number % 3)).rem_euclid(i32::from(WIDTH) + 16) - 12;
        let (_, sin) = Angle::degrees(number * 40 + time * 6).cos_sin();
        let y = (number * 29 + (sin >> 27)).rem_euclid(i32::from(HEIGHT) + 8) - 8;
        match number % 5 {
            // Stars turn around their middle, and grow.
            0 => {
                let middle = I16F16::from_num(4);
                let size = I16F16::from_num(1) + I16F16::from_bits(((time + number * 9) % 64) << 10);
                let map = Affine::translate(-middle, -middle)
                    .then(Affine::scale(size, size))
                    .then(Affine::rotate(Angle::degrees(time * 5 + number * 30)))
                    .then(Affine::translate(I16F16::from_num(at) + middle, I16F16::from_num(y) + middle));
                if let Some(star) = sprites.tile(2) {
                    frame.blit_affine(&map, &star, seen)?;
                }
            }
            // Coins are copied as they are.
            1 => {
                if let Some(coin) = sprites.tile(3) {
                    frame.blit_keyed((at, y), &coin, Index4::new(0));
                }
            }
            // Bugs walk: two steps, eight frames each.
            _ => {
                if let Some(bug) = sprites.tile((time / 8 + number).rem_euclid(2).unsigned_abs() as usize) {
                    frame.blit_mapped((at, y), &bug, seen);
                }
            }
        }
    }
    Ok(())
}
