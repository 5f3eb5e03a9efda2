//! Polygons cut into triangles: any number of contours in any order, concave, with holes and islands.
//!
//! The triangles cover what lies inside by the [even-odd rule](crate::FillRule::EvenOdd), without overlap: filling them
//! paints the pixels that filling the polygon paints, each exactly once. Their corners are vertices of the polygon; two
//! of them share a whole side, a corner, or nothing; and all go round clockwise as seen on the screen. A simple polygon
//! of n vertices is cut into `n - 2` triangles.
//!
//! **What is allowed.** Contours may touch themselves and each other in any way: at vertices, along sides, or with a
//! vertex on a side. Vertices may repeat, lie in the middle of a straight side, and form spikes. Only two sides that
//! *cross*, at a place that is an end of neither, are an error, which names them.
//!
//! **How.** In five steps:
//! 1. *Sides.* A side with vertices on it is split there. Two sides that lie on each other are taken out: by the
//!    even-odd rule the two together change nothing.
//! 2. *Directions.* Each side is directed so that the inside lies on its right hand on the screen. Which of the two
//!    directions that is follows from the number of sides left of it: odd or even.
//! 3. *Loops.* Each side is linked to one that starts where it ends. If several do, it is the one with no inside
//!    between the two; so loops can touch, but never cross.
//! 4. *Bridges.* A loop that goes round a hole is joined to a loop further left by a bridge, two new sides in opposite
//!    directions, until only outlines are left.
//! 5. *Ears.* A corner whose triangle holds no other corner is an ear. Ears are cut off, until nothing is left.
//!
//! As directions and loops are found from the sides alone, it does not matter which contour is a hole of which, nor
//! which way round the contours go. Where loops touch, no side starts between the two sides of another corner, on the
//! inside: that makes the usual test of an ear right for outlines that touch themselves, too.
//!
//! Range: any `I24F8`, up to 65,535 vertices. All decisions are signs of cross products ([`turn`](super::exact::turn)).
//! Memory: 10 bytes for each slot of a table, about one for each vertex ([`each`] says how many). Of several vertices at
//! the same place the triangles name the first one.
//!
//! Work, for n vertices: a table of slots that is surely too small is refused before any vertex is looked at. Whether
//! sides cross, and how many slots are enough, is found by a sweep with less than 28 n log2 n + 20 n comparisons of sides
//! and vertices; of the polygons of 30 vertices and more that were counted none took 5 n log2 n. If sides cross,
//! log2 n + 1 more sweeps and a look at all sides are enough to find the two to name. Then the five steps are O(s^2) for
//! s slots.
//!
//! Sources: G. H. Meisters, "Polygons have ears", American Mathematical Monthly 82, 1975; D. Eberly, "Triangulation by
//! ear clipping", 2002 (bridges, and why cutting an ear concerns its neighbours only). Directed sides and loops are the
//! half-edges of M. de Berg et al., "Computational Geometry", 2008, section 2.2.

mod ears;
mod loops;
mod mesh;
mod sides;
mod sweep;

use heapless::Vec;

pub use self::mesh::SideSlot;
use self::{mesh::Mesh, sides::Sides, sweep::touches_or_crossing};
use super::point::PointFx;
use crate::error::TriangulateError;

/// The largest number of slots that are used: nodes have numbers of 16 bits, and the last number is never used.
const LIMIT: usize = u16::MAX as usize;

/// Emits the triangles of a polygon, as numbers of its vertices.
///
/// * `vertices`: those of all contours, one contour after the other. The last vertex of each is joined to its first
///   one.
/// * `starts`: the numbers of the first vertices of the second, third, ... contour; `&[]` if there is only one contour.
/// * `slots`: scratch memory. One for every vertex, two for each entry of `starts`, and one for every place where a
///   vertex lies on a side between its ends are enough.
///
/// # Errors
/// Nothing was emitted then. The first of these that is true is told:
/// * [`TriangulateError::SideTableFull`] if there are not even slots for every vertex and for the entries of `starts`.
///   `needed` is their number. No side was looked at: sides that touch may need more.
/// * [`TriangulateError::SidesCross`]. `second` is the first side that crosses one before it, and `first` is the first
///   one that it crosses.
/// * [`TriangulateError::SideTableFull`]. `needed` is enough.
/// ```
/// use embedded_raster::{geom::triangulate::{self, SideSlot}, PointFx, TriangulateError};
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
    slots: &mut [SideSlot],
    emit: impl FnMut([u16; 3]),
) -> Result<(), TriangulateError> {
    let sides = Sides::new(vertices, starts);
    let touches = check(sides, starts.len(), slots, usize::MAX)?;
    run(sides, touches, slots, emit);
    Ok(())
}

