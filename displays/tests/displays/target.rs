//! Frames on any target of embedded-graphics.

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{OriginDimensions, Size},
    pixelcolor::{Gray8, GrayColor},
    Pixel,
};
use embedded_raster::{
    surface::{Pages, Rows},
    Framebuffer, Index1, Index4, Layout,
};
use embedded_raster_displays::to_target;
use twins::rng::Rng;

use crate::{pictures, wire::Broken};

fn check<L: Layout>(seed: u64, convert: impl Fn(L::Color) -> Gray8) {
    let mut rng = Rng::new(seed);
    for case in 0..200 {
        let (size, areas) = (pictures::sizes(&mut rng), pictures::areas(&mut rng));
        let memory = pictures::memory::<L>(&mut rng, size);
        let frame = pictures::frame::<L>(&memory, size);
        let mut pixels = vec![0xee; 60 * 60];
        let mut display = Framebuffer::<Gray8>::new(&mut pixels, 60, 60).expect("the right size");
        to_target(&frame, areas.iter().copied(), &convert, &mut display).expect("it works");
        for (y, x) in (0..60).flat_map(|y| (0..60).map(move |x| (y, x))) {
            let is_sent = areas.iter().any(|area| area.contains(x, y));
            let wanted = frame.get((x, y)).filter(|_| is_sent).map_or(Gray8::new(0xee), &convert);
            assert_eq!(display.get((x, y)), Some(wanted), "case {case}: ({x}, {y}) of {areas:?}");
        }
    }
}

#[test]
fn areas_are_their_pixels() {
    check::<Rows<Index4>>(1570, |index| Gray8::new(index.index() * 10));
    check::<Pages<Index1>>(1571, |index| Gray8::new(index.index() * 10));
}

/// Fails at the second area.
struct Failing(usize);

impl OriginDimensions for Failing {
    fn size(&self) -> Size {
        Size::new(9, 9)
    }
}

impl DrawTarget for Failing {
    type Color = Gray8;
    type Error = Broken;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray8>>>(&mut self, pixels: I) -> Result<(), Broken> {
        assert!(pixels.into_iter().all(|pixel| pixel.1.luma() == 7), "the colour");
        self.0 += 1;
        if self.0 == 2 {
            Err(Broken)
        } else {
            Ok(())
        }
    }
}

#[test]
fn errors_are_passed_on() {
    let frame = Framebuffer::<Index4>::new(&mut [0; 8], 4, 4).expect("the right size").as_bitmap().window();
    let pixels = [0; 8];
    let picture = embedded_raster::Bitmap::<Index4>::new(&pixels, 4, 4).expect("the right size");
    let mut display = Failing(0);
    assert_eq!(to_target(&picture, [frame; 3], |_| Gray8::new(7), &mut display), Err(Broken));
    assert_eq!(display.0, 2, "none after it");
}
