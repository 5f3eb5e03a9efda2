//! What a matrix shows of its planes.

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster::{
    pixel::EGA,
    surface::{Packed12, Rows},
    Frame, Index4, Layout, Rect,
};
use embedded_raster_displays::{hub75, Error};
use twins::rng::Rng;

use crate::pictures;

/// The light of each pixel: planes are lit for 1, 2, 4 ... units of time.
fn check<L: Layout>(seed: u64, light: impl Fn(L::Color) -> Rgb888) {
    let mut rng = Rng::new(seed);
    for case in 0..100 {
        let size = (rng.int(1, 40) as u16, 2 * rng.int(1, 10) as u16);
        let memory = pictures::memory::<L>(&mut rng, size);
        let frame = pictures::frame::<L>(&memory, size);
        let planes = 1 + rng.index(8);
        let width = usize::from(size.0);
        for y in 0..size.1 / 2 {
            let mut memory = vec![0xa5; planes * width + rng.index(5)];
            let bytes = hub75::row_pair(&frame, y, &light, planes, &mut memory).expect("it fits");
            assert_eq!(bytes.len(), planes * width, "all planes");
            for x in 0..width {
                let lit = |pin: u32| {
                    let times = (0..planes).map(|plane| u32::from(bytes[plane * width + x] >> pin & 1) << plane);
                    times.sum::<u32>() << (8 - planes)
                };
                for (half, row) in [y, y + size.1 / 2].into_iter().enumerate() {
                    let color = light(frame.get((x as i32, row.into())).expect("inside"));
                    let wanted =
                        [color.r(), color.g(), color.b()].map(|level| u32::from(level) >> (8 - planes) << (8 - planes));
                    let pins = [0, 1, 2].map(|pin| lit(pin + 3 * half as u32));
                    assert_eq!(pins, wanted, "case {case}: ({x}, {row}) of {size:?}, {planes} planes");
                }
            }
        }
    }
}

#[test]
fn planes_are_the_levels_of_pixels() {
    check::<Rows<Index4>>(1550, |index| EGA.get(index.index()).expect("sixteen"));
    check::<Packed12>(1551, Rgb888::from);
    check::<Rows<Rgb888>>(1552, |color| color);
}

#[test]
fn what_a_frame_lacks_is_dark() {
    let pixels = [0xff; 4];
    let frame = Frame::<_, Rows<Index4>>::new(&pixels[..], 4, 2).expect("the right size");
    let white = |_| Rgb888::WHITE;
    let mut memory = [0; 32];
    let clipped = frame.clipped(Rect::new(1, 0, 3, 1));
    assert_eq!(hub75::row_pair(&clipped, 0, white, 1, &mut memory), Ok(&[0, 0b111, 0b111, 0][..]));
    assert_eq!(hub75::row_pair(&frame, 0, white, 1, &mut memory), Ok(&[0b11_1111; 4][..]));
    assert_eq!(hub75::row_pair(&frame, u16::MAX, white, 1, &mut memory), Ok(&[0; 4][..]));
    let error = hub75::row_pair(&frame, 0, white, 8, &mut memory[..31]).err();
    assert_eq!(error, Some(Error::LineTooShort { needed: 32, given: 31 }));
}
