//! [`Row`]: the pixels of a row, told to a sink as spans of full pixels and spans of coverage.
//!
//! Pixels come one by one where sides go through them, and in runs where none does. What is covered in part waits until a pixel
//! comes that is not, or until [`CHUNK`] of them wait. Full pixels that come one by one wait with them, until a run of full pixels
//! shows that they are its beginning.

use crate::span::{ClippedSpan, Sink, Span};

/// So many levels at most are told at a time.
const CHUNK: usize = 32;

pub(super) struct Row<'s, S> {
    sink: &'s mut S,
    y: i32,
    /// The next column.
    x: i32,
    /// Levels that wait: those of the columns before x.
    levels: [u8; CHUNK],
    len: usize,
}

impl<'s, S: Sink> Row<'s, S> {
    #[inline(always)]
    pub(super) fn new(sink: &'s mut S, y: i32, x: i32) -> Self {
        Self { sink, y, x, levels: [0; CHUNK], len: 0 }
    }

    /// The next pixel.
    #[cfg_attr(not(embedded_raster_compact), inline(always))]
    #[cfg_attr(embedded_raster_compact, inline(never))]
    pub(super) fn put(&mut self, level: u8) {
        if level == 0 || self.len == CHUNK {
            self.tell();
        }
        if level != 0 {
            if let Some(place) = self.levels.get_mut(self.len) {
                *place = level;
                self.len = self.len.wrapping_add(1);
            }
        }
        self.x = self.x.wrapping_add(1);
    }

    /// The pixels up to a column, all of the same level.
    #[inline(never)]
    pub(super) fn run_to(&mut self, end: i32, level: u8) {
        if self.x >= end {
            return;
        }
        if level != 0 && level != u8::MAX {
            while self.x < end {
                self.put(level);
            }
            return;
        }
        let mut start = self.x;
        if level == u8::MAX {
            while let Some(&u8::MAX) = self.levels.get(..self.len).and_then(<[u8]>::last) {
                self.len = self.len.wrapping_sub(1);
                start = start.wrapping_sub(1);
            }
        }
        self.x = start;
        self.tell();
        self.x = end;
        if let Some(span) = (Span { y: self.y, x0: start, x1: end }).known_inside().filter(|_| level != 0) {
            self.sink.span(span);
        }
    }

    /// Tells the levels that wait, if there are any.
    #[inline(always)]
    pub(super) fn tell(&mut self) {
        if self.len != 0 {
            self.tell_some();
        }
    }

    #[inline(never)]
    fn tell_some(&mut self) {
        let Some(levels) = self.levels.get(..self.len).filter(|levels| !levels.is_empty()) else { return };
        let x0 = self.x.wrapping_sub_unsigned(u32::try_from(self.len).unwrap_or_default());
        self.sink.coverage(ClippedSpan::inside(self.y, x0, self.x), levels);
        self.len = 0;
    }
}
