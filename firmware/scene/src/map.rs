//! The countries of the world at four bits per pixel: filled, with borders.
//!
//! Equirectangular with the standard parallels at 48 degrees, where a degree of longitude is two thirds of one of latitude:
//! so 360 x 180 degrees fill 320 x 240 pixels. From hundredths of a degree to units of 1/256 pixel,
//! ```text
//!  x = (longitude + 18,000) * X / 2^15      X = 256 * 320 * 2^15 / 36,000, rounded up
//!  y = (9,000 - latitude) * Y / 2^16        Y = 256 * 240 * 2^16 / 18,000, likewise
//! ```
//! rounded down, where products stay below 2^32: a multiplication and a shift on every chip.

use core::slice;

use embedded_raster::{buffer_bytes, Canvas, EdgeSlot, Error, FillRule, Framebuffer, Index4, PointFx, Rect};

use crate::{HEIGHT, WIDTH};

include!(concat!(env!("OUT_DIR"), "/world.rs"));

/// Bytes of the framebuffer: 38,400.
pub const BYTES: usize = buffer_bytes::<Index4>(WIDTH, HEIGHT);

const SEA: Index4 = Index4::new(1);
const BORDER: Index4 = Index4::new(0);
/// Countries take these in turn: neither sea nor border.
const LAND: [u8; 7] = [2, 3, 6, 7, 10, 12, 14];

/// Draws the map on `memory` from its first byte on.
///
/// # Errors
/// `memory` is shorter than [`BYTES`], or `table` than the sides of a country in one row.
pub fn draw(memory: &mut [u8], table: &mut [EdgeSlot]) -> Result<(), Error> {
    draw_on(&mut Framebuffer::<Index4>::new(memory, WIDTH, HEIGHT)?, table)
}

/// Draws the map on the whole screen, or on a band of it: there, countries that lie above or below are left out.
///
/// # Errors
/// `table` is shorter than the sides of a country in one row.
pub fn draw_on(frame: &mut Framebuffer<'_, Index4>, table: &mut [EdgeSlot]) -> Result<(), Error> {
    frame.clear(SEA);
    let Rect { y0, y1, .. } = frame.window();
    let is_seen = |&[low, high]: &[i16; 2]| {
        let [top, bottom] = [high, low].map(|latitude| project([0, latitude]).pixel().y);
        top < y1 && bottom >= y0
    };
    let seen = || countries().zip(&LATITUDES).zip(LAND.iter().cycle()).filter(move |((_, ends), _)| is_seen(ends));
    for ((country, _), &color) in seen() {
        frame.fill_contours_fx(country, FillRule::EvenOdd, table, Index4::new(color))?;
    }
    for ring in seen().flat_map(|((country, _), _)| country) {
        // Closed: from the last point to the first.
        let last = ring.clone().last();
        frame.draw_polyline(last.into_iter().chain(ring).map(PointFx::pixel), BORDER);
    }
    Ok(())
}

/// The rings of each country.
fn countries() -> impl Iterator<Item = Rings> {
    let mut rest = Rings { lengths: &RINGS, points: &POINTS };
    COUNTRIES.iter().map_while(move |&rings| {
        let (lengths, lengths_after) = rest.lengths.split_at_checked(rings.into())?;
        let points = lengths.iter().map(|&n| usize::from(n)).sum();
        let (points, points_after) = rest.points.split_at_checked(points)?;
        rest = Rings { lengths: lengths_after, points: points_after };
        Some(Rings { lengths, points })
    })
}

/// Rings that follow each other in the tables.
#[derive(Clone)]
struct Rings {
    lengths: &'static [u16],
    points: &'static [[i16; 2]],
}

impl Iterator for Rings {
    type Item = Ring;

    fn next(&mut self) -> Option<Ring> {
        let (&length, lengths) = self.lengths.split_first()?;
        let (ring, points) = self.points.split_at_checked(length.into())?;
        *self = Self { lengths, points };
        Some(Ring(ring.iter()))
    }
}

/// The points of a ring, projected when they are asked for: there is no RAM to keep them in.
#[derive(Clone)]
struct Ring(slice::Iter<'static, [i16; 2]>);

impl Iterator for Ring {
    type Item = PointFx;

    #[inline]
    fn next(&mut self) -> Option<PointFx> {
        self.0.next().copied().map(project)
    }
}

fn project([longitude, latitude]: [i16; 2]) -> PointFx {
    const X: u32 = 74_566;
    const Y: u32 = 223_697;
    let (east, south) = ((i32::from(longitude) + 18_000) as u32, (9_000 - i32::from(latitude)) as u32);
    PointFx::from_bits((east * X >> 15) as i32, (south * Y >> 16) as i32)
}
