//! The list of what mixes colours by an alpha, by sums and as light, on frames whose colours can be mixed.

use embedded_graphics_core::pixelcolor::{Gray4, Gray8, Rgb565, Rgb888};
use embedded_raster::{
    paint::{Add, Cover, CoverGamma, Gamma, Masked},
    pixel::Argb8888,
    surface::{Accumulator, Sum},
    Antialias, Bitmap, Canvas, ClippedSpan, Framebuffer, Layout, Palette, Pictures,
};

use crate::{answer::sum, calls, Arguments};

static SRGB: Gamma = Gamma::SRGB;

calls! {
    /// Makes the call of a number below that of [`NAMES`], on any frame of 16 bits.
    NAMES, call[L: Layout](on: &mut Framebuffer<'_, Rgb565>, a)
    {
        let [p, q, r, s] = [0, 1, 2, 3].map(|i| a.byte(i));
        let (color, under, corners) = (Rgb565::new(p, q, r), Rgb565::new(q, r, s), a.corners_fx());
        let argb = Argb8888::new(p, q, r, s);
        let window = on.window();
    }
    [Argb8888]
    new => Argb8888::new(p, q, r, s) == Argb8888::default();
    argb => argb.argb();
    premultiplied => argb.premultiplied().argb();
    over => {
        let drawn = Bitmap::<Argb8888>::new(a.bytes, 5, 4).map(|picture| {
            on.blit_with(a.points[0], &picture.view(a.areas[1]), Argb8888::over);
            on.blit_with(a.points[0], &picture.clipped(a.areas[1]), Argb8888::over_premultiplied);
        });
        (drawn, argb.over(under) == color)
    };
    over_premultiplied => (argb.over_premultiplied(under) == color, argb.over_premultiplied(Gray8::new(p)) == Gray8::new(q));
    [Gamma]
    new => Gamma::new([u16::from(p); 256]).between([color, under], q) == color;
    light => SRGB.light()[usize::from(p)];
    between => {
        on.fill_triangle_aa(corners, &mut [], CoverGamma { color, gamma: &SRGB });
        SRGB.between([color, under], r) == color
    };
    fade => SRGB.fade([&Palette::new([color, under]), &Palette::new([under; 2])], q).get(r) == Some(color);
    [Accumulator]
    new => accumulated(a, |_, _| ());
    clear => accumulated(a, |sums, _| sums.clear());
    at => accumulated(a, |sums, a| sums.at(a.points[0].x, a.points[0].y) == Sum::EMPTY);
    show => accumulated(a, |sums, _| sums.show(on, Sum::over));
    [Sum]
    covered => accumulated(a, |sums, _| sum((window.y0..window.y1.min(9)).map(|y| sums.at(2, y).covered())));
    over => accumulated(a, |sums, a| sums.at(a.points[0].x, a.points[0].y).over(under) == color);
    [Frame]
    tell_levels => Bitmap::<Gray4>::new(a.bytes, 9, 7).map(|mask| {
        let mut pixels = 0_u64;
        on.fill_triangle_aa(corners, &mut [], Masked::new(mask.view(a.areas[1]), Cover(color)));
        mask.view(a.areas[1]).tell_levels(a.points[0], a.window, |span: ClippedSpan| {
            pixels = pixels.wrapping_add(span.len().into());
        });
        pixels
    });
}

/// Does something with sums of a triangle, a polygon and a rectangle, in the window of the arguments if that is small.
fn accumulated<L: Layout, R>(
    a: &mut Arguments<'_, L>,
    act: impl FnOnce(&mut Accumulator<'_>, &Arguments<'_, L>) -> R,
) -> Option<R> {
    let (mut memory, [p, q, r]) = ([Sum::EMPTY; 160], [0, 1, 2].map(|i| a.byte(i)));
    let mut sums = Accumulator::new(&mut memory, a.window).ok()?;
    let color = Rgb888::new(p, q, r);
    sums.fill_triangle_aa(a.corners_fx(), &mut [], Add(color));
    sums.fill_rectangle(a.areas[0], color);
    sums.fill_rectangle_aa(a.places[0], a.places[1], Add(color));
    Some(act(&mut sums, a))
}
