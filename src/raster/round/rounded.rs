//! Rectangles with rounded corners, filled and in outline.
//!
//! Each corner is a quarter of the circle whose box is twice the radius wide, by the rules of [`ellipse`](super::ellipse):
//! filled, the pixels whose centres lie inside of it or on it; in outline, those nearest to the curve through the centres
//! of its outermost pixels. Between the corners the sides are straight.
//! ```text
//!   11 x 6, radii 3, 3, 1, 2, clockwise from the top left
//!    .#########.      .#########.
//!    ###########      #.........#
//!    ###########      #.........#
//!    ###########      #.........#
//!    ###########      #.........#
//!    .##########      .##########
//! ```
//! A corner with a radius of 0 or 1 is square. *A radius is at most half of the shorter side*, rounded down; a larger one counts
//! as that. Each radius is limited by itself, whatever the others are.
//!
//! Range: any box, any radii. Work: additions, as many as there are visible rows, and visible columns in the corners.

use core::num::Wrapping;

use super::{
    curve::{is_inside, size_of, Size},
    disc::{Disc, DISCS},
    form::{Follower, Form, Number},
    outline::Border,
};
use crate::{
    num::cast::{signed, unsigned},
    span::{Rect, Sink, Span},
};

/// Radii of the four corners, in pixels.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Radii {
    /// Of the top left corner.
    pub top_left: u32,
    /// Of the top right corner.
    pub top_right: u32,
    /// Of the bottom right corner.
    pub bottom_right: u32,
    /// Of the bottom left corner.
    pub bottom_left: u32,
}

/// The same radius at all corners.
impl From<u32> for Radii {
    #[inline]
    fn from(radius: u32) -> Self {
        Self::all(radius)
    }
}

impl Radii {
    /// The same radius at all corners.
    pub const fn all(radius: u32) -> Self {
        Self { top_left: radius, top_right: radius, bottom_right: radius, bottom_left: radius }
    }

    pub(super) fn limited(self, area: Rect) -> Self {
        let limit = area.width().min(area.height()) / 2;
        let Self { top_left, top_right, bottom_right, bottom_left } = self;
        Self {
            top_left: top_left.min(limit),
            top_right: top_right.min(limit),
            bottom_right: bottom_right.min(limit),
            bottom_left: bottom_left.min(limit),
        }
    }

    fn largest(self) -> u32 {
        self.top_left.max(self.top_right).max(self.bottom_right).max(self.bottom_left)
    }
}

/// The rows of the corners, if all are the same and small, and all of the shape lies in the window: what is drawn most.
#[inline(always)]
fn corners(area: Rect, radii: Radii, window: Rect) -> Option<Disc> {
    let radius = radii.limited(area).top_left;
    let is_plain = DISCS && is_inside(area, window) && radii == Radii::all(radii.top_left) && radius <= 1 << 14;
    is_plain.then(|| Disc::new(area, signed(radius).wrapping_mul(2)))
}

/// The rows between the corners: a plain rectangle.
#[inline]
fn straight(area: Rect, radii: Radii) -> Rect {
    let radii = radii.limited(area);
    let upper = radii.top_left.max(radii.top_right);
    let lower = radii.bottom_left.max(radii.bottom_right);
    Rect { y0: area.y0.wrapping_add(signed(upper)), y1: area.y1.wrapping_sub(signed(lower)), ..area }
}

/// Emits a filled rectangle with rounded corners as far as it lies in `window`: the rows of the upper corners, the rows
/// between the corners as an area, and the rows of the lower corners.
///
/// Cannot fail.
/// ```
/// use embedded_raster::{raster::rounded, ClippedSpan, Radii, Rect};
/// let mut widths = vec![];
/// let area = Rect::new(0, 0, 9, 6);
/// rounded::fill(area, Radii::all(3), Rect::new(0, 0, 64, 48), |s: ClippedSpan| widths.push(s.len()));
/// assert_eq!(widths, [7, 9, 9, 9, 9, 7]);
/// ```
#[inline]
pub fn fill(area: Rect, radii: Radii, window: Rect, sink: impl Sink) {
    let middle = straight(area, radii);
    if let Some(corners) = corners(area, radii, window) {
        return fill_corners(&corners, middle, sink);
    }
    let clip = area.intersection(window);
    if !clip.is_empty() {
        draw::<false>(area, radii, clip, middle.intersection(window), sink);
    }
}

/// Both halves of a disc, and the rows between them. Not inlined, so that it has all registers to itself.
#[inline(never)]
fn fill_corners(corners: &Disc, middle: Rect, mut sink: impl Sink) {
    let mut corners = *corners;
    while corners.is_upper() {
        let Some(span) = corners.next() else { break };
        sink.span(span);
    }
    if !middle.is_empty() {
        sink.area(middle);
    }
    corners.skip_to(middle.y1);
    while let Some(span) = corners.next() {
        sink.span(span);
    }
}

/// Emits the outline of a rectangle with rounded corners as far as it lies in `window`, one pixel wide, top row first.
///
/// Cannot fail.
#[inline]
pub fn outline(area: Rect, radii: Radii, window: Rect, sink: impl Sink) {
    let clip = area.intersection(window);
    if !clip.is_empty() {
        draw::<true>(area, radii, clip, Rect::default(), sink);
    }
}

#[inline(always)]
fn draw<const OUTLINE: bool>(area: Rect, radii: Radii, clip: Rect, middle: Rect, sink: impl Sink) {
    let radii = radii.limited(area);
    let diameter = i64::from(radii.largest()) * 2;
    match size_of((diameter, diameter), 1) {
        Size::Small => draw_by::<Wrapping<i32>, OUTLINE>(area, radii, clip, middle, sink),
        _ => draw_large::<OUTLINE>(area, radii, clip, middle, sink),
    }
}

