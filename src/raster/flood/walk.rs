//! Flood fill without any memory: along the walls.
//!
//! A walker keeps a wall on its left. Whenever the pixels around it stay connected without the pixel that it stands on, it paints
//! that pixel and steps off. So what is left to paint stays in one piece, with the walker in it. At the end one pixel is left.
//!
//! Whether the pixels around stay connected is seen from the eight neighbours: the *crossing number* is the number of walls
//! that meet at a pixel, as far as one can see from there. At 1 it may be painted. At 2 it is part of a corridor: without
//! it the region is in two pieces if both walls are the same one, and still in one piece if they are different; and so on for
//! three and four walls. So there are two ways to learn more.
//!
//! **Around the other walls.** Every now and then, the walker follows the walls here that are not on its left, a few steps
//! only. If all of them turn out to be small islands, the pixel is painted, and the loop around each island is open.
//!
//! **Around its own wall.** When the walker comes round to where it has been and has painted nothing, it has followed one whole
//! wall:
//! - It came back the way it first came, and to this pixel for the first time, so the other wall is a different one: if
//!   two walls meet here, the pixel is painted, and the loop is open.
//! - It came from another side: both are the same wall. It goes back, and looks at the next pixel in the same way.
//! - It has turned to the left in all, so the wall was that of an island: the walker leaves it, from the highest pixel along
//!   it straight up to the next wall, which reaches higher. The outermost wall always has a pixel to paint. For a pixel
//!   that joins two parts of the region, take the part behind it: the pixel there that reaches furthest to some side is passed
//!   once in a lap, and two walls at most meet at it.
//!
//! Sources: S. Yokoi, J. Toriwaki, T. Fukumura, "An analysis of topological properties of digitized binary pictures using
//! local features", Computer Graphics and Image Processing 4, 1975 (the crossing number).

use super::target::{Connectivity, FloodSlot, FloodTarget};
use crate::span::Rect;

/// The neighbours, clockwise from the right one: even numbers share a side.
const NEIGHBOURS: [(i32, i32); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

/// Every so many steps of a lap, the walker looks at the other walls, and follows each of them as many steps: a power of 2. Every
/// second look goes twice as far, every fourth four times, and so on.
const NEAR: u32 = 16;

/// A walk may take so many steps for each pixel that it paints. Once it has taken more, it does not stop at a range that waits
/// until it has painted enough: otherwise many walks might go the same long way and paint nothing.
const PAID: u32 = 8;

/// The pixels to paint, and where they may lie.
pub(super) struct Region<'f, F> {
    pub target: &'f mut F,
    pub window: Rect,
    pub connectivity: Connectivity,
}

/// What a few steps along a wall have shown.
pub(super) enum Seen {
    /// A pixel that was looked for.
    Found,
    /// A lap around a small part of the region, in which no such pixel lies next to the wall.
    Closed,
    /// Nothing yet.
    Nothing,
}

/// A walker: where it stands, and in which direction it came there.
#[derive(Copy, Clone, PartialEq, Eq)]
struct Walker {
    x: i32,
    y: i32,
    direction: u32,
}

/// A lap along a wall.
struct Lap {
    start: Walker,
    steps: u32,
    /// Eighths of a turn to the right so far: at the end 8 around the region, -8 around an island.
    turns: i32,
    /// The highest pixel so far.
    top: (i32, i32),
}

