//! [`Lines`] of a text, and a [`Pen`] that goes along one.

use super::font::{Font, Glyph};
use crate::tune::keep_rolled;

/// The lines of a text: what stands between newlines. There is one more of them than newlines.
pub(super) struct Lines<'a>(pub(super) Option<&'a str>);

impl<'a> Iterator for Lines<'a> {
    type Item = &'a str;

    #[inline]
    fn next(&mut self) -> Option<&'a str> {
        let text = self.0?;
        let Some(end) = text.bytes().position(|byte| byte == b'\n') else {
            return self.0.take();
        };
        self.0 = text.get(end.wrapping_add(1)..);
        text.get(..end)
    }
}

/// Where the next cell of a line begins, in columns from the start of the line.
///
/// A line may be longer than any number of 32 bits says. So columns are counted from a column of the line, the base, which moves on
/// every million of them.
#[derive(Copy, Clone)]
pub(super) struct Pen {
    base: i64,
    column: i32,
    /// The next tab stop, or one before.
    stop: i64,
    tab: u16,
}

/// From which column on the base moves on. A character adds less than 2^16.
const FAR: i32 = 1 << 20;

impl Pen {
    #[inline]
    pub(super) const fn new(tab: u16) -> Self {
        Self { base: 0, column: 0, stop: 0, tab }
    }

    /// Columns from the base, no more than some over a million.
    #[inline(always)]
    pub(super) const fn column(&self) -> i32 {
        self.column
    }

    /// Columns before the base.
    #[inline]
    pub(super) const fn base(&self) -> i64 {
        self.base
    }

    /// Columns from the start of the line.
    #[inline]
    pub(super) fn total(&self) -> i64 {
        self.base.wrapping_add(self.column.into())
    }

    /// Moves the base on, if the pen is far from it. Says whether it did: to be called after each character.
    #[inline(always)]
    pub(super) fn moves_base(&mut self) -> bool {
        // Columns are not negative. A shift needs no constant.
        let is_far = self.column >> FAR.trailing_zeros() != 0;
        if is_far {
            (self.base, self.column) = (self.total(), 0);
        }
        is_far
    }

    /// Moves over a character to the end of its cell. Its glyph; `None` if it has none but room, perhaps.
    #[inline(always)]
    pub(super) fn next<'a>(&mut self, font: &Font<'a>, character: char) -> Option<Glyph<'a>> {
        // One comparison for most.
        if character <= '\r' && matches!(character, '\t' | '\r') {
            if character == '\t' {
                *self = self.at_next_stop();
            }
            return None;
        }
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let glyph = font.glyph(character);
        self.column = self.column.wrapping_add(glyph.advance.into());
        Some(glyph)
    }

    /// At the next tab stop. Each stop is passed once in a line, so no division is needed.
    ///
    /// By value, so that a pen may be in registers.
    #[cold]
    #[inline(never)]
    fn at_next_stop(mut self) -> Self {
        let column = self.total();
        while self.tab > 0 && self.stop <= column {
            self.stop = self.stop.wrapping_add(self.tab.into());
            // Or it becomes a division, of 128 bits.
            keep_rolled(true);
        }
        if self.tab > 0 {
            // Less than 2^16 columns on.
            self.column = i32::try_from(self.stop.wrapping_sub(self.base)).unwrap_or(FAR);
        }
        self
    }
}
