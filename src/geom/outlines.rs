//! [`Outlines`]: the contours of a path as two lists, one of vertices and one of where each contour starts.
//!
//! Contours of a [`Path`] are iterators: whoever goes over them again cuts the curves again. Written down once they can
//! be filled many times, and cut into triangles: [`triangulate`](super::triangulate) takes these two lists.

use heapless::Vec;

use super::{path::Path, point::PointFx};
use crate::error::FlattenError;

/// Contours in two lists: up to `V` vertices of all of them, and up to `S` numbers of vertices where a contour starts.
///
/// The first contour starts at vertex 0 and is not listed, so `S` contours can follow it.
/// ```
/// use embedded_raster::{geom::triangulate::{self, SideSlot}, Error, Path, PathSegment::*, PointFx};
/// let p = PointFx::px;
/// let half_moon = [MoveTo(p(0, 0)), QuadraticTo(p(16, 8), p(0, 16)), Close];
/// let outlines = Path::new(&half_moon).outlines::<32, 0>()?;
/// let mut slots = [SideSlot::EMPTY; 32];
/// let triangles = triangulate::to_vec::<30>(&outlines.vertices, &outlines.starts, &mut slots)?;
/// assert_eq!(triangles.len(), outlines.vertices.len() - 2);
/// # Ok::<(), Error>(())
/// ```
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Outlines<const V: usize, const S: usize> {
    /// The vertices of all contours, one contour after the other.
    pub vertices: Vec<PointFx, V>,
    /// The numbers of the first vertices of the second, third, ... contour.
    pub starts: Vec<u16, S>,
}

impl<const V: usize, const S: usize> Outlines<V, S> {
    /// The vertices of each contour that has any, as a fill takes them.
    /// ```
    /// use embedded_raster::{Path, PathSegment::*, PointFx};
    /// let p = PointFx::px;
    /// let two = [MoveTo(p(0, 0)), LineTo(p(9, 0)), LineTo(p(0, 9)), MoveTo(p(2, 2)), LineTo(p(3, 2)), LineTo(p(2, 3))];
    /// let outlines = Path::new(&two).outlines::<6, 1>()?;
    /// let lengths: Vec<usize> = outlines.contours().map(|contour| contour.len()).collect();
    /// assert_eq!(lengths, [3, 3]);
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub fn contours(&self) -> impl Iterator<Item = &[PointFx]> + Clone {
        let end = u16::try_from(self.vertices.len()).unwrap_or(u16::MAX);
        let ends = self.starts.iter().copied().chain([end]);
        let mut start = 0;
        ends.filter_map(move |end| {
            let contour = self.vertices.get(usize::from(start)..usize::from(end));
            start = end;
            contour.filter(|contour| !contour.is_empty())
        })
    }
}

impl Path<'_> {
    /// Its contours, written down: see [`Outlines`].
    ///
    /// # Errors
    /// [`FlattenError::VertexListFull`] if there are more than `V` or 65,535 vertices, or else
    /// [`FlattenError::StartListFull`] if more than `S` contours follow the first one.
    /// ```
    /// use embedded_raster::{FlattenError, Path, PathSegment::*, PointFx};
    /// let p = PointFx::px;
    /// let triangle = [MoveTo(p(0, 0)), LineTo(p(9, 0)), LineTo(p(0, 9)), Close];
    /// let outlines = Path::new(&triangle).outlines::<3, 0>()?;
    /// assert_eq!(outlines.vertices, [p(0, 0), p(9, 0), p(0, 9)]);
    /// let error = Path::new(&triangle).outlines::<2, 0>().unwrap_err();
    /// assert_eq!(error, FlattenError::VertexListFull { capacity: 2, needed: 3 });
    /// # Ok::<(), FlattenError>(())
    /// ```
    pub fn outlines<const V: usize, const S: usize>(self) -> Result<Outlines<V, S>, FlattenError> {
        let mut outlines = Outlines { vertices: Vec::new(), starts: Vec::new() };
        // What does not fit is counted, and left out.
        let (mut vertices, mut further) = (0_usize, 0_usize);
        for contour in self.contours() {
            // Every contour has a vertex: only the first one starts at 0.
            if vertices > 0 {
                let start = u16::try_from(vertices).unwrap_or(u16::MAX);
                outlines.starts.push(start).unwrap_or(());
                further = further.saturating_add(1);
            }
            for vertex in contour {
                outlines.vertices.push(vertex).unwrap_or(());
                vertices = vertices.saturating_add(1);
            }
        }
        let capacity = V.min(usize::from(u16::MAX));
        if vertices > capacity {
            return Err(FlattenError::VertexListFull { capacity, needed: vertices });
        }
        if further > S {
            return Err(FlattenError::StartListFull { capacity: S, needed: further });
        }
        Ok(outlines)
    }
}
