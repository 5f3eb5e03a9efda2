//! Rectangles with rounded corners, filled and in outline.
//!
//! Each corner is a quarter of the circle whose box is twice the radius wide, by the rules of [`ellipse`](super::ellipse):
//! filled, the pixels whose centres lie inside of it or on it; in outline, those nearest to the curve through the centres
//! of its outermost pixels. Between the corners the sides are straight. [`enclosed`] is the outline with all that it encloses: what
//! to fill before an outline of another colour is drawn over it.
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
        draw::<false, true>(area, radii, clip, middle.intersection(window), sink);
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
        draw::<true, false>(area, radii, clip, Rect::default(), sink);
    }
}

/// Emits the outline of a rectangle with rounded corners, and all that it encloses, as far as it lies in `window`, top row first.
///
/// Fill this before the outline is drawn over it in another colour. [`fill`] has corners on a circle that is half a pixel larger, so
/// some of its pixels may lie outside of the outline.
/// ```
/// use embedded_raster::{raster::rounded, ClippedSpan, Radii, Rect};
/// let (area, mut widths) = (Rect::new(0, 0, 12, 12), vec![]);
/// rounded::enclosed(area, Radii::all(5), area, |s: ClippedSpan| widths.push(s.len()));
/// assert_eq!(widths, [6, 8, 10, 12, 12, 12, 12, 12, 12, 10, 8, 6]);
/// ```
#[inline]
pub fn enclosed(area: Rect, radii: Radii, window: Rect, sink: impl Sink) {
    let clip = area.intersection(window);
    if !clip.is_empty() {
        draw::<true, true>(area, radii, clip, straight(area, radii).intersection(window), sink);
    }
}

#[inline(always)]
fn draw<const OUTLINE: bool, const FILLED: bool>(area: Rect, radii: Radii, clip: Rect, middle: Rect, sink: impl Sink) {
    let radii = radii.limited(area);
    let diameter = i64::from(radii.largest()) * 2;
    match size_of((diameter, diameter), 1) {
        Size::Small => draw_by::<Wrapping<i32>, OUTLINE, FILLED>(area, radii, clip, middle, sink),
        _ => draw_large::<OUTLINE, FILLED>(area, radii, clip, middle, sink),
    }
}

#[cold]
#[inline(never)]
fn draw_large<const OUTLINE: bool, const FILLED: bool>(
    area: Rect,
    radii: Radii,
    clip: Rect,
    middle: Rect,
    sink: impl Sink,
) {
    draw_by::<Wrapping<i128>, OUTLINE, FILLED>(area, radii, clip, middle, sink);
}

