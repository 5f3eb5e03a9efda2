//! [`Svg`]: a path as the `d` attribute of SVG has it, read while it is drawn.
//!
//! ```text
//!   "M4 4h16l-8 12z"  --Path::svg-->  Svg  --iter, mapped-->  MoveTo, LineTo, LineTo, Close
//!                       checked once        nothing is stored: each segment is read when it is asked for
//! ```
//! All commands count, with capital letters (from the corner of the plane) and small ones (from where the path is): M moves, L H V
//! are lines, C S cubic and Q T quadratic curves, A arcs, Z closes. S and T begin with the mirror image of the last control
//! point, if the command before was a curve of their kind. What follows the arguments of a command, without another letter, are
//! arguments of the same command again; after M they are those of L. Numbers need no space between them where none could be read
//! otherwise: `1.5.5-2` is 1.5, 0.5 and -2, and `a1 1 0 01.5.5` has the flags 0 and 1. A path begins with M; an empty
//! text is an empty path.
//!
//! **Numbers** are decimal, with exponents if they have any. They are rounded to the nearest 1/65,536, halves away from 0, and stop
//! at the ends of `I24F8`, from -8,388,608 to below 8,388,608. The tenth digit behind the point and all that follow do not count.
//! Sums of relative coordinates are exact, and stop there too. Places are [mapped](Svg::mapped), and rounded to 1/256 pixel
//! once, at the end: an icon of 24 units that is drawn twenty times as large has its digits to 1/65,536 of a unit.
//!
//! **Arcs** become cubic curves: see [`arc`](super::arc).
//!
//! **Work**: each character is read once to check it; then twice for each time that somebody goes over the path, as a contour is
//! searched for its end before it is drawn. Functions that take a table go over the path once for each band of rows. A program that
//! can spare 28 bytes a segment has them [written down](Svg::to_array) when it is compiled, and needs no reader.
//!
//! Source: "Scalable Vector Graphics 2", W3C, section 9.3, and "1.1", section 8.3.9, for `1.`, a number without a digit behind the
//! point.

use core::num::NonZeroU32;

use fixed::types::I16F16;

use super::{
    affine::{in_range, Affine, Fine},
    angle::Angle,
    arc::{Curves, FineArc},
    path::{Path, PathSegment},
};
use crate::{
    error::{SvgError, SvgExpected},
    num::{
        cast::{narrow, signed_wide},
        recip::Divisor,
    },
};

impl Path<'_> {
    /// Reads SVG path data: see [`svg`](mod@super::svg) for what counts.
    ///
    /// # Errors
    /// [`SvgError`], with the position of the first character that makes no sense.
    /// ```
    /// use embedded_raster::{Canvas, EdgeSlot, FillRule, Framebuffer, Index1, Path, Svg, SvgExpected};
    /// const HOUSE: Svg = match Path::svg("M4 0l4 4H7v4H1V4H0z") {
    ///     Ok(house) => house,
    ///     Err(_) => panic!("found when it is compiled"),
    /// };
    /// let mut ram = [0; 8];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 8, 8)?;
    /// frame.fill_path_fx(HOUSE, FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], Index1::MAX)?;
    /// assert_eq!(ram[2..6], [0b0111_1100, 0b1111_1110, 0b0111_1110, 0b0111_1110]);
    ///
    /// let error = Path::svg("M4 0 L8,").unwrap_err();
    /// assert_eq!((error.position, error.expected), (8, SvgExpected::Number));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub const fn svg(text: &str) -> Result<Svg<'_>, SvgError> {
        let mut reader = Reader::new(text.as_bytes());
        loop {
            match reader.command() {
                Ok(Some(_)) => {}
                Ok(None) => return Ok(Svg { text }),
                Err(expected) => {
                    return Err(SvgError { position: text.len().wrapping_sub(reader.rest.len()), expected })
                }
            }
        }
    }
}

/// SVG path data that was found to be right: see [`Path::svg`].
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Svg<'a> {
    text: &'a str,
}

