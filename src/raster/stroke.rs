//! Lines with a width: strokes of lines, polylines and paths, as the union of small convex pieces.
//!
//! Every side of the path becomes a parallelogram, every vertex a join, every end a cap. All pieces turn the same way round, so
//! filled by [`NonZero`](super::FillRule::NonZero) they are one shape: what they share is painted once.
//! ```text
//!   a+o __________ b+o    side     o = w/2 to the right of the direction, away from zero to whole units
//!      |          |
//!    a +    -->   + b     cap      Butt: none.  Square: b+o, b+o', b-o', b-o with o' = o + w/2 ahead
//!      |__________|                Round: b, b+o, the fan, b-o
//!   a-o            b-o    join     Bevel: v, v+p, v+q, p and q being the offsets of both sides on the outer side
//!                                  Miter: v, v+p, tip, v+q        Round: v, v+p, the fan, v+q
//! ```
//! **The rule.** Of a side with the difference d, both components are doubled until the larger one has 31 bits (or halved, if it
//! has 32); then `u = ceil(2^30 |d| / floor(|d|))` is its direction in units of 2^-30, `|d|` being the length, and an offset is
//! `ceil(w u / 2^31)`, rounded away from zero. A stroke is therefore never thinner than its width and at most 2 units (1/128
//! pixel) thicker, and one that is a pixel wide stays connected at any angle. The *tip* of a miter is `w (p + q) / (2 (1 + p q))`
//! for directions p and q, rounded to nearest; where `2 / (1 + p q)` is more than the square of the limit, the join is a
//! bevel. A *fan* turns by `1 / 2^j` of a circle from its first offset on, j being the least from 3 to 11 with
//! `12 * 4^j >= w`: chords within 1/8 pixel of the circle. Vertices stop at the ends of `i32`.
//!
//! Inside of a curve joins are round, whatever is asked for, as the curve is: mostly one triangle with no fan.
//!
//! **Work.** Pieces that cannot be seen are left out, and curves are followed only near the window, so work depends on what is
//! visible. Nothing is stored: the pieces are found anew for every band of rows that the edge table has room for.
//!
//! Range: any `I24F8`; widths from 0 to 65,536 pixels, miter limits to 255.

use core::{num::NonZeroU32, slice};

use fixed::types::I24F8;

use super::direction::{moved, with_sign, Direction};
use crate::{
    geom::{
        flatten::{Contour, Knot},
        Path, PointFx, View,
    },
    num::{
        cast::{low_u32, magnitude, unsigned},
        round::div_rem_wide,
    },
    rect::Rect,
};

/// How the ends of an open contour, or of a dash, look.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
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
pub enum Join {
    /// Outer borders go on until they meet; a [`Bevel`](Self::Bevel) where that is farther than the limit.
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
/// frame.stroke_polyline(&tick, false, &stroke, &mut [EdgeSlot::EMPTY; 64], Index1::MAX)?;
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
    /// In pixels and 1/256 of them, from 0 to 65,536; others count as the nearest of these.
    pub width: I24F8,
    /// Ends.
    pub cap: Cap,
    /// Corners.
    pub join: Join,
    /// How far, in widths, a miter may reach from its inner to its outer corner.
    pub miter_limit: I24F8,
    /// Gaps.
    pub dash: D,
}

impl Stroke {
    /// A solid stroke of this width, with butt caps and miter joins up to 4 widths.
    #[inline]
    pub const fn new(width: I24F8) -> Self {
        Self { width, cap: Cap::Butt, join: Join::Miter, miter_limit: I24F8::from_bits(4 << 8), dash: () }
    }

    /// The same, in whole pixels.
    #[inline]
    pub const fn px(width: u16) -> Self {
        Self::new(I24F8::from_bits((width as i32) << 8))
    }
}

impl<D> Stroke<D> {
    /// With other ends.
    #[inline]
    #[must_use]
    pub fn with_cap(self, cap: Cap) -> Self {
        Self { cap, ..self }
    }

    /// With other corners.
    #[inline]
    #[must_use]
    pub fn with_join(self, join: Join) -> Self {
        Self { join, ..self }
    }

    /// With another limit for miters.
    #[inline]
    #[must_use]
    pub fn with_miter_limit(self, miter_limit: I24F8) -> Self {
        Self { miter_limit, ..self }
    }

    fn pen(&self, window: Rect) -> Pen {
        let width = unsigned(self.width.to_bits().clamp(0, 1 << 24));
        let limit = unsigned(self.miter_limit.to_bits().clamp(0, 0xffff));
        let turn = TURNS.iter().find(|&&(most, _)| width <= most).map_or((0, 0), |turn| turn.1);
        // Half the width for round joins, times the root of 2 for the corners of a square cap, the limit for a miter.
        let far = if matches!(self.join, Join::Miter) { limit.max(384) } else { 384 };
        let reach = low_u32(u64::from(width).wrapping_mul(u64::from(far)) >> 9).wrapping_add(2);
        let view = View::of(window, reach);
        Pen { width, cap: self.cap, join: self.join, limit: limit.wrapping_mul(limit), turn, reach, view }
    }
}