/// Emits the rows of `clip`. Those of `middle`, which may be empty, are emitted as one area.
#[inline(always)]
fn draw_by<T: Number, const OUTLINE: bool, const FILLED: bool>(
    area: Rect,
    radii: Radii,
    clip: Rect,
    middle: Rect,
    mut sink: impl Sink,
) {
    // Columns as distances from the left and from the right side.
    let from_left = (unsigned(clip.x0.wrapping_sub(area.x0)), unsigned(clip.x1.wrapping_sub(area.x0)));
    let from_right = (unsigned(area.x1.wrapping_sub(clip.x1)), unsigned(area.x1.wrapping_sub(clip.x0)));
    let rows = (unsigned(clip.y0.wrapping_sub(area.y0)), unsigned(clip.y1.wrapping_sub(area.y0)));
    let mut left = Flank::<T, OUTLINE>::new((radii.top_left, radii.bottom_left), area.height(), rows, from_left);
    let mut right = Flank::<T, OUTLINE>::new((radii.top_right, radii.bottom_right), area.height(), rows, from_right);
    let mut y = clip.y0;
    while y < clip.y1 {
        if FILLED && y == middle.y0 && !middle.is_empty() {
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
        let whole = FILLED || y == area.y0 || y == area.y1.wrapping_sub(1) || area.width() == 1;
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

/// Emits a border of a rectangle with rounded corners, so many pixels wide, as far as it lies in `window`, top row first: the pixels
/// of a filled rectangle with rounded corners that are not pixels of another one, whose sides are `width` pixels further in, and whose
/// radii are as much less. So a border inside of a rectangle and what it encloses together draw each pixel of it once.
/// ```
/// use embedded_raster::{raster::rounded::{self, Align}, ClippedSpan, Radii, Rect};
/// let (area, mut spans) = (Rect::new(0, 0, 8, 4), vec![]);
/// rounded::border(area, Radii::all(2), 1, Align::Inside, area, |s: ClippedSpan| spans.push((s.y(), s.x0(), s.x1())));
/// assert_eq!(spans, [(0, 1, 7), (1, 0, 1), (1, 7, 8), (2, 0, 1), (2, 7, 8), (3, 1, 7)]);
/// ```
pub fn border(area: Rect, radii: Radii, width: u32, align: Align, window: Rect, sink: impl Sink) {
    let radii = radii.limited(area);
    let [outer, inner] = align.boxes(area, width);
    let grown = |by: i64| {
        // A square corner stays one.
        let radius =
            |r: u32| if r == 0 { 0 } else { u32::try_from(i64::from(r).wrapping_add(by).max(0)).unwrap_or(u32::MAX) };
        let Radii { top_left, top_right, bottom_right, bottom_left } = radii;
        Radii {
            top_left: radius(top_left),
            top_right: radius(top_right),
            bottom_right: radius(bottom_right),
            bottom_left: radius(bottom_left),
        }
    };
    let by = |outer: Rect| i64::from(area.x0).wrapping_sub(outer.x0.into());
    let shapes = [(outer, grown(by(outer)).limited(outer)), (inner, grown(by(inner)).limited(inner))];
    let clip = outer.intersection(window);
    if clip.is_empty() {
        return;
    }
    let diameter = i64::from(shapes.map(|shape| shape.1.largest()).into_iter().fold(0, u32::max)) * 2;
    match size_of((diameter, diameter), 1) {
        Size::Small => border_by::<Wrapping<i32>>(shapes, clip, sink),
        _ => large_border(shapes, clip, sink),
    }
}

#[cold]
#[inline(never)]
fn large_border(shapes: [(Rect, Radii); 2], clip: Rect, sink: impl Sink) {
    border_by::<Wrapping<i128>>(shapes, clip, sink);
}

#[inline(always)]
fn border_by<T: Number>([(outer, radii), (inner, inner_radii)]: [(Rect, Radii); 2], clip: Rect, mut sink: impl Sink) {
    let hole = inner.intersection(clip);
    let mut sides = Sides::<T>::new(outer, radii, clip);
    let mut hole_sides = Sides::<T>::new(inner, inner_radii, hole);
    for y in clip.y0..clip.y1 {
        #[cfg(test)]
        crate::num::tally::add(crate::num::tally::Work::Step);
        let (x0, x1) = sides.row();
        let is_open = !hole.is_empty() && hole.y0 <= y && y < hole.y1;
        let (a, b) =
            Some(is_open).filter(|&open| open).map(|_| hole_sides.row()).filter(|(a, b)| a < b).unwrap_or((x1, x1));
        for (x0, x1) in [(x0, x1.min(a)), (x0.max(b), x1)] {
            if let Some(span) = (Span { y, x0, x1 }).clip_columns(clip) {
                sink.span(span);
            }
        }
    }
}

/// Where a border lies, as seen from the box that it is drawn around.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Align {
    /// In the box, along its sides.
    #[default]
    Inside,
    /// Half of it inside of the box, rounded up, and the rest outside.
    Centred,
    /// Around the box.
    Outside,
}

impl Align {
    /// The outer and the inner side of a border as boxes. The inner one may be empty, and sides stop at the ends of the type.
    pub(crate) fn boxes(self, area: Rect, width: u32) -> [Rect; 2] {
        let (outside, inside) = match self {
            Self::Inside => (0, width),
            Self::Centred => (width >> 1, width.wrapping_sub(width >> 1)),
            Self::Outside => (width, 0),
        };
        let Rect { x0, y0, x1, y1 } = area;
        if area.is_empty() {
            return [Rect::default(); 2];
        }
        let out = |low: i32, high: i32| (low.saturating_sub_unsigned(outside), high.saturating_add_unsigned(outside));
        let within = |low: i32, high: i32| (low.saturating_add_unsigned(inside), high.saturating_sub_unsigned(inside));
        let rect = |(x0, x1): (i32, i32), (y0, y1): (i32, i32)| {
            if x0 < x1 && y0 < y1 {
                Rect { x0, y0, x1, y1 }
            } else {
                Rect::default()
            }
        };
        [rect(out(x0, x1), out(y0, y1)), rect(within(x0, x1), within(y0, y1))]
    }
}

/// Both borders of a filled rectangle with rounded corners, row by row.
struct Sides<T> {
    area: Rect,
    left: Flank<T, false>,
    right: Flank<T, false>,
}

impl<T: Number> Sides<T> {
    /// From the first row of `clip` on, which lies in the area.
    #[inline(always)]
    fn new(area: Rect, radii: Radii, clip: Rect) -> Self {
        let from_left = (unsigned(clip.x0.wrapping_sub(area.x0)), unsigned(clip.x1.wrapping_sub(area.x0)));
        let from_right = (unsigned(area.x1.wrapping_sub(clip.x1)), unsigned(area.x1.wrapping_sub(clip.x0)));
        let rows = (unsigned(clip.y0.wrapping_sub(area.y0)), unsigned(clip.y1.wrapping_sub(area.y0)));
        Self {
            area,
            left: Flank::new((radii.top_left, radii.bottom_left), area.height(), rows, from_left),
            right: Flank::new((radii.top_right, radii.bottom_right), area.height(), rows, from_right),
        }
    }

    /// The first pixel of this row and the one after the last; goes to the next row.
    #[inline(always)]
    fn row(&mut self) -> (i32, i32) {
        let ((left, _), (right, _)) = (self.left.row(), self.right.row());
        (self.area.x0.wrapping_add(signed(left)), self.area.x1.wrapping_sub(signed(right)))
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
