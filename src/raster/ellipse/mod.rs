//! Circles and ellipses, filled and in outline.
//!
//! **Filled.** A pixel is drawn when its centre lies inside of the curve `(u/a)^2 + (v/b)^2 = 1`, u and v being the
//! distances from the centre along x and y.
//! - Of an ellipse [in a box](Ellipse::in_box) the curve touches the sides of the box, and a centre on the curve is inside:
//!   what is drawn is as symmetric as the box.
//! - Of an ellipse by [centre and radii](Ellipse::new) a centre on the curve is inside on the left half and outside on the
//!   right: of a row, the pixels with `x0 <= cx < x1`, as for polygons.
//! ```text
//!   box 6 x 6   box 7 x 7   box 13 x 6       outlines of the same boxes
//!    .####.      ..###..     ...#######...    .####.   ..###..   ...#######...
//!    ######      .#####.     .###########.    #....#   .#...#.   .##.......##.
//!    ######      #######     #############    #....#   #.....#   #...........#
//!    ######      #######     #############    #....#   #.....#   #...........#
//!    ######      #######     .###########.    #....#   #.....#   .##.......##.
//!    .####.      .#####.     ...#######...    .####.   .#...#.   ...#######...
//!                ..###..                               ..###..
//! ```
//! **Outline.** The curve runs through the centres of the outermost pixels of a box. Wherever it crosses the line through the
//! centres of a column or of a row, the pixel of that line nearest to the crossing is drawn; of two equally near ones the
//! outer. (This is known as grid-intersection digitisation.) So every column and every row of the box has its pixels,
//! neighbours touch by a side or a corner, and the picture is as symmetric as the box. [`enclosed`] is the outline with all
//! that it encloses: what to fill before an outline of another colour is drawn over it.
//!
//! Columns and rows are two independent sweeps; each decides by the sign of `E = b^2 u^2 + a^2 v^2 - a^2 b^2`, here at the
//! midpoint between two pixels. There is no switch from one region to another, which is what breaks thin ellipses. Row by
//! row the number of pixels inside of the curve grows by as many as are visible and become so, and shrinks again: additions
//! and comparisons, as many as there are visible rows and columns.
//!
//! Range: any box, any centre and radii. Circles up to a diameter of 32,768 pixels by their box or 256 by their radius, and
//! ellipses up to 300 x 300, are followed in 32 bits, up to 65,536 (1,022 by radius) in 64, all others in 128.
//!
//! Sources: M. Pitteway, "Algorithm for drawing ellipses or hyperbolae with a digital plotter", Computer Journal 10(3), 1967
//! (signs at midpoints); R. Klette, A. Rosenfeld, "Digital Geometry", 2004 (grid-intersection digitisation).

use core::num::Wrapping;

use fixed::types::I24F8;

use self::form::Rows;
pub(crate) use self::outline::octants;
pub use self::outline::{enclosed, outline};
pub(super) use self::{
    form::{Follower, Form, Number},
    outline::Border,
};
use crate::{
    geom::{bits, PointFx},
    num::{
        cast::{narrow, saturate, unsigned},
        round::difference,
    },
    rect::Rect,
    span::{ClippedSpan, Span},
    target::{keep_rolled, COMPACT},
};

mod form;
mod outline;

/// An ellipse with axes along x and y, as the pixels that it fills.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Ellipse {
    /// Nothing is drawn outside of it.
    extent: Rect,
    /// Nothing if it touches the sides of its extent: then the curve itself is inside.
    curve: Option<Curve>,
}

/// Where the curve runs.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub(super) struct Curve {
    /// The centre, from the corner of pixel (0, 0), in units of `2^-shift` pixels.
    centre: (i64, i64),
    /// Semi-axes in these units.
    radii: (i64, i64),
    shift: u32,
    /// Whether the curve itself is inside: the box of `closed` curves is symmetric, and the shift is 1.
    closed: bool,
}

