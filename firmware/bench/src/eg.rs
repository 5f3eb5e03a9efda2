//! embedded-graphics 0.8 with its own `Framebuffer`, used as its documentation shows.

use core::convert::Infallible;

use embedded_graphics::framebuffer::{buffer_size, Framebuffer};
use embedded_graphics::iterator::raw::RawDataSlice;
use embedded_graphics::pixelcolor::raw::{LittleEndian, RawU16};
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565};
use embedded_graphics::prelude::*;
use embedded_graphics::primitives::{
    Circle, Line, PrimitiveStyle, Rectangle, RoundedRectangle, Triangle as EgTriangle,
};

use crate::engine::Engine;
use crate::scene::{corner, text, Format, Ink, Rect, Segment, Sprite, Triangle, HEIGHT, THICK, WIDTH};

/// A frame of embedded-graphics.
type Frame<C, const N: usize> = Framebuffer<C, <C as PixelColor>::Raw, LittleEndian, WIDTH, HEIGHT, N>;

/// A frame of 16-bit colours.
pub type Rgb565Frame = Frame<Rgb565, { buffer_size::<Rgb565>(WIDTH, HEIGHT) }>;
/// A frame of 8-bit grays.
pub type Gray8Frame = Frame<Gray8, { buffer_size::<Gray8>(WIDTH, HEIGHT) }>;
/// A frame of 4-bit grays.
pub type Gray4Frame = Frame<Gray4, { buffer_size::<Gray4>(WIDTH, HEIGHT) }>;
/// A frame of single bits.
pub type BinaryFrame = Frame<BinaryColor, { buffer_size::<BinaryColor>(WIDTH, HEIGHT) }>;

/// At 16 bits.
pub const RGB565: Engine<Rgb565Frame> = engine(Format::Rgb565, |frame| frame.data_mut().fill(0), |frame| frame.data());
/// At 8 bits.
pub const GRAY8: Engine<Gray8Frame> = engine(Format::Gray8, |frame| frame.data_mut().fill(0), |frame| frame.data());
/// At 4 bits.
pub const GRAY4: Engine<Gray4Frame> = engine(Format::Gray4, |frame| frame.data_mut().fill(0), |frame| frame.data());
/// At 1 bit.
pub const BINARY: Engine<BinaryFrame> = engine(Format::Binary, |frame| frame.data_mut().fill(0), |frame| frame.data());

/// embedded-graphics fills no polygons, draws no curves, rounds no corners of lines, and knows neither colour keys nor
/// colour tables.
const fn engine<F>(format: Format, blacken: fn(&mut F), bytes: fn(&F) -> &[u8]) -> Engine<F>
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked + From<<F::Color as PixelColor>::Raw>,
    for<'a> RawDataSlice<'a, <F::Color as PixelColor>::Raw, LittleEndian>:
        IntoIterator<Item = <F::Color as PixelColor>::Raw>,
{
    let mut engine = Engine::new("embedded-graphics", format, blacken, bytes);
    engine.clear = Some(clear);
    engine.rects = Some(rects);
    engine.rows = Some(rects);
    engine.columns = Some(rects);
    engine.lines = Some(lines);
    engine.triangles = Some(triangles);
    engine.discs = Some(discs);
    engine.circles = Some(circles);
    engine.rounded = Some(rounded);
    engine.thick = Some(thick);
    engine.blit = Some(blit);
    engine.text = Some(|frame, labels| {
        let Ok(()) = text(frame, labels, F::Color::inked);
    });
    engine
}

/// A colour whose value is the low bits of an ink.
trait Inked: PixelColor {
    fn inked(ink: Ink) -> Self;
}

impl Inked for Rgb565 {
    fn inked(ink: Ink) -> Self {
        RawU16::new(ink.0).into()
    }
}

impl Inked for Gray8 {
    fn inked(ink: Ink) -> Self {
        Self::new(ink.0 as u8)
    }
}

