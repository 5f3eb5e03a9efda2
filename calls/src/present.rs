//! The list of what hands frames to a display: buffers and bands. Futures are not in it, as all of them panic when they are polled
//! again after their end; nor are queues, which are those of the crate heapless.

use core::task::{Context, Waker};

use embedded_raster::{
    present::{for_each_band, Bands, Buffer, Pulse, Swapchain, Vsync},
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
    "Swapchain::begin_blocking", "Vsync::wait" => waited(a);
    "Pulse::new", "Pulse::signal", "Vsync::is_due", "Vsync::poll_due" => {
        let (pulse, mut sum) = (Pulse::new(), 0_u32);
        for operation in a.operations {
            let mut task = Context::from_waker(Waker::noop());
            let is_due = match operation & 3 {
                0 => (&pulse).is_due(),
                1 => (&pulse).poll_due(&mut task).is_ready(),
                2 => (|| operation & 4 == 0).poll_due(&mut task).is_ready(),
                _ => {
                    pulse.signal();
                    continue;
                }
            };
            sum = sum.wrapping_mul(2).wrapping_add(is_due.into());
        }
        sum
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
    "bands::for_each_band" => {
        let [width, height, rows] = a.size;
        let (mut memory, mut left) = ([0; 96], 40_u32);
        let draw = |band: &mut Frame<&mut [u8], Rows<Index4>>| band.clear(Index4::new(3));
        // The display refuses after some.
        let sent = for_each_band(&mut memory, width, height, rows, draw, |_| {
            left = left.checked_sub(1).ok_or(BufferError::TooSmall { needed: 1, given: 0 })?;
            Ok::<(), BufferError>(())
        });
        left.wrapping_add(sent.is_ok().into())
    };
}

fn digest(buffer: &Buffer<u8>) -> u32 {
    buffer
        .age()
        .map_or(0, |age| age.get().wrapping_add(buffer.frame()))
        .wrapping_mul(31)
        .wrapping_add((**buffer).into())
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
        let mut vsync = || {
            waits = waits.wrapping_add(1);
            true
        };
        vsync.wait();
        let begun = chain.begin_blocking(&mut vsync, |shown| sum = sum.wrapping_add(digest(shown)));
        sum = sum.wrapping_add(waits);
        match begun {
            Some(buffer) if operation & 2 == 0 => chain.finish(buffer),
            Some(buffer) => chain.cancel(buffer),
            None => {}
        }
    }
    sum
}
