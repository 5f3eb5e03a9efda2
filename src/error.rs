//! What can be wrong with a call, with the numbers that explain it.

use core::fmt;

/// Why a surface could not be made or a shape could not be drawn.
///
/// Drawing outside the surface is *not* an error: it is clipped. A call that returns an error has drawn nothing.
/// ```
/// use embedded_graphics_core::pixelcolor::Rgb565;
/// use embedded_raster::{Error, Framebuffer};
/// let mut ram = [0; 100];
/// let error = Framebuffer::<Rgb565>::new(&mut ram, 8, 8).unwrap_err();
/// assert_eq!(error, Error::BufferTooSmall { needed: 128, given: 100 });
/// ```
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The slice is shorter than the surface. Both counts are bytes (colours for a table); `needed` stops at `usize::MAX`.
    BufferTooSmall {
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
    /// One row alone is crossed by more edges than the edge table has slots.
    EdgeTableFull {
        /// Slots of the table.
        capacity: usize,
        /// Edges that cross the row.
        needed: usize,
        /// The first such row.
        row: i32,
    },
    /// Two sides of a polygon that was to be triangulated cross. Each is given by the number of the vertex where it starts.
    SidesCross {
        /// The one that starts first.
        first: usize,
        /// The other.
        second: usize,
    },
    /// A polygon that was to be triangulated takes more nodes than the table holds.
    NodeTableFull {
        /// Slots of the table, 65,535 of them at most.
        capacity: usize,
        /// Nodes that are enough.
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

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::BufferTooSmall { needed, given } => write!(f, "buffer too small: {needed} needed, {given} given"),
            Self::StrideTooSmall { needed, given } => {
                write!(f, "stride too small: {needed} bytes needed, {given} given")
            }
            Self::BandOutsideScreen { start, end, height } => {
                write!(f, "band {start}..{end} does not lie on a screen of {height} rows")
            }
            Self::EdgeTableFull { capacity, needed, row } => {
                write!(f, "edge table full: {needed} edges cross row {row}, the table holds {capacity}")
            }
            Self::SidesCross { first, second } => {
                write!(f, "sides cross: the one from vertex {first} and the one from vertex {second}")
            }
            Self::NodeTableFull { capacity, needed } => {
                write!(f, "node table full: {needed} nodes needed, the table holds {capacity}")
            }
            Self::TriangleTableFull { capacity, needed } => {
                write!(f, "triangle table full: {needed} slots needed, the table holds {capacity}")
            }
        }
    }
}

impl core::error::Error for Error {}
