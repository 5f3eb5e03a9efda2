//! [`Span`] and [`ClippedSpan`]: pixels of one row. [`SoftRow`]: those that have rims.

use super::rect::Rect;
use crate::num::cast::{low_u32, signed, unsigned};

/// Pixels `x0..x1` of row `y`, anywhere. Empty when `x0 >= x1`.
/// ```
/// use embedded_raster::{Rect, Span};
/// let window = Rect::new(0, 0, 64, 48);
/// let span = Span { y: 3, x0: -10, x1: 5 }.clip(window).unwrap();
/// assert_eq!((span.x0(), span.x1(), span.y()), (0, 5, 3));
/// assert!(Span { y: 48, x0: 0, x1: 5 }.clip(window).is_none());
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Span {
    /// Row.
    pub y: i32,
    /// First pixel.
    pub x0: i32,
    /// The pixel after the last.
    pub x1: i32,
}

impl Span {
    /// The part of it inside `window`, if there is one.
    #[inline(always)]
    pub fn clip(self, window: Rect) -> Option<ClippedSpan> {
        if self.y < window.y0 || self.y >= window.y1 {
            return None;
        }
        self.clip_columns(window)
    }

    /// [`clip`](Self::clip) for a row that is known to lie in the window.
    #[inline(always)]
    pub(crate) fn clip_columns(self, window: Rect) -> Option<ClippedSpan> {
        let (x0, x1) = (self.x0.max(window.x0), self.x1.min(window.x1));
        (x0 < x1).then_some(ClippedSpan { y: self.y, x0, x1 })
    }

    /// [`clip`](Self::clip) for a span that is known to lie in the window if it is not empty.
    #[inline(always)]
    pub(crate) fn known_inside(self) -> Option<ClippedSpan> {
        (self.x0 < self.x1).then_some(ClippedSpan { y: self.y, x0: self.x0, x1: self.x1 })
    }
}

impl ClippedSpan {
    /// A span of a shape that lies in the window as a whole. Not empty: `x0 < x1`.
    #[inline(always)]
    pub(crate) const fn inside(y: i32, x0: i32, x1: i32) -> Self {
        Self { y, x0, x1 }
    }
}

/// A [`Span`] that has at least one pixel and lies inside the window that it was clipped against.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct ClippedSpan {
    y: i32,
    x0: i32,
    x1: i32,
}

impl ClippedSpan {
    /// Row.
    #[inline(always)]
    pub const fn y(self) -> i32 {
        self.y
    }

    /// First pixel.
    #[inline(always)]
    pub const fn x0(self) -> i32 {
        self.x0
    }

    /// The pixel after the last.
    #[inline(always)]
    pub const fn x1(self) -> i32 {
        self.x1
    }

    /// The part of it in a window: it may have been clipped against another one.
    #[inline(always)]
    pub(crate) fn again(self, window: Rect) -> Option<Self> {
        Span { y: self.y, x0: self.x0, x1: self.x1 }.clip(window)
    }

    /// Whether it lies in a window as a whole.
    #[inline(always)]
    pub(crate) const fn lies_in(self, Rect { x0, x1, y0, y1 }: Rect) -> bool {
        y0 <= self.y && self.y < y1 && x0 <= self.x0 && self.x1 <= x1
    }

    /// All but so many pixels at its left end; `None` if there are no others.
    #[inline(always)]
    pub(crate) fn without(self, pixels: usize) -> Option<Self> {
        let left = i32::try_from(pixels).ok()?;
        let x0 = self.x0.wrapping_add(left);
        (x0 < self.x1).then_some(Self { x0, ..self })
    }

    /// Calls `f` with its parts, from left to right, each of `most` pixels but the last one. `most` is not 0.
    #[inline(always)]
    pub(crate) fn parts(self, most: u32, mut f: impl FnMut(Self)) {
        let mut x0 = self.x0;
        // One call, which is inlined: at two places it would not be.
        loop {
            let rest = Self { x0, ..self };
            let x1 = if rest.len() > most { x0.wrapping_add(signed(most)) } else { self.x1 };
            f(Self { x1, ..rest });
            if x1 == self.x1 {
                return;
            }
            x0 = x1;
        }
    }

