//! Elliptic arcs and turned ellipses, as cubic curves of a path.
//!
//! An [`Arc`] goes from one place to another on an ellipse with these radii, which is turned by an angle. Mostly there are two such
//! ellipses, and two arcs on each; two flags choose one. SVG, HPGL and PDF writers have them so.
//! ```text
//!            .-----.                    P(s) = centre + T sin s + N cos s,   s from -h to h
//!        .-'    N    '-.
//!      .'       ^       '.              T  half of the diameter along the chord, in its direction
//!     /         |         \             N  half of the diameter that T is conjugate to: the arc bulges there.
//!    |      centre --> T   |               On a circle both are as long as the radius.
//!     \         |         /             h  half of the arc's angle, as it is on a circle
//!   from '------+------' to
//! ```
//! **How it is found.** Turned back by its rotation, and with x and y divided by the radii, an ellipse is a circle of radius 1, and
//! the way from `from` to `to` a chord of it, twice the vector a. Then `sin h = |a|`, which gives h, or half a turn less h for a
//! large arc; a / |a| is T and, turned by a quarter, N. Both are brought back to the ellipse. If a is longer than 1, no ellipse
//! of these radii goes through both ends: it is enlarged until one does, which has its centre between them, and half of it is
//! the arc. If a radius is 0, the arc is a line, and if both ends are the same place it is nothing. These are the rules of SVG.
//!
//! **Curves.** The arc is cut into pieces of equal s, and each becomes a cubic curve whose control points are on the tangents, as
//! far from its ends as `4/3 tan(1/4 of its angle)` times the conjugate radius. Such a curve is never inside of the ellipse, and
//! outside of it by less than `r a^6 / 55,000` for an angle a. So 4 pieces a turn are enough up to a radius of 16 pixels, and twice
//! as many up to 64 times that: all curves are within 1/150 pixel of the ellipse. They become lines as all curves do.
//!
//! **Rounding.** T and N are computed to 30 bits and s to `2^-32` turns: an arc is off by up to `2^-28` of its radius, 1/30 pixel
//! where that is the largest there is, and less than 1/256 pixel up to 1,000,000 pixels. Then control points are rounded to
//! the nearest 1/256 pixel, after the map if there is [one](Curves::mapped). Where both ends are nearer to each other than `2^-30` of
//! the radius, the arc is a line. An arc and the same arc from its end to its start are the same curves: shapes that share it
//! leave no gap.
//!
//! Range: any `I24F8`; radii without their signs, with what is below `2^-30` of the other one rounded. Work: up to 64 pieces.
//!
//! Sources: "Scalable Vector Graphics 2", W3C, appendix B.2 (ends to centre, radii out of range); L. Maisonobe, "Drawing an
//! elliptical arc using polylines, quadratic or cubic Bézier curves", 2003 (control points).

use core::num::NonZeroU32;

use fixed::types::I24F8;

use super::{
    affine::{in_range, Affine, Fine},
    angle::Angle,
    path::PathSegment,
    point::{bits, PointFx},
};
use crate::num::{
    cast::{low_u32, narrow, saturate, signed, signed_wide, unsigned},
    recip::{inverse_root_wide, Denominator, Divisor},
    wide::Sum,
};

/// 1 as the square of a number in 2.30.
const ONE: u64 = 1 << 60;
/// A quarter of a turn, and half of one.
const QUARTER: u32 = 1 << 30;
const HALF: u32 = 1 << 31;

