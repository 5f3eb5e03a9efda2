//! Ears: corners whose triangles can be cut off.
//!
//! The triangle of a corner is that of the corner, the one before it and the one after it. A corner is *convex* if the
//! loop turns clockwise there, and *reflex* otherwise. A convex corner is an ear if no other corner lies in its
//! triangle or on the side that closes it. It is enough to look at reflex corners: if any corners lie in the triangle,
//! then the one that is farthest from the closing side is reflex. And it stays reflex while it lies there, so when an
//! ear is cut off, only the corners beside it can become ears.

use core::cmp::Ordering;

use super::mesh::Mesh;
use crate::geom::exact::turn_at;

/// The node is on no loop any more.
const CUT: u16 = 2;
/// The corner is convex.
const CONVEX: u16 = 4;
/// Its triangle can be cut off.
const EAR: u16 = 8;

impl Mesh<'_> {
    /// Cuts all loops into triangles.
    pub(super) fn cut_ears(&mut self, mut emit: impl FnMut([u16; 3])) {
        for start in self.numbers() {
            if self.node(start).flags & CUT == 0 {
                self.cut_loop(start, &mut emit);
            }
        }
    }

    /// Cuts the loop of a node into triangles.
    fn cut_loop(&mut self, start: u16, emit: &mut impl FnMut([u16; 3])) {
        let mut left = 0_u16;
        self.walk(start, start, |mesh, i| {
            mesh.update_convex(i);
            left = left.wrapping_add(1);
        });
        self.walk(start, start, Self::update_ear);
        let (mut at, mut idle) = (start, 0_u16);
        while left > 2 && idle <= left {
            let node = self.node(at);
            if node.flags & EAR == 0 {
                (at, idle) = (node.next, idle.wrapping_add(1));
                continue;
            }
            emit([node.prev, at, node.next].map(|i| self.node(i).vertex));
            self.cut(at, &mut left);
            let before = self.remove_spikes(node.prev, &mut left);
            let after = self.node(before).next;
            for i in [before, after] {
                self.update_convex(i);
            }
            for i in [before, after] {
                self.update_ear(i);
            }
            // Go on one corner further: many ears that share a corner would be long and thin.
            (at, idle) = (self.node(after).next, 0);
        }
        self.walk(at, at, |mesh, i| mesh.set(i, |node| node.flags |= CUT));
    }

    /// Takes a node out of its loop.
    fn cut(&mut self, i: u16, left: &mut u16) {
        let node = self.node(i);
        self.join(node.prev, node.next);
        self.set(i, |node| node.flags |= CUT);
        *left = left.wrapping_sub(1);
    }

    /// Removes the spikes at the node `before` and at the one after it, where the loop goes along a side and back.
    /// Returns `before` or, if that was removed, the node before it.
    fn remove_spikes(&mut self, mut before: u16, left: &mut u16) -> u16 {
        while *left > 2 {
            let node = self.node(before);
            let after = self.node(node.next);
            if self.node(node.prev).vertex == after.vertex {
                self.cut(before, left);
                self.cut(node.next, left);
                before = node.prev;
            } else if node.vertex == self.node(after.next).vertex {
                self.cut(node.next, left);
                self.cut(after.next, left);
            } else {
                break;
            }
        }
        before
    }

    /// Notes whether a corner is convex.
    fn update_convex(&mut self, i: u16) {
        let [before, at, after] = self.corner(i);
        let is_convex = turn_at(before, at, after) == Ordering::Greater;
        self.set(i, |node| node.flags = if is_convex { node.flags | CONVEX } else { node.flags & !CONVEX });
    }

    /// Notes whether a corner is an ear.
    fn update_ear(&mut self, i: u16) {
        let is_ear = self.node(i).flags & CONVEX != 0 && self.holds_no_corner(i);
        self.set(i, |node| node.flags = if is_ear { node.flags | EAR } else { node.flags & !EAR });
    }

    /// Whether no reflex corner lies in the triangle of a convex one.
    fn holds_no_corner(&self, i: u16) -> bool {
        let node = self.node(i);
        let [a, b, c] = self.corner(i);
        let own = [node.prev, i, node.next].map(|i| self.node(i).vertex);
        let mut at = self.node(node.next).next;
        for _ in 0..self.len {
            if at == node.prev {
                break;
            }
            let other = self.node(at);
            if other.flags & CONVEX == 0 && !own.contains(&other.vertex) {
                let p = self.place(other.vertex);
                let outside = |a, b| turn_at(a, b, p) == Ordering::Less;
                // Most of them lie beyond the closing side: it is tested first.
                if !(outside(c, a) || outside(a, b) || outside(b, c)) {
                    return false;
                }
            }
            at = other.next;
        }
        true
    }
}
