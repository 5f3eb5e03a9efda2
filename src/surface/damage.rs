//! [`Damage`]: which parts of a screen have changed, as a short list of rectangles.
//!
//! A screen that is mostly as it was need not be drawn nor sent as a whole. What has changed, its *damage*, is a set of pixels; a
//! list of a few rectangles that hold all of them is enough to work with, and takes 16 bytes for each.
//! ```text
//!   drawn:            2 rectangles:      1 rectangle:
//!    ####              +----+             +---------+
//!    ####              |    |             |         |
//!                      +----+             |         |
//!         ##                +--+          |         |
//!         ##                +--+          +---------+
//! ```
//! **No pixel is lost**, whatever the capacity: a list that is full becomes coarser. So there is no error, and no program has to
//! choose a capacity well; a larger one sends fewer pixels that have not changed.
//!
//! **Which rectangles are joined.** To join two is to replace them by the smallest one that holds both. What that adds,
//! `area(both) - area(a) - area(b)`, are pixels that did not change. A rectangle by itself has a price, too: a display wants to be told
//! where it lies. So two are joined
//! - when that adds [32 pixels](PRICE) or less, and
//! - when the list is full: then, of all pairs, the one that adds least. From then on until the list is empty, others that add no more are
//!   joined at once. So a list that is too short for what is drawn finds out how coarse it has to be, and the search through all
//!   pairs, which takes `N (N + 1) / 2` steps, is rare.
//!
//! Shapes are drawn row by row, and lines pixel by pixel: what comes next nearly always lies beside what came last. So the rectangle that
//! was changed last is tried first.
//!
//! Source of joining by least added area: A. Guttman, "R-trees: a dynamic index structure for spatial searching", SIGMOD 1984.

use heapless::Vec;

use crate::span::Rect;

/// What a rectangle costs by itself, in pixels. A display behind a serial bus takes eleven bytes of commands with addresses, between which
/// the bus stands still; that is the time of about so many pixels.
const PRICE: u32 = 32;

/// Rectangles that hold every pixel that has changed: `N` at most, which is 1 or more.
///
/// They may overlap, and may hold pixels that have not changed. A [`Recorder`](super::Recorder) adds what is drawn; a program that knows what
/// will change adds that itself.
/// ```
/// use embedded_raster::{surface::Damage, Rect};
/// let mut damage = Damage::<2>::new();
/// damage.add(Rect::new(0, 0, 10, 10));
/// damage.add(Rect::new(100, 50, 120, 60));
/// assert_eq!(damage.areas().len(), 2);
/// // No room for a third one: the two that are near each other are joined.
/// damage.add(Rect::new(14, 0, 20, 10));
/// assert_eq!(damage.areas(), [Rect::new(100, 50, 120, 60), Rect::new(0, 0, 20, 10)]);
/// ```
#[derive(Debug)]
pub struct Damage<const N: usize> {
    areas: Vec<Rect, N>,
    /// Two rectangles are joined when that adds so many pixels at most.
    patience: u32,
}

impl<const N: usize> Damage<N> {
    /// Nothing has changed.
    pub const fn new() -> Self {
        const { assert!(N > 0, "there is a place for one rectangle at least") };
        Self { areas: Vec::new(), patience: PRICE }
    }

    /// The pixels of `area` have changed.
    #[inline]
    pub fn add(&mut self, area: Rect) {
        if let Some(last) = self.areas.last_mut() {
            let both = last.union(area);
            if added(both, *last, area) <= self.patience {
                *last = both;
                return;
            }
        }
        self.insert(area);
    }

    /// All that is in another list has changed.
    pub fn add_all<const M: usize>(&mut self, others: &Damage<M>) {
        for &area in others.areas() {
            self.insert(area);
        }
    }

    /// Nothing has changed since now.
    pub fn clear(&mut self) {
        *self = Self::new();
    }

    /// Whether nothing has changed.
    pub fn is_empty(&self) -> bool {
        self.areas.is_empty()
    }

    /// The rectangles, none of them empty, in no order.
    pub fn areas(&self) -> &[Rect] {
        &self.areas
    }

    /// The smallest rectangle that holds all of it; an empty one if nothing has changed.
    pub fn bounds(&self) -> Rect {
        self.areas.iter().fold(Rect::default(), |bounds, &area| bounds.union(area))
    }

    /// Adds a rectangle, wherever it lies. If all are added so, no two are left that would be joined.
    pub(crate) fn insert(&mut self, mut area: Rect) {
        if area.is_empty() {
            return;
        }
        // Each round has one rectangle fewer than the one before, so there are N at most.
        loop {
            let cheapest = (0..N).zip(&self.areas).map(|(i, &held)| (added(held.union(area), held, area), i)).min();
            match cheapest {
                Some((adds, i)) if adds <= self.patience => area = area.union(self.take(i)),
                _ if self.areas.len() < N => {
                    _ = self.areas.push(area);
                    return;
                }
                _ => area = self.make_room(area),
            }
        }
    }

    /// Joins the pair that adds least, of rectangles in the list and a further one. Returns one that is to be added, as it is not in
    /// the list.
    fn make_room(&mut self, area: Rect) -> Rect {
        let (mut least, mut pair) = (u32::MAX, (0, N));
        for (i, &a) in (0..N).zip(&self.areas) {
            // The further one has the number N.
            for (j, &b) in (0..N).zip(&self.areas).skip(i.wrapping_add(1)).chain([(N, &area)]) {
                let adds = added(a.union(b), a, b);
                if adds < least {
                    (least, pair) = (adds, (i, j));
                }
            }
        }
        self.patience = self.patience.max(least);
        let (i, j) = pair;
        if j == N {
            return self.take(i).union(area);
        }
        // The later one first: that moves nothing before it.
        let joined = self.take(j).union(self.take(i));
        _ = self.areas.push(area);
        joined
    }

    /// Takes a rectangle out; the last one takes its place.
    pub(crate) fn take(&mut self, at: usize) -> Rect {
        let last = self.areas.pop().unwrap_or_default();
        match self.areas.get_mut(at) {
            Some(place) => core::mem::replace(place, last),
            None => last,
        }
    }
}

impl<const N: usize> Default for Damage<N> {
    fn default() -> Self {
        Self::new()
    }
}

impl<const N: usize> Clone for Damage<N> {
    fn clone(&self) -> Self {
        let mut copy = Self { areas: Vec::new(), ..*self };
        for &area in &self.areas {
            _ = copy.areas.push(area);
        }
        copy
    }
}

/// How many pixels the smallest rectangle that holds two others has beyond those of both. Where they overlap it may be fewer: 0 then.
#[inline]
fn added(both: Rect, a: Rect, b: Rect) -> u32 {
    area(both).saturating_sub(area(a).saturating_add(area(b)))
}

/// Pixels of a rectangle. Sides of more than 65,535 count as that: this only says what is joined.
#[inline]
fn area(rect: Rect) -> u32 {
    let side = |length: u32| length.min(0xffff);
    side(rect.width()).wrapping_mul(side(rect.height()))
}
