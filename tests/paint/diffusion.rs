//! Error diffusion against a plain model with all errors in one large table, and look-up cubes against searches.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "numbers of small pictures"
)]

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray8, GrayColor, Rgb888, RgbColor},
    prelude::DrawTarget,
    primitives::Rectangle,
};
use embedded_raster::{
    eg::recolored_at,
    pixel::{Atkinson, ColorCube, FloydSteinberg, EGA},
    Framebuffer, Palette, Readable, Rect, Span,
};
use twins::{
    pictures::{diffused, ATKINSON, FLOYD_STEINBERG},
    rng::{cases, Rng},
};

#[test]
fn errors_go_where_the_rule_says() {
    let mut rng = Rng::new(1);
    for _ in 0..cases(2_000) {
        let (width, height) = (rng.int(1, 20), rng.int(1, 12));
        let plain = rng.bits() as u8;
        let noise = rng.one_in(2);
        let levels: Vec<u8> = (0..width * height).map(|_| if noise { rng.bits() as u8 } else { plain }).collect();
        // Few levels, none of them near an end sometimes: errors grow as far as they can.
        let palette: Vec<u8> = (0..rng.int(1, 5)).map(|_| rng.bits() as u8).collect();
        let shown = |level: u8| *palette.iter().min_by_key(|&&entry| entry.abs_diff(level)).unwrap();
        let nearest = |[level]: [u8; 1]| (shown(level), [shown(level)]);

        let mut row = vec![[rng.bits() as i16]; width as usize];
        let mut diffusion = FloydSteinberg::new(&mut row);
        let picture: Vec<u8> = levels.iter().map(|&level| diffusion.next([level], nearest)).collect();
        assert_eq!(picture, diffused(&levels, width, FLOYD_STEINBERG, shown), "{width} wide, of {palette:?}");

        let mut row = vec![[[rng.bits() as i16]; 2]; width as usize];
        let mut diffusion = Atkinson::new(&mut row);
        let picture: Vec<u8> = levels.iter().map(|&level| diffusion.next([level], nearest)).collect();
        assert_eq!(picture, diffused(&levels, width, ATKINSON, shown), "{width} wide, of {palette:?}, by Atkinson");
    }
}

/// Three channels are three pictures, if each is shown by itself.
#[test]
fn channels_do_not_mix() {
    let mut rng = Rng::new(2);
    let shown = |level: u8| if level < 90 { 20 } else { 200 };
    let pixels: Vec<[u8; 3]> = (0..15 * 9).map(|_| [(); 3].map(|()| rng.bits() as u8)).collect();
    let mut row = [[0; 3]; 15];
    let mut diffusion = FloydSteinberg::new(&mut row);
    let picture: Vec<_> =
        pixels.iter().map(|&rgb| diffusion.next(rgb, |rgb| (rgb.map(shown), rgb.map(shown)))).collect();
    for channel in 0..3 {
        let levels: Vec<u8> = pixels.iter().map(|rgb| rgb[channel]).collect();
        let got: Vec<u8> = picture.iter().map(|rgb| rgb[channel]).collect();
        assert_eq!(got, diffused(&levels, 15, FLOYD_STEINBERG, shown));
    }
}

/// A grey of black and white has its brightness: what is off is at most what leaves at the edges.
#[test]
fn a_plain_grey_keeps_its_brightness() {
    for level in 0..=255_u8 {
        let mut row = [[0]; 64];
        let mut diffusion = FloydSteinberg::new(&mut row);
        let mut sum = 0_u32;
        for _ in 0..64 * 64 {
            let shown = |[level]: [u8; 1]| if level >= 128 { 255 } else { 0 };
            sum += u32::from(diffusion.next([level], |level| (shown(level), [shown(level)])));
        }
        let mean = f64::from(sum) / (64.0 * 64.0);
        assert!((mean - f64::from(level)).abs() < 2.0, "{level} is shown as {mean}");
    }
}

