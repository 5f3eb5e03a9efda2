//! Ears: corners whose triangles can be cut off.
//!
//! A corner is an ear when it turns inwards and no reflex corner lies in its triangle or on the side that closes it. Of
//! the corners in a triangle the one that hides the others from its tip is always reflex, so those that are not need no
//! test; and it stays reflex while it is there, so cutting an ear off can make ears of its two neighbours only.

use core::cmp::Ordering;

use super::mesh::Mesh;
use crate::geom::exact::turn_at;

/// The node is on no loop any more.
const CUT: u16 = 2;
/// The corner turns inwards.
const CONVEX: u16 = 4;
/// Its triangle can be cut off.
const EAR: u16 = 8;

impl Mesh<'_> {
    /// Cuts up all loops.
    pub(super) fn cut_ears(&mut self, mut emit: impl FnMut([u16; 3])) {
        for start in self.numbers() {
            if self.node(start).flags & CUT == 0 {
                self.cut_loop(start, &mut emit);
            }
        }
    }

    /// Cuts up the loop of a node.
    fn cut_loop(&mut self, start: u16, emit: &mut impl FnMut([u16; 3])) {
        let mut left = 0_u16;
        self.walk(start, start, |mesh, i| {
            mesh.judge_turn(i);
            left = left.wrapping_add(1);
        });
        self.walk(start, start, Self::judge_ear);
        let (mut at, mut idle) = (start, 0_u16);
        while left > 2 && idle <= left {
            let node = self.node(at);
            if node.flags & EAR == 0 {
                (at, idle) = (node.next, idle.wrapping_add(1));
                continue;
            }
            emit([node.prev, at, node.next].map(|i| self.node(i).vertex));
            self.cut(at, &mut left);
            let before = self.unfold(node.prev, &mut left);
            let after = self.node(before).next;
            for i in [before, after] {
                self.judge_turn(i);
            }
            for i in [before, after] {
                self.judge_ear(i);
            }
            // Not the neighbour: triangles that share a corner are long and thin.
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

    /// Where cutting left a way there and back, takes it out; returns the node in whose place `before` is then.
    fn unfold(&mut self, mut before: u16, left: &mut u16) -> u16 {
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

    fn judge_turn(&mut self, i: u16) {
        let [before, at, after] = self.corner(i);
        let is_convex = turn_at(before, at, after) == Ordering::Greater;
        self.set(i, |node| node.flags = if is_convex { node.flags | CONVEX } else { node.flags & !CONVEX });
    }

    fn judge_ear(&mut self, i: u16) {
        let is_ear = self.node(i).flags & CONVEX != 0 && self.is_free(i);
        self.set(i, |node| node.flags = if is_ear { node.flags | EAR } else { node.flags & !EAR });
    }

    /// Whether no reflex corner lies in the triangle of a convex one.
    fn is_free(&self, i: u16) -> bool {
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
                // The side that closes the triangle keeps out more of them than the others.
                if !(outside(c, a) || outside(a, b) || outside(b, c)) {
                    return false;
                }
            }
            at = other.next;
        }
        true
    }
}
