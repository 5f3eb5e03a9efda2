//! From vertices and indices to triangles, lines and points.

use core::fmt;

/// How indices make triangles.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Topology {
    /// Each three indices make one. One or two that are left over make none.
    #[default]
    List,
    /// Each index makes one with the two before it; every other one is turned, so that all face the same way.
    Strip,
    /// Each index makes one with the one before it and the first one.
    Fan,
}

/// How indices make lines.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum LineTopology {
    /// Each two indices make one. One that is left over makes none.
    #[default]
    List,
    /// Each index makes one with the one before it.
    Strip,
    /// As a strip, and one from the last index to the first one. One or two indices make no more than a strip of them.
    Loop,
}

/// What may be an index: `u8`, `u16` or `u32`.
pub trait Index: Copy {
    /// As a place in a slice.
    fn place(self) -> usize;
}

impl Index for u8 {
    #[inline(always)]
    fn place(self) -> usize {
        self.into()
    }
}

impl Index for u16 {
    #[inline(always)]
    fn place(self) -> usize {
        self.into()
    }
}

impl Index for u32 {
    #[inline(always)]
    fn place(self) -> usize {
        usize::try_from(self).unwrap_or(usize::MAX)
    }
}

/// An index has no vertex.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct IndexOutOfRange {
    /// Where it stands among the indices.
    pub at: usize,
    /// What it is.
    pub index: usize,
    /// How many vertices there are.
    pub vertices: usize,
}

impl fmt::Display for IndexOutOfRange {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { at, index, vertices } = *self;
        write!(f, "index out of range: number {at} is {index}, there are {vertices} vertices")
    }
}

impl core::error::Error for IndexOutOfRange {}

/// The triangles of some indices, as references to their corners: for
/// [`Pipeline::whole_triangles`](super::Pipeline::whole_triangles), or to look at.
///
/// # Errors
/// If an index has no vertex.
/// ```
/// use embedded_raster::pipeline::{assemble, Topology};
/// let fan: Vec<_> = assemble(Topology::Fan, &["a", "b", "c", "d"], &[0_u8, 1, 2, 3])?.collect();
/// assert_eq!(fan, [[&"a", &"b", &"c"], [&"a", &"c", &"d"]]);
/// # Ok::<(), embedded_raster::pipeline::IndexOutOfRange>(())
/// ```
#[inline]
pub fn assemble<'a, A>(
    topology: Topology,
    vertices: &'a [A],
    indices: &'a [impl Index],
) -> Result<impl Iterator<Item = [&'a A; 3]>, IndexOutOfRange> {
    check(vertices.len(), indices)?;
    let (count, step) = match topology {
        Topology::List => (indices.len() / 3, 3),
        Topology::Strip | Topology::Fan => (indices.len().saturating_sub(2), 1),
    };
    let corner = |at: usize| indices.get(at).and_then(|index| vertices.get(index.place()));
    Ok((0..count).filter_map(move |i| {
        let at = i.wrapping_mul(step);
        let places = match topology {
            Topology::Fan => [0, at.wrapping_add(1), at.wrapping_add(2)],
            Topology::Strip if i % 2 == 1 => [at.wrapping_add(1), at, at.wrapping_add(2)],
            _ => [at, at.wrapping_add(1), at.wrapping_add(2)],
        };
        let [a, b, c] = places.map(corner);
        Some([a?, b?, c?])
    }))
}

/// The lines of some indices, as references to their ends: for [`Pipeline::lines`](super::Pipeline::lines).
///
/// # Errors
/// If an index has no vertex.
/// ```
/// use embedded_raster::pipeline::{assemble_lines, LineTopology};
/// let around: Vec<_> = assemble_lines(LineTopology::Loop, &["a", "b", "c"], &[0_u8, 1, 2])?.collect();
/// assert_eq!(around, [[&"a", &"b"], [&"b", &"c"], [&"c", &"a"]]);
/// # Ok::<(), embedded_raster::pipeline::IndexOutOfRange>(())
/// ```
#[inline]
pub fn assemble_lines<'a, A>(
    topology: LineTopology,
    vertices: &'a [A],
    indices: &'a [impl Index],
) -> Result<impl Iterator<Item = [&'a A; 2]>, IndexOutOfRange> {
    check(vertices.len(), indices)?;
    let (count, step) = match topology {
        LineTopology::List => (indices.len() / 2, 2),
        LineTopology::Loop if indices.len() > 2 => (indices.len(), 1),
        LineTopology::Strip | LineTopology::Loop => (indices.len().saturating_sub(1), 1),
    };
    let end = |at: usize| indices.get(at).and_then(|index| vertices.get(index.place()));
    Ok((0..count).filter_map(move |i| {
        let at = i.wrapping_mul(step);
        let next = at.wrapping_add(1);
        let next = if next < indices.len() { next } else { 0 };
        Some([end(at)?, end(next)?])
    }))
}

/// The points of some indices, as references to their vertices: for [`Pipeline::points`](super::Pipeline::points).
///
/// # Errors
/// If an index has no vertex.
/// ```
/// use embedded_raster::pipeline::{assemble_points, IndexOutOfRange};
/// assert!(assemble_points(&["a", "b"], &[1_u8, 0])?.eq(&["b", "a"]));
/// assert!(assemble_points(&["a", "b"], &[2_u8]).is_err());
/// # Ok::<(), IndexOutOfRange>(())
/// ```
#[inline]
pub fn assemble_points<'a, A>(
    vertices: &'a [A],
    indices: &'a [impl Index],
) -> Result<impl Iterator<Item = &'a A>, IndexOutOfRange> {
    check(vertices.len(), indices)?;
    Ok(indices.iter().filter_map(|index| vertices.get(index.place())))
}

/// The first index without a vertex.
fn check(vertices: usize, indices: &[impl Index]) -> Result<(), IndexOutOfRange> {
    let mut all = indices.iter().map(|index| index.place()).enumerate();
    match all.find(|&(_, index)| index >= vertices) {
        Some((at, index)) => Err(IndexOutOfRange { at, index, vertices }),
        None => Ok(()),
    }
}
