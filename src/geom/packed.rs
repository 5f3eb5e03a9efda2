//! [`PackedPath`]: a path in few bytes, for flash, read while it is drawn.
//!
//! ```text
//!   fraction | command width  numbers | command width  numbers | ...
//!    8 bits     3      5      n width    3      5
//! ```
//! **Bytes.** The first byte, from 0 to 8, says how many bits of a number lie behind the point: numbers are multiples of `2^-fraction`
//! pixel. Then come commands, each in a byte, with the bits of each of its numbers less 1 in the same byte, and the numbers behind
//! it: in two's complement, the first bit first, with bits that do not count up to the end of the last byte.
//!
//! | command | numbers | what |
//! |---|---|---|
//! | 0 | none; the width is 0 | [`Close`](PathSegment::Close) |
//! | 1 | a | a move |
//! | 2 | a | a line |
//! | 3, 4 | x or y of a | a horizontal line, a vertical one |
//! | 5 | c, a | a quadratic curve |
//! | 6 | c, d, a | a cubic curve |
//! | 7 | d, a | a cubic curve that goes on smoothly: c is the mirror image of the last control point if a cubic curve came before, and where the path is if not |
//!
//! Each place is given by its distance from the place before it in this order, the first one of a command from where the path is: at the
//! beginning that is (0, 0), and behind a `Close` the start of its contour. A path begins with a move; a single byte is an empty path.
//! Sums are exact, and stop at the ends of `I24F8`. There are no arcs, so that a firmware which reads packed paths links no sine: they
//! were turned into cubic curves before.
//!
//! Such bytes are written on a computer, from SVG files: `cargo run -p embedded-raster-simulator --bin pathbake -- --help` in the
//! repository of this crate. 41 icons of 24 pixels take 2,424 bytes within 1/51 pixel, and 4,456 as
//! SVG path data.
//!
//! **Work**: each byte is read once to check it; then twice for each time that somebody goes over the path, as a contour is searched for
//! its end before it is drawn.

use super::{
    affine::{in_range, Affine, Fine},
    path::{Path, PathSegment},
};
use crate::error::{PackedError, PackedFault};

impl Path<'_> {
    /// Reads a packed path: see [`packed`](mod@super::packed) for the bytes.
    ///
    /// # Errors
    /// [`PackedError`], with the position of the first byte that makes no sense.
    /// ```
    /// use embedded_raster::{Canvas, EdgeSlot, FillRule, Framebuffer, Index1, PackedFault, PackedPath, Path};
    /// // A triangle, in whole pixels: a move by (1, 1), lines by (6, 0) and (-3, 6), in 2 and 4 bits for each number.
    /// const TRIANGLE: PackedPath = match Path::packed(&[0, 0x21, 0x50, 0x63, 0x60, 0x43, 0xd6, 0]) {
    ///     Ok(triangle) => triangle,
    ///     Err(_) => panic!("found when it is compiled"),
    /// };
    /// let mut ram = [0; 8];
    /// let mut frame = Framebuffer::<Index1>::new(&mut ram, 8, 8)?;
    /// frame.fill_path_fx(TRIANGLE, FillRule::NonZero, &mut [EdgeSlot::EMPTY; 8], Index1::MAX)?;
    /// assert_eq!(ram, [0, 0b0111_1110, 0b0011_1100, 0b0011_1100, 0b0001_1000, 0b0001_1000, 0, 0]);
    ///
    /// let error = Path::packed(&[0, 0x21]).unwrap_err();
    /// assert_eq!((error.position, error.fault), (1, PackedFault::Cut));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub const fn packed(bytes: &[u8]) -> Result<PackedPath<'_>, PackedError> {
        let mut reader = match Reader::new(bytes) {
            Ok(reader) => reader,
            Err(fault) => return Err(PackedError { position: 0, fault }),
        };
        let mut is_first = true;
        loop {
            let position = bytes.len().wrapping_sub(reader.rest.len());
            match reader.command() {
                Ok(Some((Command::Move, _))) => {}
                Ok(Some(_)) if is_first => return Err(PackedError { position, fault: PackedFault::Move }),
                Ok(Some(_)) => {}
                Ok(None) => return Ok(PackedPath { bytes }),
                Err(fault) => return Err(PackedError { position, fault }),
            }
            is_first = false;
        }
    }
}