/// An arc of an ellipse from one place to another.
///
/// ```
/// use embedded_raster::{geom::Arc, px, Canvas, EdgeSlot, FillRule, Framebuffer, Index1, PathSegment::*, PointFx};
/// // A slice of a pie: from the middle up, clockwise to the right, and back.
/// let (middle, top, right) = (PointFx::px(0, 8), PointFx::px(0, 0), PointFx::px(8, 8));
/// let arc = Arc { is_clockwise: true, ..Arc::circle(px(8)) };
/// let slice = [MoveTo(middle), LineTo(top)].into_iter().chain(arc.between(top, right)).chain([Close]);
/// let mut ram = [0; 8];
/// let mut frame = Framebuffer::<Index1>::new(&mut ram, 8, 8)?;
/// frame.fill_path_fx(slice, FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], Index1::MAX)?;
/// assert_eq!(ram[..4], [0b1110_0000, 0b1111_1000, 0b1111_1100, 0b1111_1110]);
/// assert_eq!(ram[4..], [0b1111_1110, 0b1111_1111, 0b1111_1111, 0b1111_1111]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Arc {
    /// Half of the ellipse's width, and half of its height, before it is turned.
    pub radii: [I24F8; 2],
    /// How far the ellipse is turned, clockwise as seen on the screen.
    pub rotation: Angle,
    /// The arc is more than half of the ellipse.
    pub is_large: bool,
    /// It goes clockwise, as seen on the screen: SVG's sweep flag.
    pub is_clockwise: bool,
}

impl Arc {
    /// The shorter arc of a circle, anticlockwise.
    #[inline]
    pub const fn circle(radius: I24F8) -> Self {
        Self { radii: [radius, radius], rotation: Angle::from_bits(0), is_large: false, is_clockwise: false }
    }

    /// The arc from one place to another: what follows in a path that is at `from`.
    pub const fn between(self, from: PointFx, to: PointFx) -> Curves {
        let [x, y] = self.radii;
        FineArc {
            radii: (fine(x.to_bits()), fine(y.to_bits())),
            rotation: self.rotation,
            is_large: self.is_large,
            is_clockwise: self.is_clockwise,
        }
        .between(fine_place(from), fine_place(to), Affine::IDENTITY)
    }
}

/// Units of 1/256 in units of 1/65,536.
const fn fine(n: i32) -> i64 {
    (n as i64) << 8
}

const fn fine_place(place: PointFx) -> Fine {
    let (x, y) = bits(place);
    (fine(x), fine(y))
}

/// An [`Arc`] whose radii are in units of 1/65,536 pixel.
#[derive(Copy, Clone, Debug)]
pub(super) struct FineArc {
    pub(super) radii: Fine,
    pub(super) rotation: Angle,
    pub(super) is_large: bool,
    pub(super) is_clockwise: bool,
}

impl FineArc {
    /// Nothing if both ends are the same place, and a line if a radius is 0.
    pub(super) const fn between(self, from: Fine, to: Fine, map: Affine) -> Curves {
        let chord = (to.0.wrapping_sub(from.0), to.1.wrapping_sub(from.1));
        let line = Curves { at: from, end: to, count: 1, ..Curves::nothing(map) };
        if chord.0 == 0 && chord.1 == 0 {
            return Curves { count: 0, ..line };
        }
        // Shifted so that the longest of all lengths has 30 bits. Chords are below 2^40.
        let (rx, ry) = (self.radii.0.unsigned_abs(), self.radii.1.unsigned_abs());
        let size = chord.0.unsigned_abs() | chord.1.unsigned_abs() | rx | ry;
        let up = signed(size.leading_zeros()).wrapping_sub(34);
        let (Some(rx), Some(ry)) = (radius(rx, up), radius(ry, up)) else { return line };
        let (cos, sin) = self.rotation.cos_sin();
        let (x, y) = turned((shifted(chord.0, up), shifted(chord.1, up)), (cos, sin.wrapping_neg()));
        // The vector a, in 2.30; its coordinates stop at 2.
        let (u, v) = (saturate(ratio(x, 1 << 29, rx)), saturate(ratio(y, 1 << 29, ry)));
        let square = Sum::ZERO.plus(u, u).plus(v, v).of_squares();
        if square == 0 {
            return line;
        }
        // All vectors are twice as long as they are called, so that the middle of the chord is exact.
        let (t, n, angle, cos_half) = if square >= ONE {
            let n = (ratio(y, rx.get(), ry), ratio(x, ry.get(), rx).wrapping_neg());
            (chord, turned_wide(n, (cos, sin), up), QUARTER, 0)
        } else {
            // a / |a|, from the reciprocal of the root: inverse 2^(shift / 2 - 62).
            let (inverse, shift) = inverse_root_wide(square);
            let down = 32_u32.wrapping_sub(shift >> 1);
            let (u, v) = (part(u, inverse, down), part(v, inverse, down));
            let t = turned((part(u, rx.get(), 30), part(v, ry.get(), 30)), (cos, sin));
            let n = turned((part(v, rx.get(), 30), part(u, ry.get(), 30).wrapping_neg()), (cos, sin));
            let up = 1_i32.wrapping_sub(up);
            let cos_half = root(ONE.wrapping_sub(square));
            (lifted(t, up), lifted(n, up), angle_of(cos_half, root(square)), cos_half)
        };
        // As it is, N is for an arc that goes clockwise and is not large.
        let n = if self.is_clockwise { n } else { (n.0.wrapping_neg(), n.1.wrapping_neg()) };
        let (half, cos_half) =
            if self.is_large { (HALF.wrapping_sub(angle), cos_half.wrapping_neg()) } else { (angle, cos_half) };
        let middle = (from.0.wrapping_add(to.0), from.1.wrapping_add(to.1));
        let centre = (middle.0.wrapping_sub(times(n.0, cos_half)), middle.1.wrapping_sub(times(n.1, cos_half)));
        Curves { centre, t, n, half, ..line }.cut()
    }
}

