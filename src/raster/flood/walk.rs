//! Flood fill without any memory: along the walls.
//!
//! A walker keeps a wall on its left. Whenever the pixels around it stay connected without the pixel that it stands on, it paints
//! that pixel and steps off. So what is left to paint stays in one piece, with the walker in it. At the end one pixel is left.
//!
//! Whether the pixels around stay connected is seen from the eight neighbours: the *crossing number* is the number of walls
//! that meet at a pixel, as far as one can see from there. At 1 it may be painted. At 2 it is part of a corridor: without
//! it the region is in two pieces if both walls are the same one, and still in one piece if they are different. So when the
//! walker comes round to where it has been and has painted nothing, it has followed one whole wall:
//! - It came back the way it first came, and to this pixel for the first time, so the other wall is a different one: if
//!   two walls meet here, the pixel is painted, and the loop is open.
//! - It came from another side: both are the same wall. It goes back, and looks at the next pixel in the same way.
//! - If neither helps, and the wall was that of an island in the region, the walker leaves it: from the highest pixel
//!   along it, straight up to the next wall, which reaches higher. The outermost wall always has a pixel to paint. For a pixel
//!   that joins two parts of the region, take the part behind it: the pixel there that reaches furthest to some side is passed
//!   once in a lap, and two walls at most meet at it.
//!
//! Sources: S. Yokoi, J. Toriwaki, T. Fukumura, "An analysis of topological properties of digitized binary pictures using
//! local features", Computer Graphics and Image Processing 4, 1975 (the crossing number).

use super::target::{Connectivity, FloodTarget};
use crate::span::Rect;

/// The neighbours, clockwise from the right one: even numbers share a side.
const NEIGHBOURS: [(i32, i32); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

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
    /// Eighths of a turn to the right so far: at the end 8 around the region, -8 around an island.
    turns: i32,
    /// The highest pixel so far.
    top: (i32, i32),
}

/// Paints the open pixels that are connected with the open pixel at `(x, y)`.
pub(super) fn paint(target: &mut impl FloodTarget, window: Rect, connectivity: Connectivity, (x, y): (i32, i32)) {
    let mut walker = Walker::below_wall(target, window, (x, y));
    let mut lap = Lap::new(walker);
    loop {
        let (open, walls) = around(target, window, connectivity, (walker.x, walker.y));
        let mut free = walls == 1 || open == 0;
        if !free && lap.is_over(walker) {
            let passed_twice = lap.start.direction != walker.direction;
            free = !passed_twice && walls == 2;
            if !free {
                walker = if !passed_twice && lap.turns < 0 {
                    Walker::below_wall(target, window, lap.top)
                } else {
                    lap.start.step(open, connectivity).0
                };
                lap = Lap::new(walker);
                continue;
            }
        }
        let (next, turn) = walker.step(open, connectivity);
        if free {
            target.paint_pixel(walker.x, walker.y);
            if open == 0 {
                return;
            }
            lap = Lap::new(next);
        } else {
            lap.go(next, turn);
        }
        walker = next;
    }
}

impl Walker {
    /// Straight up from an open pixel to where a wall is above, as if come along it from the left.
    fn below_wall(target: &impl FloodTarget, window: Rect, (x, mut y): (i32, i32)) -> Self {
        while is_open(target, window, x, y.wrapping_sub(1)) {
            y = y.wrapping_sub(1);
        }
        Self { x, y, direction: 0 }
    }

    /// One step along the wall on the left, and by how many eighths it turns to the right.
    fn step(self, open: u32, connectivity: Connectivity) -> (Self, i32) {
        // By corners, the pixel to the left of the last step is known to be closed.
        let first = if connectivity == Connectivity::Sides || self.direction & 1 != 0 { -2 } else { -1 };
        for turn in first..first + 8 {
            let direction = self.direction.wrapping_add_signed(turn) & 7;
            if open >> direction & 1 != 0 {
                let (x, y) = neighbour(self.x, self.y, direction);
                return (Self { x, y, direction }, turn);
            }
        }
        (self, 0)
    }
}

impl Lap {
    fn new(start: Walker) -> Self {
        Self { start, turns: 0, top: (start.x, start.y) }
    }

    fn go(&mut self, to: Walker, turn: i32) {
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

fn is_open(target: &impl FloodTarget, window: Rect, x: i32, y: i32) -> bool {
    window.contains(x, y) && target.is_open(x, y)
}

fn neighbour(x: i32, y: i32, direction: u32) -> (i32, i32) {
    let (dx, dy) = NEIGHBOURS.get(direction as usize).copied().unwrap_or_default();
    (x.wrapping_add(dx), y.wrapping_add(dy))
}

/// The open neighbours that can be stepped to, as bits, and the number of walls that meet here.
fn around(target: &impl FloodTarget, window: Rect, connectivity: Connectivity, (x, y): (i32, i32)) -> (u32, u32) {
    let open = |direction| {
        let (x, y) = neighbour(x, y, direction);
        u32::from(is_open(target, window, x, y)) << direction
    };
    let open = (0..8).fold(0, |bits, direction| bits | open(direction));
    // Yokoi's number: the sides where something begins that does not go on around the corner.
    let (seen, steps) = match connectivity {
        Connectivity::Sides => (open, open & 0x55),
        Connectivity::Corners => (!open & 0xff, open),
    };
    let twice = seen | seen << 8;
    (steps, (seen & !(twice >> 1 & twice >> 2) & 0x55).count_ones())
}
