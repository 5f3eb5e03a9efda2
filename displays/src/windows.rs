//! [`Windows`]: areas of a frame, each as the controller's commands for a window, and then its pixels.

use embedded_raster::Rect;

use crate::{
    pieces::Pieces,
    transfer::{Transfer, Transfers},
};

/// What a controller is told.
pub(crate) enum Say {
    /// A command, and so many bytes of parameters.
    Command(&'static [u8], [u8; PARAMETERS], usize),
    /// The command that pixels follow.
    Pixels(&'static [u8]),
    /// Nothing more for this window.
    End,
}

/// The most bytes that a command has.
pub(crate) const PARAMETERS: usize = 9;

impl Say {
    /// A command with all of its parameters.
    pub(crate) fn command<const N: usize>(command: &'static [u8], parameters: [u8; N]) -> Self {
        const { assert!(N <= PARAMETERS, "room for all of them") };
        let mut all = [0; PARAMETERS];
        all.iter_mut().zip(parameters).for_each(|(place, byte)| *place = byte);
        Self::Command(command, all, N)
    }
}

/// The transfers of some areas. `say` gives the commands for a window by their number.
pub(crate) struct Windows<I, P, S> {
    areas: I,
    pieces: P,
    say: S,
    /// The window that is sent, and the rows of its area that come in further ones.
    window: Rect,
    rest: Rect,
    /// The number of the next command; `None` between windows.
    command: Option<usize>,
    /// Whether it is the pixels' turn.
    is_open: bool,
    parameters: [u8; PARAMETERS],
}

impl<I: Iterator<Item = Rect>, P: Pieces, S: Fn(usize, Rect) -> Say> Windows<I, P, S> {
    pub(crate) fn new(areas: impl IntoIterator<IntoIter = I>, pieces: P, say: S) -> Self {
        let (areas, window, rest) = (areas.into_iter(), Rect::default(), Rect::default());
        // What has been started is sent without a window.
        let is_open = !pieces.is_done();
        Self { areas, pieces, say, window, rest, command: None, is_open, parameters: [0; PARAMETERS] }
    }

    /// Begins with the next window, with its first command. `None` after the last.
    fn open(&mut self) -> Option<usize> {
        while self.rest.is_empty() {
            self.rest = self.pieces.cover(self.areas.next()?);
        }
        let end = self.rest.y0.saturating_add(self.pieces.rows_together(self.rest)).min(self.rest.y1);
        self.window = Rect { y1: end, ..self.rest };
        self.rest.y0 = end;
        self.pieces.start(self.window);
        Some(0)
    }
}

impl<I: Iterator<Item = Rect>, P: Pieces, S: Fn(usize, Rect) -> Say> Transfers for Windows<I, P, S> {
    fn next(&mut self) -> Option<Transfer<'_>> {
        if self.is_open && !self.pieces.is_done() {
            return Some(Transfer { command: &[], data: self.pieces.next() });
        }
        self.is_open = false;
        loop {
            let number = self.command.or_else(|| self.open())?;
            let next = Some(number.saturating_add(1));
            match (self.say)(number, self.window) {
                Say::Command(command, parameters, count) => {
                    (self.command, self.parameters) = (next, parameters);
                    return Some(Transfer { command, data: self.parameters.get(..count).unwrap_or_default() });
                }
                Say::Pixels(command) => {
                    (self.command, self.is_open) = (next, true);
                    return Some(Transfer { command, data: self.pieces.next() });
                }
                Say::End => self.command = None,
            }
        }
    }
}

/// The ends of a range of columns or rows, both inside, the high byte first; `from` is added.
pub(crate) fn ends(start: i32, end: i32, from: u16) -> [u8; 4] {
    let [a, b] = [start, end.saturating_sub(1)].map(|n| number(n).saturating_add(from).to_be_bytes());
    [a[0], a[1], b[0], b[1]]
}

/// A coordinate of a screen in 16 bits.
pub(crate) fn number(n: i32) -> u16 {
    u16::try_from(n.max(0)).unwrap_or(u16::MAX)
}
