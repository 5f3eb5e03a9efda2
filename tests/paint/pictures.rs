//! Pictures on surfaces of other colours: each pixel takes the texel that the rule names, on every layout.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    reason = "small numbers, and random ones"
)]

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Rgb565, Rgb888},
};
use embedded_raster::{
    fixed::types::I16F16,
    pixel::{Be, Lsb0, Rgb444},
    raster::mapped,
    surface::{Packed12, Pages, Planes, Rows, Sheet},
    Affine, Angle, Bitmap, Frame, Index1, Index2, Index4, Index8, Layout, Pictures, PixelFormat, Rect,
};
use twins::rng::{cases, Rng};

const WIDTH: i32 = 40;
const HEIGHT: i32 = 24;

/// Draws on a clip of noise and compares each pixel with what `wanted` says of it; `None` is what was there.
fn check<L: Layout<Color: core::fmt::Debug>>(
    rng: &mut Rng,
    what: &str,
    draw: impl FnOnce(&mut Frame<&mut [u8], L>),
    wanted: impl Fn(i32, i32) -> Option<L::Color>,
) {
    let mut ram: Vec<u8> = (0..WIDTH * HEIGHT * 4).map(|_| rng.bits() as u8).collect();
    let mut before = ram.clone();
    let clip = Rect::new(rng.int(-3, 20), rng.int(-3, 12), rng.int(10, 50), rng.int(6, 30));
    let mut frame = Frame::<_, L>::new(&mut ram[..], WIDTH as u16, HEIGHT as u16).unwrap();
    let old = Frame::<_, L>::new(&mut before[..], WIDTH as u16, HEIGHT as u16).unwrap();
    draw(&mut frame.clipped(clip));
    for (x, y) in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))) {
        let right = wanted(x, y).filter(|_| clip.contains(x, y)).or(old.get(Point::new(x, y)));
        assert_eq!(frame.get(Point::new(x, y)), right, "{what} at {x}, {y} in {clip:?}");
    }
}

fn every_picture<L: Layout<Color: core::fmt::Debug>>(seed: u64, make: impl Fn(u8) -> L::Color) {
    let mut rng = Rng::new(seed);
    for _ in 0..cases(300) {
        let texels: Vec<u8> = (0..6 * 9).map(|_| rng.bits() as u8).collect();
        let whole = Bitmap::<Index4>::new(&texels, 11, 9).unwrap();
        let picture = whole.view(Rect::new(rng.int(0, 3), rng.int(0, 3), rng.int(3, 11), rng.int(3, 9)));
        let color = |index: Index4| (index.index() != 7).then(|| make(index.index()));
        let texel = |x: i32, y: i32| picture.get(Point::new(x, y)).and_then(color);

        let at = Point::new(rng.int(-9, 39), rng.int(-9, 23));
        check::<L>(&mut rng, "mapped", |f| f.blit_mapped(at, &picture, color), |x, y| texel(x - at.x, y - at.y));
        let far = Point::new(rng.pick(&[i32::MIN, i32::MAX, -9_000]), rng.bits() as i32);
        check::<L>(&mut rng, "far away", |f| f.blit_mapped(far, &picture, color), |_, _| None);

        let area = Rect::new(rng.int(-9, 20), rng.int(-9, 10), rng.int(15, 60), rng.int(8, 40));
        let size = picture.size();
        let along =
            |at: i32, low: i32, high: i32, texels: u32| (2 * (at - low) + 1) * texels as i32 / (2 * (high - low));
        let stretched = |area: Rect, texel: &dyn Fn(i32, i32) -> Option<L::Color>, (width, height), x, y| {
            let place = |(x, y)| (along(x, area.x0, area.x1, width), along(y, area.y0, area.y1, height));
            Some((x, y)).filter(|&(x, y)| area.contains(x, y)).map(place).and_then(|(x, y)| texel(x, y))
        };
        check::<L>(
            &mut rng,
            "stretched",
            |f| f.blit_stretched(area, &picture, color),
            |x, y| stretched(area, &texel, (size.width, size.height), x, y),
        );

        let turn =
            Affine::scale(I16F16::from_bits(rng.int(20_000, 300_000)), I16F16::from_bits(rng.int(20_000, 300_000)))
                .then(Affine::rotate(Angle::from_bits(rng.bits() as u32)))
                .then(Affine::translate(
                    I16F16::from_bits(rng.int(0, 2_000_000)),
                    I16F16::from_bits(rng.int(0, 1_500_000)),
                ));
        let mut pixels = vec![None; (WIDTH * HEIGHT) as usize];
        mapped::fill(&turn, size, Rect::new(0, 0, WIDTH, HEIGHT), |span, mut texels| {
            for x in span.x0()..span.x1() {
                pixels[(span.y() * WIDTH + x) as usize] = Some(texels.texel());
            }
        })
        .unwrap();
        check::<L>(
            &mut rng,
            "under a map",
            |f| f.blit_affine(&turn, &picture, color).unwrap(),
            |x, y| pixels[(y * WIDTH + x) as usize].and_then(|(x, y)| texel(x, y)),
        );

        // Nine parts, each as a picture of its own.
        let (width, height) = (size.width as i32, size.height as i32);
        let (left, top) = (rng.int(0, width), rng.int(0, height));
        let middle = Rect::new(left, top, rng.int(left, width), rng.int(top, height));
        let part = |at: i32, (start, end, size): (i32, i32, i32), (low, high): (i32, i32)| {
            let length = (high - low).max(0);
            let (mut before, mut after) = (start, size - end);
            if before + after > length {
                before = before * length / (before + after);
                after = length - before;
            }
            let cuts = [
                (0, low, start, low + before),
                (start, low + before, end, high - after),
                (end, high - after, size, high),
            ];
            cuts.into_iter()
                .find(|&(_, low, _, high)| (low..high).contains(&at))
                .map(|(from, low, to, high)| (from, along(at, low, high, (to - from) as u32), to))
        };
        let nine = |x: i32, y: i32| {
            let (from_x, x, end_x) = part(x, (middle.x0, middle.x1, width), (area.x0, area.x1))?;
            let (from_y, y, end_y) = part(y, (middle.y0, middle.y1, height), (area.y0, area.y1))?;
            // A part without texels draws nothing.
            if from_x < end_x && from_y < end_y {
                texel(from_x + x, from_y + y)
            } else {
                None
            }
        };
        check::<L>(&mut rng, "nine parts", |f| f.blit_nine_patch(area, &picture, middle, color), nine);

        let (tile_width, tile_height) = (rng.int(1, 5), rng.int(1, 4));
        let sheet = Sheet::new(&picture, tile_width as u16, tile_height as u16);
        let (columns, rows) = (width / tile_width, height / tile_height);
        assert_eq!(sheet.len() as i32, columns * rows, "tiles of {size:?}");
        let tile_at = |column: i32, row: i32| {
            let number = (column * 5 + row * 3).rem_euclid(columns * rows + 1);
            (number < 30).then_some(number as usize)
        };
        let map = |x: i32, y: i32| {
            let (column, row) = ((x - at.x).div_euclid(tile_width), (y - at.y).div_euclid(tile_height));
            let number = tile_at(column, row)? as i32;
            let (i, j) = ((x - at.x).rem_euclid(tile_width), (y - at.y).rem_euclid(tile_height));
            (number < columns * rows)
                .then(|| texel(number % columns * tile_width + i, number / columns * tile_height + j))?
        };
        let draw = |f: &mut Frame<&mut [u8], L>| f.draw_tile_map(at, &sheet, tile_at, color);
        if columns * rows > 0 {
            check::<L>(&mut rng, "a map of tiles", draw, map);
        }
    }
}

