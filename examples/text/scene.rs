//! The page: lines at all sides, a text in a box, a table by tabs. No heap: a chip draws it with this same code.
#![allow(unreachable_pub, reason = "other programs have this scene as a module of a library")]

use embedded_raster::{
    text::{Font, Horizontal, Style, Vertical, FONT_6X10},
    Canvas, Index4, Rect, Surface,
};

/// Columns of the page, upright.
pub const WIDTH: u16 = 240;
/// Rows of the page, upright.
pub const HEIGHT: u16 = 160;

/// The page, with a large text in a font of its own: any surface will do.
pub fn page(on: &mut impl Surface<Color = Index4>, font: &Font<'_>, text: &str) {
    let color = Index4::new;
    let small = Style::new(&FONT_6X10, color(7));
    on.fill_window(color(1));

    // Each corner and side holds a line that is aligned to it.
    let (right, bottom) = (i32::from(WIDTH) - 1, i32::from(HEIGHT) - 1);
    let columns = [(0, Horizontal::Left), (right / 2, Horizontal::Center), (right, Horizontal::Right)];
    for (x, horizontal) in columns {
        small.horizontal(horizontal).vertical(Vertical::Top).draw(on, (x, 0), "top");
        small.horizontal(horizontal).vertical(Vertical::Bottom).draw(on, (x, bottom), "bottom");
    }

    // A box around a text: as large as the text says that it is.
    let label = Style::new(font, color(0)).opaque(color(14)).horizontal(Horizontal::Center).vertical(Vertical::Middle);
    let at = (right / 2, 44);
    on.draw_rectangle(label.bounds(at, text).inset(-3), color(12));
    label.draw(on, at, text);

    // Columns by tabs, lines further apart than the font asks for.
    let table = Style::new(&FONT_6X10, color(11)).line_height(12).tab(60);
    table.draw(on, (10, 92), "\tmin\tmax\ntemp.\t-4 °C\t31 °C\nlength\t2 µm\t9 µm");
    on.fill_rectangle(Rect::new(10, 95, 200, 96), color(8));

    // A character that the font lacks.
    small.color(color(10)).horizontal(Horizontal::Center).draw(on, (right / 2, 134), "one the font lacks: \u{1f600}");
}
