//! The face of the clock. Integers only and no heap: a chip draws it with this same code.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "places on a screen and two digits are small"
)]
#![allow(unreachable_pub, reason = "other programs have this face as a module of a library")]

use embedded_graphics_core::pixelcolor::Rgb888;
use embedded_raster::{
    geom::Angle, Antialias, Cap, CoverageSlot, EdgeTableFull, Ellipse, FillRule, Join, Paint, Palette, PointFx, Stroke,
    Surface,
};
use fixed::types::I24F8;

/// Hours, minutes and seconds.
pub type Time = (u8, u8, u8);

/// What things are painted in.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Ink {
    /// Around the dial.
    Ground,
    /// The dial.
    Dial,
    /// Marks and numerals on the dial.
    Mark,
    /// The hands of hours and minutes.
    Hand,
    /// The hand of seconds, and how much of the minute has passed.
    Second,
}

/// The colour of an ink.
pub fn rgb(ink: Ink) -> Rgb888 {
    match ink {
        Ink::Ground => Rgb888::new(8, 10, 24),
        Ink::Dial => Rgb888::new(30, 40, 80),
        Ink::Mark => Rgb888::new(170, 180, 210),
        Ink::Hand => Rgb888::new(250, 250, 240),
        Ink::Second => Rgb888::new(240, 70, 50),
    }
}

/// Sixteen colours: the inks, and what rims need between them.
pub fn palette() -> Palette<Rgb888, 16> {
    use embedded_raster::pixel::Channels;
    let mix = |a, b, level| Rgb888::between([rgb(a), rgb(b)], level);
    Palette::new([
        rgb(Ink::Ground),
        mix(Ink::Ground, Ink::Dial, 128),
        rgb(Ink::Dial),
        mix(Ink::Dial, Ink::Mark, 64),
        mix(Ink::Dial, Ink::Mark, 128),
        mix(Ink::Dial, Ink::Mark, 192),
        rgb(Ink::Mark),
        mix(Ink::Mark, Ink::Hand, 128),
        rgb(Ink::Hand),
        mix(Ink::Dial, Ink::Second, 64),
        mix(Ink::Dial, Ink::Second, 128),
        mix(Ink::Dial, Ink::Second, 192),
        rgb(Ink::Second),
        mix(Ink::Hand, Ink::Second, 64),
        mix(Ink::Hand, Ink::Second, 128),
        mix(Ink::Hand, Ink::Second, 192),
    ])
}

/// The strokes of the digits, in a box 4 wide and 6 high.
const DIGITS: [&[(i32, i32)]; 10] = [
    &[(1, 0), (3, 0), (4, 1), (4, 5), (3, 6), (1, 6), (0, 5), (0, 1), (1, 0)],
    &[(1, 1), (2, 0), (2, 6)],
    &[(0, 1), (1, 0), (3, 0), (4, 1), (4, 2), (0, 6), (4, 6)],
    &[(0, 0), (4, 0), (2, 2), (4, 4), (4, 5), (3, 6), (1, 6), (0, 5)],
    &[(3, 6), (3, 0), (0, 4), (4, 4)],
    &[(4, 0), (0, 0), (0, 2), (3, 2), (4, 3), (4, 5), (3, 6), (0, 6)],
    &[(3, 0), (1, 0), (0, 2), (0, 5), (1, 6), (3, 6), (4, 5), (4, 4), (3, 3), (0, 3)],
    &[(0, 0), (4, 0), (1, 6)],
    &[
        (1, 3),
        (0, 2),
        (0, 1),
        (1, 0),
        (3, 0),
        (4, 1),
        (4, 2),
        (3, 3),
        (1, 3),
        (0, 4),
        (0, 5),
        (1, 6),
        (3, 6),
        (4, 5),
        (4, 4),
        (3, 3),
    ],
    &[(4, 3), (1, 3), (0, 2), (0, 1), (1, 0), (3, 0), (4, 1), (4, 4), (3, 6), (1, 6)],
];

/// Slots of the edge table that the face needs.
pub const SLOTS: usize = 160;

/// A clock at a time, in a square in the corner of the screen.
#[derive(Copy, Clone, Debug)]
pub struct Face {
    /// Columns and rows.
    pub size: u16,
    /// What it shows.
    pub time: Time,
}

impl Face {
    /// So many thousandths of the half size, in units.
    fn scaled(self, thousandths: i32) -> i32 {
        i32::from(self.size) * 128 * thousandths / 1000
    }

    fn length(self, thousandths: i32) -> I24F8 {
        I24F8::from_bits(self.scaled(thousandths).max(128))
    }

