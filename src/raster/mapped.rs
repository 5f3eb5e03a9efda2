//! Pictures under an affine map: scaled, turned, slanted, mirrored, moved; and stretched to a box.
//!
//! **Which pixels.** A map takes the picture, `w` texels wide and `h` high, to a parallelogram on the screen. A pixel is drawn when its
//! centre lies in it, by the [rule of fills](crate::raster#); so the pixels are those that a polygon with these corners has, and
//! pictures whose edges are the same line meet without a gap, and without a pixel that both draw.
//!
//! **Which texel.** The one that contains the centre, taken back to the picture: exactly, not by a gradient that was rounded. With
//! the centre at `(X, Y)` from where the map takes (0, 0), and `D = xx yy - xy yx`:
//! ```text
//!     u = (yy X - xy Y) / D        column = floor(u), drawn if 0 <= u < w
//!     v = (xx Y - yx X) / D        row    = floor(v), drawn if 0 <= v < h
//! ```
//! **How.** Both numerators are integers of 64 bits that change by a constant from pixel to pixel. Where the centre may be on an edge
//! is found from them without a division: the ends of a row move on from those of the row above. Along a run, u and v are sums with 48
//! bits of fraction whose steps are rounded up; as the true values are multiples of `1 / D`, their whole parts are right for as long as
//! the excess is below that (as with [values over triangles](crate::geom::Varying)), and a run is cut before it is not.
//!
//! **Work.** Rows and columns of the window that the box of the parallelogram shares, and one step a pixel.
//!
//! Source: P. Heckbert, "Fundamentals of Texture Mapping and Image Warping", 1989, section 2.2 (affine maps).

use core::num::NonZeroU32;

use embedded_graphics_core::geometry::Size;

use crate::{
    error::MapTooLarge,
    geom::Affine,
    num::{
        cast::{low_u32, narrow, signed, signed_wide},
        divisor::WideDivisor,
    },
    span::{ClippedSpan, Rect},
};

/// Bits of fraction of a place in a picture, below 16 bits for the texel.
const FRACTION: u32 = 48;

/// Factors of a map are below this, 64 in 16.16. So D is at most 2^45.
const MOST: u32 = 64 << 16;

/// Pixels are looked for up to here from (0, 0): no frame reaches farther. Then numerators are below 2^58.
const FAR: i32 = 1 << 17;

/// The texels along a run of pixels, from left to right.
#[derive(Copy, Clone, Debug)]
pub struct Texels {
    place: [u64; 2],
    step: [u64; 2],
}

impl Texels {
    /// Column and row of the next texel.
    #[inline(always)]
    pub fn texel(&mut self) -> (i32, i32) {
        let [u, v] = self.place.map(|place| signed(low_u32(place >> FRACTION)));
        for (place, step) in self.place.iter_mut().zip(self.step) {
            *place = place.wrapping_add(step);
        }
        (u, v)
    }
}

/// A numerator, from -2^58 to 2^58, and what it is compared with.
#[derive(Copy, Clone)]
struct Axis {
    /// At the pixel.
    at: i64,
    /// From a pixel to its right neighbour, and to the one below.
    right: i64,
    down: i64,
    /// D times the texels, where the picture ends.
    end: i64,
}

impl Axis {
    /// Whether the picture begins behind a place in this row.
    #[inline(always)]
    fn is_before(&self, at: i64) -> bool {
        (self.right > 0 && at < 0) || (self.right < 0 && at >= self.end)
    }

    /// Whether the picture has ended before a place in this row.
    #[inline(always)]
    fn is_behind(&self, at: i64) -> bool {
        (self.right < 0 && at < 0) || (self.right > 0 && at >= self.end)
    }

    /// Whether no pixel of the row can be in the picture.
    #[inline(always)]
    fn is_beside(&self) -> bool {
        self.right == 0 && (self.at < 0 || self.at >= self.end)
    }
}

/// One end of the pixels of a row, moved on from row to row.
#[derive(Copy, Clone)]
struct End {
    x: i32,
    axes: [Axis; 2],
}

