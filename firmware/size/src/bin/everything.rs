//! Everything that draws, at 16 bits: all calls of the list that the proofs take, with tables in static memory.
#![no_std]
#![no_main]

use core::hint::black_box;

use calls::{call, Arguments};
use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::fixed::types::I24F8;
use embedded_raster::pixel::Lsb0;
use embedded_raster::{Angle, Bitmap, Ellipse, Index1, PathSegment, PointFx, Radii, Rect, Sector, Stroke};

board::entry!(main);

fn main() {
    size::on_frame_and_tables::<Rgb565>(|frame, table, slots| {
        static PICTURE: [u8; 2 * 16 * 16] = [7; 2 * 16 * 16];
        let [a, b, c] = size::corners();
        let [at, end] = size::points();
        let Ok(picture) = Bitmap::<Rgb565>::new(black_box(&PICTURE), 16, 16) else { return };
        let Ok(mask) = Bitmap::<Lsb0<Index1>>::new(black_box(&PICTURE), 16, 16) else { return };
        let Ok(mask_msb0) = Bitmap::<Index1>::new(black_box(&PICTURE), 16, 16) else { return };
        let mut out = [0; 16];
        let (line, triangle) = ([at, end], [a, b, c]);
        let segments = [PathSegment::MoveTo(PointFx::px(1, 2)), PathSegment::LineTo(a)];
        let mut arguments = black_box(Arguments {
            points: [at, end, at],
            places: [a, b, c, a],
            areas: [size::area(); 2],
            ellipses: [Ellipse::in_box(Rect::new(0, 0, 90, 60)); 2],
            size: I24F8::ONE,
            radii: Radii::all(9),
            sector: Sector::new(Angle::degrees(20), Angle::degrees(200)),
            corners: &line,
            contour: &triangle,
            segments: &segments,
            stroke: Stroke::px(5),
            dashes: &[I24F8::ONE],
            phase: I24F8::ZERO,
            flag: true,
            table,
            slots,
            colors: [size::color::<Rgb565>(); 2],
            picture,
            mask,
            mask_msb0,
            window: size::area(),
            numbers: [at.x, at.y, end.x, end.y, 3, 4],
            bytes: black_box(&PICTURE),
            out: &mut out,
            starts: &[2],
            sides: &mut [],
            triangles: &mut [],
            neighbours: &mut [],
        });
        // One of them, which is not known either: all have to be there.
        black_box(call(frame, &mut arguments, black_box(0)));
    });
}