impl<F: FloodTarget> Region<'_, F> {
    /// The columns of a range, with those that it touches by a corner if corners connect.
    #[inline(always)]
    pub(super) fn columns(&self, range: FloodSlot) -> (i32, i32) {
        let FloodSlot { x0, x1, .. } = range;
        match self.connectivity {
            Connectivity::Sides => (x0, x1),
            Connectivity::Corners => {
                (x0.saturating_sub(1).max(self.window.x0), x1.saturating_add(1).min(self.window.x1))
            }
        }
    }

    /// Paints the open pixels that are connected with the open pixel `at`; or some of them, until the walker stands on a pixel
    /// that `is_found`: what is left is connected with that one.
    #[inline(never)]
    pub(super) fn paint_along_walls(&mut self, at: (i32, i32), is_found: impl Fn(i32, i32) -> bool) {
        let mut walker = self.below_wall(at);
        let mut lap = Lap::new(walker);
        // Steps that it may still take.
        let mut paid = NEAR;
        loop {
            if paid > 0 && is_found(walker.x, walker.y) {
                return;
            }
            let around = self.around((walker.x, walker.y));
            let mut free = around.walls == 1 || around.steps == 0;
            if !free && lap.is_over(walker) {
                let passed_twice = lap.start.direction != walker.direction;
                free = !passed_twice && around.walls == 2;
                if !free {
                    walker = if lap.turns < 0 {
                        self.below_wall(lap.top)
                    } else {
                        lap.start.step(|way| around.leads(way)).0
                    };
                    lap = Lap::new(walker);
                    continue;
                }
            }
            let (next, turn) = walker.step(|way| around.leads(way));
            if !free && lap.steps & (NEAR - 1) == 0 && lap.steps > 0 {
                free = self.only_islands(walker, next.direction, around, lap.steps & lap.steps.wrapping_neg());
            }
            if free {
                self.target.paint_pixel(walker.x, walker.y);
                if around.steps == 0 {
                    return;
                }
                lap = Lap::new(next);
                paid = paid.saturating_add(PAID);
            } else {
                lap.go(next, turn);
                paid = paid.saturating_sub(1);
            }
            walker = next;
        }
    }

    /// Follows the wall beside an open pixel, at most [`NEAR`] steps and without painting, to a pixel that `is_found`. The pixel
    /// above is not open, or the one below with `down` -1.
    #[inline(never)]
    pub(super) fn look_along_wall(&self, (x, y): (i32, i32), down: i32, is_found: impl Fn(i32, i32) -> bool) -> Seen {
        let mut walker = Walker { x, y, direction: if down > 0 { 0 } else { 4 } };
        let mut lap = Lap::new(walker);
        for _ in 0..NEAR {
            if is_found(walker.x, walker.y) {
                return Seen::Found;
            }
            let (next, turn) = self.step(walker);
            if next == lap.start && lap.turns.wrapping_add(turn) > 0 || (next.x, next.y) == (walker.x, walker.y) {
                return Seen::Closed;
            }
            // The lap begins after the first step: before it, the direction was a guess.
            if lap.steps == 0 {
                lap = Lap::new(next);
                lap.steps = 1;
            } else {
                lap.go(next, turn);
            }
            walker = next;
        }
        Seen::Nothing
    }

    /// Whether all walls that meet at a pixel, but the one on the walker's left, are islands that no more than `limit` steps lead
    /// around. `next` is the direction in which it goes on.
    #[cold]
    #[inline(never)]
    fn only_islands(&self, walker: Walker, next: u32, around: Around, limit: u32) -> bool {
        let mut way = next;
        loop {
            // Clockwise from way to way. What lies before the first one is its own wall.
            let after = (1..8).map(|turn| way.wrapping_add(turn) & 7).find(|&way| around.leads(way)).unwrap_or(next);
            if after == next {
                return true;
            }
            let from_there = Walker { direction: way.wrapping_add(4) & 7, ..walker };
            if around.is_wall_between(way, after, self.connectivity) && !self.is_island(from_there, limit) {
                return false;
            }
            way = after;
        }
    }

    /// Whether the wall that a walker follows leads back to this pixel for the first time as it first came.
    fn is_island(&self, start: Walker, limit: u32) -> bool {
        let mut walker = start;
        for _ in 0..limit {
            walker = self.step(walker).0;
            if (walker.x, walker.y) == (start.x, start.y) {
                return walker == start;
            }
        }
        false
    }

    /// Straight up from an open pixel to where a wall is above, as if come along it from the left.
    fn below_wall(&self, (x, mut y): (i32, i32)) -> Walker {
        while self.is_open(x, y.wrapping_sub(1)) {
            y = y.wrapping_sub(1);
        }
        Walker { x, y, direction: 0 }
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        self.window.contains(x, y) && self.target.is_open(x, y)
    }

    /// One step, looking at no more neighbours than it takes.
    fn step(&self, walker: Walker) -> (Walker, i32) {
        let is_open = |direction: u32| {
            let (x, y) = neighbour(walker.x, walker.y, direction);
            (self.connectivity == Connectivity::Corners || direction & 1 == 0) && self.is_open(x, y)
        };
        walker.step(is_open)
    }

    fn around(&self, (x, y): (i32, i32)) -> Around {
        let bit = |direction| {
            let (x, y) = neighbour(x, y, direction);
            u32::from(self.is_open(x, y)) << direction
        };
        let open = (0..8).fold(0, |bits, direction| bits | bit(direction));
        // Yokoi's number: the sides where something begins that does not go on around the corner.
        let (seen, steps) = match self.connectivity {
            Connectivity::Sides => (open, open & 0x55),
            Connectivity::Corners => (!open & 0xff, open),
        };
        let twice = seen | seen << 8;
        Around { open, steps, walls: (seen & !(twice >> 1 & twice >> 2) & 0x55).count_ones() }
    }
}

