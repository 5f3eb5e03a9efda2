//! The sweep: whether any two sides cross, and how often vertices lie on sides.
//!
//! A row moves down over the polygon, from vertex to vertex, and knows the sides that it meets, in their order from left
//! to right. Two sides that cross are neighbours in that order just above the place where they do, or neighbours that
//! lie on them are. So it is enough to compare neighbours, whenever sides become neighbours: M. I. Shamos and D. Hoey,
//! "Geometric intersection problems", FOCS 1976.
//!
//! Sides that lie on one line and on one row are a *group*. It has one place in the order and is known by the side that
//! reaches furthest down, because what crosses any of them further down crosses that one too. As long as nothing
//! crosses, there is at most one group with a vertex of the row between the ends of its sides, and its size is the
//! number of sides that the vertex lies on. A zigzag on a line, where each vertex lies on nearly every side, is one
//! group.
//!
//! Groups are a binary tree. It is not balanced, but whatever is looked for comes to its root, by a way that halves long
//! paths: D. D. Sleator and R. E. Tarjan, "Self-adjusting binary search trees", Journal of the ACM 32, 1985, section 4. It
//! takes no memory but the two links of a node, and no input is bad for it. By their analysis, with the odd step at the
//! lower end of the path, a search among n takes 4 log2 n + 2 comparisons, on average over all of a sweep, and a node that
//! comes to the root otherwise counts for log2 n. For each vertex there are six searches at most: two when its side
//! starts, three when it ends, and one for its place; and twice a node comes to the root. With 2 n log2 n for sorting this
//! is less than 28 n log2 n + 20 n.
//!
//! The fields of the caller's slots mean something else here. For slot i they are:
//! * `vertex`: the vertex that is number i from the top.
//! * `end`: if vertex i is the first one of its contour, the last one; if it is the last one, the first; else `NONE`.
//! * `prev`, `next`: in the tree, the roots of what lies left and right of the group of side i.
//! * `flags`: the number of sides in that group.

use core::{cmp::Ordering, ops::Range};

use super::{
    mesh::{order, Mesh, SideSlot},
    sides::Sides,
};
use crate::geom::exact::turn_at;

/// No vertex and no side. (There are 65,535 at most.)
const NONE: u16 = u16::MAX;

/// How often a vertex lies on a side between the ends of it; vertices at the same place count once for a side. Or else
/// two sides that cross, by the vertices where they start: the first side that crosses one before it, and the first one
/// that it crosses, which comes first here.
pub(super) fn touches_or_crossing(sides: Sides<'_>, slots: &mut [SideSlot]) -> Result<usize, [usize; 2]> {
    let mut sweep = Sweep::new(sides, slots);
    let all = sweep.mesh.numbers().end;
    sweep.touches(all).ok_or_else(|| sweep.first_crossing(all).map(usize::from))
}

/// The two links of a node: to what lies left of it and right of it.
const LEFT: bool = false;
const RIGHT: bool = true;

/// The link that leads on to a side.
fn towards(side: Ordering) -> bool {
    side == Ordering::Less
}

/// A part of a tree that lies on one side of a way: its root, and the node whose link to the way is open.
#[derive(Copy, Clone)]
struct Part {
    top: u16,
    tail: u16,
}

/// Vertices from the top down, and the tree of groups on the row.
struct Sweep<'a> {
    mesh: Mesh<'a>,
    root: u16,
    /// The side that is looked for, by the vertices at its ends: the one that the row has come to, then the other.
    seen: (u16, u16),
}

