//! This crate, on pixels of 32 and of 16 bits, and of 32 bits out of 8 through a palette.

use std::array::from_fn;

use embedded_graphics::{
    pixelcolor::{raw::RawU16, Rgb565},
    prelude::*,
};
use embedded_raster::{
    buffer_bytes, pixel::Xrgb8888, Bitmap, Framebuffer, Index8, Palette, Pictures, PixelFormat, Surface,
};

use super::{Job, Texel, Way, SIDE};
use crate::frame::{HEIGHT, WIDTH};

/// A screen, a picture in the colours of it or in others, and how a colour says which texel it is.
struct Own<F: PixelFormat, G: PixelFormat, M> {
    name: &'static str,
    memory: Vec<u8>,
    picture: Bitmap<'static, G>,
    color: M,
    /// `None` where colours do not say it.
    texel: Option<fn(F::Color) -> Texel>,
}

impl<F, G, M> Way for Own<F, G, M>
where
    F: PixelFormat,
    G: PixelFormat,
    M: Fn(G::Color) -> Option<F::Color>,
{
    fn name(&self) -> &'static str {
        self.name
    }

    fn can(&self, _: &Job) -> bool {
        true
    }

    fn clear(&mut self) {
        self.memory.fill(0);
    }

    fn draw(&mut self, job: &Job) {
        let mut frame = screen::<F>(&mut self.memory);
        match job {
            Job::Stretched(to) => frame.blit_stretched(*to, &self.picture, &self.color),
            Job::Mapped(map) => frame.blit_affine(map, &self.picture, &self.color).expect("no factor is that large"),
        }
    }

    fn texels(&self) -> Option<Vec<Texel>> {
        let texel = self.texel?;
        let frame = Bitmap::<F>::new(&self.memory, WIDTH as u16, HEIGHT as u16).expect("made for this size");
        Some(frame.colors(frame.window()).map(texel).collect())
    }
}

fn screen<F: PixelFormat>(memory: &mut [u8]) -> Framebuffer<'_, F> {
    Framebuffer::new(memory, WIDTH as u16, HEIGHT as u16).expect("made for this size")
}

/// A picture of which each texel has a colour of its own. Its bytes are never given back.
fn picture<F: PixelFormat>(color: impl Fn(u16, u16) -> F::Color) -> Bitmap<'static, F> {
    let mut memory = vec![0; buffer_bytes::<F>(SIDE, SIDE)];
    let mut frame = Framebuffer::<F>::new(&mut memory, SIDE, SIDE).expect("made for this size");
    for (x, y) in (0..SIDE).flat_map(|y| (0..SIDE).map(move |x| (x, y))) {
        frame.set(Point::new(x.into(), y.into()), color(x, y));
    }
    Bitmap::new(memory.leak(), SIDE, SIDE).expect("made for this size")
}

fn way<F: PixelFormat, G: PixelFormat>(
    name: &'static str,
    picture: Bitmap<'static, G>,
    color: impl Fn(G::Color) -> Option<F::Color> + 'static,
    texel: Option<fn(F::Color) -> Texel>,
) -> Box<dyn Way> {
    let memory = vec![0; buffer_bytes::<F>(WIDTH as u16, HEIGHT as u16)];
    Box::new(Own::<F, G, _> { name, memory, picture, color, texel })
}

pub(super) fn ways() -> Vec<Box<dyn Way>> {
    let narrow = |n: u16| n as u8;
    let wide = picture::<Xrgb8888>(|x, y| Xrgb8888::new(narrow(x), narrow(y), 255));
    let texel_of_wide = |color: Xrgb8888| (color.b() != 0).then(|| (color.r().into(), color.g().into()));
    let middle = picture::<Rgb565>(|x, y| RawU16::new(1 + y * SIDE + x).into());
    let texel_of_middle = |color: Rgb565| {
        let number = i32::from(RawU16::from(color).into_inner()) - 1;
        (number >= 0).then(|| (number % i32::from(SIDE), number / i32::from(SIDE)))
    };
    // Of 256 colours, so several texels look the same.
    let palette: Palette<Xrgb8888, 256> = Palette::new(from_fn(|i| Xrgb8888::new(narrow(i as u16), 0, 255)));
    let indices = picture::<Index8>(|x, y| Index8::new(narrow(x ^ y << 2)));
    let through = move |index: Index8| palette.get(index.into());
    vec![
        way::<Xrgb8888, Xrgb8888>("embedded-raster, 32 bits", wide, Some, Some(texel_of_wide)),
        way::<Rgb565, Rgb565>("embedded-raster, 16 bits", middle, Some, Some(texel_of_middle)),
        way::<Xrgb8888, Index8>("embedded-raster, 8 bits through a palette onto 32", indices, through, None),
    ]
}
