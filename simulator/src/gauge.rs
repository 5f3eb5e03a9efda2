//! A gauge with a needle on a display of 128 x 64 pixels at one bit, as an SSD1306 has it.
//!
//! Numerals are glyphs with soft rims: here `ab_glyph` makes them of a font, and a firmware would have them in flash. They are masks of
//! four bits a pixel, painted by [`Antialias::blit_mask_aa`].
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "sizes of glyphs and places on a screen are small"
)]

use ab_glyph::{Font, FontRef, ScaleFont};
use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray4},
};
use embedded_raster::{
    buffer_bytes,
    geom::{Angle, Arc},
    paint::Masked,
    px,
    raster::coverage,
    surface::{paged_bytes, Paged},
    Antialias, Bitmap, Cap, CoverageSlot, Ellipse, Error, FillRule, Framebuffer, PathSegment, PointFx, Solid, Stroke,
    Surface,
};
use fixed::types::I24F8;

use crate::Picture;

/// Columns and rows.
pub const SIZE: (u16, u16) = (128, 64);

/// What the gauge shows at its end.
pub const MOST: u16 = 1000;

/// A glyph: a mask of four bits a pixel, and where it is seen from the pen.
struct Glyph {
    mask: Vec<u8>,
    size: (u16, u16),
    /// From the pen to its top left pixel.
    offset: Point,
    /// How far the pen moves on.
    advance: i32,
}

/// The digits and what stands beside them at one height.
struct Digits(Vec<(char, Glyph)>);

impl Digits {
    /// Made of a font, so many pixels high.
    fn new(font: &FontRef<'_>, height: f32) -> Result<Self, Error> {
        let glyphs = "0123456789°C".chars().map(|letter| Ok((letter, Glyph::new(font, letter, height)?)));
        Ok(Self(glyphs.collect::<Result<_, Error>>()?))
    }

    fn of<'a>(&'a self, text: &'a str) -> impl Iterator<Item = &'a Glyph> {
        text.chars().filter_map(|letter| self.0.iter().find(|(known, _)| *known == letter)).map(|(_, glyph)| glyph)
    }

    /// Writes a text from a place on its base line on.
    fn write<S: Surface<Color = BinaryColor>>(&self, on: &mut S, mut pen: Point, text: &str) -> Result<(), Error> {
        for glyph in self.of(text) {
            let mask = Bitmap::<Gray4>::new(&glyph.mask, glyph.size.0, glyph.size.1)?;
            on.blit_mask_aa(pen + glyph.offset, &mask, Solid(BinaryColor::On));
            pen.x += glyph.advance;
        }
        Ok(())
    }

    fn width(&self, text: &str) -> i32 {
        self.of(text).map(|glyph| glyph.advance).sum()
    }
}

impl Glyph {
    fn new(font: &FontRef<'_>, letter: char, height: f32) -> Result<Self, Error> {
        let scaled = font.as_scaled(height);
        let glyph = scaled.scaled_glyph(letter);
        let advance = scaled.h_advance(glyph.id).round() as i32;
        let Some(outline) = font.outline_glyph(glyph) else {
            return Ok(Self { mask: vec![], size: (0, 0), offset: Point::zero(), advance });
        };
        let bounds = outline.px_bounds();
        let size = (bounds.width() as u16, bounds.height() as u16);
        let mut mask = vec![0; buffer_bytes::<Gray4>(size.0, size.1)];
        let mut frame = Framebuffer::<Gray4>::new(&mut mask, size.0, size.1)?;
        outline.draw(|x, y, covered| {
            frame.set(Point::new(x as i32, y as i32), Gray4::new((covered.clamp(0.0, 1.0) * 15.0).round() as u8));
        });
        Ok(Self { mask, size, offset: Point::new(bounds.min.x as i32, bounds.min.y as i32), advance })
    }
}

/// The middle of the dial.
fn hub() -> PointFx {
    PointFx::px(64, 61)
}

/// The direction of a value: from lower left over the top to lower right.
fn direction(value: u32) -> Angle {
    // 150 degrees of a turn for all, from 195 degrees on.
    Angle::turns(1950 * 2 + value * 3, 7200)
}