impl Ellipse {
    /// The ellipse that touches the sides of a box of pixels, whose width and height may be odd or even. A centre on the
    /// curve is inside. An empty box has no ellipse.
    #[inline]
    pub const fn in_box(area: Rect) -> Self {
        Self { extent: area, curve: None }
    }

    /// An ellipse by its centre and semi-axes, to 1/256 pixel. Without two positive radii it is empty.
    #[inline]
    pub fn new(centre: PointFx, rx: I24F8, ry: I24F8) -> Self {
        let (x, y) = bits(centre);
        Self::scaled((x.into(), y.into()), (rx.to_bits().into(), ry.to_bits().into()), 8)
    }

    /// A circle by its centre and radius, to 1/256 pixel.
    #[inline]
    pub fn circle(centre: PointFx, radius: I24F8) -> Self {
        Self::new(centre, radius, radius)
    }

    /// A circle by its centre and *diameter*, to 1/256 pixel: a round point.
    #[inline]
    pub fn splat(centre: PointFx, size: I24F8) -> Self {
        let (x, y) = bits(centre);
        let radius = size.to_bits().into();
        // Half the diameter is a whole number of units of 1/512 pixel.
        Self::scaled((i64::from(x) * 2, i64::from(y) * 2), (radius, radius), 9)
    }

    /// By numbers below 2^33, in units of `2^-shift` pixels.
    #[inline]
    fn scaled(centre: (i64, i64), radii: (i64, i64), shift: u32) -> Self {
        let pixel = |place: i64| first_pixel_from(place, shift);
        let extent = if radii.0 <= 0 || radii.1 <= 0 {
            Rect::new(0, 0, 0, 0)
        } else {
            // The one row below may hold centres on the lowest place of the curve, which are outside.
            let (x, y) = (centre.0, centre.1);
            let (low, high) = (i64::wrapping_sub, i64::wrapping_add);
            Rect::new(pixel(low(x, radii.0)), pixel(low(y, radii.1)), pixel(high(x, radii.0)), pixel(high(y, radii.1)))
        };
        Self { extent, curve: Some(Curve { centre, radii, shift, closed: false }) }
    }

    /// Its curve, made of the extent if need be.
    #[inline(always)]
    pub(super) fn curve(&self) -> Curve {
        self.curve.unwrap_or_else(|| {
            let Rect { x0, y0, x1, y1 } = self.extent;
            let sum = |a: i32, b: i32| i64::from(a).wrapping_add(b.into());
            let radii = (self.extent.width().into(), self.extent.height().into());
            Curve { centre: (sum(x0, x1), sum(y0, y1)), radii, shift: 1, closed: true }
        })
    }

    /// Where its pixels are: outside of it there are none.
    #[inline]
    pub const fn extent(&self) -> Rect {
        self.extent
    }
}

impl Curve {
    /// Distance of the centre of a column from the centre of the ellipse, in units.
    #[inline(always)]
    pub(super) fn u(&self, x: i32) -> i64 {
        centre_of(x, self.shift).wrapping_sub(self.centre.0)
    }

    /// Distance of the centre of a row.
    #[inline(always)]
    pub(super) fn v(&self, y: i32) -> i64 {
        centre_of(y, self.shift).wrapping_sub(self.centre.1)
    }

    /// The first column whose centre lies at or right of the centre.
    #[inline(always)]
    fn middle(&self) -> i32 {
        first_pixel_from(self.centre.0, self.shift)
    }

    /// The narrowest numbers that its form fits into.
    #[inline(always)]
    fn size(&self) -> Size {
        size_of(self.radii, self.shift)
    }
}

/// One unit less than a pixel, in units of `2^-shift` pixels, and half a pixel.
#[inline(always)]
fn unit(shift: u32) -> (i64, i64) {
    let pixel = 1_i64.wrapping_shl(shift);
    (pixel.wrapping_sub(1), pixel >> 1)
}

/// The centre of a pixel, in units.
#[inline(always)]
fn centre_of(pixel: i32, shift: u32) -> i64 {
    i64::from(pixel).wrapping_shl(shift).wrapping_add(unit(shift).1)
}

