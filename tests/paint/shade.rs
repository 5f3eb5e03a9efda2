//! Shaded triangles on every layout, in bands and views: pixel by pixel the nearest levels.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, PixelColor, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    geom::{Facet, Fast, Plane, Runs, Varying},
    pixel::{Be, Lsb0, Rgb444, Xrgb8888},
    surface::{Grid, Packed12, Pages, Rows},
    Canvas, ClippedSpan, Frame, Index1, Index2, Index4, Index8, Layout, PointFx, Rect,
};
use fixed::types::I16F16;
use twins::{
    corners, planes,
    rng::{cases, Rng},
    triangle_has, Units,
};

/// Of the screen that is drawn on.
const SIZE: (u16, u16) = (45, 32);

fn bytes<L: Layout>(rows: u16) -> usize {
    L::bytes(SIZE.0, Grid { stride: L::row_bytes(SIZE.0), rows: rows.into() })
}

/// A triangle around the screen, some of them much larger.
fn triangle(rng: &mut Rng) -> [Units; 3] {
    let reach = rng.pick(&[0, 2_000, 300_000]);
    [(); 3].map(|()| (rng.int(-reach, 45 * 256 + reach), rng.int(-reach, 32 * 256 + reach)))
}

/// Draws triangles as a whole, in bands, and in a view, and compares each pixel with what the rule says.
fn check<L: Layout, V: Varying>(
    seed: u64,
    value: impl Fn(u8) -> V,
    color: impl Fn(V) -> L::Color,
    wanted: impl Fn([u8; 3], [Units; 3], i32, i32) -> L::Color,
) where
    L::Color: PixelColor + core::fmt::Debug,
{
    let mut rng = Rng::new(seed);
    for _ in 0..cases(200) {
        let (units, levels) = (triangle(&mut rng), [(); 3].map(|()| rng.int(0, 255) as u8));
        let ground = color(value(rng.int(0, 255) as u8));
        let values = levels.map(&value);
        let mut whole = vec![0; bytes::<L>(SIZE.1)];
        let mut frame = Frame::<_, L>::new(&mut whole[..], SIZE.0, SIZE.1).unwrap();
        frame.clear(ground);
        frame.shade_triangle_fx(corners(units), values, &color).unwrap();
        for (x, y) in (0..32).flat_map(|y| (0..45).map(move |x| (x, y))) {
            let right = if triangle_has(units, x, y) { wanted(levels, units, x, y) } else { ground };
            assert_eq!(frame.get(Point::new(x, y)), Some(right), "{units:?} {levels:?} at {x}, {y}");
        }
        // Bands of eight rows, and a view.
        for start in (0..SIZE.1).step_by(8) {
            let mut ram = vec![0; bytes::<L>(8)];
            let mut band = Frame::<_, L>::band(&mut ram[..], SIZE.0, SIZE.1, start..start + 8).unwrap();
            band.clear(ground);
            band.shade_triangle_fx(corners(units), values, &color).unwrap();
            for (x, y) in (start.into()..i32::from(start) + 8).flat_map(|y| (0..45).map(move |x| (x, y))) {
                assert_eq!(
                    band.get(Point::new(x, y)),
                    frame.get(Point::new(x, y)),
                    "{units:?} in the band from {start}"
                );
            }
        }
        let (left, top) = (rng.int(0, 30), rng.int(0, 20));
        let mut ram = vec![0; bytes::<L>(SIZE.1)];
        let mut other = Frame::<_, L>::new(&mut ram[..], SIZE.0, SIZE.1).unwrap();
        other.clear(ground);
        let moved = units.map(|(x, y)| PointFx::from_bits(x - left * 256, y - top * 256));
        other.view(Rect::new(left, top, left + 11, top + 9)).shade_triangle_fx(moved, values, &color).unwrap();
        for (x, y) in (0..32).flat_map(|y| (0..45).map(move |x| (x, y))) {
            let seen = (left..left + 11).contains(&x) && (top..top + 9).contains(&y);
            let right = if seen { frame.get(Point::new(x, y)) } else { Some(ground) };
            assert_eq!(other.get(Point::new(x, y)), right, "{units:?} in a view at {left}, {top}: {x}, {y}");
        }
    }
}

