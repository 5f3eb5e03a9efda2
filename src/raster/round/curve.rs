//! [`Ellipse`]: the shape in numbers.

use fixed::types::I24F8;

use crate::{
    geom::{bits, PointFx},
    num::cast::{saturate, signed_wide},
    span::Rect,
};

/// An ellipse with axes along x and y, as the pixels that it fills.
///
/// There are two ways to give one, by its box or by its centre and radii. Where the centre is a centre or a corner of a pixel, or
/// the middle of a side, the ellipse is as symmetric as the pixels around it either way: centres of pixels exactly on the curve are
/// inside. Around any other centre they are inside on the left half only: see [`ellipse`](super::ellipse).
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Ellipse {
    /// Nothing is drawn outside of it.
    extent: Rect,
    /// `None` if the curve touches the sides of the extent; then centres on the curve are inside.
    curve: Option<Curve>,
}

/// Where the curve runs.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub(super) struct Curve {
    /// The centre, from the corner of pixel (0, 0), in units of `2^-shift` pixels.
    pub(super) centre: (i64, i64),
    /// Semi-axes in these units.
    pub(super) radii: (i64, i64),
    pub(super) shift: u32,
    /// Whether centres on the curve are inside. Then its centre is one of the grid too: a centre of pixels or of their sides, or a
    /// corner.
    pub(super) closed: bool,
}

impl Ellipse {
    /// The ellipse that touches the sides of a box of pixels, whose width and height may be odd or even. A centre on the
    /// curve is inside. An empty box has no ellipse.
    #[inline]
    pub const fn in_box(area: Rect) -> Self {
        Self { extent: area, curve: None }
    }

    /// An ellipse by its centre and semi-axes, to 1/256 pixel: whole pixels are [`px`](crate::px) of their number. Without two
    /// positive radii it is empty.
    #[inline]
    pub fn new(centre: PointFx, rx: I24F8, ry: I24F8) -> Self {
        let (x, y) = bits(centre);
        Self::scaled((x.into(), y.into()), (rx.to_bits().into(), ry.to_bits().into()), 8)
    }

    /// A circle by its centre and radius, to 1/256 pixel: whole pixels are [`px`](crate::px) of their number.
    /// ```
    /// use embedded_graphics_core::{geometry::Point, pixelcolor::Gray8};
    /// use embedded_raster::{px, Canvas, Ellipse, Framebuffer, PointFx};
    /// let mut ram = [b'.'; 16];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 4)?;
    /// frame.fill_ellipse_fx(Ellipse::circle(PointFx::px(2, 2), px(2)), Gray8::new(b'#'));
    /// // Around the centre of a pixel, with as many pixels on each side.
    /// frame.fill_ellipse_fx(Ellipse::circle(PointFx::centre_of(Point::new(1, 1)), px(1)), Gray8::new(b'o'));
    /// assert_eq!(&ram, b".o#.ooo##o##.##.");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    #[inline]
    pub fn circle(centre: PointFx, radius: I24F8) -> Self {
        Self::new(centre, radius, radius)
    }

    /// A circle by its centre and *diameter*, to 1/256 pixel: a round point. Whole pixels are [`px`](crate::px) of their number.
    #[inline]
    pub fn splat(centre: PointFx, size: I24F8) -> Self {
        let (x, y) = bits(centre);
        let radius = size.to_bits().into();
        // Half the diameter is a whole number of units of 1/512 pixel.
        Self::scaled((i64::from(x) * 2, i64::from(y) * 2), (radius, radius), 9)
    }

    /// By numbers below 2^45, in units of `2^-shift` pixels.
    #[inline]
    fn scaled(centre: (i64, i64), radii: (i64, i64), shift: u32) -> Self {
        let pixel = |place: i64| first_pixel_from(place, shift);
        let closed = (centre.0 | centre.1) & unit(shift).1.wrapping_sub(1) == 0;
        let extent = if radii.0 <= 0 || radii.1 <= 0 {
            Rect::new(0, 0, 0, 0)
        } else {
            // The row after the last may have its centres at the lowest place of the curve, which may count as inside.
            let (x, y) = (centre.0, centre.1);
            let (low, high) = (i64::wrapping_sub, |n: i64, r: i64| n.wrapping_add(r).wrapping_add(closed.into()));
            Rect::new(pixel(low(x, radii.0)), pixel(low(y, radii.1)), pixel(high(x, radii.0)), pixel(high(y, radii.1)))
        };
        Self { extent, curve: Some(Curve { centre, radii, shift, closed }) }
    }

    /// A circle by its centre and radius, in units of `2^-shift` pixels, below 2^45.
    pub(super) fn round(centre: (i64, i64), radius: u64, shift: u32) -> Self {
        let radius = signed_wide(radius);
        Self::scaled(centre, (radius, radius), shift)
    }

