//! What calls that draw with soft rims need besides the arguments of all calls: scratch memory, and surfaces with colours that can be
//! mixed.

use embedded_graphics_core::pixelcolor::{Gray8, Rgb565, Rgb888};
use embedded_raster::{
    paint::{Alpha, Cover, CoverIndex, Over, Ramp},
    Antialias, CoverageSlot, Framebuffer, Index4, Layout, Palette,
};

use crate::Arguments;

/// Calls `draw` with scratch memory: slots for two dozen sides, and cells that are enough for 32 columns and not for 60.
pub fn with_scratch<R>(draw: impl FnOnce(&mut [CoverageSlot], &mut [i32]) -> R) -> R {
    draw(&mut [CoverageSlot::EMPTY; 24], &mut [0; 40])
}

/// Fills a triangle with soft rims in every paint that mixes colours.
pub fn mixed<L: Layout>(a: &mut Arguments<'_, L>) -> bool {
    let (corners, alpha) = (a.corners_fx(), a.byte(0));
    let palette = Palette::new([Rgb888::new(0, 0, 0), Rgb888::new(90, 80, 70), Rgb888::new(255, 255, 255)]);
    let (color, under) = (Rgb565::new(alpha, 40, 3), Rgb565::new(9, 9, alpha));
    if let Ok(mut frame) = Framebuffer::<Rgb565>::new(a.out, 4, 4) {
        frame.fill_triangle_aa(corners, &mut [], Cover(color));
        frame.fill_triangle_aa(corners, &mut [], Alpha { color, alpha });
        frame.fill_triangle_aa(corners, &mut [], Over { color, background: under });
    }
    if let Ok(mut frame) = Framebuffer::<Gray8>::new(a.out, 4, 4) {
        frame.fill_triangle_aa(corners, &mut [], Cover(Gray8::new(alpha)));
    }
    if let Ok(mut frame) = Framebuffer::<Index4>::new(a.out, 4, 4) {
        frame.fill_triangle_aa(corners, &mut [], CoverIndex::new(&palette, Index4::new(alpha), Index4::new));
        frame.fill_triangle_aa(corners, &mut [], Ramp::<_, 5>::of_palette(&palette, [alpha, 2], Index4::new));
    }
    a.out.first() == Some(&alpha)
}
