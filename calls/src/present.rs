//! The list of everything that hands frames to a display: buffers and bands.

use core::{
    future::Future,
    pin::pin,
    task::{Context, Poll, Waker},
};

use embedded_raster::{
    present::{for_each_band, for_each_band_async, Bands, Buffer, Queues, Swapchain, Vsync},
    surface::Rows,
    BufferError, Frame, Index4,
};

/// What calls are made with: any numbers.
#[derive(Clone, Copy, Debug)]
pub struct Arguments {
    /// What is done to buffers, one after the other.
    pub operations: [u8; 12],
    /// Columns and rows of a screen, and rows of a band.
    pub size: [u16; 3],
}

/// Calls by name: a constant list and a function out of the same lines, so none can be in one and not in the other.
macro_rules! calls {
    ($a:ident; $($($name:literal),+ => $call:expr;)*) => {
        /// The names of the calls, with their type or their module.
        pub const NAMES: &[&str] = &[$($($name),+),*];

        /// Makes the call of the name of this number in [`NAMES`]. What it answered, as a number.
        pub fn call($a: &Arguments, number: usize) -> u32 {
            let mut numbers = 0..usize::MAX;
            $($(
                let _ = $name;
                if numbers.next() == Some(number) {
                    return $call;
                }
            )+)*
            0
        }
    };
}

calls! { a;
    "Buffer::age", "Buffer::frame", "Buffer::deref", "Buffer::deref_mut", "Buffer::into_inner" => {
        let mut chain = Swapchain::new([a.operations[0]]);
        chain.begin().map_or(0, |mut buffer| {
            *buffer = buffer.wrapping_add(a.operations[1]);
            digest(&buffer).wrapping_add(buffer.into_inner().into())
        })
    };
    "Swapchain::new", "Swapchain::begin", "Swapchain::finish", "Swapchain::cancel", "Swapchain::flip", "Swapchain::shown" => {
        chained::<1>(a).wrapping_add(chained::<2>(a)).wrapping_add(chained::<3>(a))
    };
    "Swapchain::begin_blocking", "Swapchain::begin_async", "Vsync::wait" => waited(a);
    "Queues::new", "Queues::default", "Queues::split", "Drawer::begin", "Drawer::finish", "Drawer::cancel", "Drawer::hand_over",
    "Display::flip", "Display::shown", "Drawer::begin_blocking", "Drawer::begin_async" => {
        queued::<2, 3>(a).wrapping_add(queued::<3, 4>(a)).wrapping_add(queued::<1, 5>(a))
    };
    "Bands::new", "Bands::next_band" => {
        let [width, height, rows] = a.size;
        let mut memory = [0; 96];
        let Ok(mut bands) = Bands::<Rows<Index4>>::new(&mut memory, width, height, rows) else { return 1 };
        let mut sum = 0_u32;
        // As many as the numbers say, but not all of thousands.
        for _ in 0..40 {
            let Some(band) = bands.next_band() else { break };
            sum = sum.wrapping_mul(31).wrapping_add(band.window().y1.cast_unsigned());
        }
        sum
    };
    "bands::for_each_band", "bands::for_each_band_async" => {
        let [width, height, rows] = a.size;
        let (mut memory, mut other, mut sum) = ([0; 96], [0; 96], 0_u32);
        // The display refuses after some.
        let mut left = [40; 2];
        let refused = BufferError::TooSmall { needed: 1, given: 0 };
        let mut take = |i: usize| {
            let left = left.get_mut(i).and_then(|left: &mut u32| left.checked_sub(1).map(|next| *left = next));
            left.ok_or(refused)
        };
        let draw = |band: &mut Frame<&mut [u8], Rows<Index4>>| band.clear(Index4::new(3));
        let first = for_each_band(&mut memory, width, height, rows, draw, |_| take(0));
        let second = for_each_band_async(
            [&mut memory, &mut other],
            width,
            height,
            rows,
            |band: &mut Frame<&mut [u8], Rows<Index4>>| sum = sum.wrapping_add(band.window().y0.cast_unsigned()),
            async |_| take(1),
        );
        let second = poll(second);
        sum.wrapping_add(first.is_ok().into()).wrapping_add(second.is_some_and(|result| result.is_ok()).into())
    };
}

fn digest(buffer: &Buffer<u8>) -> u32 {
    buffer
        .age()
        .map_or(0, |age| age.get().wrapping_add(buffer.frame()))
        .wrapping_mul(31)
        .wrapping_add((**buffer).into())
}

/// Polls some times; whoever is not ready then is dropped.
fn poll<T>(future: impl Future<Output = T>) -> Option<T> {
    let mut future = pin!(future);
    for _ in 0..4 {
        if let Poll::Ready(result) = future.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return Some(result);
        }
    }
    None
}

fn chained<const N: usize>(a: &Arguments) -> u32 {
    let mut chain = Swapchain::new([7; N]);
    let (mut drawn, mut sum) = ([None, None], 0_u32);
    for operation in a.operations {
        let [first, second] = &mut drawn;
        let place = if operation & 8 == 0 { first } else { second };
        match (operation & 7, place.take()) {
            (0 | 1, None) => *place = chain.begin(),
            (0..=4, Some(buffer)) => chain.finish(buffer),
            (5, Some(buffer)) => chain.cancel(buffer),
            (_, other) => {
                *place = other;
                sum = sum.wrapping_mul(31).wrapping_add(chain.flip().map_or(1, digest));
            }
        }
    }
    sum.wrapping_add(chain.shown().map_or(0, digest))
}

fn waited(a: &Arguments) -> u32 {
    let (mut chain, mut sum) = (Swapchain::new([7; 2]), 0_u32);
    for operation in a.operations {
        let mut waits = 0_u32;
        let begun = if operation & 1 == 0 {
            let mut vsync = || waits = waits.wrapping_add(1);
            vsync.wait();
            chain.begin_blocking(&mut vsync, |shown| sum = sum.wrapping_add(digest(shown)))
        } else {
            poll(chain.begin_async(async || waits = waits.wrapping_add(1), |_| ())).flatten()
        };
        sum = sum.wrapping_add(waits);
        match begun {
            Some(buffer) if operation & 2 == 0 => chain.finish(buffer),
            Some(buffer) => chain.cancel(buffer),
            None => {}
        }
    }
    sum
}

fn queued<const M: usize, const N: usize>(a: &Arguments) -> u32 {
    let mut queues = if M == 2 { Queues::<u8, N>::new() } else { Queues::default() };
    let Ok((mut drawer, mut display)) = queues.split([7; M]) else { return 3 };
    let (mut drawn, mut sum) = (None, 0_u32);
    for operation in a.operations {
        match (operation & 7, drawn.take()) {
            (0, None) => drawn = drawer.begin(),
            // One buffer is free, or is the moment after.
            (1, None) => {
                drawn = drawer.begin_blocking(|| {
                    display.flip();
                });
            }
            // Nobody flips meanwhile: it is given up.
            (2, None) => drawn = poll(drawer.begin_async(core::future::pending)).flatten(),
            (0..=3, Some(buffer)) => drawer.finish(buffer),
            (4, Some(buffer)) => drawer.cancel(buffer),
            (5, other) => {
                drawn = other;
                drawer.hand_over();
            }
            (_, other) => {
                drawn = other;
                sum = sum.wrapping_mul(31).wrapping_add(display.flip().map_or(1, digest));
            }
        }
    }
    sum.wrapping_add(display.shown().map_or(0, digest))
}