/// The curves of an [`Arc`] or of an [ellipse](Curves::ellipse): segments of a path.
#[derive(Clone, Debug)]
pub struct Curves {
    /// Twice the centre, T and N of an arc.
    centre: Fine,
    t: Fine,
    n: Fine,
    /// Half of the angle: up to half a turn. It is 0 for a line.
    half: u32,
    /// The pieces, and how many of them are done.
    count: u32,
    done: u32,
    /// How far control points are from the ends of a piece: a factor for T and N, in 2.30.
    handle: i32,
    /// Where the last piece ended, and where the last one of all ends.
    at: Fine,
    end: Fine,
    /// A move to its start comes first.
    has_move: bool,
    /// It is closed.
    closes: bool,
    map: Affine,
}

impl Curves {
    const fn nothing(map: Affine) -> Self {
        Self {
            centre: (0, 0),
            t: (0, 0),
            n: (0, 0),
            half: 0,
            count: 0,
            done: 0,
            handle: 0,
            at: (0, 0),
            end: (0, 0),
            has_move: false,
            closes: false,
            map,
        }
    }

    /// An ellipse with two radii that is turned clockwise, as seen on the screen, by an angle: a closed contour, which goes
    /// clockwise from the end of its first radius. Radii count without their signs.
    /// ```
    /// use embedded_raster::{geom::Curves, px, Angle, Canvas, EdgeSlot, FillRule, Framebuffer, Index1, PointFx};
    /// let leaf = Curves::ellipse(PointFx::px(4, 4), [px(5), px(3)], Angle::degrees(45));
    /// let mut ram = [0; 8];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 8, 8)?;
    /// frame.fill_path_fx(leaf, FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], Index1::MAX)?;
    /// assert_eq!(ram[..4], [0b1111_0000, 0b1111_1100, 0b1111_1110, 0b1111_1110]);
    /// assert_eq!(ram[4..], [0b0111_1111, 0b0111_1111, 0b0011_1111, 0b0000_1111]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub const fn ellipse(centre: PointFx, radii: [I24F8; 2], rotation: Angle) -> Self {
        let [rx, ry] = radii;
        let (rx, ry) = (fine(rx.to_bits()).abs().wrapping_mul(2), fine(ry.to_bits()).abs().wrapping_mul(2));
        let (x, y) = fine_place(centre);
        let (cos, sin) = rotation.cos_sin();
        // From -1/2 turn on, where the place is centre - N.
        let n = (times(rx, cos).wrapping_neg(), times(rx, sin).wrapping_neg());
        let t = (times(ry, sin), times(ry, cos).wrapping_neg());
        let start = (in_range(x.wrapping_sub(nearest(n.0, 1))), in_range(y.wrapping_sub(nearest(n.1, 1))));
        let centre = (x.wrapping_mul(2), y.wrapping_mul(2));
        let half = HALF;
        let nothing = Self::nothing(Affine::IDENTITY);
        Self { centre, t, n, half, at: start, end: start, has_move: true, closes: true, ..nothing }.cut()
    }

    /// The part of an ellipse with axes along x and y that lies between two directions, as seen from its centre: an open contour, which
    /// goes clockwise from `start` to `end`. From an angle to itself there is nothing, and of an ellipse with a radius of 0 neither.
    /// Radii count without their signs.
    ///
    /// The ends are off by `2^-30` of the radius, and by that times the square of the ratio of both radii. Arcs that follow each other
    /// meet.
    /// ```
    /// use embedded_raster::{geom::Curves, px, Angle, PathSegment::*, PointFx};
    /// let quarter = Curves::arc(PointFx::px(20, 10), [px(8), px(4)], Angle::degrees(180), Angle::degrees(270));
    /// let segments: Vec<_> = quarter.collect();
    /// assert_eq!(segments[0], MoveTo(PointFx::px(12, 10)));
    /// assert!(matches!(segments[1..], [CubicTo(_, _, end)] if end == PointFx::px(20, 6)));
    /// ```
    pub const fn arc(centre: PointFx, radii: [I24F8; 2], start: Angle, end: Angle) -> Self {
        Self::between_directions(centre, radii, [start, end], false)
    }

    /// An [arc](Self::arc), or the whole ellipse from the first direction on, which is closed.
    pub(crate) const fn between_directions(
        centre: PointFx,
        [rx, ry]: [I24F8; 2],
        [start, end]: [Angle; 2],
        is_whole: bool,
    ) -> Self {
        let nothing = Self::nothing(Affine::IDENTITY);
        let (rx, ry) = (rx.to_bits().unsigned_abs(), ry.to_bits().unsigned_abs());
        let turn = start.clockwise_to(end);
        if rx == 0 || ry == 0 || turn == 0 && !is_whole {
            return nothing;
        }
        let [a, b] = [on_ellipse([rx, ry], start.cos_sin()), on_ellipse([rx, ry], end.cos_sin())];
        let [from, to] = if rx == ry { [start, end] } else { [full_angle(a), full_angle(b)] };
        // Directions that are nearly the same may meet the ellipse in one place, or in one before the other.
        let length = from.clockwise_to(to);
        let half = if is_whole || turn > HALF && length < QUARTER {
            HALF
        } else if turn < HALF && length > QUARTER.wrapping_mul(3) {
            return nothing;
        } else {
            (length >> 1).wrapping_add(length & 1)
        };
        if half == 0 {
            return nothing;
        }
        let (x, y) = fine_place(centre);
        let (rx, ry) = ((rx as i64) << 8, (ry as i64) << 8);
        // Twice the radii.
        let (cos, sin) = from.plus(signed(half)).cos_sin();
        let n = (times(rx.wrapping_mul(2), cos), times(ry.wrapping_mul(2), sin));
        let t = (times(rx.wrapping_mul(2), sin).wrapping_neg(), times(ry.wrapping_mul(2), cos));
        let at = (in_range(x.wrapping_add(times(rx, a.0))), in_range(y.wrapping_add(times(ry, a.1))));
        let end = (in_range(x.wrapping_add(times(rx, b.0))), in_range(y.wrapping_add(times(ry, b.1))));
        let centre = (x.wrapping_mul(2), y.wrapping_mul(2));
        let end = if is_whole { at } else { end };
        Self { centre, t, n, half, at, end, has_move: true, closes: is_whole, ..nothing }.cut()
    }

    /// Around a corner: a piece of a circle. Twice its centre, T and N, half of its angle, and its ends.
    pub(super) const fn around(centre: Fine, [t, n]: [Fine; 2], half: u32, [at, end]: [Fine; 2]) -> Self {
        Self { centre, t, n, half, at, end, ..Self::nothing(Affine::IDENTITY) }.cut()
    }

    /// The same, mapped. Pieces are as many as the mapped ellipse needs, and places are rounded after the map only.
    #[must_use]
    pub const fn mapped(self, map: Affine) -> Self {
        Self { map: self.map.then(map), ..self }.cut()
    }

    /// Cuts it into pieces.
    const fn cut(self) -> Self {
        if self.half == 0 {
            return self;
        }
        // Half the width or height of the box around it, in 1/256 pixel, below 2^35; then as the map makes it.
        let width = self.t.0.unsigned_abs().wrapping_add(self.n.0.unsigned_abs());
        let height = self.t.1.unsigned_abs().wrapping_add(self.n.1.unsigned_abs());
        let size = if width > height { width } else { height } >> 9;
        let size = size.wrapping_mul(self.map.growth() as u64 >> 4) >> 12;
        // 4 pieces a turn for 16 pixels; twice as many for 64 times that.
        let (mut level, mut most) = (0, 16 << 8);
        while level < 4 && size > most {
            (level, most) = (level + 1, most << 6);
        }
        let shift = 29_u32.wrapping_sub(level);
        let count = self.half.wrapping_add((1_u32 << (shift & 31)).wrapping_sub(1)) >> (shift & 31);
        let quarter = share(self.half, 1, count.wrapping_mul(2));
        let (cos, sin) = Angle::from_bits(quarter).cos_sin();
        // The tangent of 1/16 turn at most: 0.42.
        let tangent = Denominator::new(cos).under((sin as i64) << 30);
        Self { count, handle: tangent.wrapping_mul(4) / 3, ..self }
    }

    /// The next segment; `None` at the end. [`next`](Iterator::next) does the same, but not when a program is compiled.
    pub const fn step(&mut self) -> Option<PathSegment> {
        if self.has_move && self.done == 0 {
            // The move counts as a piece, and so does the way back.
            self.done = 1;
            return Some(PathSegment::MoveTo(self.map.apply_fine(self.at)));
        }
        let moves = self.has_move as u32;
        let piece = self.done.wrapping_sub(moves);
        if piece >= self.count {
            if self.closes && piece == self.count {
                self.done = self.done.wrapping_add(1);
                return Some(PathSegment::Close);
            }
            return None;
        }
        self.done = self.done.wrapping_add(1);
        let is_last = piece.wrapping_add(1) == self.count;
        if self.half == 0 {
            return Some(PathSegment::LineTo(self.map.apply_fine(self.end)));
        }
        let (_, leaving) = self.at_piece(piece);
        let (to, arriving) = self.at_piece(piece.wrapping_add(1));
        let to = if is_last { self.end } else { to };
        let c = (in_range(self.at.0.wrapping_add(leaving.0)), in_range(self.at.1.wrapping_add(leaving.1)));
        let d = (in_range(to.0.wrapping_sub(arriving.0)), in_range(to.1.wrapping_sub(arriving.1)));
        self.at = to;
        Some(PathSegment::CubicTo(self.map.apply_fine(c), self.map.apply_fine(d), self.map.apply_fine(to)))
    }

    /// The place where so many pieces are done, and the way from there to the next control point.
    const fn at_piece(&self, piece: u32) -> (Fine, Fine) {
        // From -count to count.
        let steps = signed(piece.wrapping_mul(2).wrapping_sub(self.count));
        let angle = share(self.half, steps.unsigned_abs(), self.count);
        let (cos, sin) = Angle::from_bits(if steps < 0 { angle.wrapping_neg() } else { angle }).cos_sin();
        let x = self.centre.0.wrapping_add(times(self.t.0, sin)).wrapping_add(times(self.n.0, cos));
        let y = self.centre.1.wrapping_add(times(self.t.1, sin)).wrapping_add(times(self.n.1, cos));
        let (cos, sin) = (part(cos, unsigned(self.handle), 30), part(sin, unsigned(self.handle), 30));
        let right = times(self.t.0, cos).wrapping_sub(times(self.n.0, sin));
        let down = times(self.t.1, cos).wrapping_sub(times(self.n.1, sin));
        ((in_range(nearest(x, 1)), in_range(nearest(y, 1))), (nearest(right, 1), nearest(down, 1)))
    }
}

