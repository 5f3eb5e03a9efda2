//! Buffers between two threads: what is shown is whole, and never older than what was shown before.

use std::{
    sync::atomic::{AtomicU32, Ordering},
    thread,
};

use embedded_raster::present::{Display, Drawer, Queues};

/// A picture is one number in every place.
type Picture = Vec<u32>;

/// Draws until so many frames have been seen. Returns how often the drawer waited.
fn run((mut drawer, mut display): (Drawer<'_, Picture>, Display<'_, Picture>), frames: u32) -> u32 {
    let seen = AtomicU32::new(0);
    thread::scope(|scope| {
        let seen = &seen;
        let drawing = scope.spawn(move || {
            let (mut t, mut waits) = (0, 0);
            while seen.load(Ordering::Relaxed) < frames {
                let begun = drawer.begin_blocking(|| {
                    waits += 1;
                    thread::yield_now();
                });
                let mut buffer = begun.expect("one at a time");
                t += 1;
                assert_eq!(buffer.frame(), t, "frames are counted");
                buffer.fill(t);
                if t % 5 == 3 {
                    drawer.cancel(buffer);
                } else {
                    drawer.finish(buffer);
                }
            }
            waits
        });
        let mut last = 0;
        while !drawing.is_finished() {
            if let Some(buffer) = display.flip() {
                let first = buffer[0];
                assert!(buffer.iter().all(|&pixel| pixel == first), "a torn frame");
                assert!(first > last && first % 5 != 3, "frame {first} after {last}");
                last = first;
                seen.fetch_add(1, Ordering::Relaxed);
            }
        }
        drawing.join().expect("it ends")
    })
}

fn new() -> Picture {
    vec![0; 500]
}

#[test]
fn two_threads_with_two_buffers() {
    let mut queues = Queues::<_, 3>::new();
    run(queues.split([new(), new()]).expect("a place more"), 500);
}

#[test]
fn two_threads_with_three_buffers() {
    let mut queues = Queues::<_, 4>::new();
    let waits = run(queues.split([new(), new(), new()]).expect("a place more"), 500);
    assert_eq!(waits, 0, "with three buffers nobody waits");
}
