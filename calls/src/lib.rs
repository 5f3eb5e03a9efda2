//! The list of everything that draws.
//!
//! Whoever has to call all of it takes it from here: the proofs that no call can panic, on computers and on chips, the tests with
//! wild arguments, and the fuzz target that compares sequences of calls. The lists are:
//!
//! | list | what it calls | on |
//! |---|---|---|
//! | [`draw`] | what draws without reading | any surface |
//! | [`read`] | what reads as well | a surface that can be read |
//! | [`frames::call`] | what only memory has | a frame |
//! | [`paths::call`] | what makes paths, from texts too | nothing |
//! | [`computing::call`] | what needs no surface: shapes to spans, geometry, angles, palettes | nothing |
//! | [`blending::call`] | what mixes colours | a frame of 16 bits |
//! | [`shading::call`] | values over triangles, textures, the pipeline | a picture for the texels |
//! | [`texts::call`] | fonts, and text | any surface |
//! | [`space::call`] | vectors, matrices, surfaces and light, with arguments of their own | nothing |
//! | [`damage::call`] | what has changed, and what is to be sent of it | a list of rectangles |
//! | [`present::call`] | buffers and bands on their way to a display, likewise | nothing |
//!
//! A call is named as what it calls: the type, the trait or the module, and the function. A test in `tests/calls.rs` reads the
//! sources of the crate, and fails when something public is missing here.
#![no_std]

pub mod answer;
pub mod antialias;
pub mod blending;
pub mod computing;
pub mod damage;
pub mod frames;
pub mod paths;
pub mod present;
pub mod shading;
pub mod space;
pub mod texts;

use antialias::with_scratch;
use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Dimensions, Point},
    pixelcolor::{BinaryColor, Gray4},
    primitives::Rectangle,
    Pixel,
};
use embedded_raster::{
    eg,
    geom::{triangulate::SideSlot, Plane},
    paint::{depth, DepthShade, Dithered, Linear, Masked, Pattern, Radial, Ramp, Shade, ShadeSome, Tiles},
    pipeline::Dot,
    pixel::Lsb0,
    raster::{
        coverage,
        flood::{Connectivity, FloodSlot},
        polygon::drop_out::DropOut,
        rounded::Align,
        triangle,
    },
    surface::{Rows, Sheet, Stencil},
    Antialias, Bitmap, Canvas, ClippedSpan, EdgeSlot, Ellipse, FillRule, Frame, Index1, Layout, Path, PathSegment,
    Pictures, PointFx, Radii, Readable, Rect, Sector, Sink, SoftRow, Solid, Span, Stroke, Surface,
};
use fixed::types::I24F8;
use shading::with_depths;

/// What calls are made with: each takes what it wants.
pub struct Arguments<'a, L: Layout> {
    /// Corners, and places of whole pixels: seeds, ends.
    pub points: [Point; 3],
    /// Corners and control points.
    pub places: [PointFx; 4],
    /// Boxes, the second one for holes.
    pub areas: [Rect; 2],
    /// Ellipses, the second one for holes.
    pub ellipses: [Ellipse; 2],
    /// Of points.
    pub size: I24F8,
    /// Of rounded rectangles.
    pub radii: Radii,
    /// Of arcs.
    pub sector: Sector,
    /// Corners of a polygon in pixels.
    pub corners: &'a [Point],
    /// Corners of a polygon in places.
    pub contour: &'a [PointFx],
    /// Of a path.
    pub segments: &'a [PathSegment],
    /// Of a line with a width.
    pub stroke: Stroke,
    /// Lengths of dashes.
    pub dashes: &'a [I24F8],
    /// Where they begin.
    pub phase: I24F8,
    /// Even-odd, closed, through corners, opaque.
    pub flag: bool,
    /// Scratch memory of polygons.
    pub table: &'a mut [EdgeSlot],
    /// Scratch memory of floods.
    pub slots: &'a mut [FloodSlot],
    /// The colour, and a second one: of a boundary, of a key, of what is not set in a mask.
    pub colors: [L::Color; 2],
    /// To copy.
    pub picture: Frame<&'a [u8], L>,
    /// To paint through.
    pub mask: Frame<&'a [u8], Rows<Lsb0<Index1>>>,
    /// The same in the other order of bits.
    pub mask_msb0: Frame<&'a [u8], Rows<Index1>>,
    /// What shapes are clipped against where there is no surface.
    pub window: Rect,
    /// Numbers without a meaning.
    pub numbers: [i32; 6],
    /// Memory to read: pixels, indices.
    pub bytes: &'a [u8],
    /// Memory to write.
    pub out: &'a mut [u8],
    /// Where further contours begin in `contour`.
    pub starts: &'a [u16],
    /// Scratch memory of triangulations.
    pub sides: &'a mut [SideSlot],
    /// Triangles out of a triangulation, and to refine.
    pub triangles: &'a mut [[u16; 3]],
    /// Scratch memory of refinements.
    pub neighbours: &'a mut [[u16; 3]],
}

