//! Sides: finds where they cross and touch, makes of them a set in which sides share nothing but ends, and directs each
//! so that the inside is on its right hand.

use core::cmp::Ordering;

use super::mesh::{in_sector, order, Mesh, SideSlot};
use crate::geom::{
    exact::{turn_at, Place},
    point::{bits, PointFx},
};

/// The sides of all contours, as the numbers of the vertices where they start and end.
#[derive(Copy, Clone)]
pub(super) struct Sides<'a> {
    vertices: &'a [PointFx],
    starts: &'a [u16],
    /// The contour at hand: its first vertex, the vertex where its next side starts, and the one after its last.
    first: usize,
    at: usize,
    end: usize,
}

impl<'a> Sides<'a> {
    /// Contours that would end before they start, or after the last vertex, are empty.
    pub(super) fn new(vertices: &'a [PointFx], starts: &'a [u16]) -> Self {
        let mut sides = Self { vertices, starts, first: 0, at: 0, end: 0 };
        sides.next_contour();
        sides
    }

    pub(super) fn vertices(&self) -> &'a [PointFx] {
        self.vertices
    }

    /// Sides in all: every vertex starts one.
    pub(super) fn count(&self) -> usize {
        self.vertices.len()
    }

    /// Goes on to the next contour; false after the last one.
    fn next_contour(&mut self) -> bool {
        if self.at == self.vertices.len() {
            return false;
        }
        (self.first, self.at) = (self.end, self.end);
        self.end = match self.starts.split_first() {
            Some((&start, rest)) => {
                self.starts = rest;
                usize::from(start).clamp(self.end, self.vertices.len().max(self.end))
            }
            None => self.vertices.len(),
        };
        true
    }

    /// The next side: the numbers of the vertices at its ends.
    pub(super) fn next(&mut self) -> Option<(usize, usize)> {
        while self.at >= self.end {
            if !self.next_contour() {
                return None;
            }
        }
        let at = self.at;
        self.at = at.wrapping_add(1);
        Some((at, if self.at < self.end { self.at } else { self.first }))
    }

    fn place(&self, vertex: usize) -> Place {
        self.vertices.get(vertex).copied().map_or((0, 0), bits)
    }

    /// The first vertex at the place of another.
    fn first_at(&self, vertex: usize) -> usize {
        let place = self.place(vertex);
        self.vertices.iter().position(|&v| bits(v) == place).unwrap_or(vertex)
    }
}

/// Whether the boxes of two sides have a place in common.
#[inline(always)]
fn boxes_overlap((a, b): (Place, Place), (c, d): (Place, Place)) -> bool {
    let overlap = |a: i32, b: i32, c: i32, d: i32| a.min(b) <= c.max(d) && c.min(d) <= a.max(b);
    overlap(a.0, b.0, c.0, d.0) && overlap(a.1, b.1, c.1, d.1)
}

/// Whether `p` lies on the side `ab`, but not at an end.
fn is_between(a: Place, b: Place, p: Place) -> bool {
    boxes_overlap((a, b), (p, p)) && p != a && p != b && turn_at(a, b, p) == Ordering::Equal
}

impl Mesh<'_> {
    /// Loads the sides whose ends are different places. Of several vertices at the same place the first one stands for
    /// all.
    pub(super) fn load(&mut self, mut sides: Sides<'_>) {
        let all = sides;
        let number = |vertex: usize| u16::try_from(all.first_at(vertex)).unwrap_or(u16::MAX);
        while let Some((from, to)) = sides.next() {
            let (vertex, end) = (number(from), number(to));
            if vertex != end {
                self.push(SideSlot { vertex, end, ..SideSlot::EMPTY });
            }
        }
    }

    /// Splits sides at the vertices that lie on them.
    pub(super) fn split(&mut self) {
        let mut i = 0;
        // The parts are added at the end, and are split in their turn.
        while usize::from(i) < self.len {
            for vertex in 0..u16::try_from(self.vertices.len()).unwrap_or(u16::MAX) {
                let side = self.node(i);
                if is_between(self.place(side.vertex), self.place(side.end), self.place(vertex)) {
                    // Vertices are tried in order, so this is the first one at its place.
                    self.set(i, |node| node.end = vertex);
                    self.push(SideSlot { vertex, ..side });
                }
            }
            i = i.saturating_add(1);
        }
    }

    /// Takes out pairs of sides that lie on each other.
    pub(super) fn cancel(&mut self) {
        let mut i = 0;
        while usize::from(i) < self.len {
            let side = self.node(i);
            let same = |other: SideSlot| {
                (other.vertex, other.end) == (side.vertex, side.end)
                    || (other.end, other.vertex) == (side.vertex, side.end)
            };
            match self.numbers().skip(usize::from(i).wrapping_add(1)).find(|&j| same(self.node(j))) {
                Some(j) => {
                    self.remove(j);
                    self.remove(i);
                }
                None => i = i.saturating_add(1),
            }
        }
    }

    /// Removes a side: the last one takes its place.
    fn remove(&mut self, i: u16) {
        self.len = self.len.saturating_sub(1);
        let last = self.nodes.get(self.len).copied().unwrap_or(SideSlot::EMPTY);
        self.set(i, |node| *node = last);
    }

    /// Directs every side so that the inside lies on its right hand, as seen on the screen.
    pub(super) fn direct(&mut self) {
        for i in self.numbers() {
            let side = self.node(i);
            let (upper, lower) = self.downwards(side.vertex, side.end);
            let is_inside = self.numbers().fold(false, |odd, j| odd ^ (j != i && self.is_left(j, upper, lower)));
            // The right hand of a side that goes down is on the left of the screen.
            let goes_down = side.vertex == upper;
            if is_inside != goes_down {
                self.set(i, |node| (node.vertex, node.end) = (side.end, side.vertex));
            }
        }
    }

    /// Whether a side passes left of another one, on the row just below the upper end of the other.
    fn is_left(&self, i: u16, upper: u16, lower: u16) -> bool {
        let side = self.node(i);
        let (u, v) = self.downwards(side.vertex, side.end);
        // Sides that start at the same place are compared by their directions.
        let seen = self.place(if u == upper { lower } else { upper });
        let (u, v, start) = (self.place(u), self.place(v), self.place(upper));
        order(u) <= order(start) && order(start) < order(v) && turn_at(u, v, seen) == Ordering::Less
    }

    /// Links each side to the one that follows it: of those that start where it ends, the one with none of the others
    /// between the two, on the inside.
    pub(super) fn link(&mut self) {
        for i in self.numbers() {
            let side = self.node(i);
            let mut next = None;
            for j in self.numbers() {
                let other = self.node(j);
                if other.vertex != side.end {
                    continue;
                }
                let is_nearer = |&(_, after): &(u16, u16)| {
                    let corner = [side.vertex, side.end, after].map(|vertex| self.place(vertex));
                    in_sector(corner, self.place(other.end))
                };
                if next.as_ref().is_none_or(is_nearer) {
                    next = Some((j, other.end));
                }
            }
            if let Some((next, _)) = next {
                self.join(i, next);
            }
        }
    }
}
