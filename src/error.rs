//! What can be wrong with a call, with the numbers that explain it.
//!
//! Each kind of call has errors of its own, those that it can return: memory that does not fit a surface
//! ([`BufferError`]), a scratch table too small for a row of a polygon ([`EdgeTableFull`]), a polygon that cannot be
//! cut into triangles ([`TriangulateError`]), a list too short for the vertices of a path ([`FlattenError`]) or for the
//! crossings of a line with a polygon ([`CrossingListFull`]), a triangle too large to be shaded ([`TriangleTooLarge`]), a picture
//! too large for the pipeline ([`PictureTooLarge`]), SVG path data that makes no sense ([`SvgError`]), bytes that
//! are no font ([`FontError`]), a map that draws a picture too large ([`MapTooLarge`]).
//! too large for the pipeline ([`PictureTooLarge`]), SVG path data that makes no sense ([`SvgError`]),
//! and bytes that are no packed path ([`PackedError`]).
//! [`Error`] is any of them, for programs that pass all on with `?`.
//!
//! Drawing outside the surface is *not* an error: it is clipped. A call that returns an error has drawn nothing.

use core::fmt;

/// Why a surface could not be made of some memory.
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use embedded_raster::{BufferError, Framebuffer};
/// let mut ram = [0; 100];
/// let error = Framebuffer::<Rgb565>::new(&mut ram, 8, 8).unwrap_err();
/// assert_eq!(error, BufferError::TooSmall { needed: 128, given: 100 });
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum BufferError {
    /// The slice is shorter than the surface. Both counts are bytes; `needed` stops at `usize::MAX`.
    TooSmall {
        /// What the surface takes.
        needed: usize,
        /// What the caller passed in.
        given: usize,
    },
    /// Rows are wider than the distance between them. Both counts are bytes.
    StrideTooSmall {
        /// Bytes of one row of pixels.
        needed: usize,
        /// The stride that the caller passed in.
        given: usize,
    },
    /// The rows of a band do not lie on its screen.
    BandOutsideScreen {
        /// First row of the band.
        start: u16,
        /// The row after its last one.
        end: u16,
        /// Rows of the screen.
        height: u16,
    },
    /// A band starts or ends between rows that share bytes, such as the eight rows of a page.
    BandSplitsPage {
        /// First row of the band.
        start: u16,
        /// The row after its last one.
        end: u16,
        /// Rows that share bytes: a band starts at a multiple of this, and ends at one or at the end of the screen.
        page: u16,
    },
    /// A frame is cut between rows that share bytes, such as the eight rows of a page.
    CutInPage {
        /// The first row below the cut.
        row: i32,
        /// Rows that share bytes: the cut lies at a multiple of this, counted from the first row in memory.
        page: u16,
    },
    /// A frame is cut whose rows do not lie one after the other in memory: planes, for example.
    RowsApart {
        /// The first row below the cut.
        row: i32,
    },
}

/// One row alone is crossed by more edges than the edge table has slots.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct EdgeTableFull {
    /// Slots of the table; of a longer one, 65,535 count.
    pub capacity: usize,
    /// Edges that cross the row.
    pub needed: usize,
    /// The first such row.
    pub row: i32,
    /// As many edges as any row of the window has: a table of that length is enough.
    pub enough: usize,
}

/// Why a polygon could not be cut into triangles.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum TriangulateError {
    /// Two sides cross. Each is given by the number of the vertex where it starts.
    SidesCross {
        /// The first one that `second` crosses.
        first: usize,
        /// The first one that crosses one before it.
        second: usize,
    },
    /// The polygon takes more slots than the table of sides has.
    SideTableFull {
        /// Slots of the table, 65,535 of them at most.
        capacity: usize,
        /// Slots that are enough; if it is above 65,535, no table is. But if the table has no slot for each vertex and two
        /// for each contour but the first, `needed` is their number: sides were not looked at, and may need more if they
        /// touch.
        needed: usize,
    },
    /// A table that holds one slot for each triangle is too small.
    TriangleTableFull {
        /// Slots of the table.
        capacity: usize,
        /// Slots that are enough.
        needed: usize,
    },
}

