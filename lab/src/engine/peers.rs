//! The peers: embedded-graphics on its own `Framebuffer`, tiny-skia without anti-aliasing on its own pixmap (32 bits).

use std::convert::Infallible;

use embedded_graphics::{
    framebuffer::{buffer_size, Framebuffer},
    geometry::Point,
    pixelcolor::{
        raw::{LittleEndian, RawU16},
        Rgb565,
    },
    prelude::*,
    primitives::{Line, PrimitiveStyle, Triangle},
};
use tiny_skia::{Color, FillRule, Paint, Path, Pixmap, Stroke, Transform};

use super::Engine;
use crate::frame::{Mask, HEIGHT, WIDTH};

const SIZE: usize = buffer_size::<Rgb565>(WIDTH as usize, HEIGHT as usize);
pub(super) type Graphics = Framebuffer<Rgb565, RawU16, LittleEndian, { WIDTH as usize }, { HEIGHT as usize }, SIZE>;

/// embedded-graphics.
pub(super) struct GraphicsEngine<F> {
    frame: Box<Graphics>,
    shape: F,
}

pub(super) fn graphics<S>(shape: impl FnMut(&mut Graphics, &S)) -> GraphicsEngine<impl FnMut(&mut Graphics, &S)> {
    GraphicsEngine { frame: Box::new(Graphics::new()), shape }
}

impl<S, F: FnMut(&mut Graphics, &S)> Engine<S> for GraphicsEngine<F> {
    fn draw(&mut self, shapes: &[S]) {
        for shape in shapes {
            (self.shape)(&mut self.frame, shape);
        }
    }

    fn clear(&mut self) {
        self.frame.data_mut().fill(0);
    }

    fn painted(&self) -> Mask {
        Mask::from_pixels(self.frame.data().chunks_exact(2).map(|bytes| bytes != [0, 0]))
    }
}

pub(super) fn line<D: DrawTarget<Error = Infallible>>(frame: &mut D, a: Point, b: Point, color: D::Color) {
    let Ok(()) = Line::new(a, b).into_styled(PrimitiveStyle::with_stroke(color, 1)).draw(frame);
}

pub(super) fn triangle<D: DrawTarget<Error = Infallible>>(frame: &mut D, [a, b, c]: [Point; 3], color: D::Color) {
    let Ok(()) = Triangle::new(a, b, c).into_styled(PrimitiveStyle::with_fill(color)).draw(frame);
}

/// tiny-skia. Its paths are made beforehand.
pub(super) struct SkiaEngine<F> {
    pixmap: Pixmap,
    shape: F,
}

pub(super) fn skia<S>(shape: impl FnMut(&mut Pixmap, &S)) -> SkiaEngine<impl FnMut(&mut Pixmap, &S)> {
    let pixmap = Pixmap::new(WIDTH as u32, HEIGHT as u32).expect("the size is not zero");
    SkiaEngine { pixmap, shape }
}

impl<S, F: FnMut(&mut Pixmap, &S)> Engine<S> for SkiaEngine<F> {
    fn draw(&mut self, shapes: &[S]) {
        for shape in shapes {
            (self.shape)(&mut self.pixmap, shape);
        }
    }

    fn clear(&mut self) {
        self.pixmap.fill(Color::TRANSPARENT);
    }

    fn painted(&self) -> Mask {
        Mask::from_pixels(self.pixmap.pixels().iter().map(|p| p.alpha() != 0))
    }
}

fn paint() -> Paint<'static> {
    let mut paint = Paint { anti_alias: false, ..Paint::default() };
    paint.set_color_rgba8(0xb5, 0xd9, 0x9c, 0xff);
    paint
}

/// A stroke of width 0 is one pixel wide.
pub(super) fn hairline(pixmap: &mut Pixmap, path: Option<&Path>) {
    let Some(path) = path else { return };
    pixmap.stroke_path(path, &paint(), &Stroke { width: 0.0, ..Stroke::default() }, Transform::identity(), None);
}

pub(super) fn stroke(pixmap: &mut Pixmap, path: Option<&Path>, stroke: &Stroke) {
    let Some(path) = path else { return };
    pixmap.stroke_path(path, &paint(), stroke, Transform::identity(), None);
}

pub(super) fn fill(pixmap: &mut Pixmap, path: Option<&Path>) {
    let Some(path) = path else { return };
    pixmap.fill_path(path, &paint(), FillRule::Winding, Transform::identity(), None);
}

pub(super) fn fill_even_odd(pixmap: &mut Pixmap, path: Option<&Path>) {
    let Some(path) = path else { return };
    pixmap.fill_path(path, &paint(), FillRule::EvenOdd, Transform::identity(), None);
}