/// The nearest level at a pixel.
fn level(levels: [u8; 3], units: [Units; 3], x: i32, y: i32) -> u8 {
    planes::nearest(units, levels.map(i64::from), x, y) as u8
}

/// Levels through a function, on a layout.
fn levels<L: Layout>(seed: u64, color: impl Fn(u8) -> L::Color + Copy)
where
    L::Color: core::fmt::Debug,
{
    check::<L, u8>(seed, |n| n, color, |levels, units, x, y| color(level(levels, units, x, y)));
}

#[test]
fn levels_on_every_layout() {
    levels::<Rows<Index1>>(1, |n| Index1::new(n >> 7));
    levels::<Rows<Lsb0<BinaryColor>>>(2, |n| BinaryColor::from(n >= 128));
    levels::<Rows<Index2>>(3, |n| Index2::new(n >> 6));
    levels::<Rows<Lsb0<Gray2>>>(4, |n| Gray2::new(n >> 6));
    levels::<Rows<Index4>>(5, |n| Index4::new(n >> 4));
    levels::<Rows<Lsb0<Gray4>>>(6, |n| Gray4::new(n >> 4));
    levels::<Rows<Index8>>(7, Index8::new);
    levels::<Rows<Rgb565>>(8, |n| Rgb565::new(n >> 3, n >> 2, 31 - (n >> 3)));
    levels::<Rows<Be<Rgb565>>>(9, |n| Rgb565::new(n >> 3, n >> 2, 31 - (n >> 3)));
    levels::<Rows<Rgb888>>(10, |n| Rgb888::new(n, 255 - n, n / 2));
    levels::<Rows<Be<Xrgb8888>>>(11, |n| Xrgb8888::new(n, 255 - n, n / 2));
    levels::<Packed12>(12, |n| Rgb444::new(n >> 4, 15 - (n >> 4), 3));
    levels::<Pages<Index1>>(13, |n| Index1::new(n >> 7));
}

/// Rows in several runs: each begins where the one before it ends, as those of a plane do.
fn runs<L: Layout, const N: u32>(seed: u64, color: impl Fn(u8) -> L::Color)
where
    L::Color: core::fmt::Debug,
{
    let mut rng = Rng::new(seed);
    for _ in 0..cases(200) {
        let (units, near) = (triangle(&mut rng), rng.int(1, 70_000));
        let values = [(); 3].map(|()| {
            let w = I16F16::from_bits(rng.int(near, 4 * near));
            Runs::<u8, N> { w, value: rng.int(0, 255) as u8 }
        });
        let mut ram = vec![0; bytes::<L>(SIZE.1)];
        let mut frame = Frame::<_, L>::new(&mut ram[..], SIZE.0, SIZE.1).unwrap();
        frame.clear(color(0));
        frame.shade_triangle_fx(corners(units), values, |at| color(at.value)).unwrap();
        let plane = Plane::new(&Facet::new(corners(units)).unwrap(), values);
        let mut wanted = vec![0; 45 * 32];
        embedded_raster::raster::triangle::fill(corners(units), Rect::new(0, 0, 45, 32), |span: ClippedSpan| {
            let mut places = wanted[(span.y() * 45 + span.x0()) as usize..].iter_mut();
            plane.each(span.x0(), span.y(), span.len(), |at| *places.next().unwrap() = at.value);
        });
        for (x, y) in (0..32).flat_map(|y| (0..45).map(move |x| (x, y))) {
            let right = color(wanted[(y * 45 + x) as usize]);
            assert_eq!(frame.get(Point::new(x, y)), Some(right), "{units:?} {values:?} at {x}, {y}");
        }
    }
}