/// A list of calls: its names, and a function that makes the call of a number. Both come from the same lines, so none can be in
/// one and not in the other.
macro_rules! calls {
    (
        $(#[$doc:meta])* $names:ident, $function:ident[$($generics:tt)*]($on:ident: $type:ty, $a:ident)
        { $($prelude:tt)* }
        $([$owner:ident] $($name:ident => $call:expr;)*)*
    ) => {
        #[doc = concat!("The names of the calls of [`", stringify!($function), "`].")]
        pub const $names: &[&str] = &[$($(concat!(stringify!($owner), "::", stringify!($name))),*),*];

        $(#[$doc])*
        /// What a call answered is returned as a number.
        pub fn $function<$($generics)*>($on: $type, $a: &mut $crate::Arguments<'_, L>, number: usize) -> usize {
            $($prelude)*
            let mut numbers = 0..usize::MAX;
            $($(
                if numbers.next() == Some(number) {
                    return $crate::answer::Answer::answer($call);
                }
            )*)*
            0
        }
    };
}
pub(crate) use calls;

/// How many calls [`call`] knows.
pub const COUNT: usize = DRAWING.len() + READING.len();

/// The name of a call of [`call`].
pub fn name(number: usize) -> &'static str {
    DRAWING.iter().chain(READING).nth(number).copied().unwrap_or_default()
}

/// Makes the call of a number below [`COUNT`]: those of [`draw`], then those of [`read`].
pub fn call<S, L>(on: &mut S, a: &mut Arguments<'_, L>, number: usize) -> usize
where
    S: Readable<Color = L::Color>,
    L: Layout,
{
    match number.checked_sub(DRAWING.len()) {
        Some(number) => read(on, a, number),
        None => draw(on, a, number),
    }
}

calls! {
    /// Draws on any surface with colours as the picture of the arguments has them, by the call of a number below that of
    /// [`DRAWING`].
    DRAWING, draw[S: Surface<Color = L::Color>, L: Layout](on: &mut S, a)
    {
        let (c, window) = (a.colors[0], on.window());
        // Of a level that changes over a triangle.
        let [even, odd] = a.colors;
        let color = |level: u8| if level & 1 == 0 { even } else { odd };
        let corners = a.corners_fx();
    }
    [Canvas]
    paint => on.paint(Solid(c), |window, brush| triangle::fill(a.corners_fx(), window, brush));
    fill_window => on.fill_window(c);
    draw_point => on.draw_point(a.points[0], c);
    draw_point_fx => on.draw_point_fx(a.places[0], c);
    draw_line => on.draw_line(a.points[0], a.points[1], c);
    draw_line_fx => on.draw_line_fx(a.places[0], a.places[1], c);
    shade_line_fx => on.shade_line_fx([a.places[0], a.places[1]], [(0, -9_i32), (255, 4)], |(level, number)| {
        color(level ^ u8::from(number & 1 == 0))
    });
    depth_line_fx => with_depths(window, |depths| {
        let [first, last, _] = a.depths();
        on.depth_line_fx([a.places[0], a.places[1]], [first, last], depths, depth::less, color).is_ok()
    });
    draw_polyline => on.draw_polyline(a.corners.iter().copied(), c);
    draw_polygon => on.draw_polygon(a.corners.iter().copied(), c);
    draw_triangle => on.draw_triangle(a.points, c);
    draw_rectangle => on.draw_rectangle(a.areas[0], c);
    fill_rectangle => on.fill_rectangle(a.areas[0], c);
    fill_rectangle_fx => on.fill_rectangle_fx(a.places[0], a.places[1], c);
    fill_triangle => on.fill_triangle(a.points, c);
    fill_triangle_fx => on.fill_triangle_fx(a.corners_fx(), c);
    shade_triangle_fx => on.shade_triangle_fx(corners, [(0, -9_i32), (128, i32::MAX), (255, 4)], |(level, number)| {
        color(level ^ u8::from(number & 1 == 0))
    });
    depth_triangle_fx => with_depths(window, |depths| {
        on.depth_triangle_fx(corners, a.depths(), depths, depth::less, color).is_ok()
    });
    draw_ellipse => on.draw_ellipse(a.areas[0], c);
    fill_ellipse => on.fill_ellipse(a.areas[0], c);
    fill_ellipse_fx => on.fill_ellipse_fx(a.ellipses[0], c);
    fill_outlined_ellipse => on.fill_outlined_ellipse(a.areas[0], c);
    fill_round_point_fx => on.fill_round_point_fx(a.places[0], a.size, c);
    fill_square_point_fx => on.fill_square_point_fx(a.places[0], a.size, c);
    draw_arc => on.draw_arc(a.areas[0], a.sector, c);
    fill_sector => on.fill_sector(a.areas[0], a.sector, c);
    fill_sector_fx => on.fill_sector_fx(a.ellipses[0], a.sector, c);
    fill_ring => on.fill_ring(a.areas[0], a.areas[1], c);
    fill_ring_fx => on.fill_ring_fx(a.ellipses[0], a.ellipses[1], c);
    fill_ring_sector => on.fill_ring_sector(a.areas[0], a.areas[1], a.sector, c);
    fill_ring_sector_fx => on.fill_ring_sector_fx(a.ellipses[0], a.ellipses[1], a.sector, c);
    fill_gauge => on.fill_gauge(a.areas[0], a.areas[1], a.sector, c);
    fill_gauge_fx => on.fill_gauge_fx(a.ellipses[0], a.ellipses[1], a.sector, c);
    fill_chord => on.fill_chord(a.areas[0], a.sector, c);
    fill_chord_fx => on.fill_chord_fx(a.ellipses[0], a.sector, c);
    draw_rounded => on.draw_rounded(a.areas[0], a.radii, c);
    fill_rounded => on.fill_rounded(a.areas[0], a.radii, c);
    fill_outlined_rounded => on.fill_outlined_rounded(a.areas[0], a.radii, c);
    stroke_rounded => on.stroke_rounded(a.areas[0], a.radii, a.numbers[1].unsigned_abs() % 64, a.align(), c);
    stroke_ellipse => on.stroke_ellipse(a.areas[0], a.numbers[1].unsigned_abs() % 64, a.align(), c);
    stroke_arc => on.stroke_arc(a.areas[0], a.sector, a.numbers[1].unsigned_abs() % 64, a.align(), c);
    stroke_round_arc => on.stroke_round_arc(a.areas[0], a.sector, a.numbers[1].unsigned_abs() % 64, a.align(), c);
    stroke_arc_fx => {
        let stroke = a.stroke.dashed(a.dashes, a.phase);
        on.stroke_arc_fx(a.places[0], [a.size, a.phase], a.sector, &stroke, a.table, c)
    };
    fill_polygon => on.fill_polygon(a.corners, a.rule(), a.table, c);
    fill_polygon_fx => on.fill_polygon_fx(a.contour, a.rule(), a.table, c);
    fill_contours_fx => on.fill_contours_fx([a.contour, &a.places], a.rule(), a.table, c);
    draw_path_fx => on.draw_path_fx(Path::new(a.segments), c);
    fill_path_fx => on.fill_path_fx(Path::new(a.segments), a.rule(), a.table, c);
    fill_path_drop_out_fx => {
        let drop_out = DropOut { smart: a.flag, stubs: a.numbers[0] & 1 == 0 };
        let few = a.segments.get(..a.segments.len().min(6)).unwrap_or_default();
        on.fill_path_drop_out_fx(Path::new(few), a.rule(), drop_out, a.table, c)
    };
    draw_quadratic_fx => on.draw_quadratic_fx(a.corners_fx(), c);
    draw_cubic_fx => on.draw_cubic_fx(a.places, c);
    stroke_path_fx => on.stroke_path_fx(Path::new(a.segments), &a.stroke.dashed(a.dashes, a.phase), a.table, c);
    stroke_polyline_fx => on.stroke_polyline_fx(a.contour, a.flag, &a.stroke, a.table, c);
    stroke_round_polyline_fx => {
        on.stroke_round_polyline_fx(a.contour, a.flag, a.size, &a.stroke.dashed(a.dashes, a.phase), a.table, c)
    };
    fill_round_polygon_fx => on.fill_round_polygon_fx(a.contour, a.size, a.rule(), a.table, c);
    stroke_line_fx => on.stroke_line_fx([a.places[0], a.places[1]], &a.stroke, a.table, c);
    blit => on.blit(a.points[0], &a.picture);
    blit_keyed => on.blit_keyed(a.points[0], &a.picture, a.colors[1]);
    blit_mask => on.blit_mask(a.points[0], &a.mask, c, a.flag.then_some(a.colors[1]));
    [Antialias]
    draw_line_aa => on.draw_line_aa(a.places[0], a.places[1], Solid(c));
    fill_rectangle_aa => on.fill_rectangle_aa(a.places[0], a.places[1], Dithered::<_, 4>(c));
    fill_triangle_aa => on.fill_triangle_aa(corners, &mut [], Dithered::<_, 2>(c));
    fill_polygon_aa => with_scratch(|table, cells| on.fill_polygon_aa(a.contour, a.rule(), table, cells, Solid(c)));
    fill_contours_aa => with_scratch(|table, cells| {
        on.fill_contours_aa([a.contour, &a.places], a.rule(), table, cells, Dithered::<_, 8>(c))
    });
    fill_path_aa => with_scratch(|table, cells| {
        on.fill_path_aa(Path::new(a.segments), a.rule(), table, cells, Dithered::<_, 4>(c))
    });
    fill_ellipse_aa => on.fill_ellipse_aa(a.ellipses[0], Dithered::<_, 4>(c));
    fill_sector_aa => with_scratch(|table, cells| {
        on.fill_sector_aa(a.ellipses[0], a.sector, table, cells, Dithered::<_, 4>(c))
    });
    fill_ring_aa => on.fill_ring_aa(a.ellipses[0], a.ellipses[1], Dithered::<_, 4>(c));
    fill_ring_sector_aa => with_scratch(|table, cells| {
        on.fill_ring_sector_aa(a.ellipses, a.sector, table, cells, Dithered::<_, 4>(c))
    });
    fill_rounded_aa => with_scratch(|table, cells| on.fill_rounded_aa(a.areas[0], a.radii, table, cells, Solid(c)));
    stroke_path_aa => with_scratch(|table, cells| {
        let stroke = a.stroke.dashed(a.dashes, a.phase);
        on.stroke_path_aa(Path::new(a.segments), &stroke, table, cells, Dithered::<_, 2>(c))
    });
    stroke_polyline_aa => with_scratch(|table, cells| {
        on.stroke_polyline_aa(a.contour, a.flag, &a.stroke, table, cells, Solid(c))
    });
    stroke_line_aa => with_scratch(|table, cells| {
        on.stroke_line_aa([a.places[0], a.places[1]], &a.stroke, table, cells, Dithered::<_, 4>(c))
    });
    blit_mask_aa => Bitmap::<Gray4>::new(a.bytes, 9, 7).map(|mask| {
        on.blit_mask_aa(a.points[0], &mask.view(a.areas[1]), Dithered::<_, 4>(c));
        on.blit_mask_aa(a.points[1], &a.mask, Solid(c));
    });
    [Masked]
    new => on.fill_triangle_aa(corners, &mut [], Masked::new(a.mask_msb0, Dithered::<_, 4>(c)));
    [Stencil]
    new => {
        let mut stencil = Stencil::new(on, a.mask);
        stencil.fill_triangle_fx(corners, c);
        stencil.blit(a.points[0], &a.picture);
        stencil.draw_line(a.points[0], a.points[1], c);
    };
    [Ramp]
    new => on.fill_triangle_aa(corners, &mut [], Ramp::new(a.colors));
    [Surface]
    fill_span => a.span().clip(window).map(|span| on.fill_span(span, c));
    fill_area => on.fill_area(a.areas[0], c);
    fill_steps => embedded_raster::raster::line::clip(a.points[0], a.points[1], window).map(|steps| on.fill_steps(steps, c));
    fill_octants => octants(a.areas[0], window.inset(-40)).map(|octants| {
        // A surface that cannot, or does not see all of it, is given the same pixels in spans.
        if !on.fill_octants(octants, c) {
            on.draw_ellipse(a.areas[0], c);
        }
    });
    set => on.set(a.points[0], c);
    write_span => a.span().clip(window).map(|span| on.write_span(span, |x| a.alternate(x)));
    write_some => a.span().clip(window).map(|span| on.write_some(span, |x| (x & 4 == 0).then(|| a.alternate(x))));
    copy_picture => on.copy_picture(a.points[0], &a.picture, a.flag.then_some(a.colors[1]));
    copy_mask => on.copy_mask(a.points[0], &a.mask_msb0, c, a.flag.then_some(a.colors[1]));
    [Shade]
    new => a.facet().map(|facet| {
        let shade = Shade::new(Plane::new(&facet, a.depths()), |(_, level)| color(level));
        on.paint(shade, |window, brush| triangle::fill(corners, window, brush));
    });
    [Linear]
    new => on.paint(Linear::new([a.places[0], a.places[1]], a.outside(), |level, _| color(level)), |window, brush| {
        triangle::fill(corners, window, brush);
    });
    [Radial]
    new => on.paint(Radial::new(a.places[0], a.size, a.outside(), |level, _| color(level)), |window, brush| {
        triangle::fill(corners, window, brush);
    });
    [Pictures]
    blit_mapped => on.blit_mapped(a.points[0], &a.picture, |texel| (texel != c).then_some(texel));
    blit_stretched => on.blit_stretched(a.areas[0], &a.picture, Some);
    blit_affine => on.blit_affine(&a.map(), &a.picture, Some).is_ok();
    blit_nine_patch => on.blit_nine_patch(a.areas[0], &a.picture, a.areas[1], Some);
    draw_tile_map => {
        let sheet = Sheet::new(&a.picture, a.tile(), a.tile());
        on.draw_tile_map(a.points[0], &sheet, |column, row| usize::try_from(column ^ row).ok(), Some);
    };
    [Pattern]
    new => on.paint(Pattern::new(a.rows(), c, None), |window, brush| triangle::fill(corners, window, brush));
    at => on.paint(Pattern::new(a.rows(), c, Some(a.colors[1])).at(a.points[0]), |window, brush| {
        triangle::fill(corners, window, brush);
    });
    [Tiles]
    new => on.paint(Tiles::new(&a.picture, Some), |window, brush| triangle::fill(corners, window, brush));
    at => on.paint(Tiles::new(&a.picture, |texel| (texel != c).then_some(c)).at(a.points[0]), |window, brush| {
        triangle::fill(corners, window, brush);
    });
    [ShadeSome]
    new => a.facet().map(|facet| {
        let plane = Plane::new(&facet, a.depths());
        let shade = ShadeSome::new(plane, |(number, level)| (number & 7 != 0).then(|| color(level)));
        on.paint(shade, |window, brush| triangle::fill(corners, window, brush));
    });
    [DepthShade]
    new => a.facet().map(|facet| with_depths(window, |depths| {
        let plane = Plane::new(&facet, a.depths());
        let shade = DepthShade::new(depths, plane, depth::greater, |level, depth| (depth & 7 != 0).then(|| color(level)));
        on.paint(shade, |window, brush| triangle::fill(corners, window, brush));
    }));
    read_only => a.facet().map(|facet| with_depths(window, |depths| {
        // As it keeps no depth, the second one draws the same pixels again.
        for _ in 0..2 {
            let plane = Plane::new(&facet, a.depths());
            let shade = DepthShade::new(&mut *depths, plane, depth::less, |level, _| Some(color(level)));
            on.paint(shade.read_only(), |window, brush| triangle::fill(corners, window, brush));
        }
    }));
    [Triangle]
    fill => shading::pipeline(window).triangles([a.vertices()], |vertex| vertex, |triangle| {
        triangle.fill(on, |fragment| (fragment.at.x & 7 != 3).then(|| color(fragment.values)));
    });
    fill_depth => with_depths(window, |depths| {
        shading::pipeline(window).triangles([a.vertices()], |vertex| vertex, |triangle| {
            triangle.fill_depth(on, depths, depth::less, |fragment| Some(color(fragment.values)));
        })
    });
    fill_behind => with_depths(window, |depths| {
        shading::pipeline(window).triangles([a.vertices()], |vertex| vertex, |triangle| {
            triangle.fill_behind(on, depths, depth::less_equal, |fragment| Some(color(fragment.values)));
        })
    });
    [Line]
    draw => shading::pipeline(window).lines([a.ends()], |vertex| vertex, |line| {
        line.draw(on, |fragment| (fragment.at.x & 7 != 3).then(|| color(fragment.values)));
    });
    draw_depth => with_depths(window, |depths| {
        shading::pipeline(window).lines([a.ends()], |vertex| vertex, |line| {
            line.draw_depth(on, depths, depth::less_equal, |fragment| Some(color(fragment.values)));
        })
    });
    [Splat]
    draw => shading::pipeline(window).points(a.vertices(), |vertex| vertex, |point| {
        point.draw(Dot::Round(a.size), on, |fragment| (fragment.at.x & 7 != 3).then(|| color(fragment.values)));
    });
    draw_depth => with_depths(window, |depths| {
        shading::pipeline(window).points(a.vertices(), |vertex| vertex, |point| {
            point.draw_depth(Dot::Square(a.size), on, depths, depth::less, |fragment| Some(color(fragment.values)));
        })
    });
    [eg]
    target => eg::target(on).fill_solid(&a.rectangle(), c).is_err();
    draw_on => {
        // Its own window is a foreign one here: pixels go the long way through a `DrawTarget`, and back.
        let (corners, area) = (a.corners_fx(), a.areas[0]);
        eg::draw_on(&mut Foreign(on), |canvas| {
            canvas.fill_triangle_fx(corners, c);
            canvas.draw_rectangle(area, c);
            canvas.draw_line(a.points[0], a.points[1], c);
        }).is_err()
    };
    recolored => a.recolored(on, |target, _, on| target.clear(on).is_err());
    recolored_at => a.recolored_at(on, |target, _, on| target.clear(on).is_err());
    [RecoloredAt]
    bounding_box => (!window.is_empty()).then(|| a.recolored_at(on, |target, _, _| target.bounding_box()));
    draw_iter => a.recolored_at(on, |target, a, flag| target.draw_iter(a.points.map(|at| Pixel(at, flag)))).is_err();
    fill_contiguous => {
        let flags = (0..a.bytes.len()).map(|i| BinaryColor::from(i % 3 == 0));
        a.recolored_at(on, |target, a, _| target.fill_contiguous(&a.rectangle(), flags)).is_err()
    };
    fill_solid => a.recolored_at(on, |target, a, flag| target.fill_solid(&a.rectangle(), flag)).is_err();
    [SurfaceTarget]
    bounding_box => (!window.is_empty()).then(|| eg::target(on).bounding_box());
    draw_iter => eg::target(on).draw_iter(a.points.map(|at| Pixel(at, a.alternate(at.x)))).is_err();
    fill_contiguous => eg::target(on).fill_contiguous(&a.rectangle(), a.stream()).is_err();
    fill_solid => eg::target(on).fill_solid(&a.rectangle(), c).is_err();
    [Recolored]
    bounding_box => (!window.is_empty()).then(|| a.recolored(on, |target, _, _| target.bounding_box()));
    draw_iter => a.recolored(on, |target, a, flag| target.draw_iter(a.points.map(|at| Pixel(at, flag)))).is_err();
    fill_contiguous => {
        let flags = (0..a.bytes.len()).map(|i| BinaryColor::from(i % 3 == 0));
        a.recolored(on, |target, a, _| target.fill_contiguous(&a.rectangle(), flags)).is_err()
    };
    fill_solid => a.recolored(on, |target, a, flag| target.fill_solid(&a.rectangle(), flag)).is_err();
    clear => a.recolored(on, |target, _, flag| target.clear(flag)).is_err();
}

calls! {
    /// Draws and reads by the call of a number below that of [`READING`], on a surface that can be read.
    READING, read[S: Readable<Color = L::Color>, L: Layout](on: &mut S, a)
    {
        let (c, window) = (a.colors[0], on.window());
    }
    [Canvas]
    move_area => on.move_area(a.areas[0], a.points[0]);
    move_area_keyed => on.move_area_keyed(a.areas[0], a.points[0], a.colors[1]);
    flood_fill => on.flood_fill(a.points[0], a.connectivity(), a.slots, c);
    flood_fill_to => on.flood_fill_to(a.points[0], a.colors[1], a.connectivity(), a.slots, c);
    [Pictures]
    blit_with => on.blit_with(a.points[0], &a.picture, |new, old| if new == c { old } else { new });
    [Readable]
    color_at => !window.is_empty() && on.color_at(window.x0, window.y0) == c;
    get => on.get(a.points[0]) == Some(c);
    read_span => a.span().clip(window).map_or(0, |span| {
        let mut same = 0_usize;
        on.read_span(span, |color| same = same.wrapping_add(usize::from(color == c)));
        same
    });
    edit_span => a.span().clip(window).map(|span| on.edit_span(span, |x, old| if old == c { a.alternate(x) } else { old }));
    mix_span => a.span().clip(window).map(|span| {
        on.mix_span(span, a.bytes, |old, level| if level & 1 == 0 { old } else { a.alternate(level.into()) });
    });
    mix_row => coverage::triangle(a.corners_fx(), &mut [], window, Mixed(on, c));
    find => a.span().clip(window).map_or(0, |span| on.find(span, |color| color == c));
    find_start => a.span().clip(window).map_or(0, |span| on.find_start(span, |color| color == c));
    // Counted from the row above the window: only what a surface without corridors says is 0.
    fill_corridor => {
        let row = on.fill_corridor(a.points[0], a.flag, c, |color| color == a.colors[1]);
        row.map(|row| row.wrapping_sub(window.y0).wrapping_add(1))
    };
    copy_area => on.copy_area(a.areas[0], a.points[0], None);
}

/// Paints rows as a whole, and of their rims what is covered by half or more.
struct Mixed<'a, S: Surface>(&'a mut S, S::Color);

impl<S: Readable> Sink for Mixed<'_, S> {
    fn span(&mut self, span: ClippedSpan) {
        self.0.fill_span(span, self.1);
    }

    fn soft_row(&mut self, row: SoftRow<'_>) {
        let color = self.1;
        self.0.mix_row(row, color, |old, level| if level < 128 { old } else { color });
    }
}

