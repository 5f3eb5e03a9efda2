//! Triangulations made better: the constrained Delaunay triangulation, which avoids long thin triangles.
//!
//! Two triangles that share a side form a quadrilateral, and the side is one of its diagonals. To *flip* the side is to
//! replace it by the other diagonal. A side is flipped when the circle through the corners of one triangle has the far
//! corner of the other inside. When there is no such side left, the triangulation is Delaunay: of all triangulations
//! with the same vertices and the same outline it has the largest smallest angle.
//! ```text
//!      a           a
//!     /|\         / \        ab is replaced by cd when d lies inside of the circle through a, b and c;
//!    c | d  -->  c---d       when all four lie on one circle, ab stays
//!     \|/         \ /
//!      b           b
//! ```
//! Sides of the outline belong to one triangle only and are never flipped.
//!
//! **Why it ends.** Imagine every vertex lifted to the height `x^2 + y^2`, and the triangles as a surface in space. A
//! flip lowers this surface somewhere and raises it nowhere. So a side that was flipped never comes back, and between n
//! vertices there are `n (n - 1) / 2` sides at most. The sides between four vertices on one circle are not flipped, and
//! the test is exact ([`in_circle`]).
//!
//! Range: any `I24F8`, up to 65,535 triangles. Memory: 6 bytes a triangle. Work: O(t^2) to find neighbours; then passes
//! over the triangles until one changes nothing, few in practice.
//!
//! Sources: C. L. Lawson, "Software for C1 surface interpolation", Mathematical Software III, 1977; D. T. Lee and A. K.
//! Lin, "Generalized Delaunay triangulation for planar graphs", Discrete & Computational Geometry 1, 1986.

use core::cmp::Ordering;

use super::{
    exact::{in_circle, turn},
    point::PointFx,
};
use crate::error::TriangulateError;

/// In place of a neighbour: there is none, the side belongs to the outline.
const NONE: u16 = u16::MAX;

/// Flips sides of a triangulation until each pair of triangles is Delaunay; says how many flips it took.
///
/// * `triangles`: numbers of vertices, clockwise on the screen; two triangles share a whole side, a corner, or nothing.
///   So [`list`](super::triangulate::list) writes them. What becomes of other triangles is not specified, but it ends.
/// * `neighbours`: scratch memory, a slot for each triangle.
///
/// # Errors
/// [`TriangulateError::TriangleTableFull`] if `neighbours` has fewer slots than there are triangles, or these are more
/// than 65,535. Nothing was changed then.
/// ```
/// use embedded_raster::{geom::delaunay, PointFx};
/// let kite = [(0, 0), (8, -1), (16, 0), (8, 1)].map(|(x, y)| PointFx::px(x, y));
/// let mut triangles = [[0, 1, 2], [2, 3, 0]]; // two long ones
/// assert_eq!(delaunay::refine(&kite, &mut triangles, &mut [[0; 3]; 2])?, 1);
/// assert_eq!(triangles, [[2, 3, 1], [3, 0, 1]]);
/// # Ok::<(), embedded_raster::Error>(())
/// ```
pub fn refine(
    vertices: &[PointFx],
    triangles: &mut [[u16; 3]],
    neighbours: &mut [[u16; 3]],
) -> Result<u32, TriangulateError> {
    let (needed, capacity) = (triangles.len(), neighbours.len().min(usize::from(NONE)));
    if needed > capacity {
        return Err(TriangulateError::TriangleTableFull { capacity, needed });
    }
    let mut mesh = FlipMesh { vertices, triangles, neighbours };
    mesh.find_neighbours();
    let (mut flips, mut before) = (0_u32, None);
    // A proper triangulation ends long before the limit. It is there for triangles that are no triangulation.
    while before != Some(flips) && flips < i32::MAX.unsigned_abs() {
        before = Some(flips);
        for t in 0..u16::try_from(needed).unwrap_or(NONE) {
            for side in 0..3 {
                flips = flips.wrapping_add(u32::from(mesh.flip(t, side)));
            }
        }
    }
    Ok(flips)
}

struct FlipMesh<'a> {
    vertices: &'a [PointFx],
    triangles: &'a mut [[u16; 3]],
    /// The triangle beyond each side; side k goes from corner k to the next.
    neighbours: &'a mut [[u16; 3]],
}

