//! [`EdgeSlot`]: a side on its way down the rows, in a table that the caller owns.

use core::{cell::Cell, num::NonZeroU32};

use crate::{
    geom::{bits, PointFx},
    num::{
        cast::unsigned,
        recip::Divisor,
        round::{difference, first_centre_after},
        stepper::Stepper,
    },
    raster::slope::Slope,
};

/// No edge: the end of a list.
pub(super) const END: u16 = u16::MAX;

/// One slot of an edge table: a side on its way down the rows. See [`polygon::fill`](crate::raster::polygon::fill).
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct EdgeSlot {
    /// `value` is the first pixel right of the edge on the row it stands on.
    pub(super) crossing: Cell<Stepper>,
    /// The first row that it crosses; once that row is reached, [`ACTIVE`].
    pub(super) y: Cell<i32>,
    /// Four times the row after its last one, and in the two lowest bits the winding: 1 down, -1 up. It fits, as rows of places
    /// are below 2^24.
    end: i32,
    /// The next edge of a list.
    pub(super) link: Cell<u16>,
    /// The first edge in bucket k, where k is the number of this slot: buckets sort the edges by their first row. It has nothing
    /// to do with the edge that this slot holds.
    pub(super) bucket: Cell<u16>,
}

/// The row of all edges that are on their way: they are sorted by their crossings alone.
pub(super) const ACTIVE: i32 = i32::MIN;

impl EdgeSlot {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::EdgeSlot;
    /// use static_cell::ConstStaticCell;
    /// static TABLE: ConstStaticCell<[EdgeSlot; 64]> = ConstStaticCell::new([EdgeSlot::EMPTY; 64]);
    /// let table: &'static mut [EdgeSlot; 64] = TABLE.take();
    /// assert_eq!(size_of_val(table), 64 * 32);
    /// ```
    #[expect(clippy::declare_interior_mutable_const, reason = "it is copied into every slot")]
    pub const EMPTY: Self = Self {
        crossing: Cell::new(Stepper::still(0)),
        y: Cell::new(0),
        end: 0,
        link: Cell::new(0),
        bucket: Cell::new(0),
    };

    /// An edge right of all windows, which stands in for one that is not in the table.
    #[inline(always)]
    pub(super) fn beyond() -> Self {
        Self { crossing: Cell::new(Stepper::still(i32::MAX)), ..Self::EMPTY }
    }

    /// Puts the side from a to b into this slot, with its crossing of row y. It crosses the rows `y..end`; `down` if b lies below
    /// a.
    #[inline(always)]
    pub(super) fn put(&mut self, a: PointFx, b: PointFx, (y, end): (i32, i32), down: bool) {
        let Some(slope) = Slope::either_way(bits(a), bits(b), down) else { return };
        // A store in each branch: with one store after both, the numbers of a small side would go by way of the stack.
        if slope.is_small() {
            self.crossing.set(slope.small_at(y, end.wrapping_sub(y)));
        } else {
            self.crossing.set(slope.any_at(y));
        }
        self.y.set(y);
        self.end = end.wrapping_mul(4) | if down { 1 } else { 3 };
        self.bucket.set(END);
    }

    /// As [`put`](Self::put), with a remainder that has the whole crossing c: it lies between the centres of two pixels, `x - 1/2`
    /// and `x + 1/2`, where x is the value, and `c - (x - 1/2)` is `(rest + 1) / d`. Of sides that are higher than 65,536 pixels
    /// it is rounded down to `2^-24`.
    ///
    /// In the words of `raster::slope`, M is not divided by 256, and dy is multiplied by 256 instead.
    pub(super) fn put_exact(&mut self, a: PointFx, b: PointFx, (y, end): (i32, i32), down: bool) {
        self.put(a, b, (y, end), down);
        let ((ax, ay), (bx, by)) = if down { (bits(a), bits(b)) } else { (bits(b), bits(a)) };
        let dy = unsigned(by.wrapping_sub(ay));
        let Some(d) = NonZeroU32::new(dy << 8).filter(|_| dy >> 24 == 0) else { return };
        let (dx, rows) = (difference(bx, ax), (i64::from(y) << 8).wrapping_add(128).wrapping_sub(ay.into()));
        let f = i64::from(ax.wrapping_add(128) & 255);
        let n = f.wrapping_mul(dy.into()).wrapping_add(rows.wrapping_mul(dx)).wrapping_sub(1);
        let (k, rest) = Divisor::new(d).floor(n);
        // A side with a second row is higher than a row.
        let (slope, part) = match NonZeroU32::new(dy).filter(|_| end.wrapping_sub(y) > 1) {
            Some(dy) => Divisor::new(dy).floor(dx),
            None => (0, 0),
        };
        let first = first_centre_after(ax).wrapping_add(k);
        self.crossing.set(Stepper::new(d, (first, rest), (slope, part << 8)));
    }

    /// Its side, as far as the rows above `bottom`: what [`take_over`](Self::take_over) takes.
    #[inline(always)]
    pub(super) fn side_above(&self, bottom: i32) -> (Stepper, i32, i32) {
        (self.crossing.get(), self.y.get(), self.end().min(bottom).wrapping_mul(4) | (self.end & 3))
    }

    /// Takes the side of another slot. What else is in the slot stays there.
    #[inline(always)]
    pub(super) fn take_over(&mut self, (crossing, y, end): (Stepper, i32, i32)) {
        self.crossing.set(crossing);
        self.y.set(y);
        self.end = end;
    }

    /// The remainder of its crossing, and the divisor.
    pub(super) fn remainder(&self) -> (u32, u32) {
        self.crossing.get().remainder()
    }

    /// The first pixel right of it.
    #[inline(always)]
    pub(super) fn x(&self) -> i32 {
        self.crossing.get().value
    }

    /// The row after its last.
    #[inline(always)]
    pub(super) fn end(&self) -> i32 {
        self.end >> 2
    }

    /// To the next row, and the first pixel right of it there.
    #[inline(always)]
    pub(super) fn step(&self) -> i32 {
        let mut crossing = self.crossing.get();
        crossing.step();
        self.crossing.set(crossing);
        crossing.value
    }

    /// What lists are sorted by.
    #[inline(always)]
    pub(super) fn order(&self) -> (i32, i32) {
        (self.y.get(), self.x())
    }

    /// +1 when the contour goes down along it, -1 when up.
    #[inline(always)]
    pub(super) fn winding(&self) -> i32 {
        self.end << 30 >> 30
    }
}
