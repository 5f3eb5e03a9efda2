//! [`History`]: what changed in the last frames, for buffers that hold an older one.
//!
//! With several buffers, the one that is drawn on holds the picture of some frames ago. So what is to be drawn on it is not only what
//! changes in this frame, but also what has changed since the frame that it holds:
//! ```text
//!   frame            7    8    9   10
//!   what changed     .    b    c    d
//!                              two buffers: it holds 8, its age is 2, and it lacks  c + d
//!                         three: it holds 7, its age is 3, and it lacks         b + c + d
//! ```
//! A display with a memory of its own is one more buffer: it lacks what has changed since the frame that was sent last. So one history
//! tells what is to be drawn and what is to be sent.

use super::buffers::Buffer;
use crate::{span::Rect, surface::Damage};

/// The damage of the last `FRAMES` frames, each in `N` rectangles at most: `FRAMES` is the largest age of a buffer, the number of buffers
/// mostly. What is older is forgotten: a picture from before that is to be drawn as a whole.
///
/// A history takes `16 N + 8` bytes for each frame, and some. It is a plain value: with [`Queues`](super::Queues), where the display is
/// served elsewhere, a copy may travel with the pixels of each frame.
///
/// ```
/// use embedded_raster::{present::{History, Swapchain}, surface::Damage, Canvas, Framebuffer, Index4, Rect};
/// let screen = Rect::new(0, 0, 64, 48);
/// let mut chain = Swapchain::new([[0; 64 * 48 / 2]; 2]);
/// let mut history = History::<4, 2>::new();
/// let (mut x, mut sent) = (0, None);
/// for _ in 0..9 {
///     let mut buffer = chain.begin().expect("a flip follows each frame");
///     // A square moves: where it was, and where it is.
///     let mut changed = Damage::new();
///     changed.add(Rect::new(x, 9, x + 8, 17));
///     x += 5;
///     changed.add(Rect::new(x, 9, x + 8, 17));
///     history.record(buffer.frame(), &changed);
///     // The whole scene, where this buffer is not up to date.
///     for &area in history.missing(&buffer, screen).areas() {
///         let mut frame = Framebuffer::<Index4>::new(&mut buffer[..], 64, 48)?;
///         let mut part = frame.clipped(area);
///         part.clear(Index4::new(0));
///         part.fill_rectangle(Rect::new(x, 9, x + 8, 17), Index4::new(7));
///     }
///     chain.finish(buffer);
///     let shown = chain.flip().expect("a frame was finished").frame();
///     // To a display that keeps its picture: what is new since the last one.
///     let to_send = history.since(sent, screen);
///     assert_eq!(to_send.areas(), if sent.is_none() { [screen] } else { [Rect::new(x - 5, 9, x + 8, 17)] });
///     sent = Some(shown);
/// }
/// # Ok::<(), embedded_raster::Error>(())
/// ```
#[derive(Clone, Debug)]
pub struct History<const N: usize, const FRAMES: usize> {
    /// A ring: that of frame n lies at n modulo its length, counted from where it began.
    frames: [Damage<N>; FRAMES],
    /// Where the newest frame lies.
    at: usize,
    newest: u32,
    /// How many of the frames up to the newest are known.
    known: usize,
}

impl<const N: usize, const FRAMES: usize> History<N, FRAMES> {
    /// Nothing is known.
    pub const fn new() -> Self {
        const { assert!(FRAMES > 0, "a history has one frame at least") };
        Self { frames: [const { Damage::new() }; FRAMES], at: 0, newest: 0, known: 0 }
    }

    /// In the frame of this [number](Buffer::frame), `damage` is what differs from the frame before it.
    ///
    /// A frame that was [cancelled](super::Swapchain::cancel) is recorded as well if the next one draws only what differs from it. If
    /// the number does not follow that of the last call, all that was known is forgotten.
    pub fn record(&mut self, frame: u32, damage: &Damage<N>) {
        let follows = self.known > 0 && frame == self.newest.wrapping_add(1);
        self.known = if follows { self.known.saturating_add(1).min(FRAMES) } else { 1 };
        self.at = if self.at.wrapping_add(1) < FRAMES { self.at.wrapping_add(1) } else { 0 };
        self.newest = frame;
        if let Some(place) = self.frames.get_mut(self.at) {
            place.clone_from(damage);
        }
    }

    /// What differs between the picture that `buffer` had when drawing on it began, and the frame that was recorded last. All of `screen` if it
    /// has none, or if that is too long ago.
    ///
    /// Recorded before it is asked, this frame is in the answer: what is to be drawn on the buffer. Recorded after, it is not: what is to be
    /// brought up to date before the new frame is drawn over it.
    pub fn missing<B>(&self, buffer: &Buffer<B>, screen: Rect) -> Damage<N> {
        self.since(buffer.holds, screen)
    }

    /// What differs between the frame of a number and the one that was recorded last. All of `screen` for `None`, and for a frame that is too
    /// long ago or not yet recorded.
    pub fn since(&self, frame: Option<u32>, screen: Rect) -> Damage<N> {
        let mut damage = Damage::new();
        let age = frame.and_then(|frame| usize::try_from(self.newest.wrapping_sub(frame)).ok());
        match age.filter(|&age| age <= self.known && self.known > 0) {
            Some(age) => self.last(age).for_each(|one| damage.add_all(one)),
            None => damage.add(screen),
        }
        damage
    }

    /// The damage of so many frames, the newest first.
    fn last(&self, count: usize) -> impl Iterator<Item = &Damage<N>> {
        let (later, earlier) = self.frames.split_at_checked(self.at.wrapping_add(1)).unwrap_or_default();
        later.iter().rev().chain(earlier.iter().rev()).take(count)
    }
}

impl<const N: usize, const FRAMES: usize> Default for History<N, FRAMES> {
    fn default() -> Self {
        Self::new()
    }
}
