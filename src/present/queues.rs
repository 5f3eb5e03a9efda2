//! [`Queues`]: buffers handed to an interrupt or to another core.

use core::fmt;

use heapless::spsc::{Consumer, Producer, Queue};

use super::buffers::Buffer;

/// Two queues between a program that draws and a display that is served elsewhere: by an interrupt, or by another core. Finished frames
/// go one way and free buffers the other, without a lock and without `unsafe`: a queue takes loads and stores only, which Cortex-M0+ has.
///
/// `N` is one more than there are buffers.
///
/// The display shows frames in the order in which they were finished. While a finished frame is in the queue, the next one is held back.
/// With three buffers the program that draws never waits: if no buffer is free, it gets the one with the frame held back, which is
/// dropped. So the frame that is shown next may be one frame older than the newest. A [`Swapchain`](super::Swapchain) behind a lock shows
/// the newest.
/// ```
/// use embedded_raster::present::Queues;
///
/// // In a firmware it lies in a `static`, and so do the buffers.
/// let mut queues = Queues::<[u8; 8], 4>::new();
/// let (mut drawer, mut display) = queues.split([[0; 8]; 3]).expect("four places hold three buffers");
///
/// // The program:
/// let mut buffer = drawer.begin().expect("three buffers are enough");
/// buffer.fill(7);
/// drawer.finish(buffer);
///
/// // The interrupt of the display:
/// let shown = display.flip().expect("a frame was finished");
/// assert_eq!(**shown, [7; 8]);
/// ```
#[derive(Debug)]
pub struct Queues<B, const N: usize> {
    finished: Queue<Buffer<B>, N>,
    free: Queue<Buffer<B>, N>,
}

impl<B, const N: usize> Default for Queues<B, N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<B, const N: usize> Queues<B, N> {
    /// Without buffers.
    pub const fn new() -> Self {
        Self { finished: Queue::new(), free: Queue::new() }
    }

    /// The end of the program and the end of the display. Buffers of an earlier call are dropped.
    ///
    /// # Errors
    /// The buffers, if they are not one fewer than places.
    pub fn split<const M: usize>(&mut self, buffers: [B; M]) -> Result<(Drawer<'_, B>, Display<'_, B>), [B; M]> {
        if M.checked_add(1) != Some(N) {
            return Err(buffers);
        }
        while self.finished.dequeue().is_some() || self.free.dequeue().is_some() {}
        for buffer in buffers {
            // There is a place for each.
            let _ = self.free.enqueue(Buffer::new(buffer));
        }
        let ((to_show, finished), (to_draw, free)) = (self.finished.split(), self.free.split());
        let drawer = Drawer { finished: to_show, free, held: None, spare: None, is_drawing: false, frame: 0 };
        Ok((drawer, Display { finished, free: to_draw, shown: None }))
    }
}

/// The end of the program that draws: one frame at a time.
pub struct Drawer<'a, B> {
    finished: Producer<'a, Buffer<B>>,
    free: Consumer<'a, Buffer<B>>,
    /// A frame that is held back until the display has taken the one before.
    held: Option<Buffer<B>>,
    /// A buffer whose frame was dropped. None while a frame is drawn, as it would be that one.
    spare: Option<Buffer<B>>,
    is_drawing: bool,
    frame: u32,
}