impl Iterator for Curves {
    type Item = PathSegment;

    #[inline]
    fn next(&mut self) -> Option<PathSegment> {
        self.step()
    }
}

/// `n / 2^shift`, rounded to the nearest number, halves away from 0.
const fn nearest(n: i64, shift: u32) -> i64 {
    if shift == 0 {
        return n;
    }
    let size = n.unsigned_abs().wrapping_add(1 << (shift.wrapping_sub(1) & 63)) >> (shift & 63);
    with_sign_of(n, size)
}

const fn with_sign_of(n: i64, size: u64) -> i64 {
    if n < 0 {
        signed_wide(size).wrapping_neg()
    } else {
        signed_wide(size)
    }
}

/// `n 2^up`. The caller knows that it has 31 bits.
const fn shifted(n: i64, up: i32) -> i32 {
    narrow(if up >= 0 { n << (up & 63) } else { nearest(n, up.unsigned_abs()) })
}

/// A radius, times `2^up`: at least 1, or `None` if it is 0.
const fn radius(n: u64, up: i32) -> Option<NonZeroU32> {
    if n == 0 {
        return None;
    }
    let n = unsigned(shifted(signed_wide(n), up));
    NonZeroU32::new(if n == 0 { 1 } else { n })
}

/// `n factor / 2^shift`, rounded to nearest. The caller knows that it has 31 bits.
pub(super) const fn part(n: i32, factor: u32, shift: u32) -> i32 {
    narrow(nearest((n as i64).wrapping_mul(factor as i64), shift))
}