impl<D: Dashing> Stroke<D> {
    /// The pieces of a stroked path that `window` may show, as closed contours for [`polygon::fill`](super::polygon::fill)
    /// by [`NonZero`](super::FillRule::NonZero).
    pub fn of_path(self, path: Path<'_>, window: Rect) -> impl Iterator<Item = Piece> + Clone + use<'_, D> {
        let pen = self.pen(window);
        let contours = if D::LENGTH_MATTERS { path.contours() } else { path.contours_near(window, pen.reach) };
        let stroke = move |contour| Pieces::new(self.dash.cut(Sides::new(contour, pen.view), pen), pen);
        OneByOne { contours, stroke, parts: None }
    }

    /// The same of lines from each place to the next, and back to the first one if they are `closed`.
    pub fn of_polyline(
        self,
        places: &[PointFx],
        closed: bool,
        window: Rect,
    ) -> impl Iterator<Item = Piece> + Clone + use<'_, D> {
        let pen = self.pen(window);
        let sides = Sides::new(Polyline { places: places.iter(), closed }, pen.view);
        Pieces::new(self.dash.cut(sides, pen), pen)
    }
}

/// The pieces of one contour after the other: a `flat_map` of half the size, as it has one end only.
#[derive(Clone, Debug)]
struct OneByOne<C, F, P> {
    contours: C,
    stroke: F,
    parts: Option<P>,
}

impl<C, F, P> Iterator for OneByOne<C, F, P>
where
    C: Iterator,
    F: FnMut(C::Item) -> P,
    P: Iterator<Item = Piece>,
{
    type Item = Piece;

    fn next(&mut self) -> Option<Piece> {
        loop {
            if let Some(part) = self.parts.as_mut().and_then(Iterator::next) {
                return Some(part);
            }
            self.parts = Some((self.stroke)(self.contours.next()?));
        }
    }
}

/// What cuts a stroke into dashes, or leaves it alone.
pub trait Dashing: Sealed {}

pub(crate) use sealed::{Dashing as Sealed, Event, Start};

impl<D: Sealed> Dashing for D {}

mod sealed {
    use super::{Direction, Pen, PointFx};

    /// What happens along a contour.
    #[derive(Copy, Clone, Debug, PartialEq, Eq)]
    pub enum Event {
        /// A side, its direction if it may be seen, and what it begins with.
        Side {
            /// From here
            a: PointFx,
            /// to here
            b: PointFx,
            /// this way.
            u: Option<Direction>,
            /// At `a`.
            start: Start,
        },
        /// The sides before end here.
        Stop,
        /// The sides before form a ring.
        Close,
        /// A contour without length.
        Dot(PointFx),
    }

    /// What a side begins with.
    #[derive(Copy, Clone, Debug, PartialEq, Eq)]
    pub enum Start {
        /// A corner, or the end of a stroke.
        Corner,
        /// A place inside of a curve.
        Smooth,
        /// The start of a ring.
        Ring,
    }

    /// See [`Dashing`](super::Dashing).
    pub trait Dashing: Copy {
        /// Whether what is not seen must be measured nevertheless.
        const LENGTH_MATTERS: bool;
        /// Cuts sides.
        fn cut<S: Iterator<Item = Event> + Clone>(self, sides: S, pen: Pen) -> impl Iterator<Item = Event> + Clone;
    }
}

/// No dashes.
impl Sealed for () {
    const LENGTH_MATTERS: bool = false;

    #[inline]
    fn cut<S: Iterator<Item = Event> + Clone>(self, sides: S, _: Pen) -> impl Iterator<Item = Event> + Clone {
        sides
    }
}

/// For widths up to the first number: cosine and sine of the turn from one vertex of a fan to the next, times 2^30. It is
/// 1/8, 1/16 ... 1/2048 of a circle.
const TURNS: [(u32, (i32, i32)); 9] = [
    (768, (759_250_125, 759_250_125)),
    (3_072, (992_008_094, 410_903_207)),
    (12_288, (1_053_110_176, 209_476_638)),
    (49_152, (1_068_571_464, 105_245_103)),
    (196_608, (1_072_448_455, 52_686_014)),
    (786_432, (1_073_418_433, 26_350_943)),
    (3_145_728, (1_073_660_973, 13_176_464)),
    (12_582_912, (1_073_721_611, 6_588_356)),
    (u32::MAX, (1_073_736_771, 3_294_193)),
];