impl<B> Drawer<'_, B> {
    /// Takes a buffer to draw the next frame on. `None` if it has to wait for the display, or if one is drawn already.
    pub fn begin(&mut self) -> Option<Buffer<B>> {
        if self.is_drawing {
            return None;
        }
        self.hand_over();
        let spare = self.spare.take().or_else(|| {
            step();
            self.free.dequeue()
        });
        let buffer = spare.or_else(|| self.held.take())?;
        self.is_drawing = true;
        self.frame = self.frame.wrapping_add(1);
        Some(buffer.begin(self.frame))
    }

    /// Gives the buffer back whose picture is complete.
    pub fn finish(&mut self, buffer: Buffer<B>) {
        self.is_drawing = false;
        self.hand_over();
        self.spare = self.held.replace(buffer.finish());
        self.hand_over();
    }

    /// Gives the buffer back whose picture is not complete. It will not be shown, and has no age any more.
    pub fn cancel(&mut self, buffer: Buffer<B>) {
        self.is_drawing = false;
        self.spare = Some(buffer.cancel());
    }

    /// Gives the frame that is held back to the display, if it has taken the one before. [`begin`](Self::begin) and [`finish`](Self::finish)
    /// do the same: a program that draws nothing for a while calls this, so that its last frame is seen.
    pub fn hand_over(&mut self) {
        if self.held.is_none() {
            return;
        }
        step();
        if self.finished.is_empty() {
            if let Some(frame) = self.held.take() {
                step();
                // There is a place for each buffer.
                let _ = self.finished.enqueue(frame);
            }
        }
    }

    /// [`begin`](Self::begin), waiting as long as it has to: `wait` may be the instruction that waits for an interrupt. `None` if a frame
    /// is drawn already.
    pub fn begin_blocking(&mut self, mut wait: impl FnMut()) -> Option<Buffer<B>> {
        while !self.is_drawing {
            if let Some(buffer) = self.begin() {
                return Some(buffer);
            }
            wait();
        }
        None
    }

    /// The same for programs that await the display.
    pub async fn begin_async(&mut self, mut wait: impl AsyncFnMut()) -> Option<Buffer<B>> {
        while !self.is_drawing {
            if let Some(buffer) = self.begin() {
                return Some(buffer);
            }
            wait().await;
        }
        None
    }
}

/// The end of the display.
pub struct Display<'a, B> {
    finished: Consumer<'a, Buffer<B>>,
    free: Producer<'a, Buffer<B>>,
    shown: Option<Buffer<B>>,
}

impl<B> Display<'_, B> {
    /// The display is between two pictures: the next finished frame is shown from now on. Returns it, `None` if what is shown is as before.
    pub fn flip(&mut self) -> Option<&Buffer<B>> {
        if !self.give_back() {
            return None;
        }
        self.take();
        self.shown()
    }

    /// The frame that is shown.
    pub const fn shown(&self) -> Option<&Buffer<B>> {
        self.shown.as_ref()
    }

    /// If a frame is finished, the one that is shown is given back. That comes first: while the display has two, a drawer with three
    /// buffers may have none to go on with.
    fn give_back(&mut self) -> bool {
        let is_ready = self.finished.ready();
        if let Some(old) = self.shown.take_if(|_| is_ready) {
            // There is a place for each buffer.
            let _ = self.free.enqueue(old);
        }
        is_ready
    }

    fn take(&mut self) {
        self.shown = self.finished.dequeue();
    }
}

impl<B> fmt::Debug for Drawer<'_, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { is_drawing, frame, .. } = self;
        f.debug_struct("Drawer").field("frame", frame).field("is_drawing", is_drawing).finish_non_exhaustive()
    }
}

impl<B> fmt::Debug for Display<'_, B> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Display").field("shown", &self.shown().map(Buffer::frame)).finish_non_exhaustive()
    }
}

/// Called before each access of the drawer to a queue. In between the other end may do anything: tests do all of it.
#[inline(always)]
fn step() {
    #[cfg(test)]
    tests::step();
}

#[cfg(test)]
mod tests {
    use std::{
        boxed::Box,
        cell::RefCell,
        collections::{BTreeSet, VecDeque},
        vec,
        vec::Vec,
    };

    use super::*;

    /// What the display does between two steps of the drawer: so many halves of a flip.
    type Choices = Vec<u8>;

    /// The display, whether it is in the middle of a flip, and what it will do. What it sees is checked.
    struct Other {
        display: Display<'static, u8>,
        is_flipping: bool,
        choices: VecDeque<u8>,
        /// Steps for which there was no choice any more.
        unchosen: usize,
        last: u32,
    }

    impl Other {
        fn act(&mut self) {
            let Some(halves) = self.choices.pop_front() else {
                self.unchosen += 1;
                return;
            };
            for _ in 0..halves {
                if self.is_flipping {
                    self.display.take();
                    self.is_flipping = false;
                } else {
                    self.is_flipping = self.display.give_back();
                }
                if let Some(shown) = self.display.shown() {
                    assert_eq!(shown.holds, Some(shown.frame()), "a frame that is finished");
                    assert!(shown.frame().wrapping_sub(self.last) < 1 << 31, "an older frame after a newer one");
                    self.last = shown.frame();
                }
            }
        }
    }

    std::thread_local! {
        static OTHER: RefCell<Option<Other>> = const { RefCell::new(None) };
    }

