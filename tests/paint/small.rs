//! Small triangles, which have sums of their own: every pixel is the nearest value, up to the bounds of the proofs.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "small numbers, and random ones"
)]

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Bgr555, PixelColor, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    geom::{At, Varying},
    paint::depth,
    pixel::{Depth16, Rgb332},
    surface::DepthBuffer,
    Canvas, ClippedSpan, Framebuffer, Rect, Surface,
};
use twins::{
    corners, planes,
    rng::{cases, Rng},
    triangle_has, Units,
};

/// Width and height of what is drawn on.
const SIZE: i32 = 64;

/// Keeps what is drawn, whatever it is.
struct Picture<C>(Vec<Option<C>>, Rect);

impl<C: PixelColor> Surface for Picture<C> {
    type Color = C;

    fn window(&self) -> Rect {
        self.1
    }

    fn fill_span(&mut self, span: ClippedSpan, color: C) {
        for x in span.x0()..span.x1() {
            self.0[(span.y() * SIZE + x) as usize] = Some(color);
        }
    }
}

/// A triangle that is 54 pixels wide and high together, or a little more or less, of some kind.
fn triangle(rng: &mut Rng, kind: usize) -> [Units; 3] {
    let all = rng.pick(&[13_823, 13_823, 13_900, 16_128, 16_200, 9_000, 2_600, 700, 520]);
    let width = match kind % 4 {
        0 => all / 2,
        1 => rng.int(1, 600).min(all - 1),
        _ => rng.int(1, all - 1),
    };
    let height = all - width;
    let (left, upper) = (rng.int(0, SIZE * 256 - width), rng.int(0, SIZE * 256 - height));
    let mut corner = |i: usize| {
        let (x, y) = (rng.int(0, width), rng.int(0, height));
        match (kind / 4 + i * 5) % 7 {
            0 => (left, upper),
            1 => (left + width, upper + height),
            2 => (left + width, upper),
            3 => (left, upper + height),
            // Close to the diagonal.
            4 => (left + x, upper + (i64::from(x) * i64::from(height) / i64::from(width)) as i32),
            5 => ((left + x) | 128, (upper + y) | 128),
            _ => (left + x, upper + y),
        }
    };
    [corner(0), corner(1), corner(2)]
}

/// Draws triangles in windows and compares all pixels.
fn check<V: Varying>(
    seed: u64,
    value: impl Fn(&mut Rng) -> V,
    parts: impl Fn(&V) -> [i64; 3],
    color: impl Fn(V) -> [i64; 3],
) {
    let (mut rng, mut seen) = (Rng::new(seed), 0);
    for kind in 0..cases(1_200) {
        let (units, values) = (triangle(&mut rng, kind), [(); 3].map(|()| value(&mut rng)));
        let window = if rng.one_in(3) { Rect::new(0, rng.int(0, 30), SIZE, 50) } else { Rect::new(0, 0, SIZE, SIZE) };
        let mut shown = vec![];
        let mut picture = Picture::<Rgb888>(vec![None; (SIZE * SIZE) as usize], window);
        picture
            .shade_triangle_fx(corners(units), values.map(|value| (At::default(), value)), |(At(at), value)| {
                shown.push((at, color(value)));
                Rgb888::WHITE
            })
            .unwrap();
        let all = (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y)));
        let wanted: Vec<_> = all.filter(|&(x, y)| window.contains(x, y) && triangle_has(units, x, y)).collect();
        assert_eq!(wanted.len(), shown.len(), "{units:?}");
        for ((x, y), (at, got)) in wanted.into_iter().zip(shown) {
            assert_eq!(at, Point::new(x, y), "{units:?}");
            assert!(picture.0[(y * SIZE + x) as usize].is_some(), "{units:?} at {at}");
            for (i, got) in got.into_iter().enumerate() {
                let levels = values.each_ref().map(|value| parts(value)[i]);
                let nearest = planes::nearest(units, levels, x, y);
                assert_eq!(i128::from(got), nearest, "part {i} of {units:?} with {levels:?} at {at}");
            }
            seen += 1;
        }
    }
    assert!(seen > 20 * cases(1_200), "only {seen} pixels");
}

/// Levels from 0 to `most`, often the ends.
fn level(rng: &mut Rng, most: i32) -> i32 {
    let any = rng.int(0, most);
    rng.pick(&[0, most, any])
}

fn channels<C: RgbColor>(c: C) -> [i64; 3] {
    [c.r(), c.g(), c.b()].map(i64::from)
}

#[test]
fn colors_are_the_nearest_ones() {
    let any = |rng: &mut Rng| [(); 3].map(|()| level(rng, 255) as u8);
    check(1, |rng| any(rng), |n| n.map(i64::from), |n| n.map(i64::from));
    macro_rules! colors {
        ($($seed:literal $color:ty),*) => {
            $(check(
                $seed,
                |rng| {
                    let [r, g, b] = any(rng);
                    <$color>::new(r & <$color>::MAX_R, g & <$color>::MAX_G, b & <$color>::MAX_B)
                },
                |c| channels(*c),
                channels,
            );)*
        };
    }
    colors!(2 Rgb565, 3 Rgb888, 4 Bgr555, 5 Rgb332);
}

#[test]
fn numbers_are_the_nearest_ones() {
    let word = |rng: &mut Rng| level(rng, 65_535) as u16;
    let numbers = |(a, b, c): (u16, i16, u8)| [i64::from(a), i64::from(b), i64::from(c)];
    check(6, |rng| (word(rng), word(rng) as i16, level(rng, 255) as u8), |value| numbers(*value), numbers);
}