/// A stroke in the units of its pieces.
#[derive(Copy, Clone, Debug)]
pub struct Pen {
    pub(super) width: u32,
    cap: Cap,
    join: Join,
    /// Square of the miter limit, in 2^-16.
    limit: u32,
    turn: (i32, i32),
    /// How far from its line it may paint.
    reach: u32,
    pub(super) view: View,
}

/// Something that has nodes.
trait Outline: Clone {
    fn next_knot(&mut self) -> Option<Knot>;
    fn is_closed(&self) -> bool;
}

impl Outline for Contour<'_> {
    #[inline]
    fn next_knot(&mut self) -> Option<Knot> {
        self.next_knot()
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.is_closed()
    }
}

/// Lines from place to place.
#[derive(Clone, Debug)]
struct Polyline<'a> {
    places: slice::Iter<'a, PointFx>,
    closed: bool,
}

impl Outline for Polyline<'_> {
    #[inline]
    fn next_knot(&mut self) -> Option<Knot> {
        self.places.next().map(|&at| Knot { at, smooth: false })
    }

    #[inline]
    fn is_closed(&self) -> bool {
        self.closed
    }
}

/// The sides of a contour, without those of no length.
#[derive(Clone, Debug)]
struct Sides<O> {
    outline: O,
    view: View,
    start: PointFx,
    last: Option<Knot>,
    /// There was a side.
    moved: bool,
}

impl<O: Outline> Sides<O> {
    #[inline]
    fn new(outline: O, view: View) -> Self {
        Self { outline, view, start: PointFx::from_bits(0, 0), last: None, moved: false }
    }

    fn side(&mut self, from: Knot, b: PointFx) -> Event {
        let ring = !self.moved && self.outline.is_closed();
        let start = match from.smooth {
            _ if ring => Start::Ring,
            true => Start::Smooth,
            false => Start::Corner,
        };
        self.moved = true;
        let a = from.at;
        let u = if self.view.hides(a, b, 0) { None } else { Direction::between(a, b).map(|(u, _)| u) };
        Event::Side { a, b, u, start }
    }
}

impl<O: Outline> Iterator for Sides<O> {
    type Item = Event;

    #[inline(never)]
    fn next(&mut self) -> Option<Event> {
        while let Some(node) = self.outline.next_knot() {
            match self.last.replace(node) {
                None => self.start = node.at,
                Some(last) if last.at != node.at => return Some(self.side(last, node.at)),
                // The same place again: smooth if both are.
                Some(last) => self.last = Some(Knot { smooth: node.smooth && last.smooth, ..node }),
            }
        }
        let last = self.last.take()?;
        let closed = self.outline.is_closed();
        if closed && last.at != self.start {
            self.last = Some(Knot { at: self.start, smooth: false });
            return Some(self.side(last, self.start));
        }
        Some(match closed {
            _ if !self.moved => Event::Dot(self.start),
            true => Event::Close,
            false => Event::Stop,
        })
    }
}

/// The pieces of a stroke.
#[derive(Clone, Debug)]
struct Pieces<E> {
    events: E,
    pen: Pen,
    /// What comes after the piece that was taken last.
    pending: Option<Piece>,
    /// Where the last side ended, and its direction if it was seen.
    last: Option<(PointFx, Option<Direction>)>,
    /// The direction of the first side.
    first: Option<Direction>,
}

impl<E: Iterator<Item = Event>> Pieces<E> {
    #[inline]
    fn new(events: E, pen: Pen) -> Self {
        Self { events, pen, pending: None, last: None, first: None }
    }
}

impl<E: Iterator<Item = Event>> Iterator for Pieces<E> {
    type Item = Piece;

    #[inline(never)]
    fn next(&mut self) -> Option<Piece> {
        if let Some(part) = self.pending.take() {
            return Some(part);
        }
        loop {
            let pen = &self.pen;
            let parts = match self.events.next()? {
                Event::Side { a, b, u, start } => {
                    let before = match self.last {
                        Some((_, last)) => pen.join(a, last, u, start == Start::Smooth),
                        None if start == Start::Ring => None,
                        None => pen.cap(a, u.map(Direction::back)),
                    };
                    if start == Start::Ring {
                        self.first = u;
                    }
                    self.last = Some((b, u));
                    (before, u.map(|u| pen.side(a, b, u)))
                }
                Event::Stop => (self.last.take().and_then(|(b, u)| pen.cap(b, u)), None),
                Event::Close => (self.last.take().and_then(|(b, u)| pen.join(b, u, self.first, false)), None),
                Event::Dot(at) => {
                    let u = Direction::RIGHT;
                    (pen.cap(at, Some(u)), pen.cap(at, Some(u.back())))
                }
            };
            match parts {
                (Some(part), pending) => {
                    self.pending = pending;
                    return Some(part);
                }
                (None, Some(part)) => return Some(part),
                (None, None) => {}
            }
        }
    }
}