/// `n factor / 2^30`, rounded to nearest, for n up to `2^45`: the upper and the lower part of n, one by one.
pub(super) const fn times(n: i64, factor: i32) -> i64 {
    let size = n.unsigned_abs();
    let by = factor.unsigned_abs() as u64;
    let low = (size & 0xffff).wrapping_mul(by);
    let product = (size >> 16).wrapping_mul(by).wrapping_add(low >> 16).wrapping_add(1 << 13) >> 14;
    with_sign_of(if factor < 0 { n.wrapping_neg() } else { n }, product)
}

/// A vector below `2^30`, turned.
const fn turned((x, y): (i32, i32), (cos, sin): (i32, i32)) -> (i32, i32) {
    let right = Sum::ZERO.plus(x, cos).minus(y, sin).total();
    let down = Sum::ZERO.plus(x, sin).plus(y, cos).total();
    (narrow(nearest(right, 30)), narrow(nearest(down, 30)))
}

/// A longer vector, turned, and divided by `2^up`. A coordinate beyond `2^42` may be any number beyond that.
const fn turned_wide((x, y): (i64, i64), direction: (i32, i32), up: i32) -> Fine {
    let bits = 64_u32.wrapping_sub((x.unsigned_abs() | y.unsigned_abs()).leading_zeros());
    let down = bits.saturating_sub(30);
    lifted(turned((narrow(nearest(x, down)), narrow(nearest(y, down))), direction), signed(down).wrapping_sub(up))
}