impl<'a> Svg<'a> {
    /// Its segments.
    #[inline]
    pub const fn iter(self) -> SvgSegments<'a> {
        self.mapped(Affine::IDENTITY)
    }

    /// Its segments, mapped, and rounded after that.
    /// ```
    /// use embedded_raster::{fixed::types::I16F16, Affine, Path, PathSegment::*, PointFx};
    /// let large = Affine::scale(I16F16::from_num(1000), I16F16::from_num(1000));
    /// let path = Path::svg("M.125.375h1")?;
    /// assert!(path.mapped(large).eq([MoveTo(PointFx::px(125, 375)), LineTo(PointFx::px(1125, 375))]));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub const fn mapped(self, map: Affine) -> SvgSegments<'a> {
        SvgSegments { reader: Reader::new(self.text.as_bytes()), curves: None, map }
    }

    /// How many segments it has.
    pub const fn len(self) -> usize {
        let (mut segments, mut len) = (self.iter(), 0_usize);
        while segments.step().is_some() {
            len = len.wrapping_add(1);
        }
        len
    }

    /// Whether it has no segments.
    pub const fn is_empty(self) -> bool {
        self.iter().step().is_none()
    }

    /// Its segments, if there are as many as that: an array that is made when a program is compiled.
    /// ```
    /// use embedded_raster::{Path, PathSegment, Svg};
    /// const DROP: Svg = match Path::svg("M8 0c0 6 5 7 5 11a5 5 0 0 1-10 0c0-4 5-5 5-11z") {
    ///     Ok(drop) => drop,
    ///     Err(_) => panic!("not a path"),
    /// };
    /// static SEGMENTS: [PathSegment; DROP.len()] = DROP.to_array().unwrap();
    /// assert!(DROP.iter().eq(SEGMENTS));
    /// ```
    pub const fn to_array<const N: usize>(self) -> Option<[PathSegment; N]> {
        let (mut array, mut segments) = ([PathSegment::Close; N], self.iter());
        let mut places: &mut [PathSegment] = &mut array;
        while let Some(segment) = segments.step() {
            let Some((place, others)) = places.split_first_mut() else { return None };
            *place = segment;
            places = others;
        }
        if places.is_empty() {
            Some(array)
        } else {
            None
        }
    }
}

impl<'a> IntoIterator for Svg<'a> {
    type Item = PathSegment;
    type IntoIter = SvgSegments<'a>;

    #[inline]
    fn into_iter(self) -> SvgSegments<'a> {
        self.iter()
    }
}

/// The segments of an [`Svg`].
#[derive(Clone, Debug)]
pub struct SvgSegments<'a> {
    reader: Reader<'a>,
    /// Those of an arc, which come first.
    curves: Option<Curves>,
    map: Affine,
}

impl SvgSegments<'_> {
    /// The next segment; `None` at the end. [`next`](Iterator::next) does the same, but not when a program is compiled.
    pub const fn step(&mut self) -> Option<PathSegment> {
        loop {
            if let Some(curves) = &mut self.curves {
                if let Some(segment) = curves.step() {
                    return Some(segment);
                }
                self.curves = None;
            }
            let map = self.map;
            let Ok(Some(command)) = self.reader.command() else { return None };
            return Some(match command {
                Command::Move(a) => PathSegment::MoveTo(map.apply_fine(a)),
                Command::Line(a) => PathSegment::LineTo(map.apply_fine(a)),
                Command::Quadratic(c, a) => PathSegment::QuadraticTo(map.apply_fine(c), map.apply_fine(a)),
                Command::Cubic(c, d, a) => {
                    PathSegment::CubicTo(map.apply_fine(c), map.apply_fine(d), map.apply_fine(a))
                }
                Command::Arc(arc, from, to) => {
                    self.curves = Some(arc.between(from, to, map));
                    continue;
                }
                Command::Close => PathSegment::Close,
            });
        }
    }
}

impl Iterator for SvgSegments<'_> {
    type Item = PathSegment;

    #[inline]
    fn next(&mut self) -> Option<PathSegment> {
        self.step()
    }
}

/// A command with its places on the plane.
enum Command {
    Move(Fine),
    Line(Fine),
    Quadratic(Fine, Fine),
    Cubic(Fine, Fine, Fine),
    Arc(FineArc, Fine, Fine),
    Close,
}

/// What the command before was, for commands that go on smoothly.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
enum Last {
    Quadratic,
    Cubic,
    Other,
}

/// Reads commands from a text.
#[derive(Copy, Clone, Debug)]
struct Reader<'a> {
    rest: &'a [u8],
    /// The letter that the next arguments belong to; 0 before the first one.
    letter: u8,
    /// Where the path is, and where its contour began.
    at: Fine,
    start: Fine,
    /// The last control point of the last curve.
    control: Fine,
    last: Last,
}

impl<'a> Reader<'a> {
    const fn new(rest: &'a [u8]) -> Self {
        Self { rest, letter: 0, at: (0, 0), start: (0, 0), control: (0, 0), last: Last::Other }
    }