impl<L: Layout> Arguments<'_, L> {
    /// Does something on a surface of two colours: off and on are the two of the arguments. Gives the flag as a colour, too.
    fn recolored<S: Surface<Color = L::Color>, R>(
        &self,
        on: &mut S,
        act: impl FnOnce(&mut Flags<'_, '_, S>, &Self, BinaryColor) -> R,
    ) -> R {
        let [first, second] = self.colors;
        let convert: &dyn Fn(BinaryColor) -> S::Color = &|flag| if flag.is_on() { first } else { second };
        act(&mut eg::recolored(&mut eg::target(on), convert), self, self.flag.into())
    }

    /// The same by places: every other column has the colours exchanged.
    fn recolored_at<S: Surface<Color = L::Color>, R>(
        &self,
        on: &mut S,
        act: impl FnOnce(&mut FlagsAt<'_, '_, S>, &Self, BinaryColor) -> R,
    ) -> R {
        let [first, second] = self.colors;
        let convert: &dyn Fn(Point, BinaryColor) -> S::Color =
            &|at, flag| if flag.is_on() ^ (at.x & 1 == 0) { first } else { second };
        act(&mut eg::recolored_at(&mut eg::target(on), convert), self, self.flag.into())
    }

    /// As many colours as there are bytes.
    fn stream(&self) -> impl Iterator<Item = L::Color> {
        let [first, second] = self.colors;
        (0..self.bytes.len()).map(move |i| if i % 3 == 0 { first } else { second })
    }

    fn corners_fx(&self) -> [PointFx; 3] {
        let [a, b, c, _] = self.places;
        [a, b, c]
    }

    fn rule(&self) -> FillRule {
        if self.flag {
            FillRule::EvenOdd
        } else {
            FillRule::NonZero
        }
    }

    fn align(&self) -> Align {
        if self.flag {
            Align::Centred
        } else {
            Align::Outside
        }
    }

    fn connectivity(&self) -> Connectivity {
        if self.flag {
            Connectivity::Corners
        } else {
            Connectivity::Sides
        }
    }

    fn span(&self) -> Span {
        let Rect { x0, y0, x1, .. } = self.areas[0];
        Span { y: y0, x0, x1 }
    }

    /// The first box as embedded-graphics has it.
    fn rectangle(&self) -> Rectangle {
        Rectangle::from(self.areas[0])
    }

    fn alternate(&self, x: i32) -> L::Color {
        self.colors[usize::from(x & 1 != 0)]
    }
}

