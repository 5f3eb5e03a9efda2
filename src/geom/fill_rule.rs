//! [`FillRule`]: what is inside of contours.

/// Which regions are inside, where a contour crosses itself or there are several contours.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum FillRule {
    /// A place is inside if the contours go round it more often in one direction than in the other.
    #[default]
    NonZero,
    /// A place is inside if an odd number of sides lies to its left.
    EvenOdd,
}

impl FillRule {
    /// The bits of the winding number of a place that are not all 0 if it is inside.
    #[inline(always)]
    pub(crate) fn mask(self) -> i32 {
        match self {
            Self::NonZero => -1,
            Self::EvenOdd => 1,
        }
    }
}