#[cold]
#[inline(never)]
fn draw_large<const OUTLINE: bool>(area: Rect, radii: Radii, clip: Rect, middle: Rect, sink: impl Sink) {
    draw_by::<Wrapping<i128>, OUTLINE>(area, radii, clip, middle, sink);
}

/// Emits the rows of `clip`. Those of `middle`, which may be empty, are emitted as one area.
#[inline(always)]
fn draw_by<T: Number, const OUTLINE: bool>(area: Rect, radii: Radii, clip: Rect, middle: Rect, mut sink: impl Sink) {
    // Columns as distances from the left and from the right side.
    let from_left = (unsigned(clip.x0.wrapping_sub(area.x0)), unsigned(clip.x1.wrapping_sub(area.x0)));
    let from_right = (unsigned(area.x1.wrapping_sub(clip.x1)), unsigned(area.x1.wrapping_sub(clip.x0)));
    let rows = (unsigned(clip.y0.wrapping_sub(area.y0)), unsigned(clip.y1.wrapping_sub(area.y0)));
    let mut left = Flank::<T, OUTLINE>::new((radii.top_left, radii.bottom_left), area.height(), rows, from_left);
    let mut right = Flank::<T, OUTLINE>::new((radii.top_right, radii.bottom_right), area.height(), rows, from_right);
    let mut y = clip.y0;
    while y < clip.y1 {
        if !OUTLINE && y == middle.y0 && !middle.is_empty() {
            sink.area(middle);
            let rows = middle.height();
            left.skip(rows);
            right.skip(rows);
            y = middle.y1;
            continue;
        }
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let ((left, left_end), (right, right_end)) = (left.row(), right.row());
        let (x0, x1) = (area.x0.wrapping_add(signed(left)), area.x1.wrapping_sub(signed(right)));
        let whole = !OUTLINE || y == area.y0 || y == area.y1.wrapping_sub(1) || area.width() == 1;
        let first_end = if whole { x1 } else { area.x0.wrapping_add(signed(left_end)) };
        if let Some(span) = (Span { y, x0, x1: first_end }).clip_columns(clip) {
            sink.span(span);
        }
        if !whole {
            if let Some(span) = (Span { y, x0: area.x1.wrapping_sub(signed(right_end)), x1 }).clip_columns(clip) {
                sink.span(span);
            }
        }
        y = y.wrapping_add(1);
    }
}

/// The left or the right border: two corners, and straight rows between them. Columns are distances from that side of the box.
struct Flank<T, const OUTLINE: bool> {
    corners: [Corner<T>; 2],
    /// Rows left in the upper corner, between the corners, and in the lower one.
    rows: [u32; 2],
}

impl<T: Number, const OUTLINE: bool> Flank<T, OUTLINE> {
    #[inline(always)]
    fn new((upper, lower): (u32, u32), height: u32, rows: (u32, u32), columns: (u32, u32)) -> Self {
        let straight_end = height.wrapping_sub(lower);
        let corner =
            |radius: u32, row: u32, y: i64| Corner::new::<OUTLINE>(radius, y + 2 * i64::from(row) + 1, columns);
        Self {
            corners: [
                corner(upper, rows.0.min(upper), -2 * i64::from(upper)),
                corner(lower, rows.0.saturating_sub(straight_end), 0),
            ],
            rows: [upper.saturating_sub(rows.0), straight_end.saturating_sub(rows.0.max(upper))],
        }
    }

    /// Goes over rows between the corners.
    #[inline(always)]
    fn skip(&mut self, rows: u32) {
        let [_, straight] = &mut self.rows;
        *straight = straight.saturating_sub(rows);
    }

    /// The first pixel of this row and the one after the last of the outline; goes to the next row.
    #[inline(always)]
    fn row(&mut self) -> (u32, u32) {
        let [upper, straight] = &mut self.rows;
        let [first, second] = &mut self.corners;
        if *upper > 0 {
            *upper = upper.wrapping_sub(1);
            first.row()
        } else if *straight > 0 {
            *straight = straight.wrapping_sub(1);
            (0, 1)
        } else {
            second.row()
        }
    }
}

/// A quarter of a circle.
enum Corner<T> {
    Filled { inside: Follower<T>, end: u32 },
    Outline { border: Border<T>, end: u32 },
}

impl<T: Number> Corner<T> {
    /// From the row at distance v from the centre, in half pixels. The columns `x0..x1`, counted from the side, are visible.
    #[inline(always)]
    fn new<const OUTLINE: bool>(radius: u32, v: i64, (x0, x1): (u32, u32)) -> Self {
        // Columns of a corner are counted from the centre of its circle outwards. `first` is the innermost visible one.
        let first = radius.saturating_sub(x1);
        let count = radius.saturating_sub(x0).saturating_sub(first);
        let u = 2 * i64::from(first) + 1;
        let end = radius.wrapping_sub(first);
        let diameter = 2 * i64::from(radius);
        if OUTLINE {
            let outer = first.wrapping_add(count) < radius;
            // A corner of which no column is visible still has rows, but nothing of them is drawn.
            let border = Border::new((diameter - 1, diameter - 1), (u, v), count.max(1), outer);
            Self::Outline { border, end }
        } else {
            let form = Form::new((diameter, diameter), 1);
            Self::Filled { inside: Follower::new(&form, (u, v), 1, count), end }
        }
    }

    #[inline(always)]
    fn row(&mut self) -> (u32, u32) {
        match self {
            Self::Filled { inside, end } => (end.wrapping_sub(inside.row()), 0),
            Self::Outline { border, end } => {
                let (low, high) = border.row();
                (end.wrapping_sub(unsigned(high)), end.wrapping_sub(unsigned(low)))
            }
        }
    }
}