/// A vector times `2^up`, or `2^12` if that is more.
const fn lifted((x, y): (i32, i32), up: i32) -> Fine {
    if up < 0 {
        return (nearest(x as i64, up.unsigned_abs()), nearest(y as i64, up.unsigned_abs()));
    }
    let up = if up > 12 { 12 } else { up };
    ((x as i64) << up, (y as i64) << up)
}

/// `n factor / d`, rounded to nearest, halves away from 0.
pub(super) const fn ratio(n: i32, factor: u32, d: NonZeroU32) -> i64 {
    let size = (n.unsigned_abs() as u64).wrapping_mul(factor as u64);
    // Two steps of long division.
    let divisor = Divisor::new(d);
    let (high, rest) = divisor.div_rem(size >> 32);
    let (low, rest) = divisor.div_rem((rest as u64) << 32 | low_u32(size) as u64);
    let up = (rest >= d.get().wrapping_sub(rest)) as u64;
    with_sign_of(n as i64, ((high as u64) << 32 | low as u64).wrapping_add(up))
}

/// `angle n / d` for n up to d, rounded down.
const fn share(angle: u32, n: u32, d: u32) -> u32 {
    match NonZeroU32::new(d) {
        Some(d) => Divisor::new(d).div_rem((angle as u64).wrapping_mul(n as u64)).0,
        None => 0,
    }
}

