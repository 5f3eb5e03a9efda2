//! [`Desk`]: what the window shows around the sheet, and which commands keys and mouse are.
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

use super::{command::Command, model::Paint, sheet::Sheet};
use crate::{
    picture::Picture,
    window::{Event, Key, Shot},
};

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Tool {
    Pencil,
    Line,
    Ellipse,
    Rectangle,
    Polygon,
    Fill,
}

/// Keys and what stands on their buttons.
const BUTTONS: [(Key, &str); 12] = [
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
/// Sixtieths of a second between two turns of the palette.
const CYCLE_TICKS: u32 = 6;

/// An interactive paint program, without the window.
#[derive(Debug)]
pub struct Desk {
    paint: Paint,
    tool: Tool,
    /// Of the shape that is being drawn; the last one goes with the mouse.
    points: Vec<Point>,
    is_cycling: bool,
    ticks: u32,
    /// Pixels changed so far.
    drawn: u64,
    note: String,
    file: String,
}

impl Desk {
    /// A desk with a picture that is saved as `file`.
    pub fn new(paint: Paint, file: impl Into<String>) -> Self {
        let note = "right click or Enter closes polygons, Backspace drops, [ ] cycle".into();
        let (tool, points, file) = (Tool::Pencil, vec![], file.into());
        Self { paint, tool, points, is_cycling: false, ticks: 0, drawn: 0, note, file }
    }

    /// The picture and its tools.
    pub fn paint(&self) -> &Paint {
        &self.paint
    }

    /// Takes in what was done since the last call, a sixtieth of a second ago. Says whether the window looks different.
    pub fn go(&mut self, events: &[Event]) -> bool {
        for &event in events {
            if let Some(command) = self.command(event) {
                self.apply(&command);
            }
        }
        self.ticks = self.ticks.wrapping_add(1);
        let turns = self.is_cycling && self.ticks.is_multiple_of(CYCLE_TICKS);
        if turns {
            self.apply(&Command::Cycle(1));
        }
        turns || !events.is_empty()
    }

    /// Carries a command out; what it did, or why it failed, is in the status.
    pub fn apply(&mut self, command: &Command) {
        match self.paint.apply(command) {
            Ok(done) => {
                self.drawn += done.pixels as u64;
                match command {
                    Command::Cycle(_) | Command::Color(_) => {}
                    Command::Save(file) => self.note = format!("saved {file}"),
                    _ => self.note = done.to_string(),
                }
            }
            Err(failure) => self.note = failure.to_string(),
        }
    }

    /// The command that an event is, if it completes one.
    pub fn command(&mut self, event: Event) -> Option<Command> {
        match event {
            Event::Key(key, has_shift) => self.key(key, has_shift),
            Event::Press(at) => self.press(at),
            Event::Move(at) => {
                self.drag(self.on_sheet(at));
                None
            }
            Event::Release(at) if self.tool != Tool::Polygon && !self.points.is_empty() => {
                self.drag(self.on_sheet(at));
                self.finish()
            }
            Event::Release(_) => None,
            Event::Menu(_) => self.close(),
        }
    }

    fn key(&mut self, key: Key, has_shift: bool) -> Option<Command> {
        let color = self.color();
        match key {
            Key::Key1 => self.take(Tool::Pencil),
            Key::Key2 => self.take(Tool::Line),
            Key::Key3 => self.take(Tool::Ellipse),
            Key::Key4 => self.take(Tool::Rectangle),
            Key::Key5 => self.take(Tool::Polygon),
            Key::Key6 => self.take(Tool::Fill),
            Key::Enter => return self.close(),
            Key::Backspace => self.points.clear(),
            Key::C => self.is_cycling = !self.is_cycling,
            Key::O => return Some(Command::Filled(!self.paint.filled)),
            Key::U => return Some(Command::Undo),
            Key::Y => return Some(Command::Redo),
            Key::N => return Some(Command::Clear),
            Key::S => return Some(Command::Save(self.file.clone())),
            Key::Left => return Some(Command::Color(self.neighbour(color, -1))),
            Key::Right => return Some(Command::Color(self.neighbour(color, 1))),
            Key::LeftBracket => return Some(Command::Range(color, color.max(self.paint.range.1))),
            Key::RightBracket => return Some(Command::Range(color.min(self.paint.range.0), color)),
            Key::R | Key::G | Key::B => return Some(self.recolored(color, key, has_shift)),
            _ => {}
        }
        None
    }

    fn take(&mut self, tool: Tool) {
        self.tool = tool;
        self.points.clear();
    }

    /// The colour to paint with, as the sheet cuts it.
    #[expect(clippy::cast_possible_truncation, reason = "below 256")]
    fn color(&self) -> u8 {
        (usize::from(self.paint.color) % self.paint.sheet().colors()) as u8
    }

    fn neighbour(&self, color: u8, step: i8) -> u8 {
        color.wrapping_add_signed(step) & u8::MAX >> (8 - self.paint.sheet().bits)
    }

    /// A channel of a palette entry a fifteenth up or down.
    fn recolored(&self, index: u8, channel: Key, down: bool) -> Command {
        let step = |value: u8, key: Key| match (key == channel, down) {
            (false, _) => value,
            (true, false) => value.saturating_add(17),
            (true, true) => value.saturating_sub(17),
        };
        let c = self.paint.sheet().palette.get(index).unwrap_or_default();
        Command::Palette(index, Rgb888::new(step(c.r(), Key::R), step(c.g(), Key::G), step(c.b(), Key::B)))
    }

    fn press(&mut self, at: Point) -> Option<Command> {
        let layout = Layout::of(self.paint.sheet());
        if layout.sheet.contains(at.x, at.y) {
            let at = self.on_sheet(at);
            match self.tool {
                Tool::Fill => return Some(Command::Fill(at)),
                // The corner so far stays; another one goes with the mouse.
                Tool::Polygon if !self.points.is_empty() => self.points.push(at),
                _ => self.points = vec![at, at],
            }
            return None;
        }
        if let Some((key, _)) =
            BUTTONS.into_iter().zip(buttons()).find(|(_, area)| area.contains(at.x, at.y)).map(|b| b.0)
        {
            return self.key(key, false);
        }
        (0..=u8::MAX).find(|&index| layout.swatch(index).contains(at.x, at.y)).map(Command::Color)
    }

    /// A place of the window as one of the sheet.
    fn on_sheet(&self, at: Point) -> Point {
        let Rect { x0, y0, .. } = Layout::of(self.paint.sheet()).sheet;
        at - Point::new(x0, y0)
    }

    fn drag(&mut self, at: Point) {
        match (self.tool, self.points.last_mut()) {
            (_, None) => {}
            (Tool::Pencil, Some(&mut last)) if last != at => self.points.push(at),
            (_, Some(last)) => *last = at,
        }
    }

    /// The shape that is being drawn.
    fn shape(&self) -> Option<Command> {
        let &[first, .., last] = self.points.as_slice() else { return None };
        Some(match self.tool {
            Tool::Line => Command::Line([first, last]),
            Tool::Ellipse => Command::Ellipse([first, last]),
            Tool::Rectangle => Command::Rectangle([first, last]),
            _ => Command::Pencil(self.points.clone()),
        })
    }

    fn finish(&mut self) -> Option<Command> {
        let shape = self.shape();
        self.points.clear();
        shape
    }

    /// Closes a polygon: its corners are those that were clicked on, without the one that goes with the mouse.
    fn close(&mut self) -> Option<Command> {
        if self.tool != Tool::Polygon {
            return None;
        }
        let mut corners = std::mem::take(&mut self.points);
        corners.pop();
        if corners.len() < 3 {
            self.note = format!("{} corners instead of at least 3", corners.len());
            return None;
        }
        Some(Command::Polygon(corners))
    }

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
        screen.draw_rounded(Rect::new(x0 + 1, y0 + 1, x1 - 1, y1 - 1), Radii::all(0), Rgb888::BLACK);
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
fn buttons() -> impl Iterator<Item = Rect> {
    (0..12).map(|i| {
        let (x, y) = (1 + i % 6 * BUTTON_WIDTH, i / 6 * BUTTON_HEIGHT);
        Rect::new(x, y, x + BUTTON_WIDTH, y + BUTTON_HEIGHT)
    })
}

/// Where the rest is.
struct Layout {
    width: u16,
    height: u16,
    sheet: Rect,
    swatches: Rect,
    /// Swatches in a row, and rows of them.
    grid: (i32, i32),
}

impl Layout {
    fn of(sheet: &Sheet) -> Self {
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
    fn swatch(&self, index: u8) -> Rect {
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