impl<'a> Sweep<'a> {
    /// Sorts the vertices.
    fn new(mut sides: Sides<'a>, slots: &'a mut [SideSlot]) -> Self {
        // There is a slot for each vertex, and none has the number `NONE`.
        let slots = slots.get_mut(..sides.count()).unwrap_or_default();
        let mut mesh = Mesh::new(sides.vertices(), slots);
        while let Some((from, to)) = sides.next() {
            let [from, to] = [from, to].map(|vertex| u16::try_from(vertex).unwrap_or(NONE));
            let is_last = to <= from;
            mesh.push(SideSlot { vertex: from, end: if is_last { to } else { NONE }, ..SideSlot::EMPTY });
            if is_last {
                mesh.set(to, |node| node.end = from);
            }
        }
        let mut sweep = Self { mesh, root: NONE, seen: (NONE, NONE) };
        sweep.sort();
        sweep
    }

    /// Sorts the vertices from the top down: a heap sort, whose worst case is no worse.
    fn sort(&mut self) {
        let end = self.mesh.numbers().end;
        for top in (0..end / 2).rev() {
            self.sift(top, end);
        }
        for last in (1..end).rev() {
            self.swap(0, last);
            self.sift(0, last);
        }
    }

    /// Moves a vertex down in the heap of those before `end`, until none below it is greater.
    fn sift(&mut self, mut at: u16, end: u16) {
        // Halved, neither of the two below it is out of the range of u16.
        while at < end / 2 {
            let left = at.wrapping_mul(2).wrapping_add(1);
            let right = left.wrapping_add(1);
            let below = if right < end && self.comes_before(left, right) { right } else { left };
            if !self.comes_before(at, below) {
                break;
            }
            self.swap(at, below);
            at = below;
        }
    }

    /// Whether one vertex of the list is above another one.
    #[inline(never)]
    fn comes_before(&self, i: u16, j: u16) -> bool {
        count();
        self.is_above(self.listed(i), self.listed(j))
    }

    fn swap(&mut self, i: u16, j: u16) {
        let (a, b) = (self.listed(i), self.listed(j));
        self.mesh.set(i, |node| node.vertex = b);
        self.mesh.set(j, |node| node.vertex = a);
    }

    /// The vertex that has a number from the top.
    fn listed(&self, i: u16) -> u16 {
        self.mesh.node(i).vertex
    }

    /// The vertex after another one on its contour.
    fn after(&self, vertex: u16) -> u16 {
        let end = self.mesh.node(vertex).end;
        if end <= vertex {
            end
        } else {
            vertex.wrapping_add(1)
        }
    }

    /// The vertex before another one on its contour.
    fn before(&self, vertex: u16) -> u16 {
        let end = self.mesh.node(vertex).end;
        if end >= vertex && end != NONE {
            end
        } else {
            vertex.wrapping_sub(1)
        }
    }

    /// The upper end of a side, and the lower.
    fn ends(&self, side: u16) -> (u16, u16) {
        self.mesh.downwards(side, self.after(side))
    }

    /// Whether a vertex is above another one.
    #[inline(never)]
    fn is_above(&self, a: u16, b: u16) -> bool {
        order(self.mesh.place(a)) < order(self.mesh.place(b))
    }

    /// Which way the path over three vertices turns.
    #[inline(never)]
    fn turn(&self, a: u16, b: u16, c: u16) -> Ordering {
        turn_at(self.mesh.place(a), self.mesh.place(b), self.mesh.place(c))
    }

    /// The two sides to name, if any of the first ones cross.
    fn first_crossing(&mut self, sides: u16) -> [u16; 2] {
        // The first `none` sides do not cross, the first `some` do.
        let (mut none, mut some) = (0, sides);
        while some.abs_diff(none) > 1 {
            let middle = none.midpoint(some);
            if self.touches(middle).is_some() {
                none = middle;
            } else {
                some = middle;
            }
        }
        let first = (0..none).find(|&first| self.cross(first, none)).unwrap_or(none);
        [first, none]
    }

