//! [`Vertex`]: what the vertex stage makes, and [`Facing`].

use crate::geom::space::Vec4;

/// What the vertex stage makes of a vertex.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Vertex<V> {
    /// Where it is, in clip coordinates.
    pub position: Vec4,
    /// What changes over a triangle: see [`Varying`](crate::geom::Varying).
    pub values: V,
}

impl<V> Vertex<V> {
    /// A place in clip coordinates, and what changes over a triangle.
    #[inline]
    pub const fn new(position: Vec4, values: V) -> Self {
        Self { position, values }
    }
}

/// Which side of a triangle is seen.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Facing {
    /// Its corners turn counter-clockwise, as seen.
    Front,
    /// Its corners turn clockwise, as seen.
    Back,
}