    pub(super) fn step() {
        OTHER.with_borrow_mut(|other| {
            if let Some(other) = other {
                other.act();
            }
        });
    }

    /// Where everything is, with frames counted back from the last one; beyond some they are all the same.
    type State = Vec<(&'static str, Vec<(u8, Option<u32>)>)>;

    /// Runs the drawer, with the display in between as the choices say; the drawer begins and finishes frames as often as there are
    /// operations. Returns where everything is then, and how many choices were missing.
    fn run<const M: usize, const N: usize>(operations: usize, choices: &[u8]) -> (State, usize) {
        let queues = Box::leak(Box::new(Queues::<u8, N>::new()));
        let buffers: [u8; M] = core::array::from_fn(|i| u8::try_from(i).expect("few"));
        let (mut drawer, display) = queues.split(buffers).expect("a place more");
        let choices = choices.iter().copied().collect();
        OTHER.set(Some(Other { display, is_flipping: false, choices, unchosen: 0, last: 0 }));
        let mut drawn = None;
        for _ in 0..operations {
            if let Some(buffer) = drawn.take() {
                drawer.finish(buffer);
            } else {
                drawn = drawer.begin();
                assert!(drawn.is_some() || M < 3, "with three buffers nobody waits");
                assert!(drawn.is_none() || drawer.begin().is_none(), "one at a time");
            }
        }
        let Some(Other { mut display, is_flipping, unchosen, .. }) = OTHER.take() else { panic!("it was there") };
        let frame = drawer.frame;
        let told = |buffer: &Buffer<u8>| (**buffer, buffer.holds.map(|holds| (frame - holds).min(5)));
        let one = |buffer: &Option<Buffer<u8>>| buffer.iter().map(told).collect::<Vec<_>>();
        let mut state = vec![
            ("held", one(&drawer.held)),
            ("spare", one(&drawer.spare)),
            ("drawn", one(&drawn)),
            ("shown", one(&display.shown)),
            // Nothing, once or not at all.
            ("flipping", vec![(u8::MAX, None); usize::from(is_flipping)]),
        ];
        let mut all = |name, next: &mut dyn FnMut() -> Option<Buffer<u8>>| {
            state.push((name, core::iter::from_fn(next).map(|buffer| told(&buffer)).collect()));
        };
        all("finished", &mut || display.finished.dequeue());
        all("free", &mut || drawer.free.dequeue());
        let mut found: Vec<u8> =
            state.iter().flat_map(|(_, buffers)| buffers.iter().map(|buffer| buffer.0)).filter(|&id| id < 9).collect();
        found.sort_unstable();
        assert_eq!(found, buffers, "every buffer is in one place: {state:?}");
        (state, unchosen)
    }

    /// All that can happen, from state to state. A display does at most three halves of a flip between two steps of the drawer: then it
    /// has taken what it was about to take, and there is nothing to go on with.
    fn explore<const M: usize, const N: usize>() -> usize {
        let start: (usize, Choices) = (0, vec![]);
        let mut seen = BTreeSet::from([run::<M, N>(0, &[]).0]);
        let mut open = VecDeque::from([start]);
        while let Some((operations, choices)) = open.pop_front() {
            let mut unfinished = vec![choices];
            while let Some(choices) = unfinished.pop() {
                let (state, missing) = run::<M, N>(operations + 1, &choices);
                if missing > 0 {
                    unfinished.extend((0..=3).map(|halves| [&choices[..], &[halves]].concat()));
                } else if seen.insert(state) {
                    open.push_back((operations + 1, choices));
                }
            }
        }
        seen.len()
    }

    #[test]
    fn every_interleaving_of_two_and_three_buffers() {
        let states = [explore::<2, 3>(), explore::<3, 4>()];
        assert!(states[0] > 10 && states[1] > states[0], "few states: {states:?}");
    }

    #[test]
    fn places_are_one_more_than_buffers() {
        assert_eq!(Queues::<u8, 4>::new().split([1, 2]).err(), Some([1, 2]));
        let mut queues = Queues::<u8, 3>::new();
        for _ in 0..2 {
            let (mut drawer, mut display) = queues.split([1, 2]).expect("a place more");
            let buffer = drawer.begin().expect("free");
            drawer.finish(buffer);
            assert_eq!(display.flip().map(|buffer| **buffer), Some(1), "all anew at each call");
        }
    }
}