    /// The next command; `None` at the end. At an error, `rest` begins with what is wrong.
    const fn command(&mut self) -> Result<Option<Command>, SvgExpected> {
        self.skip_spaces();
        let Some(&next) = self.rest.first() else { return Ok(None) };
        if next.is_ascii_alphabetic() {
            let known = matches!(next | 0x20, b'm' | b'l' | b'h' | b'v' | b'c' | b's' | b'q' | b't' | b'a' | b'z');
            if self.letter == 0 && next | 0x20 != b'm' {
                return Err(SvgExpected::Move);
            }
            if !known {
                return Err(SvgExpected::Command);
            }
            self.letter = next;
            self.skip(1);
        } else {
            match self.letter | 0x20 {
                0x20 => return Err(SvgExpected::Move),
                b'z' => return Err(SvgExpected::Command),
                // What follows the arguments of a move are lines: the letter before M is L.
                b'm' => self.letter = self.letter.wrapping_sub(1),
                _ => {}
            }
            if next == b',' {
                self.skip(1);
            }
        }
        let numbers = match self.letter | 0x20 {
            b'z' => 0,
            b'h' | b'v' => 1,
            b's' | b'q' => 4,
            b'c' => 6,
            b'a' => 7,
            _ => 2,
        };
        match self.arguments(numbers) {
            Ok(arguments) => Ok(Some(self.made_of(arguments))),
            Err(expected) => Err(expected),
        }
    }

    /// The arguments of a command, at the end of an array.
    const fn arguments(&mut self, count: usize) -> Result<[i64; 7], SvgExpected> {
        let (mut found, mut i) = ([0; 7], 0_usize);
        while i < count {
            self.skip_spaces();
            if i > 0 && self.next_is(b',') {
                self.skip(1);
                self.skip_spaces();
            }
            let is_flag = count == 7 && (i == 3 || i == 4);
            let number = if is_flag { self.flag() } else { self.number() };
            let Some(number) = number else {
                return Err(if is_flag { SvgExpected::Flag } else { SvgExpected::Number });
            };
            let [_, b, c, d, e, f, g] = found;
            found = [b, c, d, e, f, g, number];
            i = i.wrapping_add(1);
        }
        Ok(found)
    }

    /// The command of the letter.
    const fn made_of(&mut self, [a, b, c, d, e, x, y]: [i64; 7]) -> Command {
        let (from, control, last) = (self.at, self.control, self.last);
        let base = if self.letter & 0x20 == 0 { (0, 0) } else { from };
        let letter = self.letter | 0x20;
        let to = match letter {
            b'z' => self.start,
            b'h' => (in_range(base.0.wrapping_add(y)), from.1),
            b'v' => (from.0, in_range(base.1.wrapping_add(y))),
            _ => sum(base, (x, y)),
        };
        self.at = to;
        self.last = Last::Other;
        match letter {
            b'm' => {
                self.start = to;
                Command::Move(to)
            }
            b'q' | b't' => {
                self.last = Last::Quadratic;
                self.control = match (letter, last) {
                    (b'q', _) => sum(base, (d, e)),
                    (_, Last::Quadratic) => mirrored(control, from),
                    _ => from,
                };
                Command::Quadratic(self.control, to)
            }
            b'c' | b's' => {
                self.last = Last::Cubic;
                self.control = sum(base, (d, e));
                let first = match (letter, last) {
                    (b'c', _) => sum(base, (b, c)),
                    (_, Last::Cubic) => mirrored(control, from),
                    _ => from,
                };
                Command::Cubic(first, self.control, to)
            }
            b'a' => {
                // Whole turns drop out of the degrees.
                let degrees = ((narrow(c >> 16) % 360) << 16).wrapping_add(narrow(c & 0xffff));
                let rotation = Angle::degrees_fx(I16F16::from_bits(degrees));
                Command::Arc(FineArc { radii: (a, b), rotation, is_large: d != 0, is_clockwise: e != 0 }, from, to)
            }
            b'z' => Command::Close,
            _ => Command::Line(to),
        }
    }

    const fn next_is(&self, wanted: u8) -> bool {
        matches!(self.rest.first(), Some(&next) if next == wanted)
    }

    /// The digit that comes next.
    const fn digit(&self) -> Option<u32> {
        match self.rest.first() {
            Some(&digit) if digit.is_ascii_digit() => Some((digit & 15) as u32),
            _ => None,
        }
    }

    const fn skip(&mut self, mut count: usize) {
        while count > 0 {
            let Some((_, rest)) = self.rest.split_first() else { return };
            self.rest = rest;
            count = count.wrapping_sub(1);
        }
    }

