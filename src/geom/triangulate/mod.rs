//! Polygons cut into triangles: any number of contours in any order, concave, with holes and islands.
//!
//! The triangles cover what lies inside by the [even-odd rule](crate::FillRule::EvenOdd), each place once: filling them
//! paints the pixels that filling the polygon paints, each exactly once. Their corners are vertices of the polygon, they
//! meet in whole sides and vertices, and all go round clockwise as seen on the screen. There are `n - 2` of them for a
//! simple polygon of n vertices.
//!
//! **What is allowed.** Contours may touch themselves and each other in any way, at vertices, along sides, or with a vertex
//! on a side; vertices may repeat, lie in the middle of a straight side, and run there and back. Only two sides that
//! *cross*, at a place inside of both, are refused, by name.
//! ```text
//!   sides      vertices on a side split it; sides that lie on each other cancel, as two make no difference to even-odd
//!   direction  each side is turned so that the inside is on its right hand on the screen: count the sides left of it
//!   loops      where a side ends, that one follows which leaves nothing of the inside between: so loops touch, never cross
//!   bridges    a loop round a hole is joined to what lies left of it, there and back, until every loop is an outline
//!   ears       a corner whose triangle holds no other corner is cut off, until nothing is left
//! ```
//! As every side is directed and every loop joined by itself, it does not matter which contour is a hole of which, nor which
//! way round they go; and where loops touch, no corner ever has another one between its sides, which is what makes the
//! usual test of an ear right for outlines that touch themselves, too.
//!
//! Range: any `I24F8`, up to 65,535 vertices. All decisions are signs of cross products ([`turn`](super::exact::turn)).
//! Memory: 10 bytes a vertex. Work: O(n^2) for n nodes. Vertices at the same place are named by the first of them.
//!
//! Sources: G. H. Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975; D. Eberly, "Triangulation by ear
//! clipping", 2002 (bridges, and why cutting an ear concerns its neighbours only). Directed sides and loops are the
//! half-edges of M. de Berg et al., "Computational Geometry", 2008, section 2.2.

mod ears;
mod loops;
mod sides;

use core::{cmp::Ordering, ops::Range};

use self::sides::Sides;
use super::{
    bits,
    exact::{turn_at, Place},
    PointFx,
};
use crate::error::TriangulateError;

/// One slot of scratch memory: a side and the corner where it starts.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct SideSlot {
    /// The vertex where the side starts.
    vertex: u16,
    /// The vertex where it ended when it was loaded.
    end: u16,
    /// The node before it on its loop.
    prev: u16,
    /// The node after it.
    next: u16,
    /// What is known of the corner.
    flags: u16,
}

impl SideSlot {
    /// An empty slot, to make a table of.
    /// ```
    /// use embedded_raster::geom::triangulate::SideSlot;
    /// static mut NODES: [SideSlot; 64] = [SideSlot::EMPTY; 64];
    /// ```
    pub const EMPTY: Self = Self { vertex: 0, end: 0, prev: 0, next: 0, flags: 0 };
}

/// The largest number of nodes: the last number is never used.
const LIMIT: usize = u16::MAX as usize;

/// Emits the triangles of a polygon, as numbers of its vertices.
///
/// * `vertices`: those of all contours, one contour after the other; each is closed by itself.
/// * `starts`: the numbers of the first vertices of the second, third, ... contour; `&[]` if there is but one.
/// * `nodes`: scratch memory. A slot for every vertex, two for each entry of `starts`, and one for every place where a
///   vertex lies on a side between its ends are enough.
///
/// # Errors
/// [`TriangulateError::SidesCross`] with the first two sides that do, or else [`TriangulateError::SideTableFull`]. Nothing was emitted then.
/// ```
/// use embedded_raster::{geom::triangulate::{self, SideSlot}, Error, PointFx, TriangulateError};
/// let arrow = [(0, 0), (4, 2), (0, 4), (1, 2)].map(|(x, y)| PointFx::px(x, y));
/// let mut triangles = vec![];
/// triangulate::each(&arrow, &[], &mut [SideSlot::EMPTY; 4], |triangle| triangles.push(triangle))?;
/// assert_eq!(triangles, [[3, 0, 1], [1, 2, 3]]);
/// let bow_tie = [(0, 0), (4, 4), (4, 0), (0, 4)].map(|(x, y)| PointFx::px(x, y));
/// let error = triangulate::each(&bow_tie, &[], &mut [SideSlot::EMPTY; 4], |_| {});
/// assert_eq!(error, Err(TriangulateError::SidesCross { first: 0, second: 2 }));
/// # Ok::<(), TriangulateError>(())
/// ```
pub fn each(
    vertices: &[PointFx],
    starts: &[u16],
    nodes: &mut [SideSlot],
    emit: impl FnMut([u16; 3]),
) -> Result<(), TriangulateError> {
    let sides = Sides::new(vertices, starts);
    check(sides, starts.len(), nodes.len().min(LIMIT))?;
    run(sides, nodes, emit);
    Ok(())
}

