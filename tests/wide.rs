//! Rows that are wide enough for the ways of computers, which `memset` and `memcpy` are part of: rectangles and blits beside single
//! pixels.

#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "random numbers, cut on purpose")]

use embedded_graphics::{
    geometry::Point,
    pixelcolor::{Gray8, Rgb565, Rgb888},
};
use embedded_raster::{
    buffer_bytes,
    pixel::{Lsb0, Xrgb8888},
    Bitmap, Canvas, Framebuffer, Index1, Index4, PixelFormat, Readable, Rect, Surface,
};
use twins::rng::{cases, Rng};

const WIDTH: u16 = 301;
const HEIGHT: u16 = 6;

/// Black, or any colour: only the first has equal bytes in every format.
fn color<F: PixelFormat>(rng: &mut Rng) -> F::Color {
    F::unpack(if rng.one_in(2) { 0 } else { rng.bits() as u32 & u32::MAX >> (32 - F::BITS) })
}

fn colors<F: PixelFormat>(frame: &Framebuffer<F>) -> Vec<u32> {
    let columns = |y| (0..i32::from(WIDTH)).map(move |x| (x, y));
    (0..i32::from(HEIGHT)).flat_map(columns).map(|(x, y)| F::pack(frame.color_at(x, y))).collect()
}

fn check<F: PixelFormat>() {
    let mut rng = Rng::new(u64::from(F::BITS));
    let bytes = |rng: &mut Rng, n: usize| (0..n).map(|_| rng.bits() as u8).collect::<Vec<_>>();
    for case in 0..cases(300) {
        let before = bytes(&mut rng, buffer_bytes::<F>(WIDTH, HEIGHT));
        let (mut memory, mut twin) = (before.clone(), before);
        let mut frame = Framebuffer::<F>::new(&mut memory, WIDTH, HEIGHT).expect("made for this size");
        let mut twin = Framebuffer::<F>::new(&mut twin, WIDTH, HEIGHT).expect("made for this size");
        let (x0, y0) = (rng.int(-9, 100), rng.int(-1, 3));
        // All of it now and then: one run without gaps.
        let whole = rng.one_in(4);
        let area = if whole {
            Rect::new(0, 0, WIDTH.into(), HEIGHT.into())
        } else {
            Rect::new(x0, y0, x0 + rng.int(1, 302), y0 + rng.int(1, 6))
        };
        let places = || (area.y0..area.y1).flat_map(|y| (area.x0..area.x1).map(move |x| Point::new(x, y)));
        if rng.one_in(2) {
            let color = color::<F>(&mut rng);
            frame.fill_area(area, color);
            places().for_each(|p| twin.set(p, color));
        } else {
            // As wide as the area, or wider.
            let left = if whole { 0 } else { rng.int(0, 9) };
            let size = ((area.x1 - area.x0 + left) as u16, (area.y1 - area.y0) as u16);
            let picture = bytes(&mut rng, buffer_bytes::<F>(size.0, size.1));
            let picture = Bitmap::<F>::new(&picture, size.0, size.1).expect("made for this size");
            let part = picture.view(Rect::new(left, 0, size.0.into(), size.1.into()));
            frame.blit(area.top_left(), &part);
            places().for_each(|p| twin.set(p, part.get(p - area.top_left()).expect("as large as the area")));
        }
        assert_eq!(colors(&frame), colors(&twin), "{} bits, case {case}, {area:?}", F::BITS);
    }
}

#[test]
fn wide_rows_are_those_of_single_pixels() {
    check::<Index1>();
    check::<Lsb0<Index1>>();
    check::<Index4>();
    check::<Lsb0<Index4>>();
    check::<Gray8>();
    check::<Rgb565>();
    check::<Rgb888>();
    check::<Xrgb8888>();
}
