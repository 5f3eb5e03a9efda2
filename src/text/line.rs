//! [`Lines`] of a text, and a [`Pen`] that goes along one.

use super::font::{Font, Glyph};

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

/// Where the next cell of a line begins. Columns are wide: a line may begin far outside of what `i32` holds, and reach into it.
pub(super) struct Pen {
    column: i64,
    /// The next tab stop, or one before.
    stop: i64,
    tab: u16,
}

impl Pen {
    #[inline]
    pub(super) const fn new(start: i64, tab: u16) -> Self {
        Self { column: start, stop: start, tab }
    }

    #[inline(always)]
    pub(super) const fn column(&self) -> i64 {
        self.column
    }

    /// Moves over a character to the end of its cell. Its glyph; `None` if it has none but room, perhaps.
    #[inline]
    pub(super) fn next<'a>(&mut self, font: &Font<'a>, character: char) -> Option<Glyph<'a>> {
        match character {
            '\t' => {
                // Each stop is passed once in a line, so no division is needed.
                while self.tab > 0 && self.stop <= self.column {
                    self.stop = self.stop.wrapping_add(self.tab.into());
                }
                self.column = self.stop.max(self.column);
                None
            }
            '\r' => None,
            _ => {
                let glyph = font.glyph(character);
                self.column = self.column.wrapping_add(glyph.advance.into());
                Some(glyph)
            }
        }
    }
}
