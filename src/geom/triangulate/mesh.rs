//! The mesh: sides that are linked to loops, in the slots of the caller's table. A slot in use is called a node.

use core::{cmp::Ordering, ops::Range};

use crate::geom::{
    exact::{turn_at, Place},
    point::{bits, PointFx},
};

/// One slot of the scratch table: a side of the polygon, and the corner where it starts.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct SideSlot {
    /// The vertex where the side starts.
    pub(super) vertex: u16,
    /// The vertex where it ended when it was loaded.
    pub(super) end: u16,
    /// The node before it on its loop.
    pub(super) prev: u16,
    /// The node after it.
    pub(super) next: u16,
    /// What is known of the corner: bits that `loops` and `ears` define.
    pub(super) flags: u16,
}

impl SideSlot {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::geom::triangulate::SideSlot;
    /// let mut slots = [SideSlot::EMPTY; 64]; // 640 bytes
    /// assert_eq!(core::mem::size_of_val(&slots), 640);
    /// ```
    pub const EMPTY: Self = Self { vertex: 0, end: 0, prev: 0, next: 0, flags: 0 };
}

/// The vertices, and the nodes that name them. Of `nodes`, the first `len` are in use.
pub(super) struct Mesh<'a> {
    pub(super) vertices: &'a [PointFx],
    pub(super) nodes: &'a mut [SideSlot],
    pub(super) len: usize,
}

impl<'a> Mesh<'a> {
    /// No nodes yet.
    pub(super) fn new(vertices: &'a [PointFx], nodes: &'a mut [SideSlot]) -> Self {
        Self { vertices, nodes, len: 0 }
    }

    /// The numbers of the nodes in use.
    #[inline(always)]
    pub(super) fn numbers(&self) -> Range<u16> {
        0..u16::try_from(self.len).unwrap_or(u16::MAX)
    }

    /// A node by its number.
    #[inline(always)]
    pub(super) fn node(&self, i: u16) -> SideSlot {
        self.nodes.get(usize::from(i)).copied().unwrap_or(SideSlot::EMPTY)
    }

    /// Changes a node.
    #[inline(always)]
    pub(super) fn set(&mut self, i: u16, change: impl FnOnce(&mut SideSlot)) {
        if let Some(node) = self.nodes.get_mut(usize::from(i)) {
            change(node);
        }
    }

    /// Adds a node and returns its number. There is room for it: slots were counted before.
    pub(super) fn push(&mut self, node: SideSlot) -> u16 {
        let at = self.len;
        if let Some(slot) = self.nodes.get_mut(at) {
            *slot = node;
            self.len = at.wrapping_add(1);
        }
        u16::try_from(at).unwrap_or(u16::MAX)
    }

    /// Where a vertex is.
    #[inline(always)]
    pub(super) fn place(&self, vertex: u16) -> Place {
        self.vertices.get(usize::from(vertex)).copied().map_or((0, 0), bits)
    }

    /// The places of the node before a node, of the node itself, and of the node after it.
    #[inline(never)]
    pub(super) fn corner(&self, i: u16) -> [Place; 3] {
        let node = self.node(i);
        [self.node(node.prev).vertex, node.vertex, self.node(node.next).vertex].map(|vertex| self.place(vertex))
    }

    /// Links two nodes: `to` becomes the next one after `from`.
    #[inline(never)]
    pub(super) fn join(&mut self, from: u16, to: u16) {
        self.set(from, |node| node.next = to);
        self.set(to, |node| node.prev = from);
    }

    /// Visits the nodes of a loop from `from` on until `to` would come, and all of them if `to` is `from`.
    #[inline]
    pub(super) fn walk(&mut self, from: u16, to: u16, mut visit: impl FnMut(&mut Self, u16)) {
        let mut i = from;
        // A loop has no more nodes than there are.
        for _ in 0..self.len {
            visit(self, i);
            i = self.node(i).next;
            if i == to {
                break;
            }
        }
    }

    /// The upper of two vertices, then the lower.
    #[inline(never)]
    pub(super) fn downwards(&self, a: u16, b: u16) -> (u16, u16) {
        if order(self.place(a)) < order(self.place(b)) {
            (a, b)
        } else {
            (b, a)
        }
    }
}

/// Whether a place lies in the sector of a corner, seen from the corner: clockwise after the side that leaves the
/// corner, and before the side that comes to it. The sides themselves are not in it.
#[inline(never)]
pub(super) fn in_sector([before, at, after]: [Place; 3], p: Place) -> bool {
    let after_side = turn_at(at, after, p) == Ordering::Greater;
    let before_side = turn_at(at, p, before) == Ordering::Greater;
    if turn_at(at, after, before) == Ordering::Greater {
        after_side && before_side
    } else {
        // The sector has a half turn or more. What is outside of it has a half turn at most, and fails both tests.
        after_side || before_side
    }
}

/// A key that sorts places as one reads: from the top down, and each row from left to right. With "above" taken in this
/// order, one of two different places is always above the other, and no side is horizontal.
#[inline(always)]
pub(super) fn order(p: Place) -> (i32, i32) {
    (p.1, p.0)
}