impl End {
    /// Moves to the first of the pixels `x0..x1` for which `is_over` holds, or to `x1`. It holds for all pixels to the right of that.
    #[inline(always)]
    fn settle(&mut self, x0: i32, x1: i32, is_over: impl Fn([(&Axis, i64); 2]) -> bool) {
        while self.x < x1 && !is_over(self.axes.each_ref().map(|axis| (axis, axis.at))) {
            self.x = self.x.wrapping_add(1);
            self.axes.iter_mut().for_each(|axis| axis.at = axis.at.wrapping_add(axis.right));
        }
        while self.x > x0 && is_over(self.axes.each_ref().map(|axis| (axis, axis.at.wrapping_sub(axis.right)))) {
            self.x = self.x.wrapping_sub(1);
            self.axes.iter_mut().for_each(|axis| axis.at = axis.at.wrapping_sub(axis.right));
        }
    }

    #[inline(always)]
    fn next_row(&mut self) {
        self.axes.iter_mut().for_each(|axis| axis.at = axis.at.wrapping_add(axis.down));
    }
}

/// Calls `draw` with the runs of pixels that a picture of a size covers when it is mapped, from top to bottom and from left to right,
/// and with their texels.
///
/// A map that squeezes the picture to a line draws nothing. Columns and rows are looked for from -131,072 to 131,071; no frame has
/// others. Of a picture that is wider or higher than 65,535 texels, the rest is left out; no frame is.
///
/// # Errors
/// [`MapTooLarge`] if one of the four factors is 64 or more, or -64 or less. Nothing is drawn then.
pub fn fill(
    map: &Affine,
    size: Size,
    window: Rect,
    mut draw: impl FnMut(ClippedSpan, Texels),
) -> Result<(), MapTooLarge> {
    let factors = [map.xx, map.xy, map.yx, map.yy];
    if let Some(&factor) = factors.iter().find(|factor| factor.to_bits().unsigned_abs() >= MOST) {
        return Err(MapTooLarge { factor: factor.to_bits() >> 16, limit: signed(MOST >> 16) });
    }
    let [xx, xy, yx, yy] = factors.map(|factor| i64::from(factor.to_bits()));
    let (Some(_), Some(_)) = (NonZeroU32::new(size.width), NonZeroU32::new(size.height)) else { return Ok(()) };
    // No picture has more.
    let (width, height) = (i64::from(size.width.min(0xffff)), i64::from(size.height.min(0xffff)));
    let determinant = xx.wrapping_mul(yy).wrapping_sub(xy.wrapping_mul(yx));
    let d = determinant.unsigned_abs();
    let dx = i64::from(map.dx.to_bits());
    let dy = i64::from(map.dy.to_bits());
    // The pixels that touch the box of the parallelogram.
    let ends = |moved: i64, a: i64, b: i64| {
        let (a, b) = (a.wrapping_mul(width), b.wrapping_mul(height));
        let (low, high) = (a.min(0).wrapping_add(b.min(0)), a.max(0).wrapping_add(b.max(0)));
        let pixel = |at: i64| narrow((moved.wrapping_add(at) >> 16).clamp(i64::from(-FAR), i64::from(FAR)));
        (pixel(low), pixel(high).wrapping_add(1))
    };
    let ((x0, x1), (y0, y1)) = (ends(dx, xx, xy), ends(dy, yx, yy));
    let seen = Rect::new(x0, y0, x1, y1).intersection(window).intersection(Rect::new(-FAR, -FAR, FAR, FAR));
    if d == 0 || seen.is_empty() {
        return Ok(());
    }
    // The numerators at the centre of the first pixel. 2^35, times 2^22, twice: 2^58.
    let centre = |x: i32, moved: i64| (i64::from(x) << 16).wrapping_add(1 << 15).wrapping_sub(moved);
    let (right, down) = (centre(seen.x0, dx), centre(seen.y0, dy));
    let axis = |[a, b]: [i64; 2], texels: i64| {
        let [a, b] = if determinant < 0 { [a.wrapping_neg(), b.wrapping_neg()] } else { [a, b] };
        let at = a.wrapping_mul(right).wrapping_add(b.wrapping_mul(down));
        // On an edge, a centre counts as if it stood a little to the right and, much less, down.
        let is_less = a < 0 || (a == 0 && b < 0);
        Axis {
            at: at.wrapping_sub(is_less.into()),
            right: a << 16,
            down: b << 16,
            end: signed_wide(d).saturating_mul(texels),
        }
    };
    let axes = [axis([yy, xy.wrapping_neg()], width), axis([yx.wrapping_neg(), xx], height)];
    let divisor = WideDivisor::new(d);
    let step = axes.map(|axis| divisor.ratio(axis.right, FRACTION));
    // Places are below 2^16, so a start is too large by less than 3 units, and each step by less than 3 more. After n pixels that is
    // below 1 / D if `3 n D < 2^48`.
    let (longest, _) = WideDivisor::new(d.wrapping_mul(3)).quotient((1 << FRACTION) - 1);
    let longest = narrow(longest.min(0xffff));
    let mut first = End { x: seen.x0, axes };
    let mut behind = first;
    for y in seen.y0..seen.y1 {
        if !first.axes.iter().any(Axis::is_beside) {
            first.settle(seen.x0, seen.x1, |axes| axes.iter().all(|(axis, at)| !axis.is_before(*at)));
            behind.settle(seen.x0, seen.x1, |axes| axes.iter().any(|(axis, at)| axis.is_behind(*at)));
            let mut x = first.x;
            while x < behind.x {
                let end = behind.x.min(x.wrapping_add(longest));
                let along = i64::from(x.wrapping_sub(first.x));
                let place = first
                    .axes
                    .map(|axis| divisor.ratio(axis.at.wrapping_add(axis.right.wrapping_mul(along)), FRACTION));
                draw(ClippedSpan::inside(y, x, end), Texels { place, step });
                x = end;
            }
        }
        first.next_row();
        behind.next_row();
    }
    Ok(())
}

