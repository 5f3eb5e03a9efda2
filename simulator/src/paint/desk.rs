//! [`Desk`]: a paint program in a window, without the window: which commands keys and mouse are.

mod screen;

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Rgb888, RgbColor},
};
use embedded_raster::Rect;
use screen::{buttons, Layout, BUTTONS};

use super::{command::Command, model::Paint};
use crate::window::{Event, Key};

#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Tool {
    Pencil,
    Line,
    Ellipse,
    Rectangle,
    Polygon,
    Fill,
}

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
        let note = "Enter or a right click closes polygons, Backspace drops them".into();
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
        // A mouse that only passes by changes nothing: frames saved are clicks not missed.
        turns || !self.points.is_empty() || events.iter().any(|event| !matches!(event, Event::Move(_)))
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
                Tool::Polygon if !self.points.is_empty() => {
                    self.drag(at);
                    self.points.push(at);
                }
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
        let corners = self.points.len().saturating_sub(1);
        if corners < 3 {
            self.note = format!("{corners} corners instead of at least 3");
            return None;
        }
        let mut corners = std::mem::take(&mut self.points);
        corners.pop();
        Some(Command::Polygon(corners))
    }
}