/// Why the contours of a path could not be written to two lists.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FlattenError {
    /// The path has more vertices than their list has slots.
    VertexListFull {
        /// Slots of the list; of a longer one, 65,535 count.
        capacity: usize,
        /// Vertices of all contours.
        needed: usize,
    },
    /// The path has more contours than the list of their starts has slots for.
    StartListFull {
        /// Slots of the list.
        capacity: usize,
        /// Contours after the first one.
        needed: usize,
    },
}

/// A line crosses more sides of a polygon than the list of crossings has slots.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct CrossingListFull {
    /// Slots of the list.
    pub capacity: usize,
    /// Sides that the line crosses.
    pub needed: usize,
}

/// A triangle, or a line, is too large for values to be exact all over it: see [`Facet`](crate::geom::Facet).
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TriangleTooLarge {
    /// Of its box, in pixels, rounded up.
    pub width: u32,
    /// Of its box, in pixels, rounded up.
    pub height: u32,
    /// What width and height may be together.
    pub most: u32,
}

/// SVG path data that makes no sense: see [`Path::svg`](crate::Path::svg).
/// ```
/// use embedded_raster::Path;
/// let error = Path::svg("M4 4 L20").unwrap_err();
/// assert_eq!(error.to_string(), "position 8: a number is expected");
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SvgError {
    /// Bytes before what is wrong.
    pub position: usize,
    /// What should be there.
    pub expected: SvgExpected,
}

/// What should be where an [`SvgError`] is.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SvgExpected {
    /// `M` or `m`: all paths begin with a move.
    Move,
    /// One of the letters of commands.
    Command,
    /// A number.
    Number,
    /// `0` or `1`, the flags of an arc.
    Flag,
}

/// Bytes that are no packed path: see [`Path::packed`](crate::Path::packed).
/// ```
/// use embedded_raster::Path;
/// let error = Path::packed(&[0, 0x21]).unwrap_err();
/// assert_eq!(error.to_string(), "byte 1: the numbers of the command are cut off");
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PackedError {
    /// Bytes before the one that is wrong.
    pub position: usize,
    /// What is wrong.
    pub fault: PackedFault,
}

/// What is wrong where a [`PackedError`] is.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum PackedFault {
    /// The first byte is missing, or above 8.
    Fraction,
    /// The first command is no move.
    Move,
    /// There is no such command.
    Command,
    /// The bytes end before the numbers of a command do.
    Cut,
}

/// A picture has more columns or rows than a [`Pipeline`](crate::pipeline::Pipeline) draws.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct PictureTooLarge {
    /// Columns.
    pub width: u16,
    /// Rows.
    pub height: u16,
    /// The most that there may be of each.
    pub most: u16,
}

/// Why bytes are not a [`Font`](crate::text::Font).
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum FontError {
    /// There are fewer bytes than the font has. Both are counts of bytes.
    TooShort {
        /// What the font takes, as far as was read.
        needed: usize,
        /// What there is.
        given: usize,
    },
    /// The bytes do not begin as those of a font, or as those of a kind of font that this version does not know.
    Unknown {
        /// The first four bytes: `erf1` in fonts.
        start: [u8; 4],
        /// The kind: 0 or 1.
        kind: u8,
    },
    /// A range of characters, or the replacement glyph, names a glyph that the font does not have.
    NoGlyph {
        /// Its number, counted from 0.
        number: u32,
        /// How many there are.
        glyphs: u16,
    },
    /// A range of characters begins before the end of the one before it, or ends beyond the last character.
    RangeOutOfOrder {
        /// Its number, counted from 0.
        range: u32,
        /// Its first character.
        first: u32,
        /// The first character after the range before.
        free: u32,
    },
    /// A glyph, or the baseline, lies below the last row of the cells.
    OutsideCell {
        /// The number of the glyph, counted from 0.
        glyph: u32,
        /// The row after its last one.
        end: u16,
        /// Rows down to the baseline.
        baseline: u8,
        /// Rows of a cell.
        rows: u8,
    },
}