    /// How often vertices lie on the first sides, as many as are given; nothing if some of these cross.
    fn touches(&mut self, sides: u16) -> Option<usize> {
        let (mut touches, mut at, end) = (0_usize, 0, self.mesh.numbers().end);
        self.root = NONE;
        while at < end {
            let vertex = self.listed(at);
            let next = (at..end).find(|&i| self.comes_before(at, i)).unwrap_or(end);
            // First the sides that end here are taken out. If a group goes on, it has the vertex between its ends.
            self.meet(at..next, sides, false)?;
            self.seen = (vertex, vertex);
            if self.find() == Ordering::Equal {
                touches = touches.saturating_add(usize::from(self.mesh.node(self.root).flags));
            }
            self.meet(at..next, sides, true)?;
            at = next;
        }
        Some(touches)
    }

    /// Adds to the tree the sides that start at the listed vertices, which are at one place, or takes out those that end
    /// there. Only the first sides count. Nothing if any of them cross.
    #[inline(never)]
    fn meet(&mut self, listed: Range<u16>, sides: u16, start: bool) -> Option<()> {
        for i in listed {
            let vertex = self.listed(i);
            let before = self.before(vertex);
            for (side, other) in [(before, before), (vertex, self.after(vertex))] {
                self.seen = (vertex, other);
                let (upper, lower) = if start { (vertex, other) } else { (other, vertex) };
                if side < sides && self.is_above(upper, lower) {
                    if start {
                        self.insert(side)?;
                    } else {
                        self.remove()?;
                    }
                }
            }
        }
        Some(())
    }

    /// Adds the side that is looked for; nothing if it crosses a neighbour.
    #[inline(never)]
    fn insert(&mut self, side: u16) -> Option<()> {
        let way = self.find();
        let root = self.root;
        let (mut left, mut right, mut size) = (self.link(root, LEFT), self.link(root, RIGHT), 1_u16);
        if way == Ordering::Equal {
            size = self.mesh.node(root).flags.saturating_add(1);
            if !self.is_above(self.ends(root).1, self.seen.1) {
                self.mesh.set(root, |node| node.flags = size);
                return Some(());
            }
        } else {
            // The root is a neighbour. It goes below the side, with what lies beyond it.
            self.set_link(root, towards(way), NONE);
            *(if way == Ordering::Less { &mut left } else { &mut right }) = root;
        }
        (left, right) = (self.splay(left).0, self.splay(right).0);
        self.mesh.set(side, |node| (node.prev, node.next, node.flags) = (left, right, size));
        self.root = side;
        (!self.cross(left, side) && !self.cross(side, right)).then_some(())
    }

    /// Takes out the side that is looked for; nothing if the neighbours cross, between which it was.
    #[inline(never)]
    fn remove(&mut self) -> Option<()> {
        self.find();
        let root = self.root;
        let size = self.mesh.node(root).flags.saturating_sub(1);
        self.mesh.set(root, |node| node.flags = size);
        if size > 0 {
            return Some(());
        }
        let (left, right) = (self.splay(self.link(root, LEFT)).0, self.splay(self.link(root, RIGHT)).0);
        self.set_link(left, RIGHT, right);
        self.root = if left == NONE { right } else { left };
        (!self.cross(left, right)).then_some(())
    }

    /// Whether two sides cross, at a place that is an end of neither: the ends of each lie on opposite sides of the other.
    /// Not if one of them is none.
    fn cross(&self, i: u16, j: u16) -> bool {
        count();
        i != NONE && j != NONE && self.parts(i, j) && self.parts(j, i)
    }

    /// Whether the ends of a side lie on opposite sides of the line through another one.
    #[inline(never)]
    fn parts(&self, line: u16, side: u16) -> bool {
        let (end, to) = (self.after(line), self.after(side));
        let turn = self.turn(line, end, side);
        turn != Ordering::Equal && self.turn(line, end, to) == turn.reverse()
    }

    /// Brings the group of the side that is looked for, or a neighbour, to the root, as [`Self::splay`] says.
    fn find(&mut self) -> Ordering {
        let (root, way) = self.splay(self.root);
        self.root = root;
        way
    }

