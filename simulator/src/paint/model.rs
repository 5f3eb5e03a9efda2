//! [`Paint`]: a sheet, the settings of the tools, and the sheets of before.

use std::{collections::VecDeque, fmt};

use embedded_graphics_core::pixelcolor::Rgb888;
use embedded_raster::{Error, Palette};

use super::{
    command::{parse, Command, ScriptError},
    sheet::{Ink, Scratch, Sheet},
};
use crate::picture::Picture;

/// Steps that can be undone.
const STEPS: usize = 32;

/// The state of a paint program.
///
/// Undo and redo go by whole sheets: at 320 x 240 pixels of 4 bits, 38,400 bytes and a palette each. Changes of one and the
/// same palette entry in a row are one step. Cycling is no step and does not touch the sheet, only how it is shown and saved.
#[derive(Debug)]
pub struct Paint {
    sheet: Sheet,
    past: VecDeque<Sheet>,
    future: Vec<Sheet>,
    /// The palette entry that the last step changed.
    edited: Option<u8>,
    /// The colour to paint with, cut to the bits of the sheet: it may be one of a deeper sheet of before.
    pub color: u8,
    /// Whether shapes are filled.
    pub filled: bool,
    /// The entries that cycle, both ends included.
    pub range: (u8, u8),
    turns: i64,
    scratch: Scratch,
}

/// What a command did.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Done {
    /// Pixels that have another index now.
    pub pixels: usize,
    /// Slots that a flood fill takes, and how many it was given. With fewer it is slower, and paints the same.
    pub slots: Option<(usize, usize)>,
}

impl fmt::Display for Done {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} px", self.pixels)?;
        match self.slots {
            None => Ok(()),
            Some((taken, given)) if taken <= given => write!(f, ", {taken} of {given} slots"),
            Some((needed, given)) => write!(f, ", {needed} slots needed, {given} given: slower, same pixels"),
        }
    }
}

/// Why a command did nothing.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Failure {
    /// The library says so.
    Draw(Error),
    /// The palette of the sheet has no entry of this number: it has so many.
    NoEntry(u8, usize),
    /// A sheet of so many bits has no colour of this number.
    NoColor(u8, u8),
    /// There is nothing to undo, or to redo.
    NoStep(&'static str),
    /// The file cannot be written, and why.
    Save(String),
}

impl fmt::Display for Failure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Draw(error) => error.fmt(f),
            Self::NoEntry(index, entries) => write!(f, "there is no entry {index} among the {entries} of the palette"),
            Self::NoColor(index, bits) => {
                let (last, plural) = (u8::MAX >> 8_u8.saturating_sub(*bits), if *bits == 1 { "" } else { "s" });
                write!(f, "color {index} is not in 0 to {last}, the colors of {bits} bit{plural}")
            }
            Self::NoStep(what) => write!(f, "nothing to {what}"),
            Self::Save(why) => f.write_str(why),
        }
    }
}

impl std::error::Error for Failure {}

impl Paint {
    /// An empty sheet, white to paint with.
    pub fn new(size: (u16, u16), bits: u8) -> Self {
        Self {
            sheet: Sheet::new(size, bits),
            past: VecDeque::new(),
            future: vec![],
            edited: None,
            color: 15,
            filled: false,
            range: (1, u8::MAX),
            turns: 0,
            scratch: Scratch { slots: 64, edges: 32 },
        }
    }

    /// The picture as it is.
    pub fn sheet(&self) -> &Sheet {
        &self.sheet
    }

    /// Memory for flood fills and polygons.
    pub fn scratch(&self) -> Scratch {
        self.scratch
    }

    /// The palette of the sheet, cycled.
    pub fn shown_palette(&self) -> Palette<Rgb888, 256> {
        let mut palette = self.sheet.palette;
        let (start, end) = (usize::from(self.range.0), (usize::from(self.range.1) + 1).min(self.sheet.colors()));
        if let Some(len) = end.checked_sub(start).and_then(|len| i64::try_from(len).ok()).filter(|&len| len > 0) {
            palette.rotate(start..end, usize::try_from(self.turns.rem_euclid(len)).unwrap_or(0));
        }
        palette
    }

    /// What is shown and saved.
    pub fn picture(&self) -> Picture {
        self.sheet.picture(&self.shown_palette())
    }