#[test]
fn runs_on_every_layout() {
    runs::<Rows<Lsb0<BinaryColor>>, 16>(40, |n| BinaryColor::from(n >= 128));
    runs::<Rows<Index4>, 5>(41, |n| Index4::new(n >> 4));
    runs::<Rows<Gray8>, 2>(42, Gray8::new);
    runs::<Rows<Gray8>, 7>(43, Gray8::new);
    runs::<Rows<Rgb565>, 16>(44, |n| Rgb565::new(n >> 3, n >> 2, 31 - (n >> 3)));
    runs::<Rows<Be<Rgb565>>, 3>(45, |n| Rgb565::new(n >> 3, n >> 2, 31 - (n >> 3)));
    runs::<Rows<Rgb888>, 8>(46, |n| Rgb888::new(n, 255 - n, n / 2));
    runs::<Rows<Be<Xrgb8888>>, 64>(47, |n| Xrgb8888::new(n, 255 - n, n / 2));
    runs::<Packed12, 4>(48, |n| Rgb444::new(n >> 4, 15 - (n >> 4), 3));
    runs::<Pages<Index1>, 9>(49, |n| Index1::new(n >> 7));
}

#[test]
fn colors_of_each_kind() {
    let mixed = |levels: [u8; 3], of: fn(u8) -> u8, units, x, y| level(levels.map(of), units, x, y);
    check::<Rows<Rgb565>, _>(
        20,
        |n| Rgb565::new(n >> 3, 63 - (n >> 2), n >> 5),
        |c| c,
        |levels, units, x, y| {
            let part = |of| mixed(levels, of, units, x, y);
            Rgb565::new(part(|n| n >> 3), part(|n| 63 - (n >> 2)), part(|n| n >> 5))
        },
    );
    check::<Rows<Rgb888>, _>(
        21,
        |n| Rgb888::new(n, 255 - n, n / 2),
        |c| c,
        |levels, units, x, y| {
            let part = |of| mixed(levels, of, units, x, y);
            Rgb888::new(part(|n| n), part(|n| 255 - n), part(|n| n / 2))
        },
    );
    check::<Packed12, _>(
        22,
        |n| Rgb444::new(n >> 4, 15 - (n >> 4), n & 15),
        |c| c,
        |levels, units, x, y| {
            let part = |of| mixed(levels, of, units, x, y);
            Rgb444::new(part(|n| n >> 4), part(|n| 15 - (n >> 4)), part(|n| n & 15))
        },
    );
    check::<Rows<Gray8>, _>(23, Gray8::new, |c| c, |levels, units, x, y| Gray8::new(level(levels, units, x, y)));
    check::<Rows<Gray4>, _>(
        24,
        |n| Gray4::new(n >> 4),
        |c| c,
        |levels, units, x, y| Gray4::new(mixed(levels, |n| n >> 4, units, x, y)),
    );
}

/// In fast mode a value is one off at most, and that seldom.
#[test]
fn fast_colors_are_close() {
    let (mut rng, mut pixels, mut off) = (Rng::new(30), 0, 0);
    for _ in 0..cases(300) {
        let units = triangle(&mut rng);
        let colors = [(); 3].map(|()| Rgb565::new(rng.int(0, 31) as u8, rng.int(0, 63) as u8, rng.int(0, 31) as u8));
        let (mut exact, mut fast) = (vec![0; bytes::<Rows<Rgb565>>(32)], vec![0; bytes::<Rows<Rgb565>>(32)]);
        let mut exact = Frame::<_, Rows<Rgb565>>::new(&mut exact[..], 45, 32).unwrap();
        let mut fast = Frame::<_, Rows<Rgb565>>::new(&mut fast[..], 45, 32).unwrap();
        exact.shade_triangle_fx(corners(units), colors, |c| c).unwrap();
        fast.shade_triangle_fx(corners(units), colors.map(Fast), |c| c.0).unwrap();
        for at in (0..32).flat_map(|y| (0..45).map(move |x| Point::new(x, y))) {
            let (a, b) = (exact.get(at).unwrap(), fast.get(at).unwrap());
            for channel in [Rgb565::r, Rgb565::g, Rgb565::b] {
                assert!(channel(&a).abs_diff(channel(&b)) <= 1, "{units:?} {colors:?} at {at}: {a:?}, {b:?}");
                off += u32::from(channel(&a) != channel(&b));
                pixels += 1;
            }
        }
    }
    assert!(off * 300 < pixels, "{off} of {pixels} levels");
}