    /// Calls `f` with the runs of pixels, from left to right, whose level is 128 or more.
    pub(crate) fn covered(self, levels: &[u8], mut f: impl FnMut(Self)) {
        let (mut x, mut start) = (self.x0, None);
        for &level in levels {
            if level >= 128 {
                start.get_or_insert(x);
            } else if let Some(x0) = start.take() {
                f(Self { x0, x1: x, ..self });
            }
            x = x.wrapping_add(1);
        }
        if let Some(x0) = start {
            f(Self { x0, x1: x, ..self });
        }
    }

    /// Calls `f` with the runs of pixels that are covered, from left to right: with their levels, or without if they are covered as a
    /// whole. Pixels of level 0 are in none.
    #[inline]
    pub(crate) fn each_covered(self, levels: &[u8], mut f: impl FnMut(Self, Option<&[u8]>)) {
        let kind = |level: u8| (level == 0, level == u8::MAX);
        let (mut x0, mut rest) = (self.x0, levels);
        while let Some(&first) = rest.first() {
            let run = rest.iter().take_while(|&&level| kind(level) == kind(first)).count();
            let Some((run, after)) = rest.split_at_checked(run) else { return };
            let x1 = x0.wrapping_add_unsigned(low_u32(run.len() as u64));
            if first != 0 {
                f(Self { x0, x1, ..self }, (first != u8::MAX).then_some(run));
            }
            (x0, rest) = (x1, after);
        }
    }

    /// Number of pixels, at least 1.
    #[inline(always)]
    #[expect(clippy::len_without_is_empty, reason = "it is never empty")]
    pub const fn len(self) -> u32 {
        unsigned(self.x1.wrapping_sub(self.x0))
    }
}

/// Pixels of one row that a shape covers as a whole, between two rims that it covers in part: what most rows of a shape with soft
/// rims are. Each part may be empty.
/// ```
/// use embedded_raster::{raster::coverage, ClippedSpan, PointFx, Rect, Sink, SoftRow};
/// struct Told(Vec<(i32, Vec<u8>, Vec<u8>)>);
/// impl Sink for &mut Told {
///     fn span(&mut self, _: ClippedSpan) {}
///     fn soft_row(&mut self, row: SoftRow<'_>) {
///         self.0.push((row.span().y(), row.left().to_vec(), row.right().to_vec()));
///     }
/// }
/// let corners = [(1, 0), (1, 8), (10, 8)].map(|(x, y)| PointFx::px(x, y));
/// let mut told = Told(vec![]);
/// coverage::triangle(corners, &mut [], Rect::new(0, 0, 11, 8), &mut told);
/// assert_eq!(told.0[0], (1, vec![], vec![168, 7])); // behind one that is full
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SoftRow<'a> {
    span: ClippedSpan,
    left: &'a [u8],
    right: &'a [u8],
}

impl<'a> SoftRow<'a> {
    /// A row of a shape that lies in the window as a whole, with the levels of its first pixels and of its last ones. It has as many
    /// pixels as both, or more.
    #[inline(always)]
    pub(crate) const fn inside(span: ClippedSpan, left: &'a [u8], right: &'a [u8]) -> Self {
        Self { span, left, right }
    }

    /// All of its pixels.
    #[inline(always)]
    pub const fn span(self) -> ClippedSpan {
        self.span
    }

    /// Of its first pixels, how many 255ths are covered.
    #[inline(always)]
    pub const fn left(self) -> &'a [u8] {
        self.left
    }

    /// Of its last pixels, how many 255ths are covered.
    #[inline(always)]
    pub const fn right(self) -> &'a [u8] {
        self.right
    }

    /// Calls `f` with its parts that are not empty, from left to right: with their levels, or without if they are covered as a whole.
    #[inline]
    pub fn each(self, mut f: impl FnMut(ClippedSpan, Option<&'a [u8]>)) {
        let ClippedSpan { x0, x1, .. } = self.span;
        let len = |levels: &[u8]| low_u32(levels.len() as u64);
        let (from, to) = (x0.wrapping_add_unsigned(len(self.left)), x1.wrapping_sub_unsigned(len(self.right)));
        for (x0, x1, levels) in [(x0, from, Some(self.left)), (from, to, None), (to, x1, Some(self.right))] {
            if x0 < x1 {
                f(ClippedSpan { x0, x1, ..self.span }, levels);
            }
        }
    }
}