/// Writes the triangles of a polygon, as numbers of its vertices, to a table; says how many there are.
///
/// * `triangles`: two slots less than [`each`] needs of `slots` are enough.
///
/// The other arguments are those of [`each`]. For a vector as the result see [`to_vec`].
///
/// # Errors
/// Those of [`each`], or else [`TriangulateError::TriangleTableFull`].
/// ```
/// use embedded_raster::{geom::triangulate::{self, SideSlot}, PointFx, TriangulateError};
/// let frame = [(0, 0), (9, 0), (9, 9), (0, 9), (3, 3), (6, 3), (6, 6), (3, 6)].map(|(x, y)| PointFx::px(x, y));
/// let mut triangles = [[0; 3]; 8];
/// assert_eq!(triangulate::list(&frame, &[4], &mut [SideSlot::EMPTY; 10], &mut triangles)?, 8);
/// # Ok::<(), TriangulateError>(())
/// ```
pub fn list(
    vertices: &[PointFx],
    starts: &[u16],
    slots: &mut [SideSlot],
    triangles: &mut [[u16; 3]],
) -> Result<usize, TriangulateError> {
    let sides = Sides::new(vertices, starts);
    let touches = check(sides, starts.len(), slots, triangles.len())?;
    let mut count = 0_usize;
    run(sides, touches, slots, |triangle| {
        if let Some(slot) = triangles.get_mut(count) {
            *slot = triangle;
            count = count.wrapping_add(1);
        }
    });
    Ok(count)
}

/// The triangles of a polygon, as numbers of its vertices.
///
/// `N`, the number of triangles that there is room for, is enough if it is two less than [`each`] needs of `slots`. The
/// arguments are those of [`each`].
///
/// # Errors
/// Those of [`each`], or else [`TriangulateError::TriangleTableFull`].
/// ```
/// use embedded_raster::{geom::triangulate::{self, SideSlot}, PointFx, TriangulateError};
/// let arrow = [(0, 0), (4, 2), (0, 4), (1, 2)].map(|(x, y)| PointFx::px(x, y));
/// let triangles = triangulate::to_vec::<8>(&arrow, &[], &mut [SideSlot::EMPTY; 4])?;
/// assert_eq!(triangles, [[3, 0, 1], [1, 2, 3]]);
/// # Ok::<(), TriangulateError>(())
/// ```
pub fn to_vec<const N: usize>(
    vertices: &[PointFx],
    starts: &[u16],
    slots: &mut [SideSlot],
) -> Result<Vec<[u16; 3], N>, TriangulateError> {
    let sides = Sides::new(vertices, starts);
    let touches = check(sides, starts.len(), slots, N)?;
    let mut triangles = Vec::new();
    // There is room for every one of them: that was checked.
    run(sides, touches, slots, |triangle| triangles.push(triangle).unwrap_or(()));
    Ok(triangles)
}

/// What can go wrong with a polygon that has so many `further` contours, in tables of so many slots. Or else how often its
/// vertices lie on sides.
fn check(
    sides: Sides<'_>,
    further: usize,
    slots: &mut [SideSlot],
    triangles: usize,
) -> Result<usize, TriangulateError> {
    let capacity = slots.len().min(LIMIT);
    // Sides that touch need more. How many do is not known yet: finding that out takes a slot for every vertex.
    let least = sides.count().saturating_add(further.saturating_mul(2));
    if least > capacity {
        return Err(TriangulateError::SideTableFull { capacity, needed: least });
    }
    let touches =
        touches_or_crossing(sides, slots).map_err(|[first, second]| TriangulateError::SidesCross { first, second })?;
    let needed = least.saturating_add(touches);
    if needed > capacity {
        return Err(TriangulateError::SideTableFull { capacity, needed });
    }
    let needed = needed.saturating_sub(2);
    if needed > triangles {
        return Err(TriangulateError::TriangleTableFull { capacity: triangles, needed });
    }
    Ok(touches)
}

/// Cuts a polygon whose vertices lie on sides so often.
fn run(sides: Sides<'_>, touches: usize, slots: &mut [SideSlot], emit: impl FnMut([u16; 3])) {
    let mut mesh = Mesh::new(sides.vertices(), slots);
    mesh.load(sides);
    if touches > 0 {
        mesh.split();
    }
    mesh.cancel();
    mesh.direct();
    mesh.link();
    mesh.bridge_holes();
    mesh.cut_ears(emit);
}