    /// Brings the group of the side that is looked for to the root of a tree and returns the new root, and where the side lies from there. If
    /// the group is not in the tree, it is the last one on the way to its place that comes to the root: a neighbour.
    ///
    /// On the way the tree is cut into what lies left of the way, what lies right of it, and what is still below. Nodes are
    /// taken two by two. If the way goes on in the same direction, the second one is first moved above the first: so the
    /// depth of all on the way is halved.
    fn splay(&mut self, mut root: u16) -> (u16, Ordering) {
        let mut parts = [Part { top: NONE, tail: NONE }; 2];
        let mut side = self.compare(root);
        while side != Ordering::Equal {
            let mut way = towards(side);
            let below = self.link(root, way);
            if below == NONE {
                break;
            }
            let side_below = self.compare(below);
            if side_below == side {
                self.set_link(root, way, self.link(below, !way));
                self.set_link(below, !way, root);
            } else {
                self.hang(&mut parts, root, way);
                side = side_below;
                way = towards(side);
            }
            root = below;
            let below = self.link(root, way);
            if side == Ordering::Equal || below == NONE {
                break;
            }
            self.hang(&mut parts, root, way);
            root = below;
            side = self.compare(root);
        }
        for way in [LEFT, RIGHT] {
            let Part { top, tail } = parts[usize::from(way)];
            if tail != NONE {
                self.set_link(tail, !way, self.link(root, way));
                self.set_link(root, way, top);
            }
        }
        (root, side)
    }

    /// Cuts off a node with all that lies beyond it, where the way goes on to one of its sides.
    #[inline(never)]
    fn hang(&mut self, parts: &mut [Part; 2], node: u16, way: bool) {
        let part = &mut parts[usize::from(!way)];
        if part.tail == NONE {
            part.top = node;
        }
        self.set_link(part.tail, way, node);
        part.tail = node;
    }

    /// Where the side that is looked for lies from a group, on the row: left of it (`Greater`, as it turns clockwise from what goes down), right
    /// of it (`Less`), or on its line. Where that end lies on the group, the other end decides.
    fn compare(&self, group: u16) -> Ordering {
        if group == NONE {
            return Ordering::Less;
        }
        count();
        let (upper, lower) = self.ends(group);
        self.turn(upper, lower, self.seen.0).then_with(|| self.turn(upper, lower, self.seen.1))
    }

    /// The root of what lies left or right of a group.
    #[inline(never)]
    fn link(&self, i: u16, way: bool) -> u16 {
        let links = |node: &SideSlot| if way == LEFT { node.prev } else { node.next };
        self.mesh.nodes.get(usize::from(i)).map_or(NONE, links)
    }

    #[inline(never)]
    fn set_link(&mut self, i: u16, way: bool, to: u16) {
        self.mesh.set(i, |node| *(if way == LEFT { &mut node.prev } else { &mut node.next }) = to);
    }
}

/// Called for each comparison of two vertices or of two sides: tests count them.
#[cfg(not(test))]
fn count() {}

#[cfg(test)]
use tests::count;

#[cfg(test)]
#[allow(clippy::cast_possible_truncation, clippy::cast_possible_wrap, reason = "numbers of small shapes")]
mod tests {
    use super::*;
    use crate::geom::point::PointFx;
    use std::{cell::Cell, thread_local, vec, vec::Vec};
    use twins::{meshes, rng::Rng, Units};

    thread_local! {
        static COUNT: Cell<u64> = const { Cell::new(0) };
    }

    pub(super) fn count() {
        COUNT.set(COUNT.get() + 1);
    }

    /// What the sweep says, and after how many comparisons.
    fn counted(contours: &[Vec<Units>]) -> (Result<usize, [usize; 2]>, u64) {
        let (units, starts) = meshes::flat(contours);
        let places: Vec<PointFx> = units.iter().map(|&(x, y)| PointFx::from_bits(x, y)).collect();
        COUNT.set(0);
        let said = touches_or_crossing(Sides::new(&places, &starts), &mut vec![SideSlot::EMPTY; units.len()]);
        (said, COUNT.get())
    }