/// A map draws a picture larger than [`mapped::fill`](crate::raster::mapped::fill) does.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct MapTooLarge {
    /// The first such factor, rounded down.
    pub factor: i32,
    /// Factors are between this and its negative.
    pub limit: i32,
}

/// Any error of the crate.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum Error {
    /// A surface could not be made.
    Buffer(BufferError),
    /// A polygon, path or stroke could not be filled.
    EdgeTable(EdgeTableFull),
    /// A polygon could not be cut into triangles.
    Triangulate(TriangulateError),
    /// A path could not be written to lists.
    Flatten(FlattenError),
    /// The crossings of a line with a polygon could not be written to a list.
    CrossingList(CrossingListFull),
    /// A triangle is too large to be shaded.
    Triangle(TriangleTooLarge),
    /// SVG path data makes no sense.
    Svg(SvgError),
    /// Bytes are no packed path.
    Packed(PackedError),
    /// A picture is too large for the pipeline.
    Picture(PictureTooLarge),
    /// Bytes are not a font.
    Font(FontError),
    /// A map draws a picture too large.
    Map(MapTooLarge),
}

impl fmt::Display for BufferError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooSmall { needed, given } => write!(f, "buffer too small: {needed} bytes needed, {given} given"),
            Self::StrideTooSmall { needed, given } => {
                write!(f, "stride too small: {needed} bytes needed, {given} given")
            }
            Self::BandOutsideScreen { start, end, height } => {
                write!(f, "band {start}..{end} does not lie on a screen of {height} rows")
            }
            Self::BandSplitsPage { start, end, page } => {
                write!(f, "band {start}..{end} splits a page: {page} rows share their bytes")
            }
            Self::CutInPage { row, page } => {
                write!(f, "a cut above row {row} lies in a page: {page} rows share their bytes")
            }
            Self::RowsApart { row } => {
                write!(f, "no cut above row {row}: the rows do not lie one after the other in memory")
            }
        }
    }
}

impl fmt::Display for EdgeTableFull {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { capacity, needed, row, enough } = *self;
        write!(
            f,
            "edge table full: {needed} edges cross row {row}, the table holds {capacity}, {enough} are enough for all rows"
        )
    }
}

impl fmt::Display for TriangulateError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::SidesCross { first, second } => {
                write!(f, "sides cross: the one from vertex {first} and the one from vertex {second}")
            }
            Self::SideTableFull { capacity, needed } => {
                write!(f, "side table full: {needed} slots needed, the table holds {capacity}")
            }
            Self::TriangleTableFull { capacity, needed } => {
                write!(f, "triangle table full: {needed} slots needed, the table holds {capacity}")
            }
        }
    }
}

impl fmt::Display for FlattenError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::VertexListFull { capacity, needed } => {
                write!(f, "vertex list full: the path has {needed} vertices, the list holds {capacity}")
            }
            Self::StartListFull { capacity, needed } => {
                write!(f, "start list full: {needed} contours follow the first one, the list holds {capacity}")
            }
        }
    }
}

impl fmt::Display for CrossingListFull {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { capacity, needed } = *self;
        write!(f, "crossing list full: the line crosses {needed} sides, the list holds {capacity}")
    }
}

impl fmt::Display for TriangleTooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { width, height, most } = *self;
        write!(f, "triangle or line too large: {width} x {height} pixels, shades take {most} for both together")
    }
}

impl fmt::Display for SvgError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let expected = match self.expected {
            SvgExpected::Move => "a path begins with M",
            SvgExpected::Command => "a command is expected",
            SvgExpected::Number => "a number is expected",
            SvgExpected::Flag => "a flag is expected, 0 or 1",
        };
        write!(f, "position {}: {expected}", self.position)
    }
}