/// What lies around a pixel.
#[derive(Copy, Clone)]
struct Around {
    /// The open neighbours, as bits.
    open: u32,
    /// Those that can be stepped to.
    steps: u32,
    /// The number of walls that meet here.
    walls: u32,
}

impl Around {
    /// Whether one can step there.
    fn leads(self, direction: u32) -> bool {
        self.steps.wrapping_shr(direction) & 1 != 0
    }

    /// Whether a wall reaches in between two ways, the second one next to the first one clockwise.
    fn is_wall_between(self, way: u32, after: u32, connectivity: Connectivity) -> bool {
        let eighths = after.wrapping_sub(way) & 7;
        match connectivity {
            // Beside one another, with an open corner between them.
            Connectivity::Sides => eighths != 2 || self.open >> (way.wrapping_add(1) & 7) & 1 == 0,
            // A side between them.
            Connectivity::Corners => eighths != 1 && (eighths != 2 || way & 1 != 0),
        }
    }
}

impl Walker {
    /// One step along the wall on the left, and by how many eighths it turns to the right.
    #[inline(always)]
    fn step(self, is_open: impl Fn(u32) -> bool) -> (Self, i32) {
        for turn in -2..=5 {
            let direction = self.direction.wrapping_add_signed(turn) & 7;
            if is_open(direction) {
                let (x, y) = neighbour(self.x, self.y, direction);
                return (Self { x, y, direction }, turn);
            }
        }
        (self, 0)
    }
}

impl Lap {
    fn new(start: Walker) -> Self {
        Self { start, steps: 0, turns: 0, top: (start.x, start.y) }
    }

    fn go(&mut self, to: Walker, turn: i32) {
        self.steps = self.steps.wrapping_add(1);
        self.turns = self.turns.wrapping_add(turn);
        if to.y < self.top.1 {
            self.top = (to.x, to.y);
        }
    }

    /// Whether the walker is back at the first pixel. All the way round it has turned once.
    fn is_over(&self, walker: Walker) -> bool {
        (walker.x, walker.y) == (self.start.x, self.start.y) && (walker != self.start || self.turns != 0)
    }
}

fn neighbour(x: i32, y: i32, direction: u32) -> (i32, i32) {
    let (dx, dy) = NEIGHBOURS.get(direction as usize).copied().unwrap_or_default();
    (x.wrapping_add(dx), y.wrapping_add(dy))
}