/// A place so many eighths of a pixel from the middle.
fn at(direction: Angle, eighths: i32) -> PointFx {
    let (cos, sin) = direction.cos_sin();
    let away = |part: i32| ((i64::from(eighths * 32) * i64::from(part) + (1 << 29)) >> 30) as i32;
    hub() + PointFx::from_bits(away(cos), away(sin))
}

/// Draws the gauge at a value of up to [`MOST`], which is 100 degrees.
///
/// # Errors
/// If scratch memory is too small, which is a mistake of this function.
///
/// # Panics
/// If the font of the crate `dejavu` is none.
pub fn gauge(value: u16) -> Result<Picture, Error> {
    let font = FontRef::try_from_slice(dejavu::sans_condensed::bold()).expect("it is a font");
    let (small, large) = (Digits::new(&font, 11.0)?, Digits::new(&font, 12.0)?);
    let mut ram = [0; paged_bytes(SIZE.0, SIZE.1)];
    let mut frame = Paged::<BinaryColor>::new(&mut ram, SIZE.0, SIZE.1)?;
    dial(&mut frame, &small)?;
    let value = value.min(MOST);
    let text = (value / 10).to_string();
    large.write(&mut frame, Point::new(127 - large.width(&text), 63), &text)?;
    large.write(&mut frame, Point::new(0, 63), "°C")?;
    needle(&mut frame, direction(value.into()))?;
    Ok(Picture::of(&frame))
}

/// All that stands still.
fn dial(frame: &mut Paged<'_, BinaryColor>, digits: &Digits) -> Result<(), Error> {
    let (table, cells) = (&mut [CoverageSlot::EMPTY; 64], &mut [0; coverage::cells(SIZE.0)]);
    let on = Solid(BinaryColor::On);
    let arc = |from: u32, to: u32, eighths: i32| {
        let curves = Arc { is_clockwise: true, ..Arc::circle(I24F8::from_bits(eighths * 32)) };
        let [from, to] = [from, to].map(|value| at(direction(value), eighths));
        [PathSegment::MoveTo(from)].into_iter().chain(curves.between(from, to))
    };
    frame.stroke_path_aa(arc(0, 1000, 464), &Stroke::px(1), table, cells, on)?;
    // The last fifth is grey: through a mask that lets every other pixel through.
    let mut checks = [0; buffer_bytes::<BinaryColor>(SIZE.0, SIZE.1)];
    for (byte, i) in checks.iter_mut().zip(0..) {
        *byte = if (i / (SIZE.0 / 8)).is_multiple_of(2) { 0xaa } else { 0x55 };
    }
    let checks = Bitmap::<BinaryColor>::new(&checks, SIZE.0, SIZE.1)?;
    frame.stroke_path_aa(arc(805, 1000, 434), &Stroke::px(6), table, cells, Masked::new(checks, on))?;
    for value in (0..=1000).step_by(50) {
        let (inner, width) = if value % 200 == 0 { (400, px(2)) } else { (432, px(1)) };
        let ends = [at(direction(value), inner), at(direction(value), 468)];
        frame.stroke_line_aa(ends, &Stroke::new(width).with_cap(Cap::Butt), table, cells, on)?;
    }
    for value in (0..=1000).step_by(200) {
        let text = (value / 10).to_string();
        let middle = at(direction(value), 304).pixel();
        digits.write(frame, middle + Point::new(-digits.width(&text) / 2, 3), &text)?;
    }
    Ok(())
}

/// The needle, dark around its rim, and the hub.
fn needle(frame: &mut Paged<'_, BinaryColor>, direction: Angle) -> Result<(), Error> {
    let (table, cells) = (&mut [CoverageSlot::EMPTY; 16], &mut [0; coverage::cells(SIZE.0)]);
    let across = direction.plus(1 << 30);
    for (color, wider) in [(BinaryColor::Off, 12), (BinaryColor::On, 0)] {
        let [right, left] = [at(across, 20 + wider), at(across, -20 - wider)];
        let tip = at(direction, 424 + 2 * wider);
        let needle = [right, tip, left];
        frame.fill_polygon_aa(&needle, FillRule::NonZero, table, cells, Solid(color))?;
        let disc = Ellipse::circle(hub(), I24F8::from_bits((52 + wider) * 32));
        frame.fill_ellipse_aa(disc, Solid(color));
    }
    frame.fill_ellipse_aa(Ellipse::circle(hub(), px(2)), Solid(BinaryColor::Off));
    Ok(())
}
