//! From vertices to fragments: a 3D pipeline in integers.
//!
//! ```text
//!   vertices + indices          what a program has: places, and whatever belongs to them
//!        |
//!   vertex stage                a closure: to clip coordinates, and the values that change over a triangle
//!        |
//!   assembly                    three corners each: from a list, a strip or a fan; two ends of a line; points
//!        |
//!   clipping                    the near and the far plane, and a guard band around the picture
//!        |
//!   perspective divide          x / w, y / w, z / w
//!        |
//!   viewport                    to pixels, in 24.8
//!        |
//!   culling                     of triangles seen from the back, or from the front
//!        |
//!   rasterization               the pixels of a triangle, a line or a point, each with its depth and values
//!        |
//!   fragment stage              a closure: the colour of a pixel, or none
//!        |
//!   frame, depth buffer
//! ```
//! The shortest program: three vertices, nothing done to them, and the same colour everywhere.
//! ```
//! use embedded_graphics_core::pixelcolor::{Rgb565, RgbColor};
//! use embedded_raster::{buffer_bytes, pipeline::{Pipeline, Vertex}, Framebuffer, Vec3};
//! use fixed::types::I16F16;
//!
//! let mut ram = [0; buffer_bytes::<Rgb565>(64, 64)];
//! let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 64)?;
//! let corners = [(-1, 0), (0, -1), (-1, -1)].map(|(x, y)| Vec3::whole(x, y, 0));
//! Pipeline::new(64, 64)?.triangles(
//!     [corners],
//!     |place| Vertex::new(place.with_w(I16F16::ONE), ()),
//!     |triangle| triangle.fill(&mut frame, |_| Some(Rgb565::BLUE)),
//! );
//! # let blue = ram.chunks(2).filter(|pixel| pixel == &[0x1f, 0]).count();
//! # assert_eq!(blue, 496);
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! ![A blue triangle in the lower left corner of a black square][blue-triangle]
//!
//! What a program sees of a pixel is a [`Fragment`]: its values, its depth, its number. Each of them can be a colour:
//!
//! ![A teapot, lit][teapot-gouraud] ![With a texture][teapot-textured]
//! ![The nearer, the lighter][teapot-depth] ![Each triangle in a colour of its own][teapot-id]
//!
//! *The teapot in 160 x 120 pixels of 4 bits, dithered: colours from corner to corner, a texture, depths, and numbers of triangles.*
//!
//! # Coordinates
//! Clip coordinates are [`Vec4`](crate::Vec4)s: x from -w to w from left to right, y from -w to w from bottom to top, z from 0 at the near plane
//! to w at the far one. What is divided by w are normalized device coordinates, NDC. The viewport maps x from -1 to 1 to pixels 0 to
//! W, and y from *1 to -1* to pixels 0 to H: on the screen y points down.
//! ```text
//!        NDC                         pixels
//!    (-1, 1)      (1, 1)         (0, 0)       (W, 0)
//!        +----------+                +----------+
//!        |     |    |                |          |        X = (x / w + 1) W / 2
//!        |-----o----|      --->      |          |        Y = (1 - y / w) H / 2
//!        |     |    |                |          |        each to the nearest 1/256 pixel
//!        +----------+                +----------+
//!    (-1,-1)      (1,-1)         (0, H)       (W, H)
//! ```
//!
//! # What is exact
//! A corner is rounded once, to 1/256 pixel. From there on the rules of [`triangle`](crate::raster::triangle) and of
//! [`varying`](crate::geom::varying) hold: triangles that share an edge have no gap and no overlap, and each value is the nearest
//! one. Depths are z / w, which is linear on the screen. Other values change linearly on the screen as well: see
//! [`Triangle::fill`].
//!
//! A triangle that planes cut gets new corners. Each of their coordinates and values is rounded once, to the nearest number, from the
//! exact place where two planes meet in the triangle or one crosses an edge, however many planes cut; so is its place on the screen. A corner on an edge comes of
//! the two ends of the edge alone: so both triangles of an edge get the same one, and there are no cracks.
//!
//! Any bits in matrices, vertices and viewports are fine: nothing wraps around, and the work for a triangle, a line or a point is
//! bounded by the pixels that it has in the window and a constant.
//!
//! # Lines and points
//! [`Pipeline::lines`] and [`Pipeline::points`] take what they are given through the same stages: see [`Line`] and [`Splat`] for
//! which pixels they have. Lines are cut by the same planes as triangles, and points are left out outside of them. With a depth
//! buffer, a mesh of lines without those that are hidden takes two passes: the triangles in the colour of the background by
//! [`Triangle::fill_behind`], and then its edges by [`Line::draw_depth`].
//! ```
//! use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
//! use embedded_raster::{paint::depth, pipeline::{Pipeline, Vertex}, pixel::Depth16, surface::DepthBuffer, Framebuffer, Vec4};
//!
//! let (mut ram, mut depth_ram) = ([b'.'; 8 * 5], [0; 8 * 5 * 2]);
//! let mut frame = Framebuffer::<Gray8>::new(&mut ram, 8, 5)?;
//! let mut depths = DepthBuffer::<Depth16>::new(&mut depth_ram, 8, 5)?;
//! depths.clear(Depth16::MAX);
//! let (pipeline, vertex) = (Pipeline::new(8, 5)?, |at| Vertex::new(at, ()));
//! // A triangle, and a line that passes behind it.
//! let triangle = [(1, 4), (1, -4), (-2, 0)].map(|(x, y)| Vec4::whole(x, y, 1, 4));
//! pipeline.triangles([triangle], vertex, |it| it.fill_behind(&mut frame, &mut depths, depth::less, |_| Some(Gray8::new(b'#'))));
//! let line = [(-3, 1), (3, 1)].map(|(x, z)| Vec4::whole(x, 0, z + 1, 4));
//! pipeline.lines([line], vertex, |it| {
//!     it.draw_depth(&mut frame, &mut depths, depth::less_equal, |_| Some(Gray8::new(b'-')));
//! });
//! assert_eq!(&ram[16..24], b".-###---");
//! # Ok::<(), embedded_raster::Error>(())
//! ```
//!
//! Sources: I. Sutherland and G. Hodgman, "Reentrant Polygon Clipping", Communications of the ACM 17, 1974; J. Blinn and M. Newell,
//! "Clipping Using Homogeneous Coordinates", SIGGRAPH 1978.
#![doc = include_str!("pictures.md")]