    /// Does one thing.
    ///
    /// # Errors
    /// Whatever keeps it from being done. Nothing has changed then.
    pub fn apply(&mut self, command: &Command) -> Result<Done, Failure> {
        match command {
            Command::Color(index) if usize::from(*index) >= self.sheet.colors() => {
                return Err(Failure::NoColor(*index, self.sheet.bits));
            }
            Command::Color(index) => self.color = *index,
            Command::Filled(filled) => self.filled = *filled,
            Command::Range(first, last) => (self.range, self.turns) = ((*first, *last), 0),
            Command::Cycle(steps) => self.turns = self.turns.wrapping_add(i64::from(*steps)),
            Command::Scratch(slots, edges) => self.scratch = Scratch { slots: *slots, edges: *edges },
            Command::Undo => return self.undo(),
            Command::Redo => return self.redo(),
            Command::Save(path) => self.save(path)?,
            _ => {
                let (sheet, slots) = self.changed(command)?;
                let edited = if let Command::Palette(index, _) = command { Some(*index) } else { None };
                return Ok(Done { pixels: self.commit(sheet, edited), slots });
            }
        }
        Ok(Done::default())
    }

    /// The sheet that a command would leave, and the slots of a flood fill.
    ///
    /// # Errors
    /// As [`apply`](Self::apply).
    pub fn changed(&self, command: &Command) -> Result<(Sheet, Option<(usize, usize)>), Failure> {
        let mut sheet = self.sheet.clone();
        match command {
            Command::Size(width, height) => {
                sheet = Sheet { palette: sheet.palette, ..Sheet::new((*width, *height), sheet.bits) };
            }
            Command::Bits(bits) => sheet = Sheet::new(sheet.size, *bits),
            Command::Palette(index, _) if usize::from(*index) >= sheet.colors() => {
                return Err(Failure::NoEntry(*index, sheet.colors()));
            }
            Command::Palette(index, color) => {
                sheet.palette.set(*index, *color);
            }
            _ => {}
        }
        let ink = Ink { color: self.color, filled: self.filled, scratch: self.scratch };
        let slots = sheet.draw(command, ink).map_err(Failure::Draw)?;
        let slots =
            matches!(command, Command::Fill(_)).then(|| (self.slots_needed(command, ink, slots), ink.scratch.slots));
        Ok((sheet, slots))
    }

    /// How many slots a flood fill would have taken if there had been enough.
    fn slots_needed(&self, command: &Command, ink: Ink, taken: usize) -> usize {
        if taken < ink.scratch.slots {
            return taken;
        }
        let slots = usize::from(self.sheet.size.0) * usize::from(self.sheet.size.1);
        let ink = Ink { scratch: Scratch { slots, ..ink.scratch }, ..ink };
        self.sheet.clone().draw(command, ink).unwrap_or(taken)
    }

    /// Makes a changed sheet the current one: a step, unless nothing differs or it goes on with the palette entry of the last.
    fn commit(&mut self, sheet: Sheet, edited: Option<u8>) -> usize {
        if edited.is_some() {
            self.turns = 0;
        }
        if sheet == self.sheet {
            return 0;
        }
        let pixels = sheet.differing(&self.sheet);
        let before = std::mem::replace(&mut self.sheet, sheet);
        if edited.is_none() || edited != self.edited {
            self.past.push_back(before);
        }
        if self.past.len() > STEPS {
            self.past.pop_front();
        }
        self.future.clear();
        self.edited = edited;
        pixels
    }

    fn undo(&mut self) -> Result<Done, Failure> {
        let sheet = self.past.pop_back().ok_or(Failure::NoStep("undo"))?;
        let (pixels, newer) = self.swap(sheet);
        self.future.push(newer);
        Ok(Done { pixels, slots: None })
    }

    fn redo(&mut self) -> Result<Done, Failure> {
        let sheet = self.future.pop().ok_or(Failure::NoStep("redo"))?;
        let (pixels, older) = self.swap(sheet);
        self.past.push_back(older);
        Ok(Done { pixels, slots: None })
    }

    fn swap(&mut self, sheet: Sheet) -> (usize, Sheet) {
        self.edited = None;
        (sheet.differing(&self.sheet), std::mem::replace(&mut self.sheet, sheet))
    }

    fn save(&self, path: &str) -> Result<(), Failure> {
        self.picture().write_png(path).map_err(|error| Failure::Save(error.to_string()))
    }
}

/// What a script did.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub struct Summary {
    /// Commands that were carried out.
    pub commands: usize,
    /// Pixels that changed, by all of them together.
    pub pixels: usize,
    /// Slots that the largest flood fill takes.
    pub slots: usize,
}

/// Runs a script. Nothing is run of one with a line that is no command.
///
/// # Errors
/// The line that is wrong, or whose command failed: what came before it is done then.
pub fn replay(script: &str, paint: &mut Paint) -> Result<Summary, ScriptError> {
    let mut summary = Summary::default();
    for (line, command) in parse(script)? {
        let done = paint.apply(&command).map_err(|error| ScriptError { line, problem: error.to_string() })?;
        summary.commands += 1;
        summary.pixels += done.pixels;
        summary.slots = summary.slots.max(done.slots.map_or(0, |(needed, _)| needed));
    }
    Ok(summary)
}