/// The first pixel whose centre lies at or right of a place.
#[inline(always)]
fn first_pixel_from(place: i64, shift: u32) -> i32 {
    let (most, half) = unit(shift);
    saturate(place.wrapping_sub(half).wrapping_add(most).wrapping_shr(shift))
}

/// What the form of an ellipse is followed in.
#[derive(Copy, Clone, PartialEq, Eq)]
pub(super) enum Size {
    Small,
    Medium,
    Large,
}

/// The bounds are those of [`form::Form::value`] and of the steps, two steps outside of the curve.
#[inline(always)]
pub(super) fn size_of((a, b): (i64, i64), shift: u32) -> Size {
    let small = if a == b {
        a <= 1 << 15
    } else {
        shift == 1 && a < 1024 && b < 1024 && a.wrapping_add(4).wrapping_mul(b.wrapping_add(4)) < 92_681
    };
    let limit = if shift == 1 { 1 << 16 } else { (1 << 18) - 1024 };
    if small {
        Size::Small
    } else if a <= limit && b <= limit {
        Size::Medium
    } else {
        Size::Large
    }
}

/// Emits the spans of a filled ellipse that lie in `window`, top row first.
///
/// Cannot fail. Work: additions, as many as there are visible rows and columns.
/// ```
/// use embedded_raster::{raster::ellipse::{self, Ellipse}, Rect};
/// let mut widths = vec![];
/// ellipse::fill(Ellipse::in_box(Rect::new(0, 0, 7, 7)), Rect::new(0, 0, 64, 48), |s| widths.push(s.len()));
/// assert_eq!(widths, [3, 5, 7, 7, 7, 5, 3]);
/// ```
#[inline]
pub fn fill(ellipse: Ellipse, window: Rect, mut emit: impl FnMut(ClippedSpan)) {
    let clip = ellipse.extent.intersection(window);
    if clip.is_empty() {
        return;
    }
    fill_any(&ellipse, clip, &mut emit);
}

/// A disc whose `2 a^2` fits 31 bits.
#[inline(always)]
fn is_small_disc(area: Rect) -> bool {
    area.width() == area.height() && area.width() <= 1 << 15
}

/// The disc that an ellipse is, if it is small and in its box, and all of it lies in the window: what is drawn most.
#[inline(always)]
pub(crate) fn disc(ellipse: &Ellipse, window: Rect) -> Option<Disc> {
    let area = ellipse.extent;
    let inside = area.intersection(window) == area && !area.is_empty();
    let diameter = area.x1.wrapping_sub(area.x0);
    (!COMPACT && inside && ellipse.curve.is_none() && is_small_disc(area)).then(|| Disc::new(area, diameter))
}

/// The rows of a whole disc from the top to the middle, each with the row that mirrors it: [`fill_by`] without what
/// clipping takes, and with fewer registers.
///
/// With u of the first pixel that is not drawn and v of the row, `f = floor((u^2 + v^2 - a^2 - 1) / 4)`.
pub(crate) struct Disc {
    f: i32,
    /// What f gains to the next pixel.
    step: i32,
    /// What f gains to the next row.
    down: i32,
    /// The first pixel that is not drawn, from the one right of the middle on.
    end: i32,
    /// Both ends of a row together.
    sum: i32,
    y: i32,
    /// The row after the one that mirrors y.
    last: i32,
    /// How many are left.
    rows: u32,
}

impl Disc {
    /// By its box, at most 32,768 pixels wide. In a larger box it is the four corners: the halves of the disc are moved
    /// apart, and the rows between are left out.
    #[inline(always)]
    pub(super) fn new(Rect { x0, y0, x1, y1 }: Rect, diameter: i32) -> Self {
        // From the middle, u = 0 or 1, on the first row, v = 1 - a.
        let odd = diameter & 1;
        let half = diameter.wrapping_add(odd) >> 1;
        Self {
            f: (1 - odd).wrapping_sub(diameter.wrapping_mul(2)) >> 2,
            step: 2 - odd,
            down: 2_i32.wrapping_sub(diameter),
            end: x1.wrapping_sub(half),
            sum: x0.wrapping_add(x1),
            y: y0,
            last: y1,
            rows: unsigned(half),
        }
    }
}

