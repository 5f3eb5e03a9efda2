//! The same clipping for builds for size: additions and halvings only, no routine of the runtime library.
//!
//! Two walks find the ends of the visible part. One goes from the top of the line to the last pixel in the window, the other
//! from the bottom to the first. What both have passed is visible. If they do not meet, no pixel is.
//!
//! Neither walk goes pixel by pixel. A jump by `n` major steps makes m minor steps and leaves q for the remainder:
//! `n db = m da + q`, `0 <= q < da`. The first jump is the whole line: `n = da`, `m = db`, `q = 0`. A jump is made as often as
//! there is room, then it is halved. Before an odd `n` is halved, one step is taken off; the half of an odd `m` goes into `q`.
//! After a miss there is room for less than `n` steps, so for at most two halves, and a walk takes 96 tries or fewer.
//!
//! The functions are small and are not inlined, as the smallest cores are short of registers, not of instructions.

use core::ptr;

use crate::{
    num::cast::{signed, unsigned},
    span::Steps,
    tune::keep_branch,
};

/// See [`clip`](super::clip). Of columns and of rows: where the line begins and ends, and the window, which is not empty.
#[inline(never)]
pub(super) fn clip(columns: &[i32; 4], rows: &[i32; 4]) -> Option<Steps> {
    let up = u32::from(rows[0] > rows[1]);
    let mut x = Axis::new(columns, up);
    let mut y = Axis::new(rows, up);
    let y_place = &raw const y;
    let (along, aside) = order(&mut x, &mut y);
    if along.start > along.end || aside.start > aside.end {
        return None;
    }
    follow(along, aside, up ^ 1);
    let rest = follow(along, aside, up);
    if along.first() > along.last() {
        return None;
    }
    let (left, sideways) = (along.seen(), aside.seen());
    let (major, minor, steep) = (along.length, aside.length, ptr::eq(along, y_place));
    Some(Steps {
        left,
        sideways,
        minor,
        major,
        // From the other end: going back over a step, the line steps aside where r < db. That is where da - 1 - r carries.
        rest: !rest.wrapping_add(major),
        first: (x.first() ^ x.turned, y.first()),
        x_step: x.turned | 1,
        steep,
    })
}

/// The major axis first. Not inlined, or the compiler would make two copies of all that follows.
#[inline(never)]
fn order<'a>(x: &'a mut Axis, y: &'a mut Axis) -> (&'a mut Axis, &'a mut Axis) {
    if y.length > x.length {
        (y, x)
    } else {
        (x, y)
    }
}

/// Walks as far as there is room, and prepares the walk from the other end. Returns r - da at its end.
///
/// `forth` is 1 in the direction in which the line was drawn, 0 against it.
#[inline(never)]
fn follow(along: &mut Axis, aside: &mut Axis, forth: u32) -> u32 {
    let (major, minor) = (along.length, aside.length);
    let (mut room, mut room_aside) = (along.room, aside.room);
    // r - da where r is h, or from the other end its complement, da - 1 - h.
    let mut rest = !(major.wrapping_sub(forth) >> 1);
    let (mut by, mut by_aside, mut by_rest) = (major, minor, 0);
    while by != 0 {
        let (sum, carry) = rest.overflowing_add(by_rest);
        let jump_aside = by_aside.wrapping_add(u32::from(carry));
        if by <= room && jump_aside <= room_aside {
            room = room.wrapping_sub(by);
            room_aside = room_aside.wrapping_sub(jump_aside);
            rest = if carry { sum.wrapping_sub(major) } else { sum };
            continue;
        }
        if by & 1 != 0 {
            let (difference, borrow) = by_rest.overflowing_sub(minor);
            by_rest = difference;
            if borrow {
                by_rest = by_rest.wrapping_add(major);
                by_aside = by_aside.wrapping_sub(1);
            }
        }
        // (q + da) / 2 where the sum is even, without its carry.
        by_rest = by_rest.wrapping_add(1) >> 1;
        if by_aside & 1 != 0 {
            by_rest = by_rest.wrapping_add(major >> 1);
        }
        by >>= 1;
        by_aside >>= 1;
    }
    along.turn(room);
    aside.turn(room_aside);
    rest
}

/// Columns or rows, counted so that they grow along the line. If they do not, all bits of each are inverted.
struct Axis {
    /// -1 if all bits are inverted, else 0.
    turned: i32,
    length: u32,
    /// The first and the last position in the window, on the line.
    start: i32,
    end: i32,
    /// Steps that can still be made without leaving the window.
    room: u32,
    /// The same for the walk from the other end.
    other_room: u32,
}

impl Axis {
    /// From the upper end of the line to the lower one; `up` is 1 if it was drawn the other way.
    #[inline(never)]
    fn new(&[a, b, low, high]: &[i32; 4], up: u32) -> Self {
        let (mut from, mut to, mut low, mut last) = (a, b, low, high.wrapping_sub(1));
        // Kept as two branches: as conditional moves, the assignments would cost time in either case.
        if up != 0 {
            (from, to) = (b, a);
            keep_branch();
        }
        let mut turned = 0;
        if to < from {
            (from, to, low, last, turned) = (!from, !to, !last, !low, -1);
            keep_branch();
        }
        let (start, end) = (low.max(from), last.min(to));
        let steps = |from: i32, to: i32| unsigned(to.wrapping_sub(from));
        Self { turned, length: steps(from, to), start, end, room: steps(from, end), other_room: steps(start, to) }
    }

    /// Ends a walk that has left `room` unused, and turns to the walk from the other end.
    #[inline(always)]
    fn turn(&mut self, room: u32) {
        self.room = self.other_room;
        self.other_room = room;
    }

    /// Where the first walk ended.
    #[inline(always)]
    fn last(&self) -> i32 {
        self.end.wrapping_sub(signed(self.room))
    }

    /// Steps between the ends of both walks.
    #[inline(always)]
    fn seen(&self) -> u32 {
        unsigned(self.last().wrapping_sub(self.first()))
    }

    /// Where the second walk, from the other end, ended.
    #[inline(always)]
    fn first(&self) -> i32 {
        self.start.wrapping_add(signed(self.other_room))
    }
}
