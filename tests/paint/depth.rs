//! Depth buffers and the numbers of triangles, against a loop over all pixels and triangles.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Gray8, GrayColor},
};
use embedded_raster::{
    geom::{Barycentric, Facet, Plane},
    paint::{depth, DepthShade},
    pixel::{Depth16, Depth32, Id16},
    raster::triangle,
    surface::{Depth, DepthBuffer},
    Canvas, Framebuffer, Index4, PointFx, Rect,
};
use twins::{
    corners, planes,
    rng::{cases, Rng},
    triangle_has, Units,
};

const WIDTH: i32 = 40;
const HEIGHT: i32 = 24;

/// Corners, depths at the corners, a colour.
type Shape = ([Units; 3], [u32; 3], u8);

fn shapes(rng: &mut Rng, most: u32) -> Vec<Shape> {
    (0..rng.int(1, 8))
        .map(|n| {
            let reach = rng.pick(&[0, 3_000, 500_000]);
            let units = [(); 3].map(|()| (rng.int(-reach, WIDTH * 256 + reach), rng.int(-reach, HEIGHT * 256 + reach)));
            // Many equal ones, and the ends of the type.
            let depth = |rng: &mut Rng| {
                let any = rng.range(0, most.into()) as u32;
                rng.pick(&[0, most, most / 2, most / 2, any, any])
            };
            (units, [depth(rng), depth(rng), depth(rng)], n as u8 + 1)
        })
        .collect()
}

/// What is seen, and how far away: pixel by pixel.
fn plain(shapes: &[Shape], start: u32, passes: impl Fn(u32, u32) -> bool) -> Vec<(u8, u32)> {
    let pixels = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    pixels
        .map(|(x, y)| {
            let (mut seen, mut nearest) = (0, start);
            for &(units, depths, color) in shapes {
                if triangle_has(units, x, y) {
                    let depth = planes::nearest(units, depths.map(i64::from), x, y) as u32;
                    if passes(depth, nearest) {
                        (seen, nearest) = (color, depth);
                    }
                }
            }
            (seen, nearest)
        })
        .collect()
}

fn check<Z>(seed: u64, most: u32, number: impl Fn(u32) -> Z::Number + Copy, pack: impl Fn(u32) -> Z)
where
    Z: Depth + PartialEq + core::fmt::Debug,
{
    let mut rng = Rng::new(seed);
    for round in 0..cases(600) {
        let shapes = shapes(&mut rng, most);
        let (test, start): (fn(u32, u32) -> bool, u32) = match round % 4 {
            0 => (|new, old| new < old, most),
            1 => (|new, old| new <= old, most),
            2 => (|new, old| new > old, 0),
            _ => (|_, _| true, most / 3),
        };
        let wanted = plain(&shapes, start, test);
        // Whole, and in bands of 7 rows.
        for rows in [HEIGHT as u16, 7] {
            for first in (0..HEIGHT as u16).step_by(rows.into()) {
                let band = first..(first + rows).min(HEIGHT as u16);
                let (mut ram, mut depth_ram) = (vec![0; 40 * 24], vec![0; 40 * 24 * 4]);
                let mut frame = Framebuffer::<Gray8>::band(&mut ram, 40, 24, band.clone()).unwrap();
                let mut buffer = DepthBuffer::<Z>::band(&mut depth_ram, 40, 24, band.clone()).unwrap();
                buffer.clear(pack(start));
                for &(units, depths, color) in &shapes {
                    let (places, values) = (corners(units), depths.map(|depth| (number(depth), ())));
                    let color = |()| Gray8::new(color);
                    match round % 4 {
                        0 => frame.depth_triangle_fx(places, values, &mut buffer, depth::less, color),
                        1 => frame.depth_triangle_fx(places, values, &mut buffer, depth::less_equal, color),
                        2 => frame.depth_triangle_fx(places, values, &mut buffer, depth::greater, color),
                        _ => frame.depth_triangle_fx(places, values, &mut buffer, depth::always, color),
                    }
                    .unwrap();
                }
                for (x, y) in band.flat_map(|y| (0..WIDTH).map(move |x| (x, i32::from(y)))) {
                    let (color, depth) = wanted[(y * WIDTH + x) as usize];
                    let at = Point::new(x, y);
                    assert_eq!(frame.get(at).unwrap().luma(), color, "{shapes:?} at {at}");
                    assert_eq!(buffer.get(at), Some(pack(depth)), "{shapes:?} at {at}");
                }
            }
        }
    }
}

#[test]
fn what_is_nearest_is_seen_at_16_bits() {
    check::<Depth16>(1, 65_535, |n| n as u16, |n| Depth16(n as u16));
}

