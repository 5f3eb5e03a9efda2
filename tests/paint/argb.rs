//! *Source over*, exhaustively: every alpha, every channel and every level under it, against the exact ratio; and pictures of it on
//! frames of many formats.

use embedded_graphics_core::pixelcolor::{Gray2, Gray4, Gray8, GrayColor, Rgb565, Rgb666, Rgb888, RgbColor};
use embedded_raster::{
    pixel::{Argb8888, Be, Channels, Rgb332, Rgb444, Xrgb8888},
    surface::{Packed12, Rows},
    Bitmap, Frame, Layout, Pictures, PixelFormat, Rect,
};
use twins::rng::{cases, Rng};

/// Whether `got` is the nearest whole number to `n / d`, where none is half way.
fn is_nearest(got: u8, n: u32, d: u32) -> bool {
    (2 * n).abs_diff(2 * u32::from(got) * d) < d
}

/// What lies under a colour whose channels have `most + 1` levels, and what becomes of it.
fn all(most: u32, over: impl Fn(Argb8888, u8) -> u8, exact: impl Fn(u32, u32, u32) -> (u32, u32)) {
    for (a, s) in (0..256_u32).flat_map(|a| (0..256_u32).map(move |s| (a, s))) {
        let color = Argb8888::new(a as u8, s as u8, s as u8, s as u8);
        for d in 0..=most {
            let (n, all) = exact(a, s, d);
            let got = over(color, d as u8);
            let right = if n > most * all { u32::from(got) == most } else { is_nearest(got, n, all) };
            assert!(right, "{got} for {n} / {all}: {s} with an alpha of {a} over {d} of {most}");
        }
    }
}

macro_rules! formats {
    ($rule:ident: $exact:expr) => {
        all(255, |color, d| color.$rule(Gray8::new(d)).luma(), $exact(255));
        all(15, |color, d| color.$rule(Gray4::new(d)).luma(), $exact(15));
        all(3, |color, d| color.$rule(Gray2::new(d)).luma(), $exact(3));
        all(31, |color, d| color.$rule(Rgb565::new(d, 9, 0)).r(), $exact(31));
        all(63, |color, d| color.$rule(Rgb565::new(9, d, 0)).g(), $exact(63));
        all(31, |color, d| color.$rule(Rgb565::new(0, 9, d)).b(), $exact(31));
        all(7, |color, d| color.$rule(Rgb332::new(d, 0, 0)).r(), $exact(7));
    };
}

#[test]
fn straight_channels_are_rounded_once() {
    formats!(over: |most: u32| move |a, s, d| (most * a * s + 255 * (255 - a) * d, 65_025));
}

#[test]
fn premultiplied_channels_are_rounded_once() {
    formats!(over_premultiplied: |most: u32| move |a, p, d| (most * p + (255 - a) * d, 255));
}

#[test]
fn premultiplying_rounds_to_nearest() {
    for (a, s) in (0..256_u32).flat_map(|a| (0..256_u32).map(move |s| (a, s))) {
        let [alpha, r, g, b] = Argb8888::new(a as u8, s as u8, 255, 0).premultiplied().argb();
        assert!(alpha == a as u8 && g == alpha && b == 0 && is_nearest(r, a * s, 255), "{r}: {s} with an alpha of {a}");
    }
}

/// Each channel by itself, and greys by the luma.
fn wanted<C: Channels>(source: u32, old: C, is_premultiplied: bool) -> C {
    let [b, g, r, a] = source.to_le_bytes().map(u32::from);
    if a == 0 && (!is_premultiplied || source == 0) {
        return old;
    }
    old.mixed_with([r, g, b], |d, most, s| {
        let (d, most) = (u32::from(d), u32::from(most));
        let (n, all) = if is_premultiplied {
            (most * s + (255 - a) * d, 255)
        } else {
            (most * a * s + 255 * (255 - a) * d, 65_025)
        };
        ((2 * n + all) / (2 * all)).min(most) as u8
    })
}

fn pictures<L: Layout<Color: Channels>>(rng: &mut Rng) {
    for _ in 0..cases(200) {
        let (width, height) = (rng.int(1, 14) as u16, rng.int(1, 9) as u16);
        let stride = L::row_bytes(width) + rng.index(3);
        let memory: Vec<u8> = (0..stride * usize::from(height)).map(|_| rng.bits() as u8).collect();
        let byte = |rng: &mut Rng| if rng.one_in(5) { rng.bits() as u8 } else { rng.pick(&[0, 1, 128, 255]) };
        let picture: Vec<u8> = (0..10 * 7 * 4).map(|_| byte(rng)).collect();
        let picture = Bitmap::<Argb8888>::new(&picture, 10, 7).expect("enough memory");
        let part = Rect::new(rng.int(0, 5), rng.int(0, 4), rng.int(3, 12), rng.int(3, 9));
        let (seen, at, is_premultiplied) = (picture.view(part), (rng.int(-9, 14), rng.int(-7, 9)), rng.one_in(2));
        let before = Frame::<_, L>::with_stride(memory.clone(), width, height, stride).expect("enough memory");
        let mut after = Frame::<_, L>::with_stride(memory, width, height, stride).expect("enough memory");
        if is_premultiplied {
            after.blit_with(at, &seen, Argb8888::over_premultiplied);
        } else {
            after.blit_with(at, &seen, Argb8888::over);
        }
        for (x, y) in (0..i32::from(height)).flat_map(|y| (0..i32::from(width)).map(move |x| (x, y))) {
            let old = before.get((x, y)).expect("a pixel");
            let source = seen.get((x - at.0, y - at.1));
            let new = source.map_or(old, |source| wanted(Argb8888::pack(source), old, is_premultiplied));
            assert!(after.get((x, y)) == Some(new), "{}: ({x}, {y})", std::any::type_name::<L>());
        }
    }
}

#[test]
fn pictures_lie_over_frames() {
    let mut rng = Rng::new(1_700);
    pictures::<Rows<Gray2>>(&mut rng);
    pictures::<Rows<Gray8>>(&mut rng);
    pictures::<Rows<Rgb565>>(&mut rng);
    pictures::<Rows<Be<Rgb565>>>(&mut rng);
    pictures::<Rows<Rgb666>>(&mut rng);
    pictures::<Rows<Be<Rgb888>>>(&mut rng);
    pictures::<Rows<Xrgb8888>>(&mut rng);
    pictures::<Rows<Rgb444>>(&mut rng);
    pictures::<Packed12>(&mut rng);
}
