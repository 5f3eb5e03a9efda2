//! [`Projection`]: the globe on a rectangle, in integers.
//!
//! All of them are *pseudo-cylindrical*: a parallel is a straight line, and places on it keep their distances. So two
//! functions of the latitude say everything, how long a parallel is and how high it lies: tables in steps of 5 degrees with
//! straight lines between.
//! ```text
//!         ___-----+-----___
//!      __/________|________\__     x = lon * length(lat)
//!     /           | height    \    y = height(lat)
//!    +------------+------------+   the equator: length 1, height 0
//! ```
//! The result is rounded to 1/256 pixel once. A place is always projected to the same vertex, so neighbours that share
//! places share vertices.

use embedded_raster::PointFx;

use super::Place;

/// Hundredths of a degree between the entries of the tables.
const STEP: i32 = 500;

/// What a parallel has to be as long as the equator.
const FULL: i64 = 10_000;

/// A hundredth of a degree along the equator in the unit of [`Projection::flat`].
const UNIT: i64 = FULL * STEP as i64;

/// How the globe is laid out flat.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Projection {
    /// Degrees are squares: twice as wide as high.
    Equirectangular,
    /// Meridians bend: shapes and areas are both nearly right. A. H. Robinson, 1963; about twice as wide as high.
    Robinson,
    /// A Mercator map with its ends pulled in, poles included. O. M. Miller, 1942; it fills a screen of 4:3.
    #[default]
    Miller,
}

/// A projection that fills a screen as far as it goes, in its middle.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Screen {
    /// Which projection.
    pub projection: Projection,
    /// Columns.
    pub width: u16,
    /// Rows.
    pub height: u16,
}

impl Projection {
    /// All there are.
    pub const ALL: [Self; 3] = [Self::Equirectangular, Self::Robinson, Self::Miller];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Equirectangular => "equirectangular",
            Self::Robinson => "robinson",
            Self::Miller => "miller",
        }
    }

    /// Of every fifth parallel from the equator to the pole: its length, of 10,000, and its height in hundredths of a
    /// degree along the equator.
    fn tables(self) -> [[i64; 19]; 2] {
        const CYLINDER: [i64; 19] = [FULL; 19];
        #[rustfmt::skip]
        return match self {
            Self::Equirectangular => [CYLINDER, [
                0, 500, 1000, 1500, 2000, 2500, 3000, 3500, 4000, 4500, 5000, 5500, 6000, 6500, 7000, 7500, 8000, 8500, 9000,
            ]],
            Self::Robinson => [
                [
                    10_000, 9986, 9954, 9900, 9822, 9730, 9600, 9427, 9216, 8962,
                    8679, 8350, 7986, 7597, 7186, 6732, 6213, 5722, 5322,
                ], [
                    0, 566, 1132, 1698, 2264, 2830, 3396, 3962, 4526, 5086,
                    5638, 6180, 6707, 7215, 7701, 8158, 8576, 8911, 9130,
                ],
            ],
            // 18,000 * 5/4 ln tan(pi/4 + 2/5 lat) / pi
            Self::Miller => [CYLINDER, [
                0, 500, 1003, 1511, 2027, 2552, 3092, 3648, 4226, 4829,
                5464, 6137, 6857, 7636, 8487, 9432, 10_499, 11_731, 13_198,
            ]],
        };
    }

    /// Where a place lies from the middle of the map, right and up.
    fn flat(self, place: Place) -> (i64, i64) {
        let [lengths, heights] = self.tables();
        let (before, rest) = (place.lat.unsigned_abs() / STEP.unsigned_abs(), i64::from(place.lat.abs() % STEP));
        let between = |table: [i64; 19]| {
            let at = |i: u32| table[(i as usize).min(18)];
            at(before) * i64::from(STEP) + (at(before + 1) - at(before)) * rest
        };
        (i64::from(place.lon) * between(lengths), between(heights) * FULL * i64::from(place.lat.signum()))
    }
}

impl Screen {
    /// The vertex of a place.
    /// ```
    /// use embedded_raster::PointFx;
    /// use embedded_raster_simulator::world::{Place, Projection, Screen};
    /// let screen = Screen { projection: Projection::Equirectangular, width: 320, height: 240 };
    /// assert_eq!(screen.vertex(Place { lon: 0, lat: 0 }), PointFx::px(160, 120));
    /// assert_eq!(screen.vertex(Place { lon: -18_000, lat: 9_000 }), PointFx::px(0, 40));
    /// ```
    pub fn vertex(self, place: Place) -> PointFx {
        let (x, y) = self.projection.flat(place);
        let units = |flat: i64| rounded_ratio(flat * self.half_width(), 18_000 * UNIT);
        PointFx::from_bits(
            i32::from(self.width) * 128 + units(x), // the middle of the screen is at width / 2 pixels
            i32::from(self.height) * 128 - units(y),
        )
    }

    /// The corners of the screen.
    pub fn corners(self) -> [PointFx; 4] {
        let (w, h) = (self.width.into(), self.height.into());
        [(0, 0), (w, 0), (w, h), (0, h)].map(|(x, y)| PointFx::px(x, y))
    }

    /// Half the equator in 1/256 pixel: as much as the width and the height have room for.
    fn half_width(self) -> i64 {
        let [_, heights] = self.projection.tables();
        (i64::from(self.width) * 128).min(i64::from(self.height) * 128 * 18_000 / heights[18])
    }
}

/// To nearest, halves up. In range for screens of up to 65,535 pixels.
fn rounded_ratio(numerator: i64, denominator: i64) -> i32 {
    i32::try_from((numerator + denominator / 2).div_euclid(denominator)).expect("a place lies on the screen")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn poles_and_dateline_touch_the_sides() {
        for projection in Projection::ALL {
            for (width, height) in [(320, 240), (720, 360), (65_535, 65_535), (65_535, 9), (1, 1), (0, 5)] {
                let screen = Screen { projection, width, height };
                let right = screen.vertex(Place { lon: 18_000, lat: 0 });
                let top = screen.vertex(Place { lon: 0, lat: 9_000 });
                let w = i32::from(width) * 256;
                assert!(right.x.to_bits() <= w && top.y.to_bits() >= 0, "{screen:?} leaves the screen");
                // One of them touches, but for the rounding of the scale to 1/256 pixel.
                assert!(w - right.x.to_bits() <= 1 || top.y.to_bits() <= 1, "{screen:?} could be larger");
            }
        }
    }

    #[test]
    fn robinson_at_a_known_place() {
        // 0.8487 and 1.3523 are Robinson's factors for the radius; here half the equator is 1000 px.
        let screen = Screen { projection: Projection::Robinson, width: 2000, height: 2000 };
        let place = screen.vertex(Place { lon: 9_000, lat: 4_500 });
        assert_eq!(place.pixel().x, 1000 + 448, "8962 of 10,000 of a quarter of the equator");
        assert_eq!(place.pixel().y, 1000 - 283, "0.5571 * 0.5072 of half the equator");
    }
}
