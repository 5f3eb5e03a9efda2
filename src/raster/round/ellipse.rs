//! Circles and ellipses, filled and in outline.
//!
//! **Filled.** A pixel is drawn when its centre lies inside of the curve `(u/a)^2 + (v/b)^2 = 1`, u and v being the
//! distances from the centre along x and y.
//! - Of an ellipse [in a box](Ellipse::in_box) the curve touches the sides of the box, and a centre on the curve is inside:
//!   what is drawn is as symmetric as the box.
//! - Of an ellipse by [centre and radii](Ellipse::new) the same, if its centre is a centre or a corner of a pixel or the middle of a
//!   side. Around any other place there is nothing to be symmetric: a centre on the curve is inside on the left half and outside
//!   on the right, of a row the pixels with `x0 <= cx < x1`, as for polygons.
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
//! midpoint between two pixels. There is no switch from one region to another, which is what breaks thin ellipses. From row to
//! row the number of visible pixels inside of the curve grows, and later shrinks. Each pixel more or less is an addition and a
//! comparison, so there are as many of these as visible rows and columns.
//!
//! Work: filled, twice as many of these rounds at most as there are rows and columns of the window in the box; in outline four
//! times as many.
//!
//! Range: any box, any centre and radii. Circles up to a diameter of 32,768 pixels by their box or 256 by their radius, and
//! ellipses up to 300 x 300, are followed in 32 bits, up to 65,536 (1,022 by radius) in 64, all others in 128.
//!
//! Sources: M. Pitteway, "Algorithm for drawing ellipses or hyperbolae with a digital plotter", Computer Journal 10(3), 1967
//! (signs at midpoints); R. Klette, A. Rosenfeld, "Digital Geometry", 2004 (grid-intersection digitisation).

use core::num::Wrapping;

use fixed::types::I24F8;

pub use super::{
    curve::Ellipse,
    outline::{enclosed, outline},
};
use super::{
    curve::{Curve, Size},
    disc::{self, Disc},
    form::{Number, Rows, NARROW},
};
use crate::{
    geom::{bits, PointFx},
    num::{cast::narrow, round::difference},
    span::{ClippedSpan, Rect, Sink, Span},
};

/// Emits the spans of a filled ellipse that lie in `window`, top row first.
///
/// Cannot fail. Work: additions, as many as there are visible rows and columns.
/// ```
/// use embedded_raster::{raster::ellipse, ClippedSpan, Ellipse, Rect};
/// let mut widths = vec![];
/// let disc = Ellipse::in_box(Rect::new(0, 0, 7, 7));
/// ellipse::fill(disc, Rect::new(0, 0, 64, 48), |s: ClippedSpan| widths.push(s.len()));
/// assert_eq!(widths, [3, 5, 7, 7, 7, 5, 3]);
/// ```
#[inline]
pub fn fill(ellipse: Ellipse, window: Rect, sink: impl Sink) {
    if let Some(disc) = Disc::of(&ellipse, window) {
        return disc::fill(&disc, sink);
    }
    let clip = ellipse.extent().intersection(window);
    if !clip.is_empty() {
        let mut sink = sink;
        fill_any(&ellipse, clip, &mut |span| sink.span(span));
    }
}

/// All other ellipses. Numbers of all widths share one copy of the sink's code: that is what the `dyn` is for.
#[inline(never)]
fn fill_any(ellipse: &Ellipse, clip: Rect, emit: &mut dyn FnMut(ClippedSpan)) {
    let curve = ellipse.curve();
    match curve.size() {
        Size::Small if NARROW => fill_by::<Wrapping<i32>>(&curve, clip, emit),
        Size::Large => fill_by::<Wrapping<i128>>(&curve, clip, emit),
        _ => fill_by::<Wrapping<i64>>(&curve, clip, emit),
    }
}

#[inline(always)]
fn fill_by<T: Number>(curve: &Curve, clip: Rect, emit: &mut dyn FnMut(ClippedSpan)) {
    let mut rows = Rows::<T>::new(curve, clip);
    for y in clip.y0..clip.y1 {
        let (x0, x1) = rows.row();
        if let Some(span) = (Span { y, x0, x1 }).clip_columns(clip) {
            emit(span);
        }
    }
}

/// The pixels whose centres lie in a square, given by its centre and its side, to 1/256 pixel: left and top sides in, right
/// and bottom sides out. A square point.
/// ```
/// use embedded_raster::{px, raster::ellipse, Rect, PointFx};
/// let at = PointFx::from_bits(640, 640); // the centre of pixel (2, 2)
/// assert_eq!(ellipse::square(at, px(3)), Rect::new(1, 1, 4, 4));
/// ```
pub fn square(centre: PointFx, size: I24F8) -> Rect {
    let (x, y) = bits(centre);
    let size = size.to_bits();
    // ceil((2 c - size - 256) / 512)
    let pixel = |c: i32, size: i64| narrow((i64::from(c) * 2 + size + 255) >> 9);
    let (low, high) = (difference(0, size), i64::from(size));
    Rect::new(pixel(x, low), pixel(y, low), pixel(x, high), pixel(y, high))
}
