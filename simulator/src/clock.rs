//! An analogue clock with soft rims, on four kinds of screens: each takes another paint, and the drawing is the same.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "places on a screen and two digits are small"
)]

use embedded_graphics_core::{
    pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565, Rgb888},
    prelude::PixelColor,
};
use embedded_raster::{
    buffer_bytes,
    geom::Angle,
    paint::{Cover, CoverIndex, Dithered},
    raster::coverage,
    Antialias, Cap, CoverageSlot, Ellipse, Error, FillRule, Framebuffer, Index4, Join, Paint, Palette, PixelFormat,
    PointFx, Stroke, Surface,
};
use fixed::types::I24F8;

use crate::Picture;

/// What the clock is shown on.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Screen {
    /// One bit per pixel, dithered.
    Mono,
    /// Sixteen greys.
    Gray4,
    /// Sixteen colours of a palette.
    Palette16,
    /// 16 bits.
    Rgb565,
}

impl Screen {
    /// All of them, with their names.
    pub const ALL: [(&'static str, Self); 4] =
        [("mono", Self::Mono), ("gray4", Self::Gray4), ("palette16", Self::Palette16), ("rgb565", Self::Rgb565)];
}

/// What things are painted in.
#[derive(Copy, Clone)]
enum Ink {
    Ground,
    Dial,
    Mark,
    Hand,
    Second,
}

/// The colour of an ink.
fn rgb(ink: Ink) -> Rgb888 {
    match ink {
        Ink::Ground => Rgb888::new(8, 10, 24),
        Ink::Dial => Rgb888::new(30, 40, 80),
        Ink::Mark => Rgb888::new(170, 180, 210),
        Ink::Hand => Rgb888::new(250, 250, 240),
        Ink::Second => Rgb888::new(240, 70, 50),
    }
}

/// Sixteen colours: the inks, and what rims need between them.
fn palette() -> Palette<Rgb888, 16> {
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

/// Hours, minutes and seconds.
pub type Time = (u8, u8, u8);

/// Draws the clock in a square of so many pixels, in bands of so many rows.
///
/// # Errors
/// If scratch memory is too small, which is a mistake of this function.
pub fn clock(screen: Screen, size: u16, time: Time, rows: u16) -> Result<Picture, Error> {
    let face = Face { size, time };
    let palette = palette();
    let entry = |ink| palette.nearest(rgb(ink));
    match screen {
        Screen::Mono => {
            let on = |ink| BinaryColor::from(!matches!(ink, Ink::Ground | Ink::Dial));
            let mut ram = face.bands::<BinaryColor, _>(rows, on(Ink::Ground), |ink| Dithered::<_, 4>(on(ink)))?;
            Ok(Picture::of(&Framebuffer::<BinaryColor>::new(&mut ram[..], size, size)?))
        }
        Screen::Gray4 => {
            let gray = |ink| Gray4::from(Gray8::from(rgb(ink)));
            let mut ram = face.bands::<Gray4, _>(rows, gray(Ink::Ground), |ink| Cover(gray(ink)))?;
            Ok(Picture::of(&Framebuffer::<Gray4>::new(&mut ram[..], size, size)?))
        }
        Screen::Palette16 => {
            let index = |ink| Index4::new(entry(ink));
            let make: fn(u8) -> Index4 = Index4::new;
            let paint = |ink| CoverIndex::new(&palette, index(ink), make);
            let mut ram = face.bands::<Index4, _>(rows, index(Ink::Ground), paint)?;
            Ok(Picture::indexed(&Framebuffer::<Index4>::new(&mut ram[..], size, size)?, &palette))
        }
        Screen::Rgb565 => {
            let color = |ink| Rgb565::from(rgb(ink));
            let mut ram = face.bands::<Rgb565, _>(rows, color(Ink::Ground), |ink| Cover(color(ink)))?;
            Ok(Picture::of(&Framebuffer::<Rgb565>::new(&mut ram[..], size, size)?))
        }
    }
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

struct Face {
    size: u16,
    time: Time,
}

impl Face {
    /// The bytes of the screen, drawn band by band.
    fn bands<C, P>(&self, rows: u16, ground: C, paint: impl Fn(Ink) -> P) -> Result<Vec<u8>, Error>
    where
        C: PixelColor + PixelFormat<Color = C>,
        P: for<'a> Paint<Framebuffer<'a, C>>,
    {
        let mut screen = Vec::new();
        let rows = rows.clamp(1, self.size);
        for start in (0..self.size).step_by(rows.into()) {
            let end = start.saturating_add(rows).min(self.size);
            let mut ram = vec![0; buffer_bytes::<C>(self.size, end - start)];
            let mut frame = Framebuffer::<C>::band(&mut ram, self.size, self.size, start..end)?;
            frame.clear(ground);
            self.draw(&mut frame, &paint)?;
            screen.extend_from_slice(frame.row_bytes(start..end));
        }
        Ok(screen)
    }

    /// So many thousandths of the half size, in units.
    fn scaled(&self, thousandths: i32) -> i32 {
        i32::from(self.size) * 128 * thousandths / 1000
    }

    fn length(&self, thousandths: i32) -> I24F8 {
        I24F8::from_bits(self.scaled(thousandths).max(128))
    }

    /// A place so far from the centre, in a direction that is clockwise from the top.
    fn at(&self, direction: Angle, thousandths: i32) -> PointFx {
        let (cos, sin) = direction.plus(-(1 << 30)).cos_sin();
        let radius = i64::from(self.scaled(thousandths));
        let away = |part: i32| ((radius * i64::from(part) + (1 << 29)) >> 30) as i32;
        let middle = i32::from(self.size) * 128;
        PointFx::from_bits(middle + away(cos), middle + away(sin))
    }

    fn draw<S: Surface, P: Paint<S>>(&self, on: &mut S, paint: &impl Fn(Ink) -> P) -> Result<(), Error> {
        let (table, cells) = (&mut [CoverageSlot::EMPTY; 160][..], &mut vec![0; coverage::cells(self.size)][..]);
        let (hours, minutes, seconds) = self.time;
        let disc = |middle, radius| Ellipse::circle(middle, radius);
        let middle = self.at(Angle::default(), 0);
        on.fill_ellipse_aa(disc(middle, self.length(960)), table, cells, paint(Ink::Dial))?;
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
        let passed: Vec<PointFx> =
            (0..=u32::from(seconds)).map(|second| self.at(Angle::turns(second, 60), 945)).collect();
        let arc = Stroke::new(self.length(26)).with_cap(Cap::Round).with_join(Join::Round);
        on.stroke_polyline_aa(&passed, false, &arc, table, cells, paint(Ink::Second))?;
        let (seconds, minutes, hours) = (u32::from(seconds), u32::from(minutes), u32::from(hours % 12));
        let minutes = minutes * 60 + seconds;
        self.hand(on, Angle::turns(hours * 3600 + minutes, 43_200), (500, 42), (table, cells), paint(Ink::Hand))?;
        self.hand(on, Angle::turns(minutes, 3600), (780, 30), (table, cells), paint(Ink::Hand))?;
        let direction = Angle::turns(seconds, 60);
        let needle = [self.at(direction, -180), self.at(direction, 840)];
        on.stroke_line_aa(needle, &Stroke::new(self.length(14)), table, cells, paint(Ink::Second))?;
        on.fill_ellipse_aa(disc(middle, self.length(52)), table, cells, paint(Ink::Second))?;
        Ok(())
    }

    /// A hand that tapers to its tip.
    fn hand<S: Surface, P: Paint<S>>(
        &self,
        on: &mut S,
        direction: Angle,
        (length, width): (i32, i32),
        (table, cells): (&mut [CoverageSlot], &mut [i32]),
        paint: P,
    ) -> Result<(), Error> {
        let across = direction.plus(1 << 30);
        let [right, left] = [self.at(across, width), self.at(across, -width)];
        let hand = [right, self.at(direction, length), left, self.at(direction, -width * 3)];
        Ok(on.fill_polygon_aa(&hand, FillRule::NonZero, table, cells, paint)?)
    }

    fn numeral<S: Surface, P: Paint<S>>(
        &self,
        on: &mut S,
        hour: u8,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
        paint: &impl Fn(Ink) -> P,
    ) -> Result<(), Error> {
        let digits = if hour < 10 { vec![hour] } else { vec![1, hour - 10] };
        let (middle, step) = (self.at(Angle::turns(hour.into(), 12), 690), self.scaled(22));
        let width = 6 * digits.len() as i32 - 2;
        for (digit, left) in digits.into_iter().zip((0..).step_by(6)) {
            let place =
                |&(x, y): &(i32, i32)| middle + PointFx::from_bits((2 * (x + left) - width) * step / 2, (y - 3) * step);
            let places: Vec<PointFx> = DIGITS[usize::from(digit)].iter().map(place).collect();
            let stroke = Stroke::new(self.length(24)).with_cap(Cap::Round).with_join(Join::Round);
            on.stroke_polyline_aa(&places, false, &stroke, table, cells, paint(Ink::Mark))?;
        }
        Ok(())
    }
}