impl Pen {
    #[inline(never)]
    fn side(&self, a: PointFx, b: PointFx, u: Direction) -> Piece {
        let (right, left) = (u.right().offset(self.width), u.right().back().offset(self.width));
        Piece::new([moved(a, right), moved(b, right), moved(b, left), moved(a, left)], 4)
    }

    /// The end of a side that goes this way.
    #[inline(never)]
    fn cap(&self, at: PointFx, u: Option<Direction>) -> Option<Piece> {
        let (right, left) = u.map(|u| (u.right(), u.right().back()))?;
        let (r, l) = (right.offset(self.width), left.offset(self.width));
        match self.cap {
            Cap::Butt => None,
            Cap::Square => {
                // Ahead is what lies to the left of the right.
                let ahead = (r.1, l.0);
                let sum = |o: (i32, i32)| (o.0.wrapping_add(ahead.0), o.1.wrapping_add(ahead.1));
                Some(Piece::new([moved(at, r), moved(at, sum(r)), moved(at, sum(l)), moved(at, l)], 4))
            }
            Cap::Round => Some(self.wedge(at, right, left, Join::Round)),
        }
    }

    /// Between two sides that meet.
    fn join(&self, at: PointFx, last: Option<Direction>, next: Option<Direction>, smooth: bool) -> Option<Piece> {
        let (last, next) = (last?, next?);
        let turn = last.cross(next);
        if turn == 0 && last.dot(next) > 0 || self.view.hides(at, at, 0) {
            return None;
        }
        // On the outer side, from one offset to the other turning left, as all pieces do.
        let (from, to) =
            if turn > 0 { (next.right().back(), last.right().back()) } else { (last.right(), next.right()) };
        Some(self.wedge(at, from, to, if smooth { Join::Round } else { self.join }))
    }

    #[inline(never)]
    fn wedge(&self, at: PointFx, from: Direction, to: Direction, join: Join) -> Piece {
        let [start, end] = [from, to].map(|o| moved(at, o.offset(self.width)));
        match join {
            Join::Miter => match self.tip(from, to) {
                Some(tip) => Piece::new([at, start, moved(at, tip), end], 4),
                None => Piece::new([at, start, end, end], 3),
            },
            Join::Bevel => Piece::new([at, start, end, end], 3),
            Join::Round => {
                let fan = Fan { centre: at, last: from, end: to, turn: self.turn, width: self.width };
                Piece { fan: Some(fan), ..Piece::new([at, start, end, end], 3) }
            }
        }
    }

    /// Where two offset borders meet, unless that is too far.
    fn tip(&self, from: Direction, to: Direction) -> Option<(i32, i32)> {
        // 1 + cos, of 31 bits.
        let c = (from.dot(to) >> 30).wrapping_add(1 << 30);
        let near = c > 0 && u64::from(self.limit).wrapping_mul(magnitude(c)) >= 1 << 47;
        let c = NonZeroU32::new(low_u32(magnitude(c))).filter(|_| near)?;
        let reach = |p: i32, q: i32| {
            let sum = i64::from(p).wrapping_add(i64::from(q));
            let n = u64::from(self.width).wrapping_mul(sum.unsigned_abs()).wrapping_add(u64::from(c.get()));
            with_sign(div_rem_wide(n >> 1, c).0, sum)
        };
        Some((reach(from.x, to.x), reach(from.y, to.y)))
    }
}

/// One piece of a stroke: the vertices of a convex contour.
#[derive(Clone, Debug)]
pub struct Piece {
    corners: [PointFx; 4],
    len: usize,
    /// How many corners are given out.
    done: usize,
    /// Comes after two corners.
    fan: Option<Fan>,
}

impl Piece {
    const fn new(corners: [PointFx; 4], len: usize) -> Self {
        Self { corners, len, done: 0, fan: None }
    }
}

impl Iterator for Piece {
    type Item = PointFx;

    #[inline(never)]
    fn next(&mut self) -> Option<PointFx> {
        if self.done == 2 {
            if let Some(v) = self.fan.as_mut().and_then(Fan::next) {
                return Some(v);
            }
        }
        let corner = self.corners.get(self.done).filter(|_| self.done < self.len)?;
        self.done = self.done.wrapping_add(1);
        Some(*corner)
    }
}

/// Vertices on a circle, between two offsets of at most half a turn.
#[derive(Clone, Debug)]
struct Fan {
    centre: PointFx,
    last: Direction,
    end: Direction,
    turn: (i32, i32),
    width: u32,
}

impl Fan {
    fn next(&mut self) -> Option<PointFx> {
        self.last = self.last.turned(self.turn);
        (self.last.cross(self.end) < 0).then(|| moved(self.centre, self.last.offset(self.width)))
    }
}
