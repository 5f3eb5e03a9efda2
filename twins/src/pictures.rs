//! Pictures, patterns and error diffusion pixel by pixel, by the rules of their documentation; and the fuzz targets `pictures`,
//! `patterns` and `diffusion`.

use std::collections::BTreeMap;

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Gray8, GrayColor, Rgb565},
};
use embedded_raster::{
    fixed::types::I16F16,
    paint::{pattern::Pattern, RasterOp, Tiles},
    pixel::{Atkinson, FloydSteinberg, Lsb0},
    raster::rectangle,
    surface::{Rows, Sheet},
    Affine, Bitmap, Canvas, Frame, Framebuffer, Index1, Index4, Paint, Pictures, PixelFormat, Rect, Surface,
};

use super::{input::Input, texts::Last};

/// Columns and rows, or a column and a row.
type Pair = (i128, i128);

/// Where a box begins and ends.
type Ends = (i32, i32);

/// The texel at the centre of a pixel, in ratios of 128 bits, of a picture under a map. A centre on an edge stands a little to the
/// right and, much less, down.
pub fn texel(map: &Affine, (width, height): (u32, u32), (x, y): (i32, i32)) -> Option<(i32, i32)> {
    let [xx, xy, yx, yy, dx, dy] = [map.xx, map.xy, map.yx, map.yy, map.dx, map.dy].map(|n| i128::from(n.to_bits()));
    let (right, down) = (i128::from(x) * 65_536 + 32_768 - dx, i128::from(y) * 65_536 + 32_768 - dy);
    let d = xx * yy - xy * yx;
    let floor = |a: i128, b: i128| {
        let (a, b, d) = if d < 0 { (-a, -b, -d) } else { (a, b, d) };
        let twice = 2 * (a * right + b * down) - i128::from((a, b) < (0, 0));
        twice.div_euclid(2 * d)
    };
    if d == 0 {
        return None;
    }
    let (column, row) = (floor(yy, -xy), floor(-yx, xx));
    let is_in = (0..i128::from(width)).contains(&column) && (0..i128::from(height)).contains(&row);
    is_in.then_some((column as i32, row as i32))
}

/// The texel of a pixel in a box of so many that shows so many texels.
fn stretched(at: i128, pixels: i128, texels: i128) -> i128 {
    ((2 * at + 1) * texels).div_euclid(2 * pixels)
}

/// Ways to draw a picture.
#[derive(Debug)]
enum Blit {
    /// As it is.
    Plain(Point),
    /// Stretched to a box.
    Stretched(Rect),
    /// Under a map.
    Mapped(Affine),
    /// In nine parts, of which the middle one is stretched.
    Nine(Rect, Rect),
    /// As tiles of a size, in a map that begins at a place.
    Tiles(Point, (u16, u16)),
}

/// The tile in a cell of a map, of so many: now and then one that is not there, or none.
fn tile_at(column: i64, row: i64, tiles: i64) -> Option<usize> {
    let number = (column * 5 + row * 3).rem_euclid(tiles + 2);
    (number <= tiles).then_some(number as usize)
}