    /// The rule.
    fn ruled(contours: &[Vec<Units>]) -> Result<usize, [usize; 2]> {
        match meshes::first_crossing(contours) {
            Some((first, second)) => Err([first, second]),
            None => Ok(meshes::nodes(contours) - contours.concat().len() - 2 * contours.len().saturating_sub(1)),
        }
    }

    /// Polygons of about so many vertices, at most four for three of them.
    #[allow(clippy::too_many_lines, reason = "a list")]
    fn shapes(n: usize, rng: &mut Rng) -> Vec<(&'static str, Vec<Vec<Units>>)> {
        let m = n as i32;
        let (low, high) = (i32::MIN, i32::MAX);
        let all = || 0..m;
        let half = || 0..m / 2;
        let third = || 0..m / 3;
        let mut shuffled: Vec<i32> = all().collect();
        rng.shuffle(&mut shuffled);
        let grid = |step: i32| third().map(move |i| (i % 50 * step, i / 50 * step));
        vec![
            ("zigzag on a row", vec![all().map(|i| if i % 2 == 0 { (i, 0) } else { (3 * m + i, 0) }).collect()]),
            ("zigzag on a column", vec![all().map(|i| (7, if i % 2 == 0 { i } else { 3 * m + i })).collect()]),
            (
                "zigzag on a slope",
                vec![all().map(|i| if i % 2 == 0 { i } else { 3 * m + i }).map(|t| (2 * t, 3 * t)).collect()],
            ),
            ("to and fro", vec![all().map(|i| if i % 2 == 0 { (low, low) } else { (high, high) }).collect()]),
            ("places on a line", vec![shuffled.iter().map(|&i| (5 * i, -i)).collect()]),
            ("one place", vec![vec![(high, low); n]]),
            (
                "comb",
                vec![all()
                    .map(|i| (10 * i, if i % 2 == 0 { 0 } else { 99_999 }))
                    .chain([(10 * m, -5), (-5, -5)])
                    .collect()],
            ),
            (
                "comb on its side",
                vec![all()
                    .map(|i| (if i % 2 == 0 { 0 } else { 99_999 }, 10 * i))
                    .chain([(-5, 10 * m), (-5, -5)])
                    .collect()],
            ),
            (
                "comb to the ends of the type",
                vec![all()
                    .map(|i| (if i % 2 == 0 { low + 1 } else { high }, 10 * i))
                    .chain([(low, 10 * m), (low, -5)])
                    .collect()],
            ),
            (
                "comb with the last tooth across",
                vec![all()
                    .map(|i| (10 * i, if i % 2 == 0 { 0 } else { 99_999 }))
                    .chain([(10 * m, 50_000), (-5, 60_000)])
                    .collect()],
            ),
            ("stairs", vec![half().flat_map(|i| [(i, i), (i + 1, i)]).chain([(m / 2, m)]).collect()]),
            (
                "spiral",
                vec![half()
                    .map(|i| spiral(60 * i + 90, i))
                    .chain(half().rev().map(|i| spiral(60 * i + 110, i)))
                    .collect()],
            ),
            (
                "triangles with one corner",
                third().map(|i| vec![(0, 0), (9_000, 20 * i), (9_000, 20 * i + 10)]).collect(),
            ),
            (
                "triangles over and under one corner",
                third()
                    .map(|i| {
                        vec![
                            (0, 0),
                            (20 * i - 9 * m, 9_000 * (i % 2 * 2 - 1)),
                            (20 * i + 10 - 9 * m, 9_000 * (i % 2 * 2 - 1)),
                        ]
                    })
                    .collect(),
            ),
            ("nested triangles", third().map(|i| vec![(-10 * i, -6 * i), (10 * i, -6 * i), (0, 12 * i)]).collect()),
            (
                "holes that touch",
                [vec![(0, 0), (90_000_000, 0), (90_000_000, 90_000_000), (0, 90_000_000)]]
                    .into_iter()
                    .chain(grid(20).map(|(x, y)| vec![(x, y), (x + 20, y), (x + 10, y + 20)]))
                    .collect(),
            ),
            ("boards", grid(10).map(|(x, y)| vec![(x, y), (x + 10, y), (x + 10, y + 10), (x, y + 10)]).collect()),
            (
                "a fan of lines",
                third().map(|i| vec![(10 * i - 5 * m, -9_000), (0, 0), (5 * m - 10 * i, 9_000)]).collect(),
            ),
            (
                "points on a side",
                [vec![(0, 0), (3 * m, 0), (3 * m, 90), (0, 90)]]
                    .into_iter()
                    .chain(all().map(|i| vec![(2 * i, 0)]))
                    .collect(),
            ),
            ("a tangle", vec![all().map(|_| (rng.int(0, 9_999), rng.int(0, 9_999))).collect()]),
            (
                "a tangle at the end",
                vec![all().map(|i| if i + 4 < m { (i, i % 7) } else { (rng.int(0, m), rng.int(0, 7)) }).collect()],
            ),
            (
                "small triangles anywhere",
                third()
                    .map(|_| {
                        let (x, y) = (rng.int(low, high - 60_000), rng.int(low, high - 60_000));
                        vec![(x, y), (x + 30_000, y + rng.int(0, 30_000)), (x + rng.int(0, 9_000), y + 60_000)]
                    })
                    .collect(),
            ),
        ]
    }

