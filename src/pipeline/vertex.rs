//! [`Vertex`]: what the vertex stage makes, [`shade_vertices`], which runs it, and [`Facing`].

use core::fmt;

use crate::geom::space::Vec4;

/// What the vertex stage makes of a vertex.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
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

/// Runs the vertex stage once for each vertex, into memory of the caller's. Triangles, lines and points of any number then share what
/// came of it, also from band to band.
///
/// * `vertices`: as the program has them.
/// * `shaded`: one place for each of them. What is in it does not matter.
/// * `stage`: is told the number of the vertex, from 0 on.
///
/// # Errors
/// If there are fewer places than vertices. Then the stage did not run.
/// ```
/// use embedded_raster::{pipeline::{shade_vertices, Pipeline, Topology, Vertex}, Vec4};
/// let corners = [(-1, -1), (1, -1), (1, 1), (-1, 1)];
/// let (mut shaded, mut runs, mut pieces) = ([Vertex::default(); 4], 0, 0);
/// let vertices = shade_vertices(&corners, &mut shaded, |&(x, y), number| {
///     runs += 1;
///     Vertex::new(Vec4::whole(x, y, 0, 1), number as u8)
/// })?;
/// Pipeline::new(8, 8)?.indexed(Topology::List, vertices, &[0_u8, 1, 2, 0, 2, 3], |vertex| *vertex, |_| pieces += 1)?;
/// assert_eq!((runs, pieces), (4, 2));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn shade_vertices<'a, A, V>(
    vertices: &[A],
    shaded: &'a mut [Vertex<V>],
    mut stage: impl FnMut(&A, usize) -> Vertex<V>,
) -> Result<&'a [Vertex<V>], TooManyVertices> {
    let (needed, capacity) = (vertices.len(), shaded.len());
    let Some(places) = shaded.get_mut(..needed) else { return Err(TooManyVertices { capacity, needed }) };
    for ((number, vertex), place) in vertices.iter().enumerate().zip(&mut *places) {
        *place = stage(vertex, number);
    }
    Ok(places)
}

/// There are fewer places for vertices than vertices.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct TooManyVertices {
    /// How many there are places for.
    pub capacity: usize,
    /// How many there are.
    pub needed: usize,
}

impl fmt::Display for TooManyVertices {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { capacity, needed } = *self;
        write!(f, "too many vertices: {needed} are shaded, there are places for {capacity}")
    }
}

impl core::error::Error for TooManyVertices {}

/// Which side of a triangle is seen.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub enum Facing {
    /// Its corners turn counter-clockwise, as seen.
    Front,
    /// Its corners turn clockwise, as seen.
    Back,
}