/// A triangle, numbered so that a certain side is the first one.
#[derive(Copy, Clone)]
struct Turned {
    corners: [u16; 3],
    /// The neighbours beyond the three sides.
    beyond: [u16; 3],
}

impl FlipMesh<'_> {
    /// Finds all neighbours: beyond a side lies the triangle that has the same side in the opposite direction.
    fn find_neighbours(&mut self) {
        for t in 0..self.triangles.len() {
            let [a, b, c] = self.corners(t);
            let beyond = [(b, a), (c, b), (a, c)].map(|side| {
                let shares = |other: &[u16; 3]| sides(*other).contains(&side);
                self.triangles.iter().position(shares).and_then(|u| u16::try_from(u).ok()).unwrap_or(NONE)
            });
            if let Some(slot) = self.neighbours.get_mut(t) {
                *slot = beyond;
            }
        }
    }

    fn corners(&self, t: usize) -> [u16; 3] {
        self.triangles.get(t).copied().unwrap_or_default()
    }

    /// A triangle, numbered so that its side `side` is the first one.
    fn turned(&self, t: u16, side: usize) -> Option<Turned> {
        let (&corners, &beyond) = self.triangles.get(usize::from(t)).zip(self.neighbours.get(usize::from(t)))?;
        let turn = |[a, b, c]: [u16; 3]| match side {
            0 => [a, b, c],
            1 => [b, c, a],
            _ => [c, a, b],
        };
        Some(Turned { corners: turn(corners), beyond: turn(beyond) })
    }

    /// Flips a side if it is not Delaunay; says whether it did.
    fn flip(&mut self, t: u16, side: usize) -> bool {
        self.try_flip(t, side).is_some()
    }

    fn try_flip(&mut self, t: u16, side: usize) -> Option<()> {
        let one = self.turned(t, side)?;
        let ([a, b, c], u) = (one.corners, one.beyond[0]);
        let back = sides(self.triangles.get(usize::from(u)).copied()?).iter().position(|&s| s == (b, a))?;
        let other = self.turned(u, back)?;
        let d = other.corners[2];
        let place = |i: u16| self.vertices.get(usize::from(i)).copied();
        let (pa, pb, pc, pd) = (place(a)?, place(b)?, place(c)?, place(d)?);
        let is_clockwise = |a, b, c| turn(a, b, c) == Ordering::Greater;
        let can_flip = is_clockwise(pa, pd, pc) && is_clockwise(pd, pb, pc);
        if t == u || !can_flip || !is_clockwise(pa, pb, pc) || in_circle(pa, pb, pc, pd) != Ordering::Greater {
            return None;
        }
        let ([_, beyond_bc, beyond_ca], [_, beyond_ad, beyond_db]) = (one.beyond, other.beyond);
        self.put(t, [a, d, c], [beyond_ad, u, beyond_ca]);
        self.put(u, [d, b, c], [beyond_db, beyond_bc, t]);
        self.set_neighbour(beyond_ad, (d, a), t);
        self.set_neighbour(beyond_bc, (c, b), u);
        Some(())
    }

    /// Replaces a triangle and its neighbours.
    fn put(&mut self, t: u16, corners: [u16; 3], beyond: [u16; 3]) {
        let t = usize::from(t);
        if let Some((triangle, neighbours)) = self.triangles.get_mut(t).zip(self.neighbours.get_mut(t)) {
            (*triangle, *neighbours) = (corners, beyond);
        }
    }

    /// Sets the neighbour of a triangle beyond one of its sides.
    fn set_neighbour(&mut self, t: u16, side: (u16, u16), now: u16) {
        let t = usize::from(t);
        let Some((triangle, neighbours)) = self.triangles.get(t).zip(self.neighbours.get_mut(t)) else { return };
        for (own, neighbour) in sides(*triangle).into_iter().zip(neighbours) {
            if own == side {
                *neighbour = now;
            }
        }
    }
}

/// The sides of a triangle, each from a corner to the next.
fn sides([a, b, c]: [u16; 3]) -> [(u16, u16); 3] {
    [(a, b), (b, c), (c, a)]
}