/// A packed path that was found to be right: see [`Path::packed`].
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PackedPath<'a> {
    bytes: &'a [u8],
}

impl<'a> PackedPath<'a> {
    /// The bytes.
    #[inline]
    pub const fn bytes(self) -> &'a [u8] {
        self.bytes
    }

    /// Its segments.
    #[inline]
    pub const fn iter(self) -> PackedSegments<'a> {
        self.mapped(Affine::IDENTITY)
    }

    /// Its segments, mapped, and rounded after that.
    /// ```
    /// use embedded_raster::{fixed::types::I16F16, Affine, Path, PathSegment::*, PointFx};
    /// let large = Affine::scale(I16F16::from_num(10), I16F16::from_num(10));
    /// let path = Path::packed(&[1, 0x22, 0b0110_1000])?; // by (1.5, 1), in 3 bits for each number
    /// assert!(path.mapped(large).eq([MoveTo(PointFx::px(15, 10))]));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub const fn mapped(self, map: Affine) -> PackedSegments<'a> {
        let reader = match Reader::new(self.bytes) {
            Ok(reader) => reader,
            Err(_) => Reader { rest: &[], unit: 0 },
        };
        PackedSegments { reader, at: (0, 0), start: (0, 0), control: (0, 0), map }
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
}

impl<'a> IntoIterator for PackedPath<'a> {
    type Item = PathSegment;
    type IntoIter = PackedSegments<'a>;

    #[inline]
    fn into_iter(self) -> PackedSegments<'a> {
        self.iter()
    }
}

/// The segments of a [`PackedPath`].
#[derive(Clone, Debug)]
pub struct PackedSegments<'a> {
    reader: Reader<'a>,
    at: Fine,
    start: Fine,
    /// The control point that a cubic curve takes if it goes on smoothly.
    control: Fine,
    map: Affine,
}

impl PackedSegments<'_> {
    /// The next segment; `None` at the end. [`next`](Iterator::next) does the same, but not when a program is compiled.
    pub const fn step(&mut self) -> Option<PathSegment> {
        let Ok(Some((command, numbers))) = self.reader.command() else { return None };
        let (from, map) = (self.at, self.map);
        let first = moved(from, numbers.pair(0));
        let second = moved(first, numbers.pair(1));
        let mut control = None;
        let (to, segment) = match command {
            Command::Close => (self.start, PathSegment::Close),
            Command::Move => {
                self.start = first;
                (first, PathSegment::MoveTo(map.apply_fine(first)))
            }
            Command::Line => (first, PathSegment::LineTo(map.apply_fine(first))),
            Command::Horizontal => {
                let to = moved(from, (numbers.pair(0).0, 0));
                (to, PathSegment::LineTo(map.apply_fine(to)))
            }
            Command::Vertical => {
                let to = moved(from, (0, numbers.pair(0).0));
                (to, PathSegment::LineTo(map.apply_fine(to)))
            }
            Command::Quadratic => (second, PathSegment::QuadraticTo(map.apply_fine(first), map.apply_fine(second))),
            Command::Cubic => {
                let to = moved(second, numbers.pair(2));
                control = Some(second);
                (to, PathSegment::CubicTo(map.apply_fine(first), map.apply_fine(second), map.apply_fine(to)))
            }
            Command::Smooth => {
                let c = self.control;
                let d = moved(c, numbers.pair(0));
                let to = moved(d, numbers.pair(1));
                control = Some(d);
                (to, PathSegment::CubicTo(map.apply_fine(c), map.apply_fine(d), map.apply_fine(to)))
            }
        };
        self.at = to;
        self.control = match control {
            Some(last) => moved(to, (to.0.wrapping_sub(last.0), to.1.wrapping_sub(last.1))),
            None => to,
        };
        Some(segment)
    }
}