/// A surface of two colours.
type Flags<'a, 'b, S> =
    eg::Recolored<'a, eg::SurfaceTarget<'b, S>, BinaryColor, &'a dyn Fn(BinaryColor) -> <S as Surface>::Color>;

/// The same, by places.
type FlagsAt<'a, 'b, S> =
    eg::RecoloredAt<'a, eg::SurfaceTarget<'b, S>, BinaryColor, &'a dyn Fn(Point, BinaryColor) -> <S as Surface>::Color>;

/// The circle in a box, if it lies in the window as a whole: what its outline says.
fn octants(area: Rect, window: Rect) -> Option<embedded_raster::Octants> {
    struct Catch(Option<embedded_raster::Octants>);
    impl Sink for &mut Catch {
        fn span(&mut self, _: embedded_raster::ClippedSpan) {}
        fn octants(&mut self, octants: embedded_raster::Octants) -> bool {
            self.0 = Some(octants);
            true
        }
    }
    let mut catch = Catch(None);
    embedded_raster::raster::ellipse::outline(area, window, &mut catch);
    catch.0
}

/// A surface seen as a display driver of somebody else: pixel by pixel.
struct Foreign<'a, S>(&'a mut S);

impl<S: Surface> Dimensions for Foreign<'_, S> {
    fn bounding_box(&self) -> Rectangle {
        self.0.window().into()
    }
}

impl<S: Surface> DrawTarget for Foreign<'_, S> {
    type Color = S::Color;
    type Error = core::convert::Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<S::Color>>>(&mut self, pixels: I) -> Result<(), Self::Error> {
        pixels.into_iter().for_each(|Pixel(at, color)| self.0.set(at, color));
        Ok(())
    }
}