impl Blit {
    fn of(input: &mut Input<'_>, window: Rect) -> Self {
        let near = |input: &mut Input<'_>| Point::new(input.near(window.x0, 1), input.near(window.y0, 1));
        let number = |input: &mut Input<'_>| match input.byte() {
            n @ 0..128 => (i32::from(n) - 64) << 14,
            128..192 => 6 * input.within(-32_000, 32_000),
            _ => input.int(),
        };
        match input.below(5) {
            0 => Self::Plain(near(input)),
            1 => Self::Stretched(input.area_near(window)),
            2 => {
                let [xx, xy, yx, yy] = [(); 4].map(|()| I16F16::from_bits(number(input)));
                let at = near(input);
                let moved = |at: i32, by: i32| I16F16::from_bits(at.wrapping_shl(16).wrapping_add(by));
                let (dx, dy) = (moved(at.x, number(input)), moved(at.y, number(input)));
                Self::Mapped(Affine { xx, xy, dx, yx, yy, dy })
            }
            3 => Self::Nine(input.area_near(window), input.area_near(Rect::new(4, 4, 9, 9))),
            _ => Self::Tiles(near(input), (input.below(7) as u16, input.below(7) as u16)),
        }
    }

    fn draw<S: Surface<Color = Gray8>>(&self, on: &mut S, picture: &Bitmap<'_, Gray8>) {
        match *self {
            Self::Plain(at) => on.blit_mapped(at, picture, color),
            Self::Stretched(area) => on.blit_stretched(area, picture, color),
            Self::Mapped(map) => {
                let is_too_large =
                    [map.xx, map.xy, map.yx, map.yy].iter().any(|n| n.to_bits().unsigned_abs() >= 64 << 16);
                assert_eq!(on.blit_affine(&map, picture, color).is_err(), is_too_large, "{map:?}");
            }
            Self::Nine(area, middle) => on.blit_nine_patch(area, picture, middle, color),
            Self::Tiles(at, (width, height)) => {
                let sheet = Sheet::new(picture, width, height);
                let tiles = sheet.len() as i64;
                on.draw_tile_map(at, &sheet, |column, row| tile_at(column.into(), row.into(), tiles), color);
            }
        }
    }

    /// The texel that a pixel shows, of a picture of a size.
    fn texel(&self, size: Pair, (x, y): (i32, i32)) -> Option<Pair> {
        let from = |at: i32, origin: i32| i128::from(at) - i128::from(origin);
        match *self {
            Self::Plain(at) => Some((from(x, at.x), from(y, at.y))),
            Self::Stretched(area) => area.contains(x, y).then(|| {
                let (width, height) = (from(area.x1, area.x0), from(area.y1, area.y0));
                (stretched(from(x, area.x0), width, size.0), stretched(from(y, area.y0), height, size.1))
            }),
            Self::Mapped(map) => {
                let is_too_large =
                    [map.xx, map.xy, map.yx, map.yy].iter().any(|n| n.to_bits().unsigned_abs() >= 64 << 16);
                let is_near = [x, y].iter().all(|n| (-131_072..131_072).contains(n));
                let texel = texel(&map, (size.0 as u32, size.1 as u32), (x, y)).filter(|_| is_near && !is_too_large);
                texel.map(|(column, row)| (column.into(), row.into()))
            }
            Self::Nine(area, middle) => {
                let column = nine(x, (middle.x0, middle.x1), (area.x0, area.x1), size.0)?;
                Some((column, nine(y, (middle.y0, middle.y1), (area.y0, area.y1), size.1)?))
            }
            Self::Tiles(at, (width, height)) => {
                let (width, height) = (i128::from(width), i128::from(height));
                let (columns, rows) = (size.0.checked_div(width)?, size.1.checked_div(height)?);
                let (x, y) = (from(x, at.x), from(y, at.y));
                let (column, row) = (x.div_euclid(width) as i64, y.div_euclid(height) as i64);
                let number = tile_at(column, row, (columns * rows) as i64)? as i128;
                let (left, top) = (number.checked_rem(columns)? * width, number / columns * height);
                (number < columns * rows).then(|| (left + x.rem_euclid(width), top + y.rem_euclid(height)))
            }
        }
    }
}

/// Along one axis of a frame in nine parts, the texel at a pixel.
fn nine(at: i32, (start, end): Ends, (low, high): Ends, size: i128) -> Option<i128> {
    let start = i128::from(start).clamp(0, size);
    let end = i128::from(end).clamp(start, size);
    let length = (i128::from(high) - i128::from(low)).max(0);
    let (mut before, mut after) = (start, size - end);
    if before + after > length {
        before = before * length / (before + after);
        after = length - before;
    }
    let at = i128::from(at) - i128::from(low);
    let parts = [(0, 0, start, before), (start, before, end, length - after), (end, length - after, size, length)];
    let (from, low, to, high) = parts.into_iter().find(|&(_, low, _, high)| (low..high).contains(&at))?;
    (from < to).then(|| from + stretched(at - low, high - low, to - from))
}

/// Not the texel, and nothing where that is divisible by 8.
fn color(texel: Gray8) -> Option<Gray8> {
    (texel.luma() & 7 != 0).then(|| Gray8::new(texel.luma() ^ 0x55))
}

