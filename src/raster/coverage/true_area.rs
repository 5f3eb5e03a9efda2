//! The true area of a shape in a pixel, also where its sides cross there, or where several go through it: for those who ask for it.
//!
//! The row is cut into strips at each height at which a side enters the pixel, leaves it, ends, or crosses another one. In a strip
//! sides do not cross, so from left to right each of them says whether the shape begins there or ends, by the winding numbers on both
//! sides of it. Those that do count as if the shape had no others.
//! ```text
//!      +-----------+
//!      |\         /|     a bow-tie: two strips, in each of which its sides are in order
//!      |##\     /##|
//!      |####\ /####|     the sum of areas is 0, as its loops turn in opposite directions;
//!      |----/ \----|     the true area is a half
//!      |##/     \##|
//!      |/         \|
//!      +-----------+
//! ```
//! What lies left of the pixel counts as if it went along its left side. All places are those of `strip.rs`: a side enters and leaves
//! a pixel at the same steps of the grid whatever else is there, and nothing right of the pixel matters. So a window, a band or a strip
//! changes nothing. Where sides cross is rounded to the grid, too: that moves an area by less than 2^-14 for each crossing.
//!
//! Nothing is stored. Work: with k sides in a pixel or left of it in the row, k times for each of them in each of its strips; there is
//! one for each end and for each crossing.

use super::{
    slot::{Across, CoverageSlot},
    strip::{ratio, rounded_area, GRID_BITS},
};
use crate::{
    geom::fill_rule::FillRule,
    num::cast::{low_u32, magnitude, signed, unsigned},
};

const PIXEL: i32 = 1 << GRID_BITS;

/// A part of a side that lies in the pixel, or along its left side. Heights and insets are in steps of the grid.
#[derive(Copy, Clone)]
struct Piece {
    top: i32,
    bottom: i32,
    /// How far from the left side of the pixel it is at its top and at its bottom.
    insets: (i32, i32),
    winding: i32,
}

impl Piece {
    /// Its inset at a height between its ends, to the nearest step.
    fn inset(&self, height: i32) -> i32 {
        // Products are at most 2^30, and half of a height.
        let (down, all) = (height.wrapping_sub(self.top), self.bottom.wrapping_sub(self.top).max(1));
        let way = self.insets.1.wrapping_sub(self.insets.0).wrapping_mul(down);
        let rounded = if way < 0 { way.wrapping_sub(all >> 1) } else { way.wrapping_add(all >> 1) };
        self.insets.0.wrapping_add(rounded.wrapping_div(all))
    }

    fn is_in(&self, height: i32) -> bool {
        self.top <= height && height < self.bottom
    }

    /// The sum of its insets at two heights: its place among others that do not cross it between them.
    fn place(&self, (top, bottom): (i32, i32)) -> i32 {
        self.inset(top).wrapping_add(self.inset(bottom))
    }

    /// The height at which it crosses another one, or the step after it, if it does so between two heights.
    fn crossing(&self, other: &Self, (top, bottom): (i32, i32)) -> Option<i32> {
        let apart = |height: i32| other.inset(height).wrapping_sub(self.inset(height));
        let (above, below) = (apart(top), apart(bottom));
        if above.signum().wrapping_mul(below.signum()) >= 0 {
            return None;
        }
        // Insets are at most 2^15 apart.
        let (above, below) = (above.wrapping_abs(), below.wrapping_abs());
        let down = bottom.wrapping_sub(top).wrapping_mul(above).wrapping_div(above.wrapping_add(below).max(1));
        Some(top.wrapping_add(down.max(1)))
    }
}

/// The sides that go through a row, as one pixel sees them.
pub(super) struct Pixel<'t> {
    table: &'t [CoverageSlot],
    /// The first of the sides.
    first: u16,
    y: i32,
    /// The left side of the pixel, in steps of the grid from that of the window, and that of the window itself.
    left: i64,
    window: i64,
}

impl<'t> Pixel<'t> {
    /// The pixel whose left side is `column` pixels right of the left side x0 of the window.
    pub(super) fn new(table: &'t [CoverageSlot], first: u16, (x0, y): (i32, i32), column: u32) -> Self {
        let steps = |pixels: i64| pixels << GRID_BITS;
        Self { table, first, y, left: steps(column.into()), window: steps(x0.into()) }
    }