impl Iterator for Disc {
    type Item = [ClippedSpan; 2];

    #[inline(always)]
    fn next(&mut self) -> Option<[ClippedSpan; 2]> {
        self.rows = self.rows.checked_sub(1)?;
        while self.f < 0 {
            self.f = self.f.wrapping_add(self.step);
            self.step = self.step.wrapping_add(2);
            self.end = self.end.wrapping_add(1);
            // Unrolled, the loop costs more than it saves: mostly it is taken once or not at all.
            keep_rolled();
        }
        let y = self.y;
        self.f = self.f.wrapping_add(self.down);
        self.down = self.down.wrapping_add(2);
        self.y = y.wrapping_add(1);
        self.last = self.last.wrapping_sub(1);
        // Never empty: on every row of a disc the pixels next to the middle lie inside.
        Some([y, self.last].map(|y| ClippedSpan::inside(y, self.sum.wrapping_sub(self.end), self.end)))
    }
}

/// All other ellipses, with one copy of the surface's code.
#[inline(never)]
fn fill_any(ellipse: &Ellipse, clip: Rect, emit: &mut dyn FnMut(ClippedSpan)) {
    let curve = ellipse.curve();
    match curve.size() {
        Size::Small if !COMPACT => fill_by::<Wrapping<i32>>(&curve, clip, emit),
        Size::Large => fill_by::<Wrapping<i128>>(&curve, clip, emit),
        _ => fill_by::<Wrapping<i64>>(&curve, clip, emit),
    }
}

#[inline(always)]
fn fill_by<T: Number>(curve: &Curve, clip: Rect, mut emit: impl FnMut(ClippedSpan)) {
    let mut rows = Rows::<T>::new(curve, clip);
    for y in clip.y0..clip.y1 {
        let (x0, x1) = rows.row();
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(clip) {
            emit(span);
        }
    }
}

/// The rows of any ellipse, one after the other.
#[derive(Copy, Clone)]
pub(super) enum AnyRows {
    Small(Rows<Wrapping<i32>>),
    Medium(Rows<Wrapping<i64>>),
    Large(Rows<Wrapping<i128>>),
}

impl AnyRows {
    /// From the first row of `clip` on, which lies inside of the extent.
    pub(super) fn new(ellipse: &Ellipse, clip: Rect) -> Self {
        let curve = ellipse.curve();
        match curve.size() {
            Size::Small if !COMPACT => Self::Small(Rows::new(&curve, clip)),
            Size::Large => Self::Large(Rows::new(&curve, clip)),
            _ => Self::Medium(Rows::new(&curve, clip)),
        }
    }

    /// First pixel and the one after the last of this row, right where they are visible; goes to the next row.
    #[inline(never)]
    pub(super) fn row(&mut self) -> (i32, i32) {
        match self {
            Self::Small(rows) => rows.row(),
            Self::Medium(rows) => rows.row(),
            Self::Large(rows) => rows.row(),
        }
    }
}

/// The pixels whose centres lie in a square, given by its centre and its side, to 1/256 pixel: left and top sides in, right
/// and bottom sides out. A square point.
/// ```
/// use embedded_raster::{raster::ellipse, Rect, PointFx};
/// use fixed::types::I24F8;
/// let at = PointFx::from_bits(640, 640); // the centre of pixel (2, 2)
/// assert_eq!(ellipse::square(at, I24F8::from_num(3)), Rect::new(1, 1, 4, 4));
/// ```
pub fn square(centre: PointFx, size: I24F8) -> Rect {
    let (x, y) = bits(centre);
    let size = size.to_bits();
    // ceil((2 c - size - 256) / 512)
    let pixel = |c: i32, size: i64| narrow((i64::from(c) * 2 + size + 255) >> 9);
    let (low, high) = (difference(0, size), i64::from(size));
    Rect::new(pixel(x, low), pixel(y, low), pixel(x, high), pixel(y, high))
}