/// Writes the triangles of a polygon, as numbers of its vertices, to a table; says how many there are.
///
/// * `triangles`: two slots less than `nodes` needs are enough.
///
/// For the rest, and an example, see [`each`].
///
/// # Errors
/// Those of [`each`], or else [`TriangulateError::TriangleTableFull`].
/// ```
/// use embedded_raster::{geom::triangulate::{self, SideSlot}, Error, PointFx, TriangulateError};
/// let frame = [(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6)].map(|(x, y)| PointFx::px(x, y));
/// let mut triangles = [[0; 3]; 8];
/// assert_eq!(triangulate::list(&frame, &[4], &mut [SideSlot::EMPTY; 10], &mut triangles)?, 8);
/// # Ok::<(), TriangulateError>(())
/// ```
pub fn list(
    vertices: &[PointFx],
    starts: &[u16],
    nodes: &mut [SideSlot],
    triangles: &mut [[u16; 3]],
) -> Result<usize, TriangulateError> {
    let sides = Sides::new(vertices, starts);
    let needed = check(sides, starts.len(), nodes.len().min(LIMIT))?.saturating_sub(2);
    if triangles.len() < needed {
        return Err(TriangulateError::TriangleTableFull { capacity: triangles.len(), needed });
    }
    let mut count = 0_usize;
    run(sides, nodes, |triangle| {
        if let Some(slot) = triangles.get_mut(count) {
            *slot = triangle;
            count = count.wrapping_add(1);
        }
    });
    Ok(count)
}

/// What can go wrong; or how many nodes are enough.
fn check(sides: Sides<'_>, further: usize, capacity: usize) -> Result<usize, TriangulateError> {
    if let Some((first, second)) = sides.crossing() {
        return Err(TriangulateError::SidesCross { first, second });
    }
    let needed = sides.count().saturating_add(further.saturating_mul(2)).saturating_add(sides.touches());
    if needed > capacity {
        return Err(TriangulateError::SideTableFull { capacity, needed });
    }
    Ok(needed)
}

fn run(sides: Sides<'_>, nodes: &mut [SideSlot], emit: impl FnMut([u16; 3])) {
    let mut mesh = Mesh { vertices: sides.vertices(), nodes, len: 0 };
    mesh.load(sides);
    mesh.split();
    mesh.cancel();
    mesh.direct();
    mesh.link();
    mesh.bridge_holes();
    mesh.cut_ears(emit);
}

/// The nodes in use, over the vertices that they name.
struct Mesh<'a> {
    vertices: &'a [PointFx],
    nodes: &'a mut [SideSlot],
    len: usize,
}

impl Mesh<'_> {
    /// The numbers of the nodes in use.
    #[inline(always)]
    fn numbers(&self) -> Range<u16> {
        0..u16::try_from(self.len).unwrap_or(u16::MAX)
    }

    #[inline(always)]
    fn node(&self, i: u16) -> SideSlot {
        self.nodes.get(usize::from(i)).copied().unwrap_or(SideSlot::EMPTY)
    }

    #[inline(always)]
    fn set(&mut self, i: u16, change: impl FnOnce(&mut SideSlot)) {
        if let Some(node) = self.nodes.get_mut(usize::from(i)) {
            change(node);
        }
    }

    /// Adds a node and returns its number. There is room: it was counted.
    fn push(&mut self, node: SideSlot) -> u16 {
        let at = self.len;
        if let Some(slot) = self.nodes.get_mut(at) {
            *slot = node;
            self.len = at.wrapping_add(1);
        }
        u16::try_from(at).unwrap_or(u16::MAX)
    }

    /// Where a vertex is.
    #[inline(always)]
    fn place(&self, vertex: u16) -> Place {
        self.vertices.get(usize::from(vertex)).copied().map_or((0, 0), bits)
    }

    /// Where a node is, and the nodes before and after it: the two ends of its sector, backwards.
    #[inline(never)]
    fn corner(&self, i: u16) -> [Place; 3] {
        let node = self.node(i);
        [self.node(node.prev).vertex, node.vertex, self.node(node.next).vertex].map(|vertex| self.place(vertex))
    }

    /// Makes one node the next of another.
    #[inline(never)]
    fn join(&mut self, from: u16, to: u16) {
        self.set(from, |node| node.next = to);
        self.set(to, |node| node.prev = from);
    }

    /// Visits the nodes of a loop from `from` on up to, and without, `to`; all of them if that is the same.
    #[inline]
    fn walk(&mut self, from: u16, to: u16, mut visit: impl FnMut(&mut Self, u16)) {
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
    fn downwards(&self, a: u16, b: u16) -> (u16, u16) {
        if down(self.place(a)) < down(self.place(b)) {
            (a, b)
        } else {
            (b, a)
        }
    }
}

/// Whether `p` lies inside of the sector of a corner: clockwise from the side that leaves it and before the one that comes.
#[inline(never)]
fn in_sector([before, at, after]: [Place; 3], p: Place) -> bool {
    let after_side = turn_at(at, after, p) == Ordering::Greater;
    let before_side = turn_at(at, p, before) == Ordering::Greater;
    if turn_at(at, after, before) == Ordering::Greater {
        after_side && before_side
    } else {
        // The rest of the round is a sector below a half turn, or a half turn: outside are it and its ends.
        after_side || before_side
    }
}

/// The order in which rows are walked: from the top down, and from left to right. It is that of a plane sheared so little
/// that no two vertices share a row, and no side is horizontal.
#[inline(always)]
fn down(p: Place) -> (i32, i32) {
    (p.1, p.0)
}