/// The square root of a number up to `2^60`, at most 1 off.
pub(super) const fn root(n: u64) -> i32 {
    if n == 0 {
        return 0;
    }
    let (inverse, shift) = inverse_root_wide(n);
    // n is m 2^(32 - shift), and m from 2^30 on.
    let m = (n << (shift & 63)) >> 32;
    let root = m.wrapping_mul(inverse as u64) >> ((shift >> 1).wrapping_add(29) & 63);
    signed(low_u32(root.wrapping_add(1) >> 1))
}

/// Where a ray in a direction, given as a vector in 2.30, meets an ellipse with axes along x and y: the place divided by the radii, a
/// place on the circle of radius 1, in 2.30. Both radii may be in any unit, and neither is 0.
pub(crate) const fn on_ellipse([rx, ry]: [u32; 2], direction: (i32, i32)) -> (i32, i32) {
    let most = match NonZeroU32::new(if rx > ry { rx } else { ry }) {
        Some(most) if rx != ry && direction.0 != 0 && direction.1 != 0 => most,
        _ => return direction,
    };
    // The place (s cos, s sin) is on it where ((s cos / rx), (s sin / ry)) has the length 1.
    let x = narrow(ratio(direction.0, ry, most));
    let y = narrow(ratio(direction.1, rx, most));
    let square = Sum::ZERO.plus(x, x).plus(y, y).of_squares();
    if square == 0 {
        return direction;
    }
    let (inverse, shift) = inverse_root_wide(square);
    let down = 32_u32.wrapping_sub(shift >> 1);
    (part(x, inverse, down), part(y, inverse, down))
}

/// The angle of a vector of length 1 in 2.30.
const fn full_angle((cos, sin): (i32, i32)) -> Angle {
    let angle = angle_of(cos.wrapping_abs(), sin.wrapping_abs());
    let angle = if cos < 0 { HALF.wrapping_sub(angle) } else { angle };
    Angle::from_bits(if sin < 0 { angle.wrapping_neg() } else { angle })
}

/// The angle whose cosine and sine, neither of them negative, are given in 2.30.
///
/// By Newton's method, from the sine on: an angle that is e off has the sine of e as its cross product with what is looked for,
/// and is e^3 / 6 off when that is added. The sine is off by 0.57 at most; then come 0.031, 5e-6 and nothing.
pub(super) const fn angle_of(cos: i32, sin: i32) -> u32 {
    /// A unit of 2.30 radians in units of `2^-32` turns, times `2^32`.
    const UNIT: i64 = 2_734_261_102;
    let (mut angle, mut error, mut round) = (0_u32, sin, 0);
    while round < 4 {
        let by = nearest((error as i64).wrapping_mul(UNIT), 32);
        angle = angle.wrapping_add(unsigned(narrow(by)));
        let (c, s) = Angle::from_bits(angle).cos_sin();
        error = Sum::ZERO.plus(sin, c).minus(cos, s).nearest(30);
        round = 1_i32.wrapping_add(round);
    }
    angle
}
