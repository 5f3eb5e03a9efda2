//! One arc at 16 bits.
#![no_std]
#![no_main]

use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{Angle, Canvas, Sector};

board::entry!(main);

fn main() {
    size::on_frame::<Rgb565>(|frame| {
        let area = size::area();
        let sector = Sector::new(Angle::from_bits(area.x0.unsigned_abs()), Angle::from_bits(area.x1.unsigned_abs()));
        frame.draw_arc(area, sector, size::color::<Rgb565>());
    });
}
