//! [`Swapchain`]: one buffer, two or three, and who has them.

use core::{
    num::NonZeroU32,
    ops::{Deref, DerefMut},
};

use super::vsync::Vsync;

/// What is drawn on and shown as one thing: memory, or memory and the palette that belongs to it.
///
/// It is moved, not borrowed: from those that are free to the program that draws, and on to the display. What is in it is reached by
/// `*buffer`.
#[derive(Debug)]
pub struct Buffer<B> {
    content: B,
    /// The number of the frame that is in it; none before the first.
    pub(super) holds: Option<u32>,
    /// The number of the frame that is drawn, or was drawn last.
    frame: u32,
}

impl<B> Buffer<B> {
    pub(super) const fn new(content: B) -> Self {
        Self { content, holds: None, frame: 0 }
    }

    /// How many frames old its picture is: 1 if it is that of the frame before this one, 2 of the one before that. `None` if it has none:
    /// then all is to be drawn.
    ///
    /// What changed in this frame and in the `age - 1` frames before it is all that differs from the picture in the buffer. The
    /// extension `EGL_EXT_buffer_age` counts the same way.
    pub fn age(&self) -> Option<NonZeroU32> {
        self.holds.and_then(|holds| NonZeroU32::new(self.frame.wrapping_sub(holds)))
    }

    /// The number of the frame that is drawn on it, or was drawn last. The first one is 1; after `u32::MAX` comes 0.
    pub const fn frame(&self) -> u32 {
        self.frame
    }

    /// Drawing begins.
    pub(super) fn begin(mut self, frame: u32) -> Self {
        self.frame = frame;
        self
    }

    /// Drawing ends: it holds that frame now.
    pub(super) fn finish(mut self) -> Self {
        self.holds = Some(self.frame);
        self
    }

    /// Drawing ends before it was complete: it holds no frame.
    pub(super) fn cancel(mut self) -> Self {
        self.holds = None;
        self
    }

    /// What is in it, for good.
    pub fn into_inner(self) -> B {
        self.content
    }
}

impl<B> Deref for Buffer<B> {
    type Target = B;

    fn deref(&self) -> &B {
        &self.content
    }
}

impl<B> DerefMut for Buffer<B> {
    fn deref_mut(&mut self) -> &mut B {
        &mut self.content
    }
}

/// `N` buffers, and who has them: single, double or triple buffering.
///
/// The program takes a buffer by [`begin`](Self::begin), draws on it and gives it back by [`finish`](Self::finish). At each refresh of
/// the display [`flip`](Self::flip) puts the newest finished frame in the place of the one that is shown. Each of these takes a few
/// moves, whatever the size of the buffers.
///
/// - A frame that is not finished is never shown.
/// - Frames are shown in the order in which they are finished.
/// - With three buffers or more [`begin`](Self::begin) always has one: a frame that still waits when a newer one is finished is dropped.
///   With two it has none from [`finish`](Self::finish) until the next [`flip`](Self::flip).
/// - With one buffer, beginning takes away the picture that is shown, or that waits.
///
/// ```
/// use embedded_raster::{present::Swapchain, Canvas, Framebuffer, Index4, Palette};
/// use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
///
/// // Pixels, and the palette that belongs to them.
/// let memory = [[0; 16 * 16 / 2], [0; 16 * 16 / 2]].map(|pixels| (pixels, Palette::new([Rgb565::WHITE; 16])));
/// let mut chain = Swapchain::new(memory);
/// for t in 0..10 {
///     let mut buffer = chain.begin().expect("a flip follows each frame");
///     let (pixels, _) = &mut *buffer;
///     let mut frame = Framebuffer::<Index4>::new(&mut pixels[..], 16, 16)?;
///     frame.clear(Index4::new(0));
///     frame.draw_line((0, 0), (15, t), Index4::new(15));
///     chain.finish(buffer);
///     let shown = chain.flip().expect("a frame was finished");
///     assert_eq!(shown.frame(), t as u32 + 1);
/// }
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Debug)]
pub struct Swapchain<B, const N: usize> {
    free: [Option<Buffer<B>>; N],
    /// Finished, and newer than what is shown.
    waiting: Option<Buffer<B>>,
    shown: Option<Buffer<B>>,
    /// The number of the frame that was begun last.
    frame: u32,
}

