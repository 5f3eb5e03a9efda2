//! What the window shows around the sheet, and where it is.
//! ```text
//!   +--------------------+
//!   | buttons, two rows  |   a click on a button is the key that stands on it
//!   | sheet              |
//!   | palette            |   a click chooses the colour; R, G, B change it, with shift downwards
//!   | status, two lines  |   tool and colour; what the last command did, or why it failed
//!   +--------------------+
//! ```

use embedded_graphics::{
    draw_target::DrawTarget,
    geometry::Point,
    mono_font::{ascii::FONT_5X8, MonoTextStyle},
    pixelcolor::{Rgb888, RgbColor},
    text::{Baseline, Text},
    Drawable,
};
use embedded_raster::{buffer_bytes, Canvas, Framebuffer, Radii, Rect, Surface};

use super::Desk;
use crate::{
    paint::sheet::Sheet,
    picture::Picture,
    window::{Key, Shot},
};

/// Keys and what stands on their buttons.
pub(super) const BUTTONS: [(Key, &str); 12] = [
    (Key::Key1, "1 Pencil"),
    (Key::Key2, "2 Line"),
    (Key::Key3, "3 Ellipse"),
    (Key::Key4, "4 Rect"),
    (Key::Key5, "5 Polygon"),
    (Key::Key6, "6 Fill"),
    (Key::O, "O Filled"),
    (Key::U, "U Undo"),
    (Key::Y, "Y Redo"),
    (Key::C, "C Cycle"),
    (Key::N, "N Clear"),
    (Key::S, "S Save"),
];

/// All in pixels of the picture.
const BUTTON_WIDTH: i32 = 53;
const BUTTON_HEIGHT: i32 = 12;
const TOP: i32 = 2 * BUTTON_HEIGHT;
const PALETTE_HEIGHT: i32 = 16;
const LINE_HEIGHT: i32 = 10;
/// What two rows of six buttons take.
const LEAST_WIDTH: i32 = 6 * BUTTON_WIDTH + 2;
impl Desk {
    /// What the window shows, and what its title says of it.
    pub fn shot(&self) -> Shot {
        let Sheet { size: (width, height), bits, ram, .. } = self.paint.sheet();
        let caption = format!("{width} x {height} at {bits} bits");
        Shot { picture: self.picture(), caption, ram: ram.len(), drawn: self.drawn }
    }

    fn picture(&self) -> Picture {
        let palette = self.paint.shown_palette();
        let preview = self.shape().and_then(|shape| self.paint.changed(&shape).ok());
        let sheet = preview.map_or_else(|| self.paint.picture(), |(sheet, _)| sheet.picture(&palette));
        let layout = Layout::of(self.paint.sheet());
        let mut ram = vec![0; buffer_bytes::<Rgb888>(layout.width, layout.height)];
        let mut screen = Framebuffer::<Rgb888>::new(&mut ram, layout.width, layout.height).expect("it has its bytes");
        let Ok(()) = screen.fill_contiguous(&layout.sheet.into(), sheet.colors());
        self.draw_buttons(&mut screen);
        for index in 0..=u8::MAX {
            screen.fill_area(layout.swatch(index), palette.get(index).unwrap_or_default());
        }
        let Rect { x0, y0, x1, y1 } = layout.swatch(self.color());
        screen.draw_rounded(Rect::new(x0, y0, x1, y1), Radii::all(0), Rgb888::WHITE);
        if layout.grid.1 == 1 {
            screen.draw_rounded(Rect::new(x0 + 1, y0 + 1, x1 - 1, y1 - 1), Radii::all(0), Rgb888::BLACK);
        }
        let [x, y] = [0, layout.swatches.y1];
        write(&mut screen, Point::new(x, y + 1), &self.status(), Rgb888::WHITE);
        write(&mut screen, Point::new(x, y + 1 + LINE_HEIGHT), &self.note, Rgb888::YELLOW);
        Picture::of(&screen)
    }

    fn draw_buttons(&self, screen: &mut Framebuffer<'_, Rgb888>) {
        let (down, up) = (Rgb888::new(200, 120, 40), Rgb888::new(64, 72, 80));
        for (i, ((key, label), area)) in BUTTONS.into_iter().zip(buttons()).enumerate() {
            let is_down = match key {
                Key::O => self.paint.filled,
                Key::C => self.is_cycling,
                _ => i == self.tool as usize,
            };
            let inner = Rect::new(area.x0, area.y0, area.x1 - 1, area.y1 - 1);
            screen.fill_rounded(inner, Radii::all(2), if is_down { down } else { up });
            write(screen, Point::new(area.x0 + 3, area.y0 + 2), label, Rgb888::WHITE);
        }
    }

    fn status(&self) -> String {
        let (index, (first, last)) = (self.color(), self.paint.range);
        let last = usize::from(last).min(self.paint.sheet().colors() - 1);
        let c = self.paint.sheet().palette.get(index).unwrap_or_default();
        let [r, g, b] = [c.r(), c.g(), c.b()];
        format!("color {index}: R {r} G {g} B {b}  cycle {first} to {last}")
    }
}

fn write(screen: &mut Framebuffer<'_, Rgb888>, at: Point, text: &str, color: Rgb888) {
    let style = MonoTextStyle::new(&FONT_5X8, color);
    let Ok(_) = Text::with_baseline(text, at, style, Baseline::Top).draw(screen);
}

/// Where buttons are.
pub(super) fn buttons() -> impl Iterator<Item = Rect> {
    (0..12).map(|i| {
        let (x, y) = (1 + i % 6 * BUTTON_WIDTH, i / 6 * BUTTON_HEIGHT);
        Rect::new(x, y, x + BUTTON_WIDTH, y + BUTTON_HEIGHT)
    })
}

/// Where the rest is.
pub(super) struct Layout {
    width: u16,
    height: u16,
    pub(super) sheet: Rect,
    swatches: Rect,
    /// Swatches in a row, and rows of them.
    grid: (i32, i32),
}

impl Layout {
    pub(super) fn of(sheet: &Sheet) -> Self {
        let (width, bottom) = (i32::from(sheet.size.0).max(LEAST_WIDTH), TOP + i32::from(sheet.size.1));
        let grid = if sheet.bits == 8 { (64, 4) } else { (1 << sheet.bits, 1) };
        let side = |n: i32| u16::try_from(n).expect("a sheet is small");
        Self {
            width: side(width),
            height: side(bottom + PALETTE_HEIGHT + 2 * LINE_HEIGHT),
            sheet: Rect::new(0, TOP, sheet.size.0.into(), bottom),
            swatches: Rect::new(0, bottom, width, bottom + PALETTE_HEIGHT),
            grid,
        }
    }

    /// Where an entry of the palette is; empty if the sheet does not have it.
    pub(super) fn swatch(&self, index: u8) -> Rect {
        let (columns, rows) = self.grid;
        let (column, row) = (i32::from(index) % columns, i32::from(index) / columns);
        if row >= rows {
            return Rect::default();
        }
        let x = |column: i32| column * self.swatches.x1 / columns;
        let y = |row: i32| self.swatches.y0 + row * PALETTE_HEIGHT / rows;
        Rect::new(x(column), y(row), x(column + 1), y(row + 1))
    }
}