    /// A place so far from the centre, in a direction that is clockwise from the top.
    fn at(self, direction: Angle, thousandths: i32) -> PointFx {
        let (cos, sin) = direction.plus(-(1 << 30)).cos_sin();
        let radius = i64::from(self.scaled(thousandths));
        let away = |part: i32| ((radius * i64::from(part) + (1 << 29)) >> 30) as i32;
        let middle = i32::from(self.size) * 128;
        PointFx::from_bits(middle + away(cos), middle + away(sin))
    }

    /// Draws all but the ground. `paint` says how an ink is painted.
    ///
    /// # Errors
    /// `table` is shorter than [`SLOTS`].
    pub fn draw<S: Surface, P: Paint<S>>(
        self,
        on: &mut S,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: &impl Fn(Ink) -> P,
    ) -> Result<(), EdgeTableFull> {
        let (hours, minutes, seconds) = self.time;
        let disc = |middle, radius| Ellipse::circle(middle, radius);
        let middle = self.at(Angle::default(), 0);
        on.fill_ellipse_aa(disc(middle, self.length(960)), paint(Ink::Dial));
        for minute in 0..60 {
            let (inner, width) = if minute % 5 == 0 { (830, 36) } else { (885, 14) };
            let direction = Angle::turns(minute, 60);
            let ends = [self.at(direction, inner), self.at(direction, 915)];
            on.stroke_line_aa(ends, &Stroke::new(self.length(width)), table, cells, paint(Ink::Mark))?;
        }
        for hour in 1..=12_u8 {
            self.numeral(on, hour, table, cells, paint)?;
        }
        // How much of the minute has passed, along the rim.
        let mut passed = [PointFx::default(); 60];
        for (second, place) in (0..).zip(&mut passed) {
            *place = self.at(Angle::turns(second, 60), 945);
        }
        let passed = passed.get(..=usize::from(seconds)).unwrap_or(&passed);
        let arc = Stroke::new(self.length(26)).with_cap(Cap::Round).with_join(Join::Round);
        on.stroke_polyline_aa(passed, false, &arc, table, cells, paint(Ink::Second))?;
        let (seconds, minutes, hours) = (u32::from(seconds), u32::from(minutes), u32::from(hours % 12));
        let minutes = minutes * 60 + seconds;
        self.hand(on, Angle::turns(hours * 3600 + minutes, 43_200), (500, 42), (table, cells), paint(Ink::Hand))?;
        self.hand(on, Angle::turns(minutes, 3600), (780, 30), (table, cells), paint(Ink::Hand))?;
        let direction = Angle::turns(seconds, 60);
        let needle = [self.at(direction, -180), self.at(direction, 840)];
        on.stroke_line_aa(needle, &Stroke::new(self.length(14)), table, cells, paint(Ink::Second))?;
        on.fill_ellipse_aa(disc(middle, self.length(52)), paint(Ink::Second));
        Ok(())
    }

    /// A hand that tapers to its tip.
    fn hand<S: Surface, P: Paint<S>>(
        self,
        on: &mut S,
        direction: Angle,
        (length, width): (i32, i32),
        (table, cells): (&mut [CoverageSlot], &mut [i32]),
        paint: P,
    ) -> Result<(), EdgeTableFull> {
        let across = direction.plus(1 << 30);
        let [right, left] = [self.at(across, width), self.at(across, -width)];
        let hand = [right, self.at(direction, length), left, self.at(direction, -width * 3)];
        on.fill_polygon_aa(&hand, FillRule::NonZero, table, cells, paint)
    }

    fn numeral<S: Surface, P: Paint<S>>(
        self,
        on: &mut S,
        hour: u8,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: &impl Fn(Ink) -> P,
    ) -> Result<(), EdgeTableFull> {
        let (tens, units) = (usize::from(hour / 10), usize::from(hour % 10));
        let digits = if tens > 0 { &[tens, units][..] } else { &[units] };
        let (middle, step) = (self.at(Angle::turns(hour.into(), 12), 690), self.scaled(22));
        let width = 6 * digits.len() as i32 - 2;
        for (&digit, left) in digits.iter().zip((0..).step_by(6)) {
            let strokes = DIGITS[digit];
            let mut places = [PointFx::default(); 16];
            for (place, &(x, y)) in places.iter_mut().zip(strokes) {
                *place = middle + PointFx::from_bits((2 * (x + left) - width) * step / 2, (y - 3) * step);
            }
            let stroke = Stroke::new(self.length(24)).with_cap(Cap::Round).with_join(Join::Round);
            on.stroke_polyline_aa(&places[..strokes.len()], false, &stroke, table, cells, paint(Ink::Mark))?;
        }
        Ok(())
    }
}