    const fn skip_spaces(&mut self) {
        while let Some((b' ' | b'\t' | b'\n' | b'\x0c' | b'\r', rest)) = self.rest.split_first() {
            self.rest = rest;
        }
    }

    /// A sign, if there is one: whether it is a minus.
    const fn sign(&mut self) -> bool {
        let is_minus = self.next_is(b'-');
        if is_minus || self.next_is(b'+') {
            self.skip(1);
        }
        is_minus
    }

    const fn flag(&mut self) -> Option<i64> {
        match self.rest.first() {
            Some(&flag) if flag == b'0' || flag == b'1' => {
                self.skip(1);
                Some((flag & 1) as i64)
            }
            _ => None,
        }
    }

    /// Goes over digits, and counts them.
    const fn skip_digits(&mut self) -> i32 {
        let mut count = 0_i32;
        while self.digit().is_some() {
            self.skip(1);
            count = count.saturating_add(1);
        }
        count
    }

    /// A number in units of 1/65,536. Where there is none, the text stays where it is.
    const fn number(&mut self) -> Option<i64> {
        let begin = *self;
        let is_negative = self.sign();
        let mut digits = *self;
        let before = self.skip_digits();
        let mut count = before;
        if self.next_is(b'.') {
            self.skip(1);
            count = count.saturating_add(self.skip_digits());
        }
        if count == 0 {
            *self = begin;
            return None;
        }
        let size = digits.value(count, before.saturating_add(self.exponent()));
        Some(in_range(if is_negative { size.wrapping_neg() } else { size }))
    }

    /// An exponent, or 0 if there is none.
    const fn exponent(&mut self) -> i32 {
        let mut exponent = *self;
        if !exponent.next_is(b'e') && !exponent.next_is(b'E') {
            return 0;
        }
        exponent.skip(1);
        let is_negative = exponent.sign();
        if exponent.digit().is_none() {
            return 0;
        }
        let mut value = 0_i32;
        while let Some(digit) = exponent.digit() {
            // Far beyond any text, and far below the ends of the type.
            if value < 100_000_000 {
                value = value.wrapping_mul(10).wrapping_add(digit.cast_signed());
            }
            exponent.skip(1);
        }
        *self = exponent;
        if is_negative {
            value.wrapping_neg()
        } else {
            value
        }
    }

    /// So many digits, with the point behind `before` of them, or further left or right of all.
    const fn value(&mut self, count: i32, before: i32) -> i64 {
        /// Of the part behind the point.
        const PLACES: i32 = 9;
        const BILLION: NonZeroU32 = match NonZeroU32::new(1_000_000_000) {
            Some(billion) => billion,
            None => NonZeroU32::MIN,
        };
        const TO_FRACTION: Divisor = Divisor::new(BILLION);
        let end = before.saturating_add(PLACES);
        let (mut whole, mut part, mut place) = (0_u32, 0_u32, 0_i32);
        while place < count {
            if self.next_is(b'.') {
                self.skip(1);
            }
            let Some(digit) = self.digit() else { break };
            self.skip(1);
            if place < before {
                whole = with_digit(whole, digit);
            } else if place < end {
                part = part.wrapping_mul(10).wrapping_add(digit);
            }
            place = place.wrapping_add(1);
        }
        // Zeros that are not written.
        while place < before && whole != 0 && whole < MOST {
            whole = with_digit(whole, 0);
            place = place.wrapping_add(1);
        }
        while place < end && part != 0 {
            part = part.wrapping_mul(10);
            place = place.wrapping_add(1);
        }
        let (units, rest) = TO_FRACTION.div_rem((part as u64) << 16);
        let up = (rest >= BILLION.get() >> 1) as u32;
        signed_wide(((whole as u64) << 16).wrapping_add(units.wrapping_add(up) as u64))
    }
}

/// Beyond the range of whole pixels.
const MOST: u32 = 1 << 24;

/// A number with one more digit, or one that is beyond the range.
const fn with_digit(n: u32, digit: u32) -> u32 {
    if n >= MOST {
        n
    } else {
        n.wrapping_mul(10).wrapping_add(digit)
    }
}

const fn sum(a: Fine, b: Fine) -> Fine {
    (in_range(a.0.wrapping_add(b.0)), in_range(a.1.wrapping_add(b.1)))
}

/// A place on the opposite side of `at`.
const fn mirrored(place: Fine, at: Fine) -> Fine {
    let twice = (at.0.wrapping_mul(2), at.1.wrapping_mul(2));
    (in_range(twice.0.wrapping_sub(place.0)), in_range(twice.1.wrapping_sub(place.1)))
}