#[test]
fn pictures_on_every_layout() {
    fn bits<F: PixelFormat>(n: u8) -> F::Color {
        F::unpack(u32::from(n).wrapping_mul(0x0111_1111) & (u32::MAX >> (32 - F::BITS)))
    }
    every_picture::<Rows<Index1>>(1, bits::<Index1>);
    every_picture::<Rows<Lsb0<Index2>>>(2, bits::<Index2>);
    every_picture::<Rows<Index4>>(3, bits::<Index4>);
    every_picture::<Rows<Index8>>(4, bits::<Index8>);
    every_picture::<Rows<Be<Rgb565>>>(5, bits::<Rgb565>);
    every_picture::<Rows<Rgb888>>(6, bits::<Rgb888>);
    every_picture::<Pages<Lsb0<BinaryColor>>>(7, bits::<BinaryColor>);
    every_picture::<Planes<Index2>>(8, bits::<Index2>);
    every_picture::<Packed12>(9, bits::<Rgb444>);
}

/// Only cells that meet the window are asked for, once each, wherever the map begins.
#[test]
fn a_map_of_tiles_asks_for_visible_cells() {
    let picture = Bitmap::<Index8>::new(&[0; 64], 8, 8).unwrap();
    let sheet = Sheet::new(&picture, 4, 4);
    let mut ram = [0; 20 * 10];
    let mut frame = Frame::<_, Rows<Index8>>::new(&mut ram[..], 20, 10).unwrap();
    for (at, first, last) in [
        ((0, 0), (0, 0), (4, 2)),
        ((-1, 3), (0, -1), (5, 1)),
        ((i32::MIN, i32::MAX), (536_870_912, -536_870_912), (536_870_916, -536_870_910)),
    ] {
        let mut asked = vec![];
        let tile_at = |column, row| {
            asked.push((column, row));
            None
        };
        frame.draw_tile_map(at, &sheet, tile_at, |index: Index8| Some(index));
        assert_eq!((asked.first(), asked.last()), (Some(&first), Some(&last)), "from {at:?}");
        assert_eq!(asked.len() as i32, (last.0 - first.0 + 1) * (last.1 - first.1 + 1), "from {at:?}");
    }
    let none = Sheet::new(&picture, 0, 4);
    frame.draw_tile_map((0, 0), &none, |_, _| panic!("asked"), |index: Index8| Some(index));
}
