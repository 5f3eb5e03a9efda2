//! The visible tiles of a map, at 16 bits.
#![no_std]
#![no_main]

use embedded_raster::surface::Sheet;
use embedded_raster::Pictures;

board::entry!(main);

fn main() {
    size::on_picture(|frame, at, picture| {
        let sheet = Sheet::new(picture, 8, 8);
        frame.draw_tile_map(at, &sheet, |column, row| Some((column ^ row) as usize & 3), Some);
    });
}