impl<B, const N: usize> Swapchain<B, N> {
    /// Nothing is shown.
    pub fn new(buffers: [B; N]) -> Self {
        const { assert!(N > 0, "a swapchain has one buffer at least") };
        Self { free: buffers.map(|content| Some(Buffer::new(content))), waiting: None, shown: None, frame: 0 }
    }

    /// Takes a buffer to draw the next frame on, of those that are free the one with the newest picture. `None` if it has to wait for
    /// the next [`flip`](Self::flip), or if all have been taken.
    pub fn begin(&mut self) -> Option<Buffer<B>> {
        let frame = self.frame.wrapping_add(1);
        // The fewest frames ago is the least to draw.
        let age = |buffer: &Buffer<B>| buffer.holds.map_or(u32::MAX, |holds| frame.wrapping_sub(holds));
        let full = self.free.iter_mut().filter(|place| place.is_some());
        let free = full.min_by_key(|place| place.as_ref().map(age)).and_then(Option::take);
        let taken = if N == 1 { free.or_else(|| self.waiting.take()).or_else(|| self.shown.take()) } else { free }?;
        self.frame = frame;
        Some(taken.begin(frame))
    }

    /// Gives a buffer back whose picture is complete. A frame that still waits is dropped.
    pub fn finish(&mut self, buffer: Buffer<B>) {
        if let Some(replaced) = self.waiting.replace(buffer.finish()) {
            self.put(replaced);
        }
    }

    /// Gives a buffer back whose picture is not complete. It will not be shown, and has no age any more.
    pub fn cancel(&mut self, buffer: Buffer<B>) {
        self.put(buffer.cancel());
    }

    /// The display is between two pictures: the frame that waits is shown from now on. Returns what is shown, `None` if that is as before.
    pub fn flip(&mut self) -> Option<&Buffer<B>> {
        let next = self.waiting.take()?;
        if let Some(old) = self.shown.replace(next) {
            self.put(old);
        }
        self.shown()
    }

    /// The frame that is shown.
    pub const fn shown(&self) -> Option<&Buffer<B>> {
        self.shown.as_ref()
    }

    /// [`begin`](Self::begin) for programs that may wait: as long as no buffer is free, it waits for the display and flips. `show` is
    /// called with each frame that is shown from then on. `None` if all buffers have been taken, as then nobody would end the wait.
    pub fn begin_blocking(&mut self, vsync: &mut impl Vsync, mut show: impl FnMut(&Buffer<B>)) -> Option<Buffer<B>> {
        loop {
            if let Some(buffer) = self.begin() {
                return Some(buffer);
            }
            self.waiting.as_ref()?;
            vsync.wait();
            if let Some(shown) = self.flip() {
                show(shown);
            }
        }
    }

    /// The same for programs that await the display.
    pub async fn begin_async(
        &mut self,
        mut vsync: impl AsyncFnMut(),
        mut show: impl FnMut(&Buffer<B>),
    ) -> Option<Buffer<B>> {
        loop {
            if let Some(buffer) = self.begin() {
                return Some(buffer);
            }
            self.waiting.as_ref()?;
            vsync().await;
            if let Some(shown) = self.flip() {
                show(shown);
            }
        }
    }