impl Inked for Gray4 {
    fn inked(ink: Ink) -> Self {
        Self::new(ink.0 as u8 & 15)
    }
}

impl Inked for BinaryColor {
    fn inked(ink: Ink) -> Self {
        Self::from(ink.0 & 1 != 0)
    }
}

fn clear<F>(frame: &mut F, ink: Ink)
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    let Ok(()) = frame.clear(F::Color::inked(ink));
}

fn rects<F>(frame: &mut F, rects: &[Rect])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for rect in rects {
        let style = PrimitiveStyle::with_fill(F::Color::inked(rect.ink));
        let Ok(()) = rect.area.into_styled(style).draw(frame);
    }
}

fn lines<F>(frame: &mut F, lines: &[Segment])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for line in lines {
        let [from, to] = line.ends;
        let style = PrimitiveStyle::with_stroke(F::Color::inked(line.ink), 1);
        let Ok(()) = Line::new(from, to).into_styled(style).draw(frame);
    }
}

fn thick<F>(frame: &mut F, lines: &[Segment])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for line in lines {
        let [from, to] = line.ends;
        let style = PrimitiveStyle::with_stroke(F::Color::inked(line.ink), THICK);
        let Ok(()) = Line::new(from, to).into_styled(style).draw(frame);
    }
}

fn triangles<F>(frame: &mut F, triangles: &[Triangle])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for triangle in triangles {
        let [a, b, c] = triangle.px;
        let style = PrimitiveStyle::with_fill(F::Color::inked(triangle.ink));
        let Ok(()) = EgTriangle::new(a, b, c).into_styled(style).draw(frame);
    }
}

fn discs<F>(frame: &mut F, discs: &[Rect])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for disc in discs {
        let style = PrimitiveStyle::with_fill(F::Color::inked(disc.ink));
        let Ok(()) = Circle::new(disc.area.top_left, disc.area.size.width).into_styled(style).draw(frame);
    }
}

fn circles<F>(frame: &mut F, circles: &[Rect])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for circle in circles {
        let style = PrimitiveStyle::with_stroke(F::Color::inked(circle.ink), 1);
        let style = embedded_graphics::primitives::PrimitiveStyleBuilder::from(&style)
            .stroke_alignment(embedded_graphics::primitives::StrokeAlignment::Inside)
            .build();
        let Ok(()) = Circle::new(circle.area.top_left, circle.area.size.width).into_styled(style).draw(frame);
    }
}

fn rounded<F>(frame: &mut F, rects: &[Rect])
where
    F: DrawTarget<Error = Infallible>,
    F::Color: Inked,
{
    for rect in rects {
        let style = PrimitiveStyle::with_fill(F::Color::inked(rect.ink));
        let shape = RoundedRectangle::with_equal_corners(rect.area, Size::new_equal(corner()));
        let Ok(()) = shape.into_styled(style).draw(frame);
    }
}

/// `Image` would do the same by way of its clipping, and take half as long again.
fn blit<F>(frame: &mut F, sprite: &Sprite<'_>)
where
    F: DrawTarget<Error = Infallible>,
    F::Color: From<<F::Color as PixelColor>::Raw>,
    for<'a> RawDataSlice<'a, <F::Color as PixelColor>::Raw, LittleEndian>:
        IntoIterator<Item = <F::Color as PixelColor>::Raw>,
{
    let used = Sprite::SIDE * Sprite::SIDE * <F::Color as PixelColor>::Raw::BITS_PER_PIXEL / 8;
    let size = Size::new_equal(Sprite::SIDE as u32);
    for &at in sprite.at {
        let raw = RawDataSlice::<_, LittleEndian>::new(&sprite.bytes[..used]);
        let colours = raw.into_iter().map(F::Color::from);
        let Ok(()) = frame.fill_contiguous(&Rectangle::new(at, size), colours);
    }
}