    /// Its area by a fill rule, in parts of `strip.rs`; `None` where it is what sides sum up to, as one of them at most goes through it
    /// and all others go past it as a whole.
    #[inline(never)]
    pub(super) fn area(&self, rule: FillRule) -> Option<u32> {
        let (mut inside, mut is_cut) = (0_u32, false);
        self.sides(&mut |side| {
            inside = inside.wrapping_add(u32::from(side.to > self.left));
            is_cut |= side.height() != unsigned(PIXEL);
        });
        if inside < 2 && !is_cut {
            return None;
        }
        let (mut area, mut top) = (0_u32, 0);
        while top < PIXEL {
            let strip = (top, self.end_of_strip(top));
            area = area.wrapping_add(self.strip(rule, strip));
            top = strip.1;
        }
        Some(area)
    }

    /// The sides of the row that are not right of the pixel.
    fn sides(&self, f: &mut dyn FnMut(&Across)) {
        let mut place = self.first;
        while let Some(side) = self.table.get(usize::from(place)) {
            if side.first_row() <= self.y {
                let side = side.across(self.y, self.window);
                if side.from < self.left.wrapping_add(PIXEL.into()) {
                    f(&side);
                }
            }
            place = side.link.get();
        }
    }

    /// Their pieces, two of each at most.
    fn pieces(&self, f: &mut dyn FnMut(&Piece)) {
        self.sides(&mut |side| {
            // Up to a place, so much of its height.
            let height = side.height();
            let before = |x: i64| {
                if x <= side.from {
                    0
                } else if x >= side.to {
                    height
                } else {
                    ratio(magnitude(x.wrapping_sub(side.from)), height, magnitude(side.to.wrapping_sub(side.from)))
                }
            };
            let (beside, inside) = (before(self.left), before(self.left.wrapping_add(PIXEL.into())));
            // Between 0 and a pixel.
            let inset = |x: i64| signed(low_u32(magnitude(x.wrapping_sub(self.left).clamp(0, PIXEL.into()))));
            let mut tell = |(from, to): (u32, u32), insets: (i32, i32)| {
                let [from, to] = [from, to].map(signed);
                let (top, bottom, insets) = if side.is_rightward {
                    (side.top.wrapping_add(from), side.top.wrapping_add(to), insets)
                } else {
                    (side.bottom.wrapping_sub(to), side.bottom.wrapping_sub(from), (insets.1, insets.0))
                };
                if top < bottom {
                    f(&Piece { top, bottom, insets, winding: side.winding });
                }
            };
            tell((0, beside), (0, 0));
            tell((beside, inside), (inset(side.from), inset(side.to)));
        });
    }

    /// Where the strip ends that begins at a height.
    fn end_of_strip(&self, top: i32) -> i32 {
        let mut end = PIXEL;
        self.pieces(&mut |piece| {
            for height in [piece.top, piece.bottom] {
                if height > top {
                    end = end.min(height);
                }
            }
        });
        self.pieces(&mut |piece| {
            if piece.is_in(top) {
                self.pieces(&mut |other| {
                    if other.is_in(top) {
                        if let Some(height) = piece.crossing(other, (top, end)) {
                            end = end.min(height);
                        }
                    }
                });
            }
        });
        end
    }

    /// The area of the shape in a strip.
    fn strip(&self, rule: FillRule, strip: (i32, i32)) -> u32 {
        let (mut area, mut number) = (0_u32, 0_u32);
        self.pieces(&mut |piece| {
            if !piece.is_in(strip.0) {
                return;
            }
            // Of several at the same place, those that come first are left of the others.
            let (place, mut left, mut n) = (piece.place(strip), 0_i32, 0);
            self.pieces(&mut |other| {
                if other.is_in(strip.0) {
                    let is_before = (other.place(strip), n) < (place, number);
                    left = left.wrapping_add(if is_before { other.winding } else { 0 });
                    n = n.wrapping_add(1);
                }
            });
            number = number.wrapping_add(1);
            let is_inside = |winding: i32| match rule {
                FillRule::NonZero => winding != 0,
                FillRule::EvenOdd => winding & 1 != 0,
            };
            let height = unsigned(strip.1.wrapping_sub(strip.0));
            let right = rounded_area(height, unsigned((2 * PIXEL).wrapping_sub(place)));
            match (is_inside(left), is_inside(left.wrapping_add(piece.winding))) {
                (false, true) => area = area.wrapping_add(right),
                (true, false) => area = area.wrapping_sub(right),
                _ => {}
            }
        });
        area
    }
}