    fn put(&mut self, buffer: Buffer<B>) {
        // There are as many places as buffers.
        if let Some(place) = self.free.iter_mut().find(|place| place.is_none()) {
            *place = Some(buffer);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::{
        collections::{BTreeSet, VecDeque},
        vec,
        vec::Vec,
    };

    use super::*;

    /// What may happen next.
    #[derive(Copy, Clone, Debug, PartialEq, Eq)]
    enum Operation {
        Begin,
        /// Of the buffers that are drawn, the one that was taken first, or the last one.
        Finish(bool),
        Cancel,
        Flip,
    }

    const ALL: [Operation; 5] =
        [Operation::Begin, Operation::Finish(true), Operation::Finish(false), Operation::Cancel, Operation::Flip];

    /// Buffers, and the frames that they hold, counted from the last one.
    type Place = Vec<(u8, Option<u32>)>;

    /// Where everything is after some operations. All that is promised is checked at the last one.
    fn run<const N: usize>(operations: &[Operation]) -> Vec<Place> {
        let all: [u8; N] = core::array::from_fn(|i| u8::try_from(i).expect("few"));
        let mut chain = Swapchain::new(all);
        let (mut drawn, mut shown, mut newest) = (VecDeque::new(), None, None);
        for &operation in operations {
            match operation {
                Operation::Begin => {
                    let waited = chain.waiting.is_some();
                    match chain.begin() {
                        Some(buffer) => {
                            drawn.push_back(buffer);
                            newest = newest.filter(|_| N > 1);
                        }
                        None => assert!(!drawn.is_empty() || N == 2 && waited, "one of {N} can be drawn"),
                    }
                }
                Operation::Finish(first) => {
                    let Some(buffer) = (if first { drawn.pop_front() } else { drawn.pop_back() }) else { continue };
                    newest = Some(buffer.frame());
                    chain.finish(buffer);
                }
                Operation::Cancel => drawn.pop_front().into_iter().for_each(|buffer| chain.cancel(buffer)),
                Operation::Flip => {
                    let flipped = chain.flip().map(Buffer::frame);
                    assert_eq!(flipped, newest.take(), "the frame that was finished last, if there is one");
                    shown = flipped.or(shown);
                }
            }
            if N > 1 {
                assert_eq!(chain.shown().map(Buffer::frame), shown, "nobody takes away what is shown");
            }
        }
        let frame = chain.frame;
        let told = |buffer: &Buffer<u8>| {
            assert_eq!(
                buffer.age().map(NonZeroU32::get),
                buffer.holds.map(|holds| buffer.frame - holds).filter(|&age| age > 0),
                "frames since then"
            );
            (buffer.content, buffer.holds.map(|holds| frame - holds))
        };
        let place = |buffer: &Option<Buffer<u8>>| buffer.iter().map(told).collect::<Place>();
        for buffer in chain.waiting.iter().chain(&chain.shown) {
            assert_eq!(buffer.holds, Some(buffer.frame), "it is finished");
        }
        let mut places = vec![place(&chain.waiting), place(&chain.shown), drawn.iter().map(told).collect()];
        places.push(chain.free.iter().flatten().map(told).collect());
        let mut found: Vec<u8> = places.iter().flatten().map(|buffer| buffer.0).collect();
        found.sort_unstable();
        assert_eq!(found, all, "every buffer is in one place");
        places
    }

    /// Goes on with every operation from every state, until none is new. Frames are forgotten after some.
    fn explore<const N: usize>() -> usize {
        let known = |places: Vec<Place>| -> Vec<Place> {
            let place = |place: Place| place.into_iter().map(|(id, age)| (id, age.map(|age| age.min(6)))).collect();
            places.into_iter().map(place).collect()
        };
        let mut seen = BTreeSet::from([known(run::<N>(&[]))]);
        let mut open = VecDeque::from([vec![]]);
        while let Some(operations) = open.pop_front() {
            for next in ALL {
                let operations = [&operations[..], &[next]].concat();
                if seen.insert(known(run::<N>(&operations))) {
                    open.push_back(operations);
                }
            }
        }
        seen.len()
    }

    #[test]
    fn everything_that_can_happen_to_one_two_and_three_buffers() {
        let states = [explore::<1>(), explore::<2>(), explore::<3>()];
        assert!(states[0] > 3 && states[1] > 20 && states[2] > 100, "few states: {states:?}");
    }

    #[test]
    fn ages_are_frames() {
        let mut chain = Swapchain::new(['a', 'b', 'c']);
        let mut frame = |shows: bool| {
            let buffer = chain.begin().expect("there are three");
            let seen = (*buffer, buffer.age().map(NonZeroU32::get));
            chain.finish(buffer);
            if shows {
                chain.flip();
            }
            seen
        };
        assert_eq!([frame(true), frame(true), frame(true)], [('a', None), ('b', None), ('a', Some(2))]);
        // A frame that was never shown is the newest picture.
        assert_eq!([frame(false), frame(false), frame(true)], [('b', Some(2)), ('c', None), ('b', Some(2))]);
    }

    #[test]
    fn waiting_ends_with_a_flip() {
        let mut chain = Swapchain::new([0, 1]);
        let (mut waited, mut seen) = (0, vec![]);
        for _ in 0..4 {
            let mut vsync = || {
                waited += 1;
                true
            };
            let buffer = chain.begin_blocking(&mut vsync, |shown| seen.push(shown.frame()));
            chain.finish(buffer.expect("one of two"));
            chain.flip();
            let buffer = chain.begin().expect("the other one");
            assert!(
                chain.begin_blocking(&mut || -> bool { unreachable!("nothing waits") }, |_| ()).is_none(),
                "both are taken"
            );
            chain.finish(buffer);
        }
        assert_eq!((waited, seen), (3, vec![2, 4, 6]));
    }
}