/// What the fuzz target `pictures` checks: a picture drawn in any way, anywhere, on a surface that knows spans and on a frame.
pub fn blits(data: &[u8]) {
    let mut input = Input(data);
    let mut window = input.window();
    let is_frame = input.one_in(2);
    if is_frame {
        window = Rect::new(0, 0, window.width() as i32, window.height() as i32);
    }
    let (width, height) = (input.below(20) as u16, input.below(14) as u16);
    let blit = Blit::of(&mut input, window);
    let first = input.byte();
    let texels: Vec<u8> = (0..width * height)
        .map(|n| if input.goes_on() { input.byte() } else { (n as u8).wrapping_add(first) })
        .collect();
    let picture = Bitmap::<Gray8>::new(&texels, width, height).expect("the right size");
    let at = |x: i32, y: i32| {
        let (column, row) = blit.texel((width.into(), height.into()), (x, y))?;
        let (column, row) = (i32::try_from(column).ok()?, i32::try_from(row).ok()?);
        picture.get(Point::new(column, row)).and_then(color)
    };
    let what = || format!("{blit:?} of {width} x {height} in {window:?}");
    let pixels = (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)));
    let wanted: BTreeMap<_, _> = pixels.clone().filter_map(|(x, y)| Some(((x.into(), y.into()), at(x, y)?))).collect();
    let mut last = Last(window, BTreeMap::new());
    blit.draw(&mut last, &picture);
    assert!(last.1 == wanted, "{}\ngot {:?}\nwanted {wanted:?}", what(), last.1);
    if is_frame {
        let mut ram = [0xaa; 16 * 16];
        let size = (window.width() as u16, window.height() as u16);
        let mut frame = Framebuffer::<Gray8>::new(&mut ram, size.0, size.1).expect("the right size");
        blit.draw(&mut frame, &picture);
        for (x, y) in pixels {
            let right = at(x, y).unwrap_or(Gray8::new(0xaa));
            assert_eq!(frame.get(Point::new(x, y)), Some(right), "({x}, {y}): {}", what());
        }
    }
}

/// What the fuzz target `patterns` checks: patterns, tiles and raster operations at any place, in a clip of a frame.
pub fn patterns(data: &[u8]) {
    let mut input = Input(data);
    match input.below(4) {
        0 => every_pattern::<Index1>(&mut input),
        1 => every_pattern::<Lsb0<Index4>>(&mut input),
        2 => every_pattern::<Gray8>(&mut input),
        _ => every_pattern::<Rgb565>(&mut input),
    }
}

fn every_pattern<F: PixelFormat<Color: PixelFormat<Color = F::Color> + core::fmt::Debug>>(input: &mut Input<'_>) {
    const SIDE: u16 = 16;
    let window = Rect::new(0, 0, SIDE.into(), SIDE.into());
    let mut bits = || (u32::from(input.byte()) << 8 | u32::from(input.byte())) & (u32::MAX >> (32 - F::BITS));
    let (on, off) = (bits(), bits());
    let [color, ground] = [on, off].map(F::unpack);
    let (clip, area) = (input.area_near(window), input.area_near(window));
    let origin = Point::new(input.near(0, 1), input.near(0, 1));
    let from = |at: i32, origin: i32, size: i64| (i64::from(at) - i64::from(origin)).rem_euclid(size) as i32;
    let mut shape = Filled { clip, area, before: (0..512).map(|n| n as u8 ^ input.byte()).collect() };
    match input.below(6) {
        0 | 1 => {
            let rows = [(); 8].map(|()| input.byte());
            let off = input.one_in(2).then_some(ground);
            let paint = Pattern::new(rows, color, off).at(origin);
            let is_set = |x, y| rows[from(y, origin.y, 8) as usize] << from(x, origin.x, 8) & 0x80 != 0;
            shape.check::<F>(paint, |x, y, old| if is_set(x, y) { color } else { off.unwrap_or(old) });
        }
        2 => {
            let (width, height) = (input.below(6) as u16, input.below(6) as u16);
            let texels: Vec<u8> = (0..width * height).map(|_| input.byte()).collect();
            let tile = Bitmap::<Gray8>::new(&texels, width, height).expect("the right size");
            let texel =
                |texel: Gray8| (texel.luma() & 3 != 0).then(|| if texel.luma() & 4 == 0 { color } else { ground });
            let wanted = |x, y, old| {
                if width == 0 || height == 0 {
                    return old;
                }
                let place = Point::new(from(x, origin.x, width.into()), from(y, origin.y, height.into()));
                tile.get(place).and_then(texel).unwrap_or(old)
            };
            shape.check::<F>(Tiles::new(&tile, texel).at(origin), wanted);
        }
        3 => shape.check::<F>(RasterOp::and(color), |_, _, old| F::unpack(F::pack(old) & on)),
        4 => shape.check::<F>(RasterOp::or(color), |_, _, old| F::unpack(F::pack(old) | on)),
        _ => shape.check::<F>(RasterOp::xor(color), |_, _, old| F::unpack(F::pack(old) ^ on)),
    }
}