#[test]
fn what_is_nearest_is_seen_at_32_bits() {
    check::<Depth32>(2, u32::MAX, |n| n, Depth32);
}

/// A plane in two triangles: whichever way it is cut, each pixel has the same depth.
#[test]
fn triangles_of_one_plane_do_not_fight() {
    let mut rng = Rng::new(3);
    for _ in 0..cases(2_000) {
        let depth = {
            let (a, b, c) = (rng.range(-40, 40), rng.range(-40, 40), rng.range(30_000, 34_000));
            move |(x, y): Units| ((a * i64::from(x / 64) + b * i64::from(y / 64)) / 4 * 4 + c) as u16
        };
        // Corners on a grid of pixels, where the plane has whole depths.
        let mut corner = || (rng.int(-10, 50) * 256, rng.int(-10, 34) * 256);
        let shapes = [[corner(), corner(), corner()], [corner(), corner(), corner()]];
        let mut seen = [0, 1].map(|_| vec![0; 40 * 24 * 2]);
        for (order, ram) in [[0, 1], [1, 0]].into_iter().zip(&mut seen) {
            let mut colors = vec![0; 40 * 24];
            let mut frame = Framebuffer::<Gray8>::new(&mut colors, 40, 24).unwrap();
            let mut buffer = DepthBuffer::<Depth16>::new(ram, 40, 24).unwrap();
            buffer.clear(Depth16::MAX);
            for shape in order {
                let values = shapes[shape].map(|units| (depth(units), ()));
                let gray = |()| Gray8::new(1);
                frame.depth_triangle_fx(corners(shapes[shape]), values, &mut buffer, depth::less, gray).unwrap();
            }
        }
        assert!(seen[0] == seen[1], "{shapes:?}");
    }
}

/// The picture of the lecture: two triangles on 5 x 5 pixels share one, and the nearer one is seen there.
#[test]
fn numbers_of_two_triangles() {
    let half = |(x, y): (i32, i32)| PointFx::from_bits(x * 128, y * 128);
    let first = [(0, 1), (3, 6), (8, 4)].map(half);
    let second = [(0, 6), (7, 4), (8, 8)].map(half);
    let (far, near) = (1000_u16, 800_u16);
    for order in [[(first, far, 1), (second, near, 2)], [(second, near, 2), (first, far, 1)]] {
        let (mut ram, mut depth_ram) = ([0; 50], [0; 50]);
        let mut ids = Framebuffer::<Id16>::new(&mut ram, 5, 5).unwrap();
        let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 5, 5).unwrap();
        buffer.clear(Depth16::MAX);
        for (corners, depth, id) in order {
            ids.depth_triangle_fx(corners, [(depth, ()); 3], &mut buffer, depth::less, |()| Id16(id)).unwrap();
        }
        let rows: Vec<Vec<u16>> =
            (0..5).map(|y| (0..5).map(|x| ids.get(Point::new(x, y)).unwrap().0).collect()).collect();
        #[rustfmt::skip]
        assert_eq!(rows, [
            [0, 0, 0, 0, 0],
            [0, 1, 1, 0, 0],
            [0, 1, 2, 2, 0],
            [0, 0, 2, 2, 0],
            [0, 0, 0, 0, 0],
        ]);
        // What lies under a pixel: where in its triangle, and how far away.
        let Barycentric { weights, total } = Facet::new(second).unwrap().weights(PointFx::centre_of(Point::new(2, 2)));
        assert!(weights.iter().all(|&w| w > 0) && weights.iter().sum::<i64>() == total);
        assert_eq!(buffer.get(Point::new(2, 2)), Some(Depth16(near)));
        assert_eq!(buffer.get(Point::new(1, 1)), Some(Depth16(far)));
    }
}