#[test]
fn a_picture_is_dithered_in_place_and_through_a_draw_target() {
    let mut rng = Rng::new(3);
    let levels: Vec<u8> = (0..20 * 10).map(|_| rng.bits() as u8).collect();
    let shown = |level: u8| if level >= 128 { 255 } else { 0 };
    let wanted = diffused(&levels, 20, FLOYD_STEINBERG, shown);

    let mut ram = levels.clone();
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 20, 10).unwrap();
    let (mut row, window) = ([[0]; 20], Rect::new(0, 0, 20, 10));
    let mut diffusion = FloydSteinberg::new(&mut row);
    for y in 0..10 {
        let span = Span { y, x0: 0, x1: 20 }.clip(window).unwrap();
        frame.edit_span(span, |_, old| {
            Gray8::new(diffusion.next([old.luma()], |[level]| (shown(level), [shown(level)])))
        });
    }
    assert_eq!(ram, wanted, "in place");

    // A band of it sees the same pixels: those above are asked for, too.
    let mut ram = [0; 3 * 4];
    let mut band = Framebuffer::<BinaryColor>::band(&mut ram, 20, 10, 4..8).unwrap();
    let mut row = [[0]; 20];
    let mut diffusion = FloydSteinberg::new(&mut row);
    let area = Rectangle::new(Point::zero(), Size::new(20, 10));
    recolored_at(&mut band, |_, grey: Gray8| {
        diffusion.next([grey.luma()], |[level]| (BinaryColor::from(level >= 128), [shown(level)]))
    })
    .fill_contiguous(&area, levels.iter().map(|&level| Gray8::new(level)))
    .unwrap();
    for (x, y) in (4..8).flat_map(|y| (0..20).map(move |x| (x, y))) {
        let is_on = wanted[(y * 20 + x) as usize] == 255;
        assert_eq!(band.get(Point::new(x, y)), Some(BinaryColor::from(is_on)), "{x}, {y}");
    }
}

/// A place for each colour, the right one, for pixels, rows and areas.
#[test]
fn colors_are_told_their_places() {
    let mut ram = [0; 8 * 6];
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 8, 6).unwrap();
    let mut target = recolored_at(&mut frame, |at: Point, grey: Gray8| {
        Gray8::new(grey.luma().wrapping_add((at.y * 8 + at.x) as u8))
    });
    target.fill_contiguous(&Rectangle::new(Point::new(-2, -1), Size::new(6, 4)), [Gray8::new(100); 24]).unwrap();
    target.fill_solid(&Rectangle::new(Point::new(5, 4), Size::new(99, 99)), Gray8::new(50)).unwrap();
    for (x, y) in (0..6).flat_map(|y| (0..8).map(move |x| (x, y))) {
        let ground = if x < 4 && y < 3 {
            100
        } else if x >= 5 && y >= 4 {
            50
        } else {
            continue;
        };
        assert_eq!(frame.get(Point::new(x, y)).unwrap().luma(), ground + (y * 8 + x) as u8, "{x}, {y}");
    }
}

#[test]
fn a_cube_finds_what_a_search_for_the_middle_of_a_cell_finds() {
    fn check<const LEN: usize>(palette: &Palette<Rgb888, 16>, rng: &mut Rng) {
        let bits = LEN.trailing_zeros() / 3;
        let cube = ColorCube::<LEN>::new(palette);
        for _ in 0..2_000 {
            let color = Rgb888::new(rng.bits() as u8, rng.bits() as u8, rng.bits() as u8);
            let middle = |level: u8| level >> (8 - bits) << (8 - bits) | 1 << (7 - bits);
            let wanted = palette.nearest(Rgb888::new(middle(color.r()), middle(color.g()), middle(color.b())));
            assert_eq!(cube.nearest(color), wanted, "{color:?} of {LEN} cells");
        }
    }
    let mut rng = Rng::new(4);
    check::<64>(&EGA, &mut rng);
    check::<512>(&EGA, &mut rng);
    check::<4_096>(&EGA, &mut rng);
    check::<32_768>(&EGA, &mut rng);
}