mod assembly;
mod clip;
mod depth;
mod draw;
mod line;
mod splat;
mod vertex;
mod viewport;

pub use self::{
    assembly::{assemble, assemble_lines, assemble_points, Index, IndexOutOfRange, LineTopology, Topology},
    depth::DepthOf,
    draw::{Fragment, Triangle},
    line::Line,
    splat::{Dot, Splat},
    vertex::{shade_vertices, Facing, TooManyVertices, Vertex},
};
use self::{
    clip::Clipped,
    viewport::{Corner, Screen},
};
use crate::{error::PictureTooLarge, geom::Mix};

/// The fixed stages between vertices and fragments. See the [module](self) for what they are.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Pipeline {
    screen: Screen,
    culled: Option<Facing>,
    front_is_clockwise: bool,
}

impl Pipeline {
    /// For a picture of `width` x `height` pixels.
    ///
    /// All triangles are drawn, whichever side is seen.
    ///
    /// # Errors
    /// If it has more than 4,096 columns or rows.
    pub const fn new(width: u16, height: u16) -> Result<Self, PictureTooLarge> {
        const MOST: u16 = Screen::MOST;
        if width > MOST || height > MOST {
            return Err(PictureTooLarge { width, height, most: MOST });
        }
        Ok(Self { screen: Screen { width, height }, culled: None, front_is_clockwise: false })
    }

    /// Leaves out the triangles of which this side is seen.
    #[must_use]
    pub const fn cull(self, side: Facing) -> Self {
        Self { culled: Some(side), ..self }
    }

    /// For meshes whose triangles turn clockwise when they are seen from the front.
    #[must_use]
    pub const fn front_is_clockwise(self) -> Self {
        Self { front_is_clockwise: true, ..self }
    }