impl Iterator for PackedSegments<'_> {
    type Item = PathSegment;

    #[inline]
    fn next(&mut self) -> Option<PathSegment> {
        self.step()
    }
}

/// A place, and how far the next one is from it. It stops at the ends of the range.
const fn moved(at: Fine, by: Fine) -> Fine {
    (in_range(at.0.wrapping_add(by.0)), in_range(at.1.wrapping_add(by.1)))
}

#[derive(Copy, Clone)]
enum Command {
    Close,
    Move,
    Line,
    Horizontal,
    Vertical,
    Quadratic,
    Cubic,
    Smooth,
}

/// The numbers of a command: bytes that begin with them, and how many bits each has.
#[derive(Copy, Clone)]
struct Numbers<'a> {
    bytes: &'a [u8],
    width: usize,
    unit: u32,
}

impl Numbers<'_> {
    /// Two numbers that follow each other, in units of 1/65,536 pixel. What lies behind the end is 0.
    const fn pair(self, index: usize) -> Fine {
        (self.number(index.wrapping_mul(2)), self.number(index.wrapping_mul(2).wrapping_add(1)))
    }

    const fn number(self, index: usize) -> i64 {
        // The numbers of a command have 192 bits at most. Each lies in five bytes.
        let start = index.wrapping_mul(self.width);
        let (mut word, mut i) = (0_u64, 0_usize);
        while i < 5 {
            let place = (start >> 3).wrapping_add(i);
            let byte = match self.bytes.split_at_checked(place) {
                Some((_, [byte, ..])) => *byte,
                _ => 0,
            };
            word = word << 8 | byte as u64;
            i = i.wrapping_add(1);
        }
        // The first of its bits becomes the highest one.
        let bits = word << (24_usize.wrapping_add(start & 7) & 63);
        (bits.cast_signed() >> (64_usize.wrapping_sub(self.width) & 63)) << (self.unit & 31)
    }
}

/// Reads commands from bytes.
#[derive(Copy, Clone, Debug)]
struct Reader<'a> {
    rest: &'a [u8],
    /// A number is so many times `2^unit` 1/65,536 pixel.
    unit: u32,
}

impl<'a> Reader<'a> {
    const fn new(bytes: &'a [u8]) -> Result<Self, PackedFault> {
        match bytes.split_first() {
            Some((&fraction, rest)) if fraction <= 8 => Ok(Self { rest, unit: 16 - fraction as u32 }),
            _ => Err(PackedFault::Fraction),
        }
    }

    /// The next command and its numbers; `None` at the end. At a fault, `rest` stays.
    const fn command(&mut self) -> Result<Option<(Command, Numbers<'a>)>, PackedFault> {
        let Some((&first, bytes)) = self.rest.split_first() else { return Ok(None) };
        let width = (first & 31) as usize;
        let (command, count) = match first >> 5 {
            0 if width == 0 => (Command::Close, 0),
            0 => return Err(PackedFault::Command),
            1 => (Command::Move, 2),
            2 => (Command::Line, 2),
            3 => (Command::Horizontal, 1),
            4 => (Command::Vertical, 1),
            5 => (Command::Quadratic, 4),
            6 => (Command::Cubic, 6),
            _ => (Command::Smooth, 4),
        };
        let width = width.wrapping_add(1);
        let size = width.wrapping_mul(count).wrapping_add(7) >> 3;
        let Some((numbers, rest)) = bytes.split_at_checked(size) else { return Err(PackedFault::Cut) };
        self.rest = rest;
        Ok(Some((command, Numbers { bytes: numbers, width, unit: self.unit })))
    }
}
