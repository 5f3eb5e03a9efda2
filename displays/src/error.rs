//! [`Error`]: why pixels cannot be sent as asked. It comes before the first byte.

use core::fmt;

/// Why pixels cannot be sent.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Error {
    /// The memory that pixels are converted in, or packed in, is too small.
    LineTooShort {
        /// Bytes that are enough.
        needed: usize,
        /// Bytes of the slice.
        given: usize,
    },
    /// Pixels are to be sent as they lie, and the first one lies inside of a byte, a page or a line: the frame is a view.
    Misaligned {
        /// Its column or row in memory.
        at: usize,
        /// Columns or rows that begin with a multiple of this can be sent.
        unit: usize,
    },
}

impl Error {
    /// # Errors
    /// [`Error::Misaligned`] if `at` is no multiple of `unit`.
    pub(crate) const fn check_aligned(at: usize, unit: usize) -> Result<(), Self> {
        if at.is_multiple_of(unit) {
            Ok(())
        } else {
            Err(Self::Misaligned { at, unit })
        }
    }
}

impl fmt::Display for Error {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::LineTooShort { needed, given } => {
                write!(f, "memory for a line too small: {needed} bytes needed, {given} given")
            }
            Self::Misaligned { at, unit } => {
                write!(f, "pixels that lie from column or row {at} on cannot be sent: not a multiple of {unit}")
            }
        }
    }
}

impl core::error::Error for Error {}