    /// Takes triangles through all stages up to culling, and hands each that is left to `draw`: see [`Triangle::fill`]. One that a
    /// plane cuts comes in several pieces, all with its number. Returns how many came.
    ///
    /// * `triangles`: three vertices each, as the program has them.
    /// * `vertex`: the vertex stage.
    pub fn triangles<A, V: Mix>(
        &self,
        triangles: impl IntoIterator<Item = [A; 3]>,
        mut vertex: impl FnMut(A) -> Vertex<V>,
        mut draw: impl FnMut(&Triangle<V>),
    ) -> u32 {
        let (mut number, mut count) = (0_u32, 0_u32);
        for corners in triangles {
            number = number.wrapping_add(1);
            let corners = corners.map(&mut vertex);
            let mut piece =
                |corners: &[Corner<V>; 3]| count = count.wrapping_add(self.finish(corners, number, &mut draw));
            match clip::look(self.screen, &corners) {
                Clipped::Outside => {}
                Clipped::Inside => {
                    if let Some(corners) = self.screen.corners(corners) {
                        piece(&corners);
                    }
                }
                Clipped::Cut(planes) => clip::cut(self.screen, &corners, planes, piece),
            }
        }
        count
    }

    /// [`triangles`](Self::triangles), but one that a plane would cut is left out: for scenes that stay between the near and the far
    /// plane, and not far outside of the picture.
    ///
    /// A firmware that draws nothing else does not have the clipper in its flash and on its stack.
    /// ```
    /// use embedded_raster::{pipeline::{Pipeline, Vertex}, Vec4};
    /// let (mut whole, mut pieces) = (0, 0);
    /// // The last corner lies in front of the near plane.
    /// let triangle = [Vec4::whole(-1, -1, 1, 2), Vec4::whole(1, -1, 1, 2), Vec4::whole(0, 1, -1, 2)];
    /// Pipeline::new(4, 4)?.whole_triangles([triangle], |at| Vertex::new(at, ()), |_| whole += 1);
    /// Pipeline::new(4, 4)?.triangles([triangle], |at| Vertex::new(at, ()), |_| pieces += 1);
    /// assert_eq!((whole, pieces), (0, 2));
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub fn whole_triangles<A, V: Copy>(
        &self,
        triangles: impl IntoIterator<Item = [A; 3]>,
        mut vertex: impl FnMut(A) -> Vertex<V>,
        mut draw: impl FnMut(&Triangle<V>),
    ) -> u32 {
        let (mut number, mut count) = (0_u32, 0_u32);
        for corners in triangles {
            number = number.wrapping_add(1);
            let corners = corners.map(&mut vertex);
            if let Clipped::Inside = clip::look(self.screen, &corners) {
                let Some(corners) = self.screen.corners(corners) else { continue };
                count = count.wrapping_add(self.finish(&corners, number, &mut draw));
            }
        }
        count
    }