/// Numbers first and colours later: the same picture as colours at once.
#[test]
fn deferred_shading_is_immediate_shading() {
    let mut rng = Rng::new(4);
    for _ in 0..cases(300) {
        let shapes = shapes(&mut rng, 65_535);
        let colors: Vec<[u8; 3]> = shapes.iter().map(|_| [(); 3].map(|()| rng.int(0, 255) as u8)).collect();
        let (mut now, mut later, mut ids) = (vec![0; 40 * 24], vec![0; 40 * 24], vec![0; 40 * 24 * 2]);
        let mut depths = [0, 1].map(|_| vec![0; 40 * 24 * 2]);
        let [first, second] = &mut depths;
        let mut now = Framebuffer::<Gray8>::new(&mut now, 40, 24).unwrap();
        let mut later = Framebuffer::<Gray8>::new(&mut later, 40, 24).unwrap();
        let mut ids = Framebuffer::<Id16>::new(&mut ids, 40, 24).unwrap();
        let mut first = DepthBuffer::<Depth16>::new(first, 40, 24).unwrap();
        let mut second = DepthBuffer::<Depth16>::new(second, 40, 24).unwrap();
        first.clear(Depth16::MAX);
        second.clear(Depth16::MAX);
        for (id, (&(units, depths, _), levels)) in (1..).zip(shapes.iter().zip(&colors)) {
            let depth = depths.map(|n| n as u16);
            let with = |i: usize| (depth[i], levels[i]);
            let values = [with(0), with(1), with(2)];
            now.depth_triangle_fx(corners(units), values, &mut first, depth::less, Gray8::new).unwrap();
            ids.depth_triangle_fx(corners(units), depth.map(|z| (z, ())), &mut second, depth::less, |()| Id16(id))
                .unwrap();
        }
        for at in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| Point::new(x, y))) {
            if let Some(i) = usize::from(ids.get(at).unwrap().0).checked_sub(1) {
                let plane = Plane::new(&Facet::new(corners(shapes[i].0)).unwrap(), colors[i]);
                later.draw_point(at, Gray8::new(plane.at(at.x, at.y)));
            }
            assert_eq!(later.get(at), now.get(at), "{shapes:?} at {at}");
        }
    }
}

/// A discarded pixel keeps its depth, and so do all where depths are only read.
#[test]
fn what_is_not_painted_keeps_its_depth() {
    let corners = [PointFx::px(0, 0), PointFx::px(80, 0), PointFx::px(0, 80)];
    let plane = Plane::new(&Facet::new(corners).unwrap(), [(7_u16, 0_u8), (7, 80), (7, 0)]);
    let (mut ram, mut depth_ram) = ([0; 20 * 4], [0xff; 40 * 4 * 2]);
    let mut frame = Framebuffer::<Index4>::new(&mut ram, 40, 4).unwrap();
    let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 40, 4).unwrap();
    let odd = |level: u8, _| (level % 2 == 1).then_some(Index4::new(3));
    let window = Rect::new(0, 0, 40, 4);
    frame.paint(DepthShade::new(&mut buffer, plane, depth::less, odd), |_, brush| {
        triangle::fill(corners, window, brush);
    });
    for at in (0..4).flat_map(|y| (0..40).map(move |x| Point::new(x, y))) {
        let painted = plane.at(at.x, at.y).1 % 2 == 1;
        assert_eq!(frame.get(at), Some(Index4::new(if painted { 3 } else { 0 })), "{at}");
        assert_eq!(buffer.get(at), Some(if painted { Depth16(7) } else { Depth16::MAX }), "{at}");
    }
    let all = |_, _| Some(Index4::new(9));
    let nearer = Plane::new(&Facet::new(corners).unwrap(), [(5_u16, 0_u8); 3]);
    let shade = DepthShade::new(&mut buffer, nearer, depth::less, all).read_only();
    frame.paint(shade, |window, brush| triangle::fill(corners, window, brush));
    assert!((0..40).all(|x| frame.get(Point::new(x, 2)) == Some(Index4::new(9))));
    assert!((0..40).all(|x| buffer.get(Point::new(x, 2)) != Some(Depth16(5))));
}

/// Colours are painted only where there is a depth.
#[test]
fn outside_of_the_depth_buffer_nothing_is_painted() {
    let (mut ram, mut depth_ram) = ([0; 20 * 10], [0xff; 8 * 4 * 2]);
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 20, 10).unwrap();
    let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 8, 4).unwrap();
    let corners = [PointFx::px(-5, -5), PointFx::px(90, -5), PointFx::px(-5, 90)];
    frame.depth_triangle_fx(corners, [(1, ()); 3], &mut buffer, depth::less, |()| Gray8::new(1)).unwrap();
    for at in (0..10).flat_map(|y| (0..20).map(move |x| Point::new(x, y))) {
        assert_eq!(frame.get(at).unwrap().luma(), u8::from(at.x < 8 && at.y < 4), "{at}");
    }
}

/// A triangle that is too large is an error, even where there are no depths; any other one is not.
#[test]
fn too_large_is_an_error_even_where_nothing_is_seen() {
    let mut ram = [0; 20 * 10];
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, 20, 10).unwrap();
    let mut buffer = DepthBuffer::<Depth16>::new(&mut [], 0, 0).unwrap();
    for (size, is_drawn) in [(8, true), (200, true), (9_000, false)] {
        let corners = [PointFx::px(0, 0), PointFx::px(size, 0), PointFx::px(0, size)];
        let drawn = frame.depth_triangle_fx(corners, [(1, ()); 3], &mut buffer, depth::less, |()| Gray8::new(1));
        assert_eq!(drawn.is_ok(), is_drawn, "{size} pixels");
    }
    assert_eq!(ram, [0; 200]);
}
