//! Masks of one bit in one or two colours, against single bits.
#![no_main]

mod input;

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb555, Rgb565, Rgb888},
};
use embedded_raster::{
    pixel::{Be, Lsb0, Xrgb8888},
    surface::Rows,
    Index1, Index2, Index4, Index8, PixelFormat,
};
use input::Input;
use libfuzzer_sys::fuzz_target;
use twins::{
    frame::{Kind, Of},
    memory::{Format, Naive},
    rng::Rng,
};

fuzz_target!(|data: &[u8]| {
    let mut input = Input(data);
    match input.byte() % 10 {
        0 => draw::<Index1>(&mut input),
        1 => draw::<Lsb0<Index1>>(&mut input),
        2 => draw::<Index2>(&mut input),
        3 => draw::<Lsb0<Index4>>(&mut input),
        4 => draw::<Index4>(&mut input),
        5 => draw::<Index8>(&mut input),
        6 => draw::<Rgb555>(&mut input),
        7 => draw::<Be<Rgb565>>(&mut input),
        8 => draw::<Xrgb8888>(&mut input),
        _ => draw::<Rgb888>(&mut input),
    }
});

fn draw<F: PixelFormat>(input: &mut Input<'_>) {
    let mut rng = Rng::new(input.byte().into());
    let choice = input.byte();
    let mut picture = |input: &mut Input<'_>, format: Format| {
        let size = ((input.byte() % 80).into(), (input.byte() % 8).into());
        let (start, gap) = (usize::from(input.byte() & 7), usize::from(input.byte() & 3));
        Naive::random(&mut rng, format, size, start, gap)
    };
    let mut twin = picture(input, Format::of::<F>());
    let bits = if choice & 1 == 0 { Format::of::<Index1>() } else { Format::of::<Lsb0<Index1>>() };
    let mask = picture(input, bits);
    let mut real = twin.bytes.clone();
    let (clip, part) = (input.area_near(twin.window()), input.area_near(mask.window()));
    let at = Point::new(input.near(0, 1), input.near(0, 1));
    let format = Format::of::<F>();
    let colors = (format.random(&mut rng), (choice & 2 == 0).then(|| format.random(&mut rng)));
    Of::<Rows<F>, F>::rows().open(&twin, &mut real).clipped(clip).blit_mask(at, &mask, part, colors.0, colors.1);
    twin.blit_mask(clip, at, &mask, part, colors);
    twin.assert_same(&real, &|| format!("{part:?} of a mask at {at} in {clip:?}"));
}
