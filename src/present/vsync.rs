//! [`Vsync`]: when the display may be given another picture.
//!
//! A display shows its memory row by row, from the top down, some sixty times a second. A picture that is exchanged while rows are shown
//! *tears*. Between the last row and the first one of the next refresh nothing is shown; then is the time. Display controllers tell it by
//! an interrupt or a flag (the vertical blanking of LTDC, the end of a transfer), and panels with a memory of their own by a pin, *tearing
//! effect*, which rises when the last row has been shown.

use core::{
    hint::spin_loop,
    sync::atomic::{AtomicBool, Ordering},
    task::{Context, Poll},
};

/// The beginning of refreshes: vertical synchronisation, or a tearing-effect line.
///
/// One method tells of them all: a program asks, waits or awaits. A function that returns whether one has begun is a `Vsync`:
/// ```
/// use embedded_raster::present::Vsync;
/// let mut levels = [false, false, true, true, false, true].into_iter();
/// let mut pin = || levels.next() == Some(true);
/// // The edge of a pin that is polled: it was low, and is high.
/// let mut was_high = false;
/// let mut rises = || {
///     let is_high = pin();
///     is_high && !core::mem::replace(&mut was_high, is_high)
/// };
/// assert!(!rises.is_due());
/// rises.wait();
/// assert!(!rises.is_due(), "it is still the same refresh");
/// ```
pub trait Vsync {
    /// Whether a refresh has begun since it was asked last. Returns at once.
    fn is_due(&mut self) -> bool;

    /// Returns when a refresh begins. A processor that can sleep until something happens may do so here; by default it asks all the time.
    fn wait(&mut self) {
        while !self.is_due() {
            spin_loop();
        }
    }

    /// Ready if a refresh has begun since it was asked last: for tasks that await it. By default the task is woken at once, and asks again
    /// after the others had their turn; whoever has an interrupt keeps the waker and wakes the task from there.
    /// ```
    /// use core::future::poll_fn;
    /// use embedded_raster::present::{Swapchain, Vsync};
    /// async fn draw(chain: &mut Swapchain<[u8; 512], 2>, mut vsync: impl Vsync) {
    ///     let mut buffer = chain.begin_async(async || poll_fn(|task| vsync.poll_due(task)).await, |_| ()).await;
    ///     // Or, with a pin of embedded-hal-async: `async || _ = pin.wait_for_rising_edge().await`.
    /// }
    /// ```
    fn poll_due(&mut self, task: &mut Context<'_>) -> Poll<()> {
        if self.is_due() {
            return Poll::Ready(());
        }
        task.waker().wake_by_ref();
        Poll::Pending
    }
}

/// A function that says whether a refresh has begun since it was called last. One that waits for it returns `true`.
impl<F: FnMut() -> bool> Vsync for F {
    fn is_due(&mut self) -> bool {
        self()
    }
}

/// A refresh that an interrupt tells of. Loads and stores only, which Cortex-M0+ has.
///
/// One place of the program asks; if several do, one of them has the answer.
/// ```
/// use embedded_raster::present::{Pulse, Swapchain, Vsync};
/// static REFRESH: Pulse = Pulse::new();
///
/// // The interrupt of the display:
/// REFRESH.signal();
///
/// // The program, which has something else to do until then:
/// let mut chain = Swapchain::new([[0; 512]; 2]);
/// for _ in 0..2 {
///     if let Some(buffer) = chain.begin() {
///         chain.finish(buffer);
///     }
///     if (&REFRESH).is_due() {
///         let shown = chain.flip().map(|buffer| buffer.as_ptr()); // its address, to the display
///         assert!(shown.is_some());
///     }
/// }
/// ```
/// Here the program exchanges the buffers some time after the interrupt. Where that is too late, the interrupt does it: see
/// [`Queues`](super::Queues).
#[derive(Debug, Default)]
pub struct Pulse(AtomicBool);

impl Pulse {
    /// Nothing has begun.
    pub const fn new() -> Self {
        Self(AtomicBool::new(false))
    }

    /// A refresh begins.
    pub fn signal(&self) {
        self.0.store(true, Ordering::Release);
    }
}

impl Vsync for &Pulse {
    fn is_due(&mut self) -> bool {
        let is_due = self.0.load(Ordering::Acquire);
        if is_due {
            // One that begins right now is the same: nobody could tell them apart.
            self.0.store(false, Ordering::Relaxed);
        }
        is_due
    }

    /// A refresh that began before does not count: by now the display may be in the middle of it.
    fn wait(&mut self) {
        self.0.store(false, Ordering::Relaxed);
        while !self.is_due() {
            spin_loop();
        }
    }
}
