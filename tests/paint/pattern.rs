//! Patterns, tiles and raster operations, pixel by pixel, on every layout.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray2, Gray4, Rgb555, Rgb565, Rgb888},
};
use embedded_raster::{
    paint::{
        pattern::{self, Pattern},
        RasterOp, Tiles,
    },
    pixel::{Be, Lsb0, Xrgb8888},
    raster::ellipse,
    surface::{Packed12, Pages, Planes, Rows},
    Bitmap, Canvas, ClippedSpan, Ellipse, Frame, Index1, Index2, Index4, Index8, Layout, Paint, PixelFormat, Rect,
};
use twins::{
    relay::Relay,
    rng::{cases, Rng},
};

const WIDTH: i32 = 40;
const HEIGHT: i32 = 24;

/// What a layout of these tests has: colours with bits.
trait Tested: Layout<Color: PixelFormat<Color = Self::Color> + core::fmt::Debug> {
    fn mask() -> u32 {
        u32::MAX >> (32 - Self::Color::BITS)
    }
    fn color(bits: u64) -> Self::Color {
        Self::Color::unpack(bits as u32 & Self::mask())
    }
}
impl<L: Layout<Color: PixelFormat<Color = L::Color> + core::fmt::Debug>> Tested for L {}

/// Paints a disc on a screen full of noise, in a clip of a band, or of a view of it, and compares each pixel with what `wanted` makes
/// of its place and its old colour. Places are those that the paint sees.
fn check<L: Tested, P>(rng: &mut Rng, paint: P, wanted: impl Fn(i32, i32, L::Color) -> L::Color, what: &str)
where
    P: for<'a> Paint<Frame<&'a mut [u8], L>>,
{
    let mut ram: Vec<u8> = (0..WIDTH * HEIGHT * 4).map(|_| rng.bits() as u8).collect();
    let mut before = ram.clone();
    let disc = Ellipse::in_box(Rect::new(rng.int(-5, 20), rng.int(-5, 10), rng.int(21, 45), rng.int(11, 30)));
    let clip = Rect::new(rng.int(-3, 20), rng.int(-3, 12), rng.int(10, 50), rng.int(6, 30));
    let first = rng.int(0, 1) as u16 * 8;
    let rows = first..first + 16;
    let mut frame = Frame::<_, L>::band(&mut ram[..], WIDTH as u16, HEIGHT as u16, rows.clone()).unwrap();
    let old = Frame::<_, L>::band(&mut before[..], WIDTH as u16, HEIGHT as u16, rows.clone()).unwrap();
    let area = if rng.one_in(3) { Rect::new(4, 9, 33, 15) } else { Rect::new(0, 0, WIDTH, HEIGHT) };
    let mut view = frame.view(area);
    view.clipped(clip).paint(paint, |window, mut brush| ellipse::fill(disc, window, Relay(&mut brush)));
    let mut in_disc = [false; (WIDTH * HEIGHT) as usize];
    ellipse::fill(disc, Rect::new(0, 0, WIDTH, HEIGHT), |span: ClippedSpan| {
        (span.x0()..span.x1()).for_each(|x| in_disc[(span.y() * WIDTH + x) as usize] = true);
    });
    for (x, y) in rows.flat_map(|y| (0..WIDTH).map(move |x| (x, i32::from(y)))) {
        let was = old.get(Point::new(x, y)).unwrap();
        // In the view.
        let (i, j) = (x - area.x0, y - area.y0);
        let is_in = area.contains(x, y) && clip.contains(i, j) && in_disc[(j * WIDTH + i) as usize];
        let right = if is_in { wanted(i, j, was) } else { was };
        assert_eq!(frame.get(Point::new(x, y)), Some(right), "{what} at {x}, {y}: {disc:?} in {clip:?} of {area:?}");
    }
}

const HATCHINGS: [[u8; 8]; 9] = [
    pattern::HORIZONTAL,
    pattern::VERTICAL,
    pattern::DIAGONAL,
    pattern::BACK_DIAGONAL,
    pattern::GRID,
    pattern::DIAGONAL_GRID,
    pattern::CHECKER,
    pattern::DOTS,
    pattern::BRICKS,
];

/// A place near, or anywhere.
fn place(rng: &mut Rng) -> Point {
    if rng.one_in(4) {
        Point::new(rng.bits() as i32, rng.bits() as i32)
    } else {
        Point::new(rng.int(-9, 30), rng.int(-9, 30))
    }
}