    /// Its curve. That of an ellipse in a box is made of the box.
    #[inline(always)]
    pub(super) fn curve(&self) -> Curve {
        self.curve.unwrap_or_else(|| {
            let Rect { x0, y0, x1, y1 } = self.extent;
            let sum = |a: i32, b: i32| i64::from(a).wrapping_add(b.into());
            let radii = (self.extent.width().into(), self.extent.height().into());
            Curve { centre: (sum(x0, x1), sum(y0, y1)), radii, shift: 1, closed: true }
        })
    }

    /// Its centre and its radii in units of 1/512 pixel, if it has area.
    pub(crate) fn on_grid(&self) -> Option<((i64, i64), (i64, i64))> {
        let curve = self.curve();
        // The shift is at most 9.
        let up = 9_u32.wrapping_sub(curve.shift) & 15;
        let scaled = |(x, y): (i64, i64)| (x << up, y << up);
        (curve.radii.0 > 0 && curve.radii.1 > 0).then(|| (scaled(curve.centre), scaled(curve.radii)))
    }

    /// Whether it touches the sides of its extent.
    #[inline(always)]
    pub(super) const fn is_in_box(&self) -> bool {
        self.curve.is_none()
    }

    /// A box that encloses it: outside there are no pixels.
    #[inline]
    pub const fn extent(&self) -> Rect {
        self.extent
    }
}

impl Curve {
    /// Distance of the centre of a column from the centre of the ellipse, in units.
    #[inline(always)]
    pub(super) fn u(&self, x: i32) -> i64 {
        centre_of(x, self.shift).wrapping_sub(self.centre.0)
    }

    /// Distance of the centre of a row.
    #[inline(always)]
    pub(super) fn v(&self, y: i32) -> i64 {
        centre_of(y, self.shift).wrapping_sub(self.centre.1)
    }

    /// The sum of the first column of a row and the one after its last, if it is closed.
    #[inline(always)]
    pub(super) fn both_ends(&self) -> i64 {
        self.centre.0.wrapping_shr(self.shift.wrapping_sub(1))
    }

    /// The first column whose centre lies at or right of the centre.
    #[inline(always)]
    pub(super) fn middle(&self) -> i32 {
        first_pixel_from(self.centre.0, self.shift)
    }

    /// The narrowest numbers that its form fits into.
    #[inline(always)]
    pub(super) fn size(&self) -> Size {
        size_of(self.radii, self.shift)
    }
}

/// One unit less than a pixel, in units of `2^-shift` pixels, and half a pixel.
#[inline(always)]
fn unit(shift: u32) -> (i64, i64) {
    let pixel = 1_i64.wrapping_shl(shift);
    (pixel.wrapping_sub(1), pixel >> 1)
}

/// The centre of a pixel, in units.
#[inline(always)]
fn centre_of(pixel: i32, shift: u32) -> i64 {
    i64::from(pixel).wrapping_shl(shift).wrapping_add(unit(shift).1)
}

/// The first pixel whose centre lies at or right of a place.
#[inline(always)]
fn first_pixel_from(place: i64, shift: u32) -> i32 {
    let (most, half) = unit(shift);
    saturate(place.wrapping_sub(half).wrapping_add(most).wrapping_shr(shift))
}

/// The numbers that an ellipse is drawn with: 32, 64 or 128 bits.
#[derive(Copy, Clone, PartialEq, Eq)]
pub(super) enum Size {
    Small,
    Medium,
    Large,
}

/// Within these bounds `Form::value` and its steps fit, up to two steps outside of the curve.
#[inline(always)]
pub(super) fn size_of((a, b): (i64, i64), shift: u32) -> Size {
    let small = if a == b {
        a <= 1 << 15
    } else {
        shift == 1 && a < 1024 && b < 1024 && a.wrapping_add(4).wrapping_mul(b.wrapping_add(4)) < 92_681
    };
    let limit = if shift == 1 { 1 << 16 } else { (1 << 18) - 1024 };
    if small {
        Size::Small
    } else if a <= limit && b <= limit {
        Size::Medium
    } else {
        Size::Large
    }
}

/// Whether the ellipse in a box is a circle whose `2 a^2` fits 31 bits.
#[inline(always)]
pub(super) fn is_small_circle(area: Rect) -> bool {
    area.width() == area.height() && area.width() <= 1 << 15
}

/// Whether a box that is not empty lies in a window as a whole.
#[inline(always)]
pub(super) fn is_inside(area: Rect, window: Rect) -> bool {
    area.intersection(window) == area && !area.is_empty()
}
