//! From vertices and indices to triangles.

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
    for (at, index) in indices.iter().enumerate() {
        let index = index.place();
        if index >= vertices.len() {
            return Err(IndexOutOfRange { at, index, vertices: vertices.len() });
        }
    }
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
