//! Bands are the whole picture, whatever their height, one by one and two at a time.

use std::{
    future::Future,
    pin::pin,
    task::{Context, Poll, Waker},
};

use crate::scene;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_raster::{
    pixel::Rgb444,
    present::{for_each_band, for_each_band_async},
    surface::{Grid, Packed12, Pages, Planes, Rows},
    BufferError, Frame, Index1, Index2, Index4, Layout, PixelFormat,
};

fn run<T>(future: impl Future<Output = T>) -> T {
    let mut future = pin!(future);
    for _ in 0..1_000 {
        if let Poll::Ready(result) = future.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return result;
        }
    }
    panic!("it does not end");
}

/// Is not ready when it is polled first, nor second.
async fn wire() {
    let mut polls = 0;
    std::future::poll_fn(|_| {
        polls += 1;
        if polls > 2 {
            Poll::Ready(())
        } else {
            Poll::Pending
        }
    })
    .await;
}

fn check<F: PixelFormat, L: Layout<Color = F::Color>>() {
    let color = |n: u32| F::unpack(n & (u32::MAX >> (32 - F::BITS)));
    let (width, height) = (41_u16, 29_u16);
    let bytes = |rows: u16| L::bytes(width, Grid { stride: L::row_bytes(width), rows: rows.into() });
    let mut memory = vec![0; bytes(height)];
    let mut whole = Frame::<_, L>::new(&mut memory[..], width, height).expect("the right size");
    scene(&mut whole, color);
    let whole = whole.as_bitmap();
    for rows in 1..height + 3 {
        let given = bytes(rows.min(height));
        let (mut memory, mut other) = (vec![0; given], vec![0xA5; given]);
        let mut next = 0;
        let same = |band: &Frame<&[u8], L>, next: &mut i32| {
            let window = band.window();
            assert_eq!((window.x0, window.x1, window.y0), (0, i32::from(width), *next), "bands follow each other");
            assert!(band.colors(window).eq(whole.colors(window)), "a band of {rows} rows from row {next}");
            *next = window.y1;
        };
        let sent = for_each_band::<L, BufferError>(
            &mut memory,
            width,
            height,
            rows,
            |band| scene(band, color),
            |band| {
                same(&band, &mut next);
                Ok(())
            },
        );
        if rows < height && rows % L::PAGE != 0 {
            assert_eq!(sent, Err(BufferError::BandSplitsPage { start: 0, end: rows, page: L::PAGE }), "{rows} rows");
            continue;
        }
        assert_eq!((sent, next), (Ok(()), i32::from(height)), "{rows} rows");
        let mut next = 0;
        let draw = |band: &mut Frame<&mut [u8], L>| scene(band, color);
        let sent = run(for_each_band_async::<L, BufferError>(
            [&mut memory, &mut other],
            width,
            height,
            rows,
            draw,
            async |band: Frame<&[u8], L>| {
                same(&band, &mut next);
                wire().await;
                // While it was sent, the next one was drawn beside it.
                assert!(band.colors(band.window()).eq(whole.colors(band.window())), "it is still there");
                Ok(())
            },
        ));
        assert_eq!((sent, next), (Ok(()), i32::from(height)), "{rows} rows, two bands");
    }
}

#[test]
fn bands_of_every_height_are_the_whole() {
    check::<Rgb565, Rows<Rgb565>>();
    check::<Index4, Rows<Index4>>();
    check::<Index1, Pages<Index1>>();
    check::<Index2, Planes<Index2>>();
    check::<Rgb444, Packed12>();
}

#[test]
fn errors_come_before_anything_is_drawn() {
    let mut drawn = 0;
    let mut bands = |memory: &mut [u8], height, rows| {
        for_each_band::<Rows<Rgb565>, BufferError>(memory, 10, height, rows, |_| drawn += 1, |_| Ok(()))
    };
    assert_eq!(bands(&mut [0; 39], 10, 2), Err(BufferError::TooSmall { needed: 40, given: 39 }));
    assert_eq!(bands(&mut [0; 40], 10, 0), Err(BufferError::BandOutsideScreen { start: 0, end: 0, height: 10 }));
    assert_eq!(bands(&mut [], 0, 0), Ok(()), "a screen without rows");
    assert_eq!(drawn, 0);
}

#[test]
fn the_first_error_of_the_display_ends_it() {
    let mut drawn = 0;
    let mut memory = [0; 40];
    let send = |band: Frame<&[u8], Rows<Rgb565>>| {
        if band.window().y0 < 4 {
            Ok(())
        } else {
            Err(BufferError::TooSmall { needed: 1, given: 0 })
        }
    };
    let sent = for_each_band(&mut memory, 10, 10, 2, |_| drawn += 1, send);
    assert_eq!((sent, drawn), (Err(BufferError::TooSmall { needed: 1, given: 0 }), 3));
}
