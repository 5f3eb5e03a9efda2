//! Antialiased fills: how much of each pixel a shape covers.
//!
//! The coverage of a pixel is the area of the part of the shape that lies in it, in 255ths, rounded to nearest. Pixels that are
//! covered as a whole are told as plain spans, the others as spans of [coverage](crate::Sink::coverage).
//! ```text
//!      +-----+-----+-----+-----+
//!      |     |    .'#####|#####|     0    43   254   255      a span of coverage, 43 254, and then a plain span
//!      +-----+--.'-+-----+-----+
//!      |     |.'###|#####|#####|     3   212   255   255
//!      +----.+-----+-----+-----+
//! ```
//! **How.** Going once round the shape, each side adds to every row that it crosses the area on its right, or takes it away, by
//! the direction in which it goes. The cells of a row sum that up (`strip.rs`); sides come down the rows by exact steps
//! (`slot.rs`). Nothing has to be sorted along a row.
//!
//! **How exact.** Where a side crosses the border of a row or of a column, its place is rounded to the nearest 1/32,768 pixel;
//! all else is exact until areas are rounded to `2^-18` pixel, and once more to 255ths. Each side that goes through a pixel may
//! put it off by 0.004 of a 255th up to 0.009 at the very worst, the last rounding by 0.5. A pixel that the shape covers as a
//! whole has 255, and one that it does not touch has 0. Two shapes that share a side add up to 255 or 256 along it.
//!
//! **Where sides cross inside of a pixel** the sum may not be the area. It is the sum of areas times their winding numbers, and the
//! fill rule is applied to it as a whole; as long as the winding numbers in the pixel are 0 and 1, or 0 and -1, that is the area of
//! the shape. Otherwise what two parts share counts twice: by the non-zero rule up to the whole pixel, by the even-odd rule what is
//! beyond the whole pixel is taken away again. Two loops of a bow-tie that turn in opposite directions cancel out. Only the pixel of
//! the crossing is wrong: its neighbours, and pixels where sides meet at a corner, are right. [`fill_true`], [`path_true`] and
//! [`stroke_true`] find the true area in such pixels (`true_area.rs`), for more time there.
//!
//! **Rows with two sides**, which are most rows of triangles, lines and other simple shapes, take no cells: `pair.rs`.
//!
//! **Lines one pixel wide** take neither sides nor cells: `line.rs`. Nor do **circles, ellipses and rings**: `oval.rs`.
//!
//! **Memory.** Scratch memory for the sides, 44 bytes each, and for the cells: 4 bytes a pixel of the width, and 4 for each 32
//! pixels ([`cells`] counts them). With less, a row is drawn in strips, with the same result, and with a look at each side for
//! each strip. Cells for up to 32 pixels lie on the stack, so a program may pass none.
//!
//! **Work.** For each side a comparison, and two divisions if it meets the window; in each row the sides that cross it and do not
//! lie right of the window, the pixels that they go through, and a look at 32 pixels at a time. Where a side goes through two
//! pixels of a row or more it takes one division, or two.
//!
//! Range: any coordinates. Winding numbers from -8,191 to 8,191: beyond, a pixel counts as if they began anew.
//!
//! Sources: R. Levien, "Inside the fastest font renderer in the world", 2016 (sums along a row); D. Turner, `ftgrays.c` of
//! FreeType, 1999 (areas of cells).

mod fill;
mod line;
mod oval;
mod pair;
mod round;
mod row;
mod shapes;
mod slot;
mod strip;
mod true_area;

pub use self::{
    fill::{cells, extent, fill, fill_true},
    line::line,
    oval::{ellipse, ring},
    round::{ring_sector, sector},
    shapes::{path, path_true, rectangle, rounded, stroke, stroke_polyline, stroke_true, triangle},
    slot::CoverageSlot,
};
