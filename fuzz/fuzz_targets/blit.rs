//! Blits and moves, with and without a key, against single bits.
#![no_main]

mod input;

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb555, Rgb565, Rgb888},
};
use embedded_raster::{pixel::Lsb0, surface::Rows, Index1, Index2, Index4, Index8, PixelFormat, Rect};
use input::Input;
use libfuzzer_sys::fuzz_target;
use twins::{
    frame::{Kind, Of},
    memory::{Format, Naive},
    rng::Rng,
};

fuzz_target!(|data: &[u8]| {
    let mut input = Input(data);
    match input.byte() & 7 {
        0 => copy::<Index1>(&mut input),
        1 => copy::<Lsb0<Index1>>(&mut input),
        2 => copy::<Index2>(&mut input),
        3 => copy::<Lsb0<Index4>>(&mut input),
        4 => copy::<Index8>(&mut input),
        5 => copy::<Rgb555>(&mut input),
        6 => copy::<Rgb565>(&mut input),
        _ => copy::<Rgb888>(&mut input),
    }
});

/// A rectangle near the memory, or anywhere.
fn area(input: &mut Input<'_>) -> Rect {
    if input.byte() & 3 == 0 {
        Rect::new(input.int(), input.int(), input.int(), input.int())
    } else {
        let mut side = || i32::from(input.byte() as i8) / 2;
        let (x, y) = (side(), side() / 4);
        Rect::new(x, y, x.saturating_add(side()), y.saturating_add(side() / 4))
    }
}

fn copy<F: PixelFormat>(input: &mut Input<'_>) {
    let mut rng = Rng::new(input.byte().into());
    let mut picture = |input: &mut Input<'_>| {
        let size = ((input.byte() % 80).into(), (input.byte() % 8).into());
        let (start, gap) = (usize::from(input.byte() & 7), usize::from(input.byte() & 3));
        Naive::random(&mut rng, Format::of::<F>(), size, start, gap)
    };
    let (mut twin, source) = (picture(input), picture(input));
    let mut real = twin.bytes.clone();
    let (clip, part) = (area(input), area(input));
    let at = if input.byte() & 3 == 0 { Point::new(input.int(), input.int()) } else { Point::new(part.x0, part.y0) };
    let (dx, dy) = (input.byte() as i8, input.byte() as i8 / 16);
    let at = Point::new(at.x.saturating_add(dx.into()), at.y.saturating_add(dy.into()));
    let choice = input.byte();
    let key = source.get((input.byte() % 80).into(), (input.byte() % 8).into()).filter(|_| choice & 1 == 0);
    {
        let mut frame = Of::<Rows<F>, F>::rows().open(&twin, &mut real);
        let mut target = frame.clipped(clip);
        if choice & 2 == 0 {
            target.blit(at, &source, part, key);
        } else {
            target.move_area(part, at, key);
        }
    }
    if choice & 2 == 0 {
        twin.blit(clip, at, &source, part, key);
    } else {
        twin.move_area(clip, part, at, key);
    }
    twin.assert_same(&real, &|| format!("{part:?} at {at} in {clip:?}"));
}
