//! A frame that several threads draw at once, in parts that were cut from it.

use std::thread;

use crate::scene;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{
    pixel::{Lsb0, Rgb444},
    surface::{Grid, Packed12, Pages, Planes, Rows},
    BufferError, Frame, Index1, Index2, Index4, Layout, PixelFormat, Rect,
};

/// Draws the scene in so many parts, each in a thread.
fn in_parts<F: PixelFormat, L: Layout<Color = F::Color> + Send>(frame: Frame<&mut [u8], L>, parts: i32) {
    let color = |n: u32| F::unpack(n & (u32::MAX >> (32 - F::BITS)));
    let window = frame.window();
    let page = i32::from(L::PAGE);
    let mut rest = frame;
    thread::scope(|scope| {
        for part in 1..parts {
            let row = (window.y0 + (window.y1 - window.y0) * part / parts) / page * page;
            let (mut above, below) = rest.split_at_row(row).expect("a row that shares no bytes with the one above");
            scope.spawn(move || scene(&mut above, color));
            rest = below;
        }
        scene(&mut rest, color);
    });
}

const WIDTH: u16 = 41;
const HEIGHT: u16 = 29;

fn strided<L: Layout>(memory: &mut [u8], grid: Grid) -> Frame<&mut [u8], L> {
    Frame::with_stride(memory, WIDTH, HEIGHT, grid.stride).expect("the right size")
}

fn check<F: PixelFormat, L: Layout<Color = F::Color> + Send>() {
    let color = |n: u32| F::unpack(n & (u32::MAX >> (32 - F::BITS)));
    let (width, height) = (WIDTH, HEIGHT);
    for gap in [0, 3] {
        let grid = Grid { stride: L::row_bytes(width) + gap, rows: height.into() };
        let mut whole = vec![0xA5; L::bytes(width, grid)];
        scene(&mut strided::<L>(&mut whole, grid), color);
        for parts in 1..=8 {
            let mut memory = vec![0xA5; L::bytes(width, grid)];
            in_parts::<F, L>(strided(&mut memory, grid), parts);
            assert_eq!(memory, whole, "{parts} parts, {gap} bytes between rows");
        }
    }
    // A view, and a band: their rows are counted from elsewhere.
    let mut memory = vec![0; L::bytes(width, Grid { stride: L::row_bytes(width), rows: height.into() })];
    let mut whole = memory.clone();
    let area = Rect::new(3, 8, 30, 26);
    scene(&mut Frame::<_, L>::new(&mut whole[..], width, height).expect("the right size").view(area), color);
    in_parts::<F, L>(Frame::<_, L>::new(&mut memory[..], width, height).expect("the right size").view(area), 2);
    assert_eq!(memory, whole, "a view");
    let rows = 8..29;
    scene(&mut Frame::<_, L>::band(&mut whole[..], width, height, rows.clone()).expect("the right size"), color);
    in_parts::<F, L>(Frame::<_, L>::band(&mut memory[..], width, height, rows).expect("the right size"), 2);
    assert_eq!(memory, whole, "a band");
}

#[test]
fn parts_are_the_whole() {
    check::<Rgb565, Rows<Rgb565>>();
    check::<Index4, Rows<Index4>>();
    check::<Lsb0<Index1>, Rows<Lsb0<Index1>>>();
    check::<Index1, Pages<Index1>>();
    check::<Rgb444, Packed12>();
}

#[test]
fn rows_outside_leave_one_part_empty() {
    let mut memory = [0; 64];
    let mut frame = Frame::<_, Rows<Index4>>::new(&mut memory[..], 8, 8).expect("the right size");
    let whole = frame.window();
    for row in [i32::MIN, -1, 0] {
        let (above, below) = frame.as_mut().split_at_row(row).expect("rows");
        assert!(above.window().is_empty() && below.window() == whole, "above row {row}");
    }
    for row in [8, 9, i32::MAX] {
        let (above, below) = frame.as_mut().split_at_row(row).expect("rows");
        assert!(above.window() == whole && below.window().is_empty(), "above row {row}");
    }
}

#[test]
fn rows_that_share_bytes_are_not_cut() {
    let mut memory = [0; 64];
    let mut pages = Frame::<_, Pages<Index1>>::new(&mut memory[..], 8, 20).expect("the right size");
    for row in 0..=20 {
        let cut = pages.as_mut().split_at_row(row).map(|_| ());
        let wanted = if [0, 8, 16, 20].contains(&row) { Ok(()) } else { Err(BufferError::CutInPage { row, page: 8 }) };
        assert_eq!(cut, wanted);
    }
    let planes = Frame::<_, Planes<Index2>>::new(&mut memory[..], 8, 8).expect("the right size");
    let error = planes.split_at_row(3).err();
    assert_eq!(error, Some(BufferError::RowsApart { row: 3 }));
    assert_eq!(
        error.map(|error| error.to_string()).as_deref(),
        Some("no cut above row 3: the rows do not lie one after the other in memory")
    );
}