    /// [`triangles`](Self::triangles) of vertices that indices choose.
    ///
    /// The vertex stage runs three times for each triangle. Where triangles share vertices, [`shade_vertices`] runs it once for each of
    /// those, and this takes what came of it: then its own stage is `|vertex| *vertex`.
    ///
    /// # Errors
    /// If an index has no vertex. Then nothing is drawn.
    /// ```
    /// use embedded_graphics_core::pixelcolor::Gray8;
    /// use embedded_raster::{pipeline::{Pipeline, Topology, Vertex}, Framebuffer, Vec3};
    /// use fixed::types::I16F16;
    /// let mut ram = [0; 16];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 4, 4)?;
    /// let square = [(-1, -1), (1, -1), (-1, 1), (1, 1)].map(|(x, y)| Vec3::whole(x, y, 0));
    /// Pipeline::new(4, 4)?.indexed(
    ///     Topology::Strip,
    ///     &square,
    ///     &[0_u8, 1, 2, 3],
    ///     |place| Vertex::new(place.with_w(I16F16::ONE), ()),
    ///     |triangle| triangle.fill(&mut frame, |fragment| Some(Gray8::new(fragment.number as u8))),
    /// )?;
    /// assert_eq!(ram, [2, 2, 2, 2, 1, 2, 2, 2, 1, 1, 2, 2, 1, 1, 1, 2]);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn indexed<A, V: Mix>(
        &self,
        topology: Topology,
        vertices: &[A],
        indices: &[impl Index],
        vertex: impl FnMut(&A) -> Vertex<V>,
        draw: impl FnMut(&Triangle<V>),
    ) -> Result<u32, IndexOutOfRange> {
        Ok(self.triangles(assemble(topology, vertices, indices)?, vertex, draw))
    }

    /// Takes lines through all stages up to the viewport, and hands each that is left to `draw`: see [`Line::draw`]. Returns how many
    /// came.
    ///
    /// * `lines`: two vertices each, as the program has them.
    /// * `vertex`: the vertex stage.
    pub fn lines<A, V: Mix>(
        &self,
        lines: impl IntoIterator<Item = [A; 2]>,
        mut vertex: impl FnMut(A) -> Vertex<V>,
        mut draw: impl FnMut(&Line<V>),
    ) -> u32 {
        let (mut number, mut count) = (0_u32, 0_u32);
        for ends in lines {
            number = number.wrapping_add(1);
            let ends = ends.map(&mut vertex);
            let [a, b] = ends.each_ref().map(|end| clip::planes(self.screen, end.position));
            let left = match a | b {
                0 => self.screen.ends(ends),
                planes => clip::cut_line(self.screen, &ends, planes),
            };
            let Some(ends) = left else { continue };
            let (projected, ends) = (ends.each_ref().map(|end| end.projected), ends.map(|end| end.vertex));
            draw(&Line { projected, ends, number });
            count = count.wrapping_add(1);
        }
        count
    }

    /// Takes points through all stages up to the viewport, and hands each that is left to `draw`: see [`Splat::draw`]. Returns how
    /// many came.
    ///
    /// * `points`: vertices, as the program has them.
    /// * `vertex`: the vertex stage.
    /// ```
    /// use embedded_graphics_core::pixelcolor::{Gray8, GrayColor};
    /// use embedded_raster::{pipeline::{Dot, Pipeline, Vertex}, px, Framebuffer, Vec4};
    /// let mut ram = [b'.'; 24];
    /// let mut frame = Framebuffer::<Gray8>::new(&mut ram, 8, 3)?;
    /// // The nearer, the larger: 4 pixels where w is 1.
    /// Pipeline::new(8, 3)?.points(
    ///     [Vec4::whole(-2, 0, 1, 4), Vec4::whole(1, 0, 1, 2)],
    ///     |at| Vertex::new(at, ()),
    ///     |point| {
    ///         let size = px(4) / point.vertex().position.w.to_num::<i32>();
    ///         point.draw(Dot::Square(size), &mut frame, |_| Some(Gray8::new(b'#')));
    ///     },
    /// );
    /// assert_eq!(&ram, b".....##..#...##.........");
    /// # Ok::<(), embedded_raster::Error>(())
    /// ```
    pub fn points<A, V: Copy>(
        &self,
        points: impl IntoIterator<Item = A>,
        mut vertex: impl FnMut(A) -> Vertex<V>,
        mut draw: impl FnMut(&Splat<V>),
    ) -> u32 {
        let (mut number, mut count) = (0_u32, 0_u32);
        for point in points {
            number = number.wrapping_add(1);
            let vertex = vertex(point);
            if clip::planes(self.screen, vertex.position) != 0 {
                continue;
            }
            if let Some(projected) = self.screen.project(vertex.position) {
                draw(&Splat { projected, vertex, number });
                count = count.wrapping_add(1);
            }
        }
        count
    }

    /// Culling. How many of it were drawn: one or none.
    ///
    /// Not inlined: it is called for whole triangles and for pieces, and `draw` may be large.
    #[inline(never)]
    fn finish<V: Copy>(self, corners: &[Corner<V>; 3], number: u32, draw: &mut impl FnMut(&Triangle<V>)) -> u32 {
        let projected = corners.each_ref().map(|corner| corner.projected);
        let turn = viewport::turn(projected.each_ref().map(|it| it.place));
        let is_front = (turn > 0) == self.front_is_clockwise;
        let facing = if is_front { Facing::Front } else { Facing::Back };
        if turn == 0 || self.culled == Some(facing) {
            return 0;
        }
        let corners = corners.each_ref().map(|corner| corner.vertex);
        draw(&Triangle { projected, corners, facing, number });
        1
    }
}
