//! [`Windows`]: areas of a frame, each as the controller's commands for a window, and then its pixels.

use embedded_raster::Rect;

use crate::{
    pieces::Pieces,
    transfer::{Transfer, Transfers},
};

/// What a controller is told.
pub(crate) enum Say {
    /// A command, and so many bytes of parameters.
    Command(&'static [u8], [u8; 4], usize),
    /// The command that pixels follow: the last one of a window.
    Pixels(&'static [u8]),
}

/// The transfers of some areas. `say` gives the commands for a window by their number.
pub(crate) struct Windows<I, P, S> {
    areas: I,
    pieces: P,
    say: S,
    /// The window that is sent, and the rows of its area that come in further ones.
    window: Rect,
    rest: Rect,
    /// The number of the next command; `None` while pixels follow.
    command: Option<usize>,
    parameters: [u8; 4],
}

impl<I: Iterator<Item = Rect>, P: Pieces, S: Fn(usize, Rect) -> Say> Windows<I, P, S> {
    pub(crate) fn new(areas: impl IntoIterator<IntoIter = I>, pieces: P, say: S) -> Self {
        let areas = areas.into_iter();
        Self { areas, pieces, say, window: Rect::default(), rest: Rect::default(), command: None, parameters: [0; 4] }
    }

    /// Begins with the next window. `None` after the last.
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
        if self.command.is_none() && !self.pieces.is_done() {
            return Some(Transfer { command: &[], data: self.pieces.next() });
        }
        let number = self.command.or_else(|| self.open())?;
        match (self.say)(number, self.window) {
            Say::Command(command, parameters, count) => {
                (self.command, self.parameters) = (Some(number.saturating_add(1)), parameters);
                Some(Transfer { command, data: self.parameters.get(..count).unwrap_or_default() })
            }
            Say::Pixels(command) => {
                self.command = None;
                Some(Transfer { command, data: self.pieces.next() })
            }
        }
    }
}

/// A single command.
pub(crate) struct Once<const N: usize> {
    pub(crate) command: &'static [u8],
    pub(crate) parameters: [u8; N],
    pub(crate) is_sent: bool,
}

impl<const N: usize> Once<N> {
    pub(crate) const fn new(command: &'static [u8], parameters: [u8; N]) -> Self {
        Self { command, parameters, is_sent: false }
    }
}

impl<const N: usize> Transfers for Once<N> {
    fn next(&mut self) -> Option<Transfer<'_>> {
        if core::mem::replace(&mut self.is_sent, true) {
            return None;
        }
        Some(Transfer { command: self.command, data: &self.parameters })
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
