//! Triangulations made better: no triangle sharper than it must be.
//!
//! The side between two triangles is *flipped*, replaced by the other diagonal of the two, while one of them has the far
//! corner of the other inside of its circle. What is left is the constrained Delaunay triangulation: among all that keep
//! the outline it has the largest smallest angle.
//! ```text
//!      c           c
//!     /|\         / \        the side ab goes, cd comes, when d lies inside of the circle through a, b, c;
//!    a | d  -->  a---d  ...  when all four lie on one circle, the side stays
//!     \|/         \ /
//!      b           b
//! ```
//! Sides of the outline belong to one triangle only and are never flipped.
//!
//! **It ends.** Lift every vertex to the height `x^2 + y^2`: each flip lowers the surface of the lifted triangles somewhere
//! and nowhere raises it, so no side ever comes back, and `n` vertices have `n (n - 1) / 2` sides at most. Ties do not
//! flip, and the signs are exact ([`in_circle`]).
//!
//! Range: any `I24F8`, up to 65,535 triangles. Memory: 6 bytes a triangle. Work: O(t^2) to find neighbours; then passes
//! over the triangles until one changes nothing, few in practice.
//!
//! Sources: C. L. Lawson, "Software for C1 surface interpolation", Mathematical Software III, 1977; D. T. Lee and A. K. Lin,
//! "Generalized Delaunay triangulation for planar graphs", Discrete & Computational Geometry 1, 1986.

use core::cmp::Ordering;

use super::{
    exact::{in_circle, turn},
    point::PointFx,
};
use crate::error::TriangulateError;

/// No triangle: beyond the outline.
const NONE: u16 = u16::MAX;

/// Flips sides of a triangulation until each pair of triangles is Delaunay; says how many flips it took.
///
/// * `triangles`: numbers of vertices, clockwise on the screen and meeting in whole sides, as
///   [`list`](super::triangulate::list) writes them. Of anything else the result is some list of triangles.
/// * `neighbours`: scratch memory, a slot for each triangle.
///
/// # Errors
/// [`TriangulateError::TriangleTableFull`] if `neighbours` has fewer slots than there are triangles, or these are more than 65,535.
/// Nothing was changed then.
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
    mesh.meet();
    let (mut flips, mut before) = (0_u32, None);
    // A proper triangulation ends long before the limit; what is none must end too.
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

/// A triangle and its neighbours, turned so that some side is the first.
#[derive(Copy, Clone)]
struct Turned {
    corners: [u16; 3],
    beyond: [u16; 3],
}

impl FlipMesh<'_> {
    /// Finds all neighbours: who has the same side the other way.
    fn meet(&mut self) {
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

    /// A triangle, turned so that its side `side` is the first.
    fn turned(&self, t: u16, side: usize) -> Option<Turned> {
        let (&corners, &beyond) = self.triangles.get(usize::from(t)).zip(self.neighbours.get(usize::from(t)))?;
        let turn = |[a, b, c]: [u16; 3]| match side {
            0 => [a, b, c],
            1 => [b, c, a],
            _ => [c, a, b],
        };
        Some(Turned { corners: turn(corners), beyond: turn(beyond) })
    }

    /// Flips a side if it is worth it.
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
        self.exchange(beyond_ad, (d, a), t);
        self.exchange(beyond_bc, (c, b), u);
        Some(())
    }

    fn put(&mut self, t: u16, corners: [u16; 3], beyond: [u16; 3]) {
        let t = usize::from(t);
        if let Some((triangle, neighbours)) = self.triangles.get_mut(t).zip(self.neighbours.get_mut(t)) {
            (*triangle, *neighbours) = (corners, beyond);
        }
    }

    /// Tells a triangle who lies beyond one of its sides now.
    fn exchange(&mut self, t: u16, side: (u16, u16), now: u16) {
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