fn every_paint<L: Tested>() {
    let mut rng = Rng::new(L::row_bytes(99) as u64);
    for _ in 0..cases(300) {
        let (on, off) = (L::color(rng.bits()), L::color(rng.bits()));
        let rows = if rng.one_in(2) { rng.pick(&HATCHINGS) } else { [(); 8].map(|()| rng.bits() as u8) };
        let off = rng.one_in(2).then_some(off);
        let origin = place(&mut rng);
        let bit = |x: i32, y: i32| {
            let column = (i64::from(x) - i64::from(origin.x)).rem_euclid(8);
            rows[(i64::from(y) - i64::from(origin.y)).rem_euclid(8) as usize] << column & 0x80 != 0
        };
        let wanted = |x, y, old| if bit(x, y) { on } else { off.unwrap_or(old) };
        check::<L, _>(&mut rng, Pattern::new(rows, on, off).at(origin), wanted, "a pattern");

        // A tile out of the middle of a picture, all but one of its colours.
        let texels: Vec<u8> = (0..30).map(|_| rng.bits() as u8).collect();
        let (left, top, right, bottom) = (rng.int(0, 3), rng.int(0, 2), rng.int(0, 9), rng.int(0, 6));
        let picture = Bitmap::<Index4>::new(&texels, 9, 6).unwrap().view(Rect::new(left, top, right, bottom));
        let size = picture.size();
        let color = |index: Index4| (index.index() != 5).then(|| L::color(u64::from(index.index()) * 0x0123_4567));
        let texel = |x: i32, y: i32| {
            let column = (i64::from(x) - i64::from(origin.x)).rem_euclid(size.width.into());
            let row = (i64::from(y) - i64::from(origin.y)).rem_euclid(size.height.into());
            picture.get(Point::new(column as i32, row as i32)).unwrap()
        };
        let is_empty = size.width == 0 || size.height == 0;
        let wanted = |x, y, old| if is_empty { old } else { color(texel(x, y)).unwrap_or(old) };
        check::<L, _>(&mut rng, Tiles::new(&picture, color).at(origin), wanted, "tiles");

        let (bits, all) = (L::Color::pack(on), L::mask());
        let new = |bits: u32| L::color(bits.into());
        let old = |color| L::Color::pack(color);
        check::<L, _>(&mut rng, RasterOp::and(on), |_, _, c| new(old(c) & bits), "and");
        check::<L, _>(&mut rng, RasterOp::or(on), |_, _, c| new(old(c) | bits), "or");
        check::<L, _>(&mut rng, RasterOp::xor(on), |_, _, c| new(old(c) ^ bits), "xor");
        check::<L, _>(&mut rng, RasterOp::invert(), |_, _, c| new(old(c) ^ all), "invert");
    }
}

#[test]
fn patterns_tiles_and_raster_operations_on_every_layout() {
    every_paint::<Rows<Index1>>();
    every_paint::<Rows<Lsb0<BinaryColor>>>();
    every_paint::<Rows<Gray2>>();
    every_paint::<Rows<Lsb0<Index2>>>();
    every_paint::<Rows<Index4>>();
    every_paint::<Rows<Lsb0<Gray4>>>();
    every_paint::<Rows<Index8>>();
    every_paint::<Rows<Rgb555>>();
    every_paint::<Rows<Be<Rgb565>>>();
    every_paint::<Rows<Rgb888>>();
    every_paint::<Rows<Be<Xrgb8888>>>();
    every_paint::<Pages<Lsb0<Index1>>>();
    every_paint::<Planes<Index2>>();
    every_paint::<Packed12>();
}

/// Neighbours differ: a hatching that is one colour would tell nothing apart.
#[test]
fn hatchings_have_both_colors_in_every_direction() {
    for rows in HATCHINGS {
        let set: u32 = rows.map(u8::count_ones).iter().sum();
        assert!((8..=40).contains(&set), "{rows:x?}");
        assert_eq!(HATCHINGS.iter().filter(|other| **other == rows).count(), 1, "{rows:x?} is there twice");
    }
}

/// Each shade has the pixels of the one below, and one more.
#[test]
fn shades_grow() {
    let mut before = [0; 8];
    for n in 0..=64 {
        let rows = pattern::shade(n);
        assert_eq!(rows.map(u8::count_ones).iter().sum::<u32>(), n);
        assert!(before.iter().zip(rows).all(|(before, now)| before & !now == 0), "shade {n}");
        before = rows;
    }
    assert_eq!(pattern::shade(u32::MAX), [0xff; 8]);
}