    fn spiral(r: i32, i: i32) -> Units {
        [(r, 0), (0, r), (-r, 0), (0, -r)][i.unsigned_abs() as usize % 4]
    }

    /// Every way in which sides can lie on each other, also at the ends of the type.
    #[test]
    fn the_rule_on_few_places() {
        let mut rng = Rng::new(610);
        let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
        let (mut crossed, mut touched) = (0, 0);
        for i in 0..60_000 {
            let contours: Vec<Vec<Units>> = (0..rng.range(1, 3))
                .map(|_| {
                    let place = |rng: &mut Rng| match i % 4 {
                        0 => (rng.pick(&ends), rng.pick(&ends)),
                        1 => (rng.int(0, 3), rng.int(0, 3)),
                        2 => (rng.int(0, 9), rng.int(0, 1)),
                        _ => [rng.int(-9, 9), rng.int(0, 9)].map(|t| (3 * t, -2 * t))[usize::from(rng.one_in(9))],
                    };
                    (0..rng.index(8)).map(|_| place(&mut rng)).collect()
                })
                .collect();
            let ruled = ruled(&contours);
            assert_eq!(counted(&contours).0, ruled, "{contours:?}");
            crossed += usize::from(ruled.is_err());
            touched += usize::from(ruled.is_ok_and(|touches| touches > 0));
        }
        assert!(crossed > 5_000 && touched > 5_000, "{crossed} crossed, {touched} touched");
    }

    /// The documentation allows 28 n log2 n + 20 n. These shapes take less than 5 n log2 n, with the logarithm rounded up;
    /// and for each sweep that finds out which sides to name, 2 n log2 n more.
    #[test]
    fn comparisons_are_few() {
        let mut rng = Rng::new(611);
        for n in [6, 30, 300, 2_000, 45_000] {
            for (what, contours) in shapes(n, &mut rng) {
                let (said, count) = counted(&contours);
                if n <= 300 {
                    assert_eq!(said, ruled(&contours), "{what}, {n}");
                }
                let vertices = contours.concat().len() as u64;
                let log = u64::from(vertices.ilog2()) + 1;
                let most = if said.is_ok() { 5 } else { 5 + 2 * log };
                assert!(count <= most * vertices * log, "{what}, {n}: {count} comparisons of {vertices} vertices");
            }
        }
    }
}