/// With a depth buffer, in two orders, against a loop over all pixels and triangles.
#[test]
fn nearest_colors_are_the_nearest_ones() {
    let mut rng = Rng::new(7);
    for kind in 0..cases(300) {
        let shapes: Vec<_> = (0..4)
            .map(|i| {
                let depths = [(); 3].map(|()| level(&mut rng, 65_535) as u16);
                let colors = [(); 3].map(|()| {
                    Rgb565::new(level(&mut rng, 31) as u8, level(&mut rng, 63) as u8, level(&mut rng, 31) as u8)
                });
                (triangle(&mut rng, kind * 4 + i), depths, colors)
            })
            .collect();
        let first = rng.pick(&[0, 20]);
        let window = Rect::new(0, first, SIZE, SIZE);
        let mut ram = vec![0; (2 * SIZE * SIZE) as usize];
        let mut depth_ram = ram.clone();
        let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 64).unwrap();
        let mut frame = frame.clipped(window);
        let mut depths = DepthBuffer::<Depth16>::new(&mut depth_ram, 64, 64).unwrap();
        depths.clear(Depth16::MAX);
        let mut wanted = vec![(u16::MAX, [0_i64; 3]); (SIZE * SIZE) as usize];
        for &(units, z, colors) in &shapes {
            let values = [0, 1, 2].map(|i| (z[i], colors[i]));
            frame.depth_triangle_fx(corners(units), values, &mut depths, depth::less, |c| c).unwrap();
            for (x, y) in (first..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
                let depth = |z: [u16; 3]| planes::nearest(units, z.map(i64::from), x, y) as u16;
                let place = &mut wanted[(y * SIZE + x) as usize];
                if triangle_has(units, x, y) && depth(z) < place.0 {
                    let part = |i: usize| planes::nearest(units, colors.map(|c| channels(c)[i]), x, y) as i64;
                    *place = (depth(z), [part(0), part(1), part(2)]);
                }
            }
        }
        for (x, y) in (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| (x, y))) {
            let (depth, color) = wanted[(y * SIZE + x) as usize];
            let at = Point::new(x, y);
            assert_eq!(depths.get(at), Some(Depth16(depth)), "{shapes:?} at {at}");
            if window.contains(x, y) {
                assert_eq!(frame.get(at).map(channels), Some(color), "{shapes:?} at {at}");
            }
        }
    }
}

/// Where rows are not whole pixels apart, in views, and where depths pass here and there.
#[test]
fn memory_of_any_kind_has_the_same_pixels() {
    let (mut rng, mut painted) = (Rng::new(8), 0);
    for kind in 0..cases(300) {
        let units = triangle(&mut rng, kind);
        let z = [(); 3].map(|()| level(&mut rng, 65_535) as u16);
        let colors = [(); 3].map(|()| Rgb565::new(level(&mut rng, 31) as u8, level(&mut rng, 63) as u8, 9));
        let pattern: Vec<u16> = (0..SIZE * SIZE).map(|_| rng.pick(&[0, 20_000, 40_000, u16::MAX])).collect();
        // Two numbers of bytes from row to row, where a view begins, and whether the memory does at an even address.
        let mut memory = || {
            (rng.pick(&[160, 161, 163, 200]), rng.pick(&[(0, 0), (5, 3), (-2, -4), (3, 16)]), rng.pick(&[0, 0, 1, 2]))
        };
        let ((stride, corner, start), (depth_stride, depth_corner, depth_start)) = (memory(), memory());
        let (mut ram, mut depth_ram) = ([0; 200 * 80 + 8], [0; 200 * 80 + 8]);
        let from = |ram: &[u8], start: usize| ram.as_ptr().align_offset(4) + start;
        let (ram, depth_ram) = {
            let (start, depth_start) = (from(&ram, start), from(&depth_ram, depth_start));
            (&mut ram[start..], &mut depth_ram[depth_start..])
        };
        let view = |(x, y): (i32, i32)| Rect::new(x, y, x + SIZE, y + SIZE);
        let mut frame = Framebuffer::<Rgb565>::with_stride(ram, 80, 80, stride).unwrap();
        let mut frame = frame.view(view(corner));
        let mut depths = DepthBuffer::<Depth16>::with_stride(depth_ram, 80, 80, depth_stride).unwrap();
        let mut depths = depths.view(view(depth_corner));
        let places = || (0..SIZE).flat_map(|y| (0..SIZE).map(move |x| Point::new(x, y)));
        let before = |at: Point| pattern[(at.y * SIZE + at.x) as usize];
        places().for_each(|at| depths.draw_point(at, Depth16(before(at))));
        let values = [0, 1, 2].map(|i| (z[i], colors[i]));
        frame.depth_triangle_fx(corners(units), values, &mut depths, depth::less, |c| c).unwrap();
        for at in places() {
            let nearest = |n: [i64; 3]| planes::nearest(units, n, at.x, at.y) as i64;
            let is_inside = frame.window().contains(at.x, at.y) && depths.window().contains(at.x, at.y);
            let is_painted =
                is_inside && triangle_has(units, at.x, at.y) && nearest(z.map(i64::from)) < i64::from(before(at));
            let depth = if is_painted { nearest(z.map(i64::from)) as u16 } else { before(at) };
            let color = [0, 1, 2].map(|i| if is_painted { nearest(colors.map(|c| channels(c)[i])) } else { 0 });
            if let Some(found) = depths.get(at) {
                assert_eq!(found, Depth16(depth), "{units:?} at {at}");
            }
            if let Some(found) = frame.get(at) {
                assert_eq!(channels(found), color, "{units:?} at {at}");
            }
            painted += i32::from(is_painted);
        }
    }
    assert!(painted > 10 * cases(300) as i32, "only {painted} pixels");
}
