//! Loops: which of them go round holes, and the bridges that join these to the outlines around them.

use core::cmp::Ordering;

use super::mesh::{in_sector, order, Mesh, SideSlot};
use crate::{
    geom::exact::{turn_at, Place},
    num::round::difference,
};

/// The loop of the node was looked at.
const SEEN: u16 = 1;

impl Mesh<'_> {
    /// Joins every loop that goes round a hole to a loop that reaches further left. If that goes round a hole, it is
    /// joined in turn, and the last one of them is an outline.
    pub(super) fn bridge_holes(&mut self) {
        for i in self.numbers() {
            if self.node(i).flags & SEEN == 0 {
                let (area, leftmost) = self.area_and_leftmost(i);
                if area < 0 {
                    self.bridge(leftmost);
                }
            }
        }
    }

    /// Twice the area of a loop, negative if it goes round a hole, and its leftmost vertex, the uppermost of several.
    fn area_and_leftmost(&mut self, start: u16) -> (i128, u16) {
        let (mut area, mut leftmost) = (0_i128, self.node(start).vertex);
        self.walk(start, start, |mesh, i| {
            let [before, at, after] = mesh.corner(i);
            area = area.wrapping_add(i128::from(i64::from(at.0).wrapping_mul(difference(after.1, before.1))));
            if at < mesh.place(leftmost) {
                leftmost = mesh.node(i).vertex;
            }
            mesh.set(i, |node| node.flags |= SEEN);
        });
        (area, leftmost)
    }

    /// Joins a hole, given by its leftmost vertex, to a vertex on its left by two sides, one in each direction.
    fn bridge(&mut self, hole: u16) {
        let Some(corner) = self.visible_from(hole) else { return };
        let node_at = |vertex: u16, towards: u16| {
            let place = self.place(towards);
            self.numbers().find(|&i| self.node(i).vertex == vertex && in_sector(self.corner(i), place))
        };
        let (Some(from), Some(to)) = (node_at(corner, hole), node_at(hole, corner)) else { return };
        let (after, before) = (self.node(from).next, self.node(to).prev);
        let back = self.push(SideSlot { vertex: hole, flags: SEEN, ..SideSlot::EMPTY });
        let on = self.push(SideSlot { vertex: corner, flags: SEEN, ..SideSlot::EMPTY });
        self.join(from, to);
        self.join(before, back);
        self.join(back, on);
        self.join(on, after);
    }

    /// A vertex on the left of a hole that can be joined to the leftmost vertex of the hole without crossing a side.
    ///
    /// The ray from that leftmost vertex to the left hits a side, and the end of this side that lies further left is a
    /// candidate. If vertices lie in the triangle between the candidate, the leftmost vertex and the place that was
    /// hit, they may be in the way. Of these take the one whose direction from the leftmost vertex is closest to the
    /// ray: nothing is in front of it.
    fn visible_from(&self, hole: u16) -> Option<u16> {
        let h = self.place(hole);
        let (upper, lower) = self.side_left_of(h)?;
        let (u, v) = (self.place(upper), self.place(lower));
        let is_above = u.0 <= v.0;
        let closer = if is_above { Ordering::Less } else { Ordering::Greater };
        let mut best = if is_above { upper } else { lower };
        for i in self.numbers() {
            let vertex = self.node(i).vertex;
            let (p, goal) = (self.place(vertex), self.place(best));
            let in_reach = p != h && (order(p) < order(h)) == is_above && turn_at(u, v, p) == Ordering::Less;
            if !in_reach {
                continue;
            }
            let turn = turn_at(h, goal, p);
            let is_nearer = h.0.abs_diff(p.0) < h.0.abs_diff(goal.0);
            if turn == closer || turn == Ordering::Equal && is_nearer {
                best = vertex;
            }
        }
        Some(best)
    }

    /// The side that a ray from a place to the left hits first: its upper end and its lower end.
    fn side_left_of(&self, h: Place) -> Option<(u16, u16)> {
        let mut nearest = None;
        for i in self.numbers() {
            let node = self.node(i);
            let side = self.downwards(node.vertex, self.node(node.next).vertex);
            let (u, v) = (self.place(side.0), self.place(side.1));
            let is_left = order(u) < order(h) && order(h) < order(v) && turn_at(u, v, h) == Ordering::Less;
            if is_left && nearest.is_none_or(|other| self.is_right_of(side, other)) {
                nearest = Some(side);
            }
        }
        nearest
    }

    /// Whether a side lies right of another one on the rows that both of them have. They do not cross.
    fn is_right_of(&self, side: (u16, u16), other: (u16, u16)) -> bool {
        let [u, v, other_u, other_v] = [side.0, side.1, other.0, other.1].map(|vertex| self.place(vertex));
        match order(u).cmp(&order(other_u)) {
            Ordering::Less => turn_at(u, v, other_u) == Ordering::Greater,
            Ordering::Equal => turn_at(other_u, other_v, v) == Ordering::Less,
            Ordering::Greater => turn_at(other_u, other_v, u) == Ordering::Less,
        }
    }
}