/// Calls `draw` with the pixels of a box that lie in the window, from top to bottom and from left to right, and with their texels
/// when a picture of a size is stretched to the box: column `floor((2 x + 1) w / (2 W))` in column x of W, and so for rows.
///
/// A picture without texels draws nothing. Of one that is wider or higher than 65,535 texels, the rest is left out.
pub fn stretch(area: Rect, size: Size, window: Rect, mut draw: impl FnMut(ClippedSpan, Texels)) {
    let seen = area.intersection(window);
    if seen.is_empty() || size.width == 0 || size.height == 0 {
        return;
    }
    // Below 2^49, over at most 2^33.
    let axis = |texels: u32, pixels: u32| {
        let texels = i64::from(texels.min(0xffff));
        (texels, WideDivisor::new(u64::from(pixels) << 1))
    };
    let twice = |at: i32, from: i32| i64::from(at).wrapping_sub(from.into()).wrapping_mul(2).wrapping_add(1);
    let ((width, columns), (height, rows)) = (axis(size.width, area.width()), axis(size.height, area.height()));
    let step = [columns.ratio(width.wrapping_mul(2), FRACTION), 0];
    // As in `fill`: at least 2^13 pixels.
    let longest = WideDivisor::new(u64::from(area.width()).wrapping_mul(6)).quotient((1 << FRACTION) - 1).0;
    let longest = narrow(longest.min(0xffff));
    for y in seen.y0..seen.y1 {
        let (row, _) = rows.quotient(twice(y, area.y0).wrapping_mul(height));
        let mut x = seen.x0;
        while x < seen.x1 {
            let end = seen.x1.min(x.saturating_add(longest));
            let place =
                [columns.ratio(twice(x, area.x0).wrapping_mul(width), FRACTION), row.unsigned_abs() << FRACTION];
            draw(ClippedSpan::inside(y, x, end), Texels { place, step });
            x = end;
        }
    }
}
