//! Frames of random pixels, and areas of them.

use embedded_raster::{
    surface::{Grid, Layout},
    Frame, Rect,
};
use twins::rng::Rng;

/// Memory of a frame whose bits are all random, those of gaps between the rows included; and its stride.
pub(crate) fn memory<L: Layout>(rng: &mut Rng, (width, height): (u16, u16)) -> (Vec<u8>, usize) {
    let gap = if rng.one_in(2) { 0 } else { rng.index(4) };
    let stride = L::row_bytes(width) + gap;
    let bytes = L::bytes(width, Grid { stride, rows: height.into() });
    ((0..bytes).map(|_| rng.bits() as u8).collect(), stride)
}

/// A picture to read.
pub(crate) fn frame<L: Layout>(memory: &(Vec<u8>, usize), (width, height): (u16, u16)) -> Frame<&[u8], L> {
    Frame::with_stride(&memory.0[..], width, height, memory.1).expect("the right size")
}

/// A picture or a view of a larger one.
pub(crate) fn sizes(rng: &mut Rng) -> (u16, u16) {
    (rng.int(1, 40) as u16, rng.int(1, 20) as u16)
}

/// An area that may lie beside a picture, or be empty.
pub(crate) fn area(rng: &mut Rng) -> Rect {
    let side = |rng: &mut Rng| match rng.below(12) {
        0 => rng.pick(&[i32::MIN, i32::MIN + 1, i32::MAX, i32::MAX - 1]),
        1 => rng.bits() as i32,
        _ => rng.int(-5, 45),
    };
    let (a, b, c, d) = (side(rng), side(rng), side(rng), side(rng));
    if rng.one_in(4) {
        Rect::new(a, b, c, d)
    } else {
        Rect::new(a.min(c), b.min(d), a.max(c), b.max(d))
    }
}

/// An area whose corner is at most a few pixels beside a picture: what a view of it shows lies near its corner.
pub(crate) fn part(rng: &mut Rng) -> Rect {
    let (x, y) = (rng.int(-3, 40), rng.int(-3, 20));
    Rect::new(x, y, rng.int(x, 45), rng.int(y, 45))
}

/// Some areas.
pub(crate) fn areas(rng: &mut Rng) -> Vec<Rect> {
    (0..rng.index(4)).map(|_| area(rng)).collect()
}
