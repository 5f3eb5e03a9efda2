//! The page: a thermostat with text, round shapes, a curve and small pictures. Any surface will do, and so does any part of one.

use embedded_raster::{
    text::{Horizontal, Style, Vertical, FONT_6X10, FONT_8X13},
    Angle, Bitmap, Canvas, Error, Index1, Index4, Rect, Sector, Surface,
};

/// Columns of the page, upright.
pub(crate) const WIDTH: u16 = 120;
/// Rows of the page, upright.
pub(crate) const HEIGHT: u16 = 80;

/// A flame, 8 x 8 pixels of one bit.
const FLAME: [u8; 8] = [0x10, 0x18, 0x3c, 0x5c, 0xfe, 0xee, 0xc6, 0x7c];

/// A battery that is half full, 8 x 5 pixels of four bits each.
const BATTERY: [u8; 20] = [
    0xff, 0xff, 0xff, 0xf0, //
    0xfa, 0xa8, 0x88, 0xff, //
    0xfa, 0xa8, 0x88, 0xff, //
    0xfa, 0xa8, 0x88, 0xff, //
    0xff, 0xff, 0xff, 0xf0, //
];

/// What was measured in the last hours, in pixels above the lowest value.
const HISTORY: [i32; 13] = [3, 2, 2, 1, 4, 9, 13, 16, 17, 15, 16, 18, 17];

/// Draws the page, with a temperature in tenths of a degree.
pub(crate) fn draw(on: &mut impl Surface<Color = Index4>, tenths: i32) -> Result<(), Error> {
    let color = Index4::new;
    on.fill_window(color(0));

    // The bar at the top: text, a picture with a colour that lets through, and text that ends at the right.
    on.fill_area(Rect::new(0, 0, WIDTH.into(), 13), color(1));
    let bar = Style::new(&FONT_6X10, color(15)).vertical(Vertical::Top);
    bar.draw(on, (3, 1), "Kitchen");
    on.blit_keyed((78, 4), &Bitmap::<Index4>::new(&BATTERY, 8, 5)?, color(0));
    bar.horizontal(Horizontal::Right).draw(on, (117, 1), "9:41");

    // The dial: from 10 to 30 degrees over three quarters of a turn, from the lower left clockwise.
    let (outer, inner) = (Rect::new(4, 18, 62, 76), Rect::new(12, 26, 54, 68));
    let at = |tenths: i32| Angle::degrees(135 + (tenths - 100).clamp(0, 200) * 27 / 20);
    on.fill_gauge(outer, inner, Sector::new(at(100), at(300)), color(8));
    on.fill_gauge(outer, inner, Sector::new(at(100), at(tenths)), color(12));
    let value = format!("{}.{}", tenths / 10, tenths % 10);
    let large = Style::new(&FONT_8X13, color(14)).horizontal(Horizontal::Center).vertical(Vertical::Middle);
    large.draw(on, (33, 46), &value);
    on.blit_mask((29, 56), &Bitmap::<Index1>::new(&FLAME, 8, 8)?, color(12), None);

    // The curve, and what it means.
    let curve = (70..).step_by(4).zip(HISTORY.map(|value| 48 - value));
    on.draw_line((68, 28), (68, 50), color(7));
    on.draw_line((68, 50), (118, 50), color(7));
    on.draw_polyline(curve, color(11));
    Style::new(&FONT_6X10, color(7)).vertical(Vertical::Top).draw(on, (70, 54), "12 hours\nheating");
    Ok(())
}
