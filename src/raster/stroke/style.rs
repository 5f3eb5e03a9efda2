//! [`Stroke`]: how a line with a width looks.

use fixed::types::I24F8;

/// How the ends of an open contour, or of a dash, look.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Cap {
    /// Cut off at the end.
    #[default]
    Butt,
    /// Longer by half the width.
    Square,
    /// A half circle.
    Round,
}

/// How two sides meet.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Join {
    /// The outer borders go on until they meet. Where that is farther away than the limit, the join is a [`Bevel`](Self::Bevel).
    #[default]
    Miter,
    /// The corner is cut off.
    Bevel,
    /// A piece of a circle.
    Round,
}

/// How a stroke looks: its width, its ends, its corners. `D` is `()` for a solid one, [`Dash`](super::dash::Dash) for dashes.
/// ```
/// use embedded_raster::{buffer_bytes, Canvas, Cap, EdgeSlot, Framebuffer, Index1, Join, Stroke, PointFx};
/// let mut ram = [0; buffer_bytes::<Index1>(16, 8)];
/// let mut frame = Framebuffer::<Index1>::new(&mut ram, 16, 8)?;
/// let tick = [PointFx::px(2, 2), PointFx::px(6, 6), PointFx::px(14, 1)];
/// let stroke = Stroke::px(2).with_join(Join::Round).with_cap(Cap::Round);
/// frame.stroke_polyline_fx(&tick, false, &stroke, &mut [EdgeSlot::EMPTY; 64], Index1::MAX)?;
/// let rows = [
///     0b0000_0000_0000_0110_u16,
///     0b0110_0000_0001_1110,
///     0b0111_0000_0011_1000,
///     0b0011_1000_1111_0000,
///     0b0001_1101_1100_0000,
///     0b0000_1111_1000_0000,
///     0b0000_0110_0000_0000,
///     0b0000_0000_0000_0000,
/// ];
/// assert_eq!(ram, rows.map(u16::to_be_bytes).concat()[..]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Stroke<D = ()> {
    /// In pixels and 1/256 of them, from `min_width` to 65,536; others count as the nearest of these.
    pub width: I24F8,
    /// How its ends look.
    pub cap: Cap,
    /// How its corners look.
    pub join: Join,
    /// How far, in widths, a miter may reach from its inner to its outer corner.
    pub miter_limit: I24F8,
    /// What a smaller width counts as: one pixel, unless [`with_min_width`](Self::with_min_width) says something else. A stroke
    /// that is thinner than a pixel misses the centres of most pixels, so little of it would be seen, and that in pieces.
    pub min_width: I24F8,
    /// Its gaps: `()` for none.
    pub dash: D,
}

impl Stroke {
    /// A solid stroke of this width, with butt caps and miter joins up to 4 widths. For whole pixels there is [`px`](Self::px).
    #[inline]
    pub const fn new(width: I24F8) -> Self {
        let (miter_limit, min_width) = (I24F8::from_bits(4 << 8), I24F8::from_bits(1 << 8));
        Self { width, cap: Cap::Butt, join: Join::Miter, miter_limit, min_width, dash: () }
    }

    /// The same, in whole pixels.
    #[inline]
    pub const fn px(width: u16) -> Self {
        Self::new(I24F8::from_bits((width as i32) << 8))
    }
}

impl<D> Stroke<D> {
    /// The same stroke with these ends.
    #[inline]
    #[must_use]
    pub fn with_cap(self, cap: Cap) -> Self {
        Self { cap, ..self }
    }

    /// The same stroke with these corners.
    #[inline]
    #[must_use]
    pub fn with_join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// The same stroke with this limit for miters, in widths of the stroke: [`px(2)`](crate::px) for two of them.
    #[inline]
    #[must_use]
    pub fn with_miter_limit(self, miter_limit: I24F8) -> Self {
        Self { miter_limit, ..self }
    }

    /// The same stroke with another least width. With 0, a thin one has the pixels whose centres it covers, and no others.
    /// ```
    /// use embedded_raster::{px, raster::stroke, ClippedSpan, EdgeSlot, Path, PathSegment::*, PointFx, Rect, Stroke};
    /// use fixed::types::I24F8;
    /// let line = [MoveTo(PointFx::px(1, 1)), LineTo(PointFx::px(7, 1))];
    /// let count = |stroke: &Stroke| {
    ///     let (mut count, mut table) = (0, [EdgeSlot::EMPTY; 8]);
    ///     let window = Rect::new(0, 0, 8, 2);
    ///     stroke::fill(Path::new(&line), stroke, &mut table, window, |s: ClippedSpan| count += s.len()).map(|()| count)
    /// };
    /// let thin = Stroke::new(I24F8::from_num(0.25));
    /// assert_eq!(count(&thin), Ok(6));
    /// assert_eq!(count(&thin.with_min_width(px(0))), Ok(0));
    /// ```
    #[inline]
    #[must_use]
    pub fn with_min_width(self, min_width: I24F8) -> Self {
        Self { min_width, ..self }
    }
}