/// A rectangle in a clip, on noise.
struct Filled {
    clip: Rect,
    area: Rect,
    before: Vec<u8>,
}

impl Filled {
    fn check<F: PixelFormat<Color: core::fmt::Debug>>(
        &mut self,
        paint: impl for<'a> Paint<Frame<&'a mut [u8], Rows<F>>>,
        wanted: impl Fn(i32, i32, F::Color) -> F::Color,
    ) {
        let mut ram = self.before.clone();
        let mut frame = Framebuffer::<F>::new(&mut ram, 16, 16).expect("two bytes a pixel are enough");
        let old = Framebuffer::<F>::new(&mut self.before, 16, 16).expect("two bytes a pixel are enough");
        frame.clipped(self.clip).paint(paint, |window, brush| rectangle::fill(self.area, window, brush));
        for (x, y) in (0..16).flat_map(|y| (0..16).map(move |x| (x, y))) {
            let was = old.get(Point::new(x, y)).expect("inside");
            let is_in = self.clip.contains(x, y) && self.area.contains(x, y);
            let right = if is_in { wanted(x, y, was) } else { was };
            assert_eq!(frame.get(Point::new(x, y)), Some(right), "({x}, {y}): {:?} in {:?}", self.area, self.clip);
        }
    }
}

/// Where parts of an error go: columns to the right, rows down, and how many parts; and how many there are in all.
pub type Parts = (&'static [(i32, i32, i64)], i64);

/// Those of [`FloydSteinberg`].
pub const FLOYD_STEINBERG: Parts = (&[(1, 0, 7), (-1, 1, 3), (0, 1, 5), (1, 1, 1)], 16);
/// Those of [`Atkinson`].
pub const ATKINSON: Parts = (&[(1, 0, 1), (2, 0, 1), (-1, 1, 1), (0, 1, 1), (1, 1, 1), (0, 2, 1)], 8);

/// The picture that a rule makes of levels, with all errors in one large table.
pub fn diffused(levels: &[u8], width: i32, (parts, all): Parts, shown: impl Fn(u8) -> u8) -> Vec<u8> {
    let height = levels.len() as i32 / width;
    let mut handed = vec![0_i64; levels.len()];
    let mut picture = vec![];
    for (x, y) in (0..height).flat_map(|y| (0..width).map(move |x| (x, y))) {
        let here = (y * width + x) as usize;
        // To the nearest, halves upwards.
        let level = i64::from(levels[here]) + (2 * handed[here] + all).div_euclid(2 * all);
        let level = level.clamp(0, 255) as u8;
        let error = i64::from(level) - i64::from(shown(level));
        for &(right, down, part) in parts {
            if (0..width).contains(&(x + right)) && y + down < height {
                handed[((y + down) * width + x + right) as usize] += part * error;
            }
        }
        picture.push(shown(level));
    }
    picture
}

/// What the fuzz target `diffusion` checks: any levels shown by any few others.
pub fn diffusion(data: &[u8]) {
    let mut input = Input(data);
    let width = input.within(1, 20);
    let palette: Vec<u8> = (0..input.within(1, 5)).map(|_| input.byte()).collect();
    let shown = |level: u8| *palette.iter().min_by_key(|&&entry| entry.abs_diff(level)).expect("one at least");
    let nearest = |[level]: [u8; 1]| (shown(level), [shown(level)]);
    let mut row = vec![[i16::from(input.byte()) << 7]; width as usize];
    let mut two = vec![[[i16::from(input.byte()) << 7]; 2]; width as usize];
    // Whole rows.
    let mut levels = input.0.to_vec();
    levels.truncate(levels.len() / width as usize * width as usize);
    let mut rule = FloydSteinberg::new(&mut row);
    let picture: Vec<u8> = levels.iter().map(|&level| rule.next([level], nearest)).collect();
    assert_eq!(picture, diffused(&levels, width, FLOYD_STEINBERG, shown), "{width} wide, of {palette:?}");
    let mut rule = Atkinson::new(&mut two);
    let picture: Vec<u8> = levels.iter().map(|&level| rule.next([level], nearest)).collect();
    assert_eq!(picture, diffused(&levels, width, ATKINSON, shown), "{width} wide, of {palette:?}, by Atkinson");
}