impl fmt::Display for PackedError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let fault = match self.fault {
            PackedFault::Fraction => "the bits of a fraction are expected, from 0 to 8",
            PackedFault::Move => "a path begins with a move",
            PackedFault::Command => "there is no such command",
            PackedFault::Cut => "the numbers of the command are cut off",
        };
        write!(f, "byte {}: {fault}", self.position)
    }
}

impl fmt::Display for PictureTooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { width, height, most } = *self;
        write!(f, "picture too large: {width} x {height} pixels, the pipeline draws {most} each way")
    }
}

impl fmt::Display for FontError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::TooShort { needed, given } => write!(f, "font too short: {needed} bytes needed, {given} given"),
            Self::Unknown { start, kind } => {
                write!(f, "not a font of this version: it begins with {start:02x?}, and is of kind {kind}")
            }
            Self::NoGlyph { number, glyphs } => write!(f, "glyph {number} is named, the font has {glyphs}"),
            Self::RangeOutOfOrder { range, first, free } => {
                write!(f, "range {range} begins with character {first}, the first one free is {free}")
            }
            Self::OutsideCell { glyph, end, baseline, rows } => {
                write!(f, "glyph {glyph} ends in row {end}, baseline {baseline}, of cells of {rows} rows")
            }
        }
    }
}

impl fmt::Display for MapTooLarge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { factor, limit } = *self;
        write!(f, "map too large: a factor of {factor}, pictures are drawn by less than {limit} times as large")
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Buffer(error) => error.fmt(f),
            Self::EdgeTable(error) => error.fmt(f),
            Self::Triangulate(error) => error.fmt(f),
            Self::Flatten(error) => error.fmt(f),
            Self::CrossingList(error) => error.fmt(f),
            Self::Triangle(error) => error.fmt(f),
            Self::Svg(error) => error.fmt(f),
            Self::Packed(error) => error.fmt(f),
            Self::Picture(error) => error.fmt(f),
            Self::Font(error) => error.fmt(f),
            Self::Map(error) => error.fmt(f),
        }
    }
}

impl core::error::Error for BufferError {}
impl core::error::Error for EdgeTableFull {}
impl core::error::Error for TriangulateError {}
impl core::error::Error for FlattenError {}
impl core::error::Error for CrossingListFull {}
impl core::error::Error for TriangleTooLarge {}
impl core::error::Error for SvgError {}
impl core::error::Error for PackedError {}
impl core::error::Error for PictureTooLarge {}
impl core::error::Error for FontError {}
impl core::error::Error for MapTooLarge {}
impl core::error::Error for Error {}

impl From<BufferError> for Error {
    fn from(error: BufferError) -> Self {
        Self::Buffer(error)
    }
}

impl From<EdgeTableFull> for Error {
    fn from(error: EdgeTableFull) -> Self {
        Self::EdgeTable(error)
    }
}

impl From<TriangulateError> for Error {
    fn from(error: TriangulateError) -> Self {
        Self::Triangulate(error)
    }
}

impl From<FlattenError> for Error {
    fn from(error: FlattenError) -> Self {
        Self::Flatten(error)
    }
}

impl From<CrossingListFull> for Error {
    fn from(error: CrossingListFull) -> Self {
        Self::CrossingList(error)
    }
}

impl From<TriangleTooLarge> for Error {
    fn from(error: TriangleTooLarge) -> Self {
        Self::Triangle(error)
    }
}

impl From<SvgError> for Error {
    fn from(error: SvgError) -> Self {
        Self::Svg(error)
    }
}

impl From<PackedError> for Error {
    fn from(error: PackedError) -> Self {
        Self::Packed(error)
    }
}

impl From<PictureTooLarge> for Error {
    fn from(error: PictureTooLarge) -> Self {
        Self::Picture(error)
    }
}

impl From<FontError> for Error {
    fn from(error: FontError) -> Self {
        Self::Font(error)
    }
}

impl From<MapTooLarge> for Error {
    fn from(error: MapTooLarge) -> Self {
        Self::Map(error)
    }
}
