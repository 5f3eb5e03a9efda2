//! The calls, each with arguments that the optimiser cannot know.

use core::{convert::Infallible, slice};

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray2, Rgb565, Rgb888, RgbColor},
    prelude::DrawTarget,
    primitives::Rectangle,
};
use embedded_raster::{
    geom::{
        clip::{self, Clipped},
        delaunay, exact, polygon,
        triangulate::{self, SideSlot},
        Viewport,
    },
    pixel::{Be, Lsb0},
    raster::{
        flood::{Connectivity, FloodSlot},
        triangle,
    },
    surface::Paged,
    Angle, Bitmap, Canvas, EdgeSlot, Ellipse, FillRule, Framebuffer, Index1, Index4, Index8, Palette, Path,
    PathSegment, PixelFormat, PointFx, Radii, Rect, Sector, Stroke, Surface,
};
use fixed::types::I24F8;

/// Everything that a call is given. Vertices and edges have any bits in them.
#[repr(C)]
pub struct Arguments {
    bytes: *mut u8,
    len: usize,
    source: *const u8,
    source_len: usize,
    outline: *const PointFx,
    outline_len: usize,
    table: *mut EdgeSlot,
    table_len: usize,
    size: [u16; 2],
    rows: [u16; 2],
    stride: usize,
    area: [i32; 4],
    points: [Point; 2],
    corners: [PointFx; 3],
    color: u32,
    radii: Radii,
    angles: [u32; 2],
    pending: *mut FloodSlot,
    pending_len: usize,
    path: *const PathSegment,
    path_len: usize,
    stroke: Stroke,
    lengths: *const I24F8,
    lengths_len: usize,
    phase: I24F8,
    flag: bool,
}

impl Arguments {
    unsafe fn frame<F: PixelFormat>(&self) -> Option<Framebuffer<'_, F>> {
        let bytes = slice::from_raw_parts_mut(self.bytes, self.len);
        Framebuffer::with_stride(bytes, self.size[0], self.size[1], self.stride).ok()
    }

    unsafe fn source<F: PixelFormat>(&self) -> Option<Bitmap<'_, F>> {
        let bytes = slice::from_raw_parts(self.source, self.source_len);
        Bitmap::with_stride(bytes, self.rows[0], self.rows[1], self.stride).ok()
    }

    unsafe fn outline(&self) -> &[PointFx] {
        slice::from_raw_parts(self.outline, self.outline_len)
    }

    /// Nobody else holds it meanwhile.
    #[allow(clippy::mut_from_ref)]
    unsafe fn table(&self) -> &mut [EdgeSlot] {
        slice::from_raw_parts_mut(self.table, self.table_len)
    }

    unsafe fn path(&self) -> Path<'_> {
        Path::new(slice::from_raw_parts(self.path, self.path_len))
    }

    fn area(&self) -> Rect {
        let [x0, y0, x1, y1] = self.area;
        Rect { x0, y0, x1, y1 }
    }
}

unsafe fn shapes<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (frame, color) = (&mut a.frame::<F>()?, F::unpack(a.color));
    let (outline, table) = (a.outline(), a.table());
    frame.clear(color);
    frame.draw_line(a.points[0], a.points[1], color);
    frame.fill_rectangle_fx(a.corners[0], a.corners[1], color);
    frame.draw_point_fx(a.corners[2], color);
    let view = &mut frame.view(a.area());
    view.fill_triangle_fx(a.corners, color);
    triangle::walk(a.corners, view.window(), |span| view.fill_span(span, color));
    view.fill_polygon_fx(outline, FillRule::NonZero, table, color).ok()?;
    view.fill_polygon_fx(outline, FillRule::EvenOdd, table, color).ok()
}

unsafe fn round<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (mut memory, color) = (a.frame::<F>()?, F::unpack(a.color));
    let frame = &mut memory.clipped(a.area());
    let [at, size, inner] = a.corners;
    let (ring, hole) = (Ellipse::new(at, size.x, size.y), Ellipse::splat(at, inner.x));
    let [start, end] = a.angles.map(Angle::from_bits);
    let sector = Sector::new(start, end);
    frame.fill_ellipse_fx(ring, color);
    frame.fill_ellipse_fx(Ellipse::in_box(a.area()), color);
    frame.draw_ellipse(a.area(), color);
    frame.fill_outlined_ellipse(a.area(), color);
    frame.fill_round_point_fx(at, size.x, color);
    frame.fill_square_point_fx(at, size.x, color);
    frame.fill_rounded(a.area(), a.radii, color);
    frame.draw_rounded(a.area(), a.radii, color);
    frame.draw_rectangle(a.area(), color);
    frame.draw_polygon(a.points, color);
    frame.draw_arc(a.area(), sector, color);
    frame.fill_sector_fx(ring, sector, color);
    frame.fill_ring_fx(ring, hole, color);
    frame.fill_ring_sector_fx(ring, hole, sector, color);
    let table = slice::from_raw_parts_mut(a.pending, a.pending_len);
    let reach = if a.flag { Connectivity::Corners } else { Connectivity::Sides };
    frame.flood_fill(a.points[0], reach, table, color);
    frame.flood_fill_to(a.points[1], F::unpack(a.rows[0].into()), reach, table, color);
    Some(())
}

unsafe fn paths<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (mut memory, color) = (a.frame::<F>()?, F::unpack(a.color));
    let frame = &mut memory.clipped(a.area());
    let (path, table) = (a.path(), a.table());
    let dashed = a.stroke.dashed(slice::from_raw_parts(a.lengths, a.lengths_len), a.phase);
    let [from, through, to] = a.corners;
    frame.draw_path_fx(path, color);
    frame.draw_quadratic_fx(a.corners, color);
    frame.draw_cubic_fx([from, through, through, to], color);
    frame.fill_path_fx(path, FillRule::EvenOdd, table, color).ok()?;
    frame.stroke_path_fx(path, &a.stroke, table, color).ok()?;
    frame.stroke_path_fx(path, &dashed, table, color).ok()?;
    frame.stroke_polyline_fx(a.outline(), a.flag, &a.stroke, table, color).ok()?;
    frame.stroke_line_fx([from, to], &dashed, table, color).ok()
}

unsafe fn masks<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (mut memory, color) = (a.frame::<F>()?, F::unpack(a.color));
    let frame = &mut memory.clipped(a.area());
    let bytes = slice::from_raw_parts(a.source, a.source_len);
    let off = a.flag.then(|| F::unpack(a.rows[0].into()));
    let mask = Bitmap::<Lsb0<Index1>>::with_stride(bytes, a.rows[0], a.rows[1], a.stride).ok()?;
    frame.blit_mask(a.points[0], &mask.clipped(a.area()), color, off);
    let mask = Bitmap::<BinaryColor>::with_stride(bytes, a.rows[0], a.rows[1], a.stride).ok()?;
    frame.blit_mask(a.points[1], &mask, color, off);
    Some(())
}

unsafe fn pictures<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (frame, color, source) = (&mut a.frame::<F>()?, F::unpack(a.color), a.source::<F>()?.clipped(a.area()));
    frame.blit(a.points[0], &source);
    frame.blit_keyed(a.points[1], &source, color);
    frame.move_area(a.area(), a.points[0]);
    frame.move_area_keyed(a.area(), a.points[1], color);
    frame.set(a.points[0], frame.get(a.points[1])?);
    Some(())
}

unsafe fn target<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (frame, color) = (&mut a.frame::<F>()?, F::unpack(a.color));
    let [width, height] = a.size.map(u32::from);
    let area = Rectangle::new(a.points[0], Size::new(width, height));
    let all: Result<(), Infallible> = frame
        .fill_solid(&area, color)
        .and_then(|()| frame.fill_contiguous(&area, core::iter::repeat(color)))
        .and_then(|()| DrawTarget::clear(frame, color));
    all.ok()
}

macro_rules! entry_points {
    ($($shapes:ident $round:ident $paths:ident $masks:ident $pictures:ident $target:ident: $format:ty;)*) => {$(
        #[no_mangle]
        pub unsafe extern "C" fn $round(a: &Arguments) -> bool {
            round::<$format>(a).is_some()
        }
        #[no_mangle]
        pub unsafe extern "C" fn $paths(a: &Arguments) -> bool {
            paths::<$format>(a).is_some()
        }
        #[no_mangle]
        pub unsafe extern "C" fn $masks(a: &Arguments) -> bool {
            masks::<$format>(a).is_some()
        }
        #[no_mangle]
        pub unsafe extern "C" fn $shapes(a: &Arguments) -> bool {
            shapes::<$format>(a).is_some()
        }
        #[no_mangle]
        pub unsafe extern "C" fn $pictures(a: &Arguments) -> bool {
            pictures::<$format>(a).is_some()
        }
        #[no_mangle]
        pub unsafe extern "C" fn $target(a: &Arguments) -> bool {
            target::<$format>(a).is_some()
        }
    )*};
}

entry_points! {
    shapes4 round4 paths4 masks4 pictures4 target4: Index4;
    shapes16 round16 paths16 masks16 pictures16 target16: Rgb565;
    shapes24 round24 paths24 masks24 pictures24 target24: Be<Rgb888>;
}

#[no_mangle]
pub unsafe extern "C" fn band(a: &Arguments) -> bool {
    let bytes = slice::from_raw_parts_mut(a.bytes, a.len);
    let Ok(mut band) = Framebuffer::<Index4>::band(bytes, a.size[0], a.size[1], a.rows[0]..a.rows[1]) else {
        return false;
    };
    band.fill_area(a.area(), Index4::MAX);
    !band.row_bytes(a.rows[0]..a.rows[1]).is_empty()
}

#[no_mangle]
pub unsafe extern "C" fn paged(a: &Arguments) -> usize {
    let bytes = slice::from_raw_parts_mut(a.bytes, a.len);
    let Ok(mut oled) = Paged::<BinaryColor>::new(bytes, a.size[0], a.size[1]) else { return 0 };
    oled.clear(BinaryColor::Off);
    let mut part = oled.clipped(a.area());
    part.fill_triangle_fx(a.corners, BinaryColor::On);
    part.draw_line(a.points[0], a.points[1], BinaryColor::On);
    part.set(a.points[0], part.get(a.points[1]).unwrap_or(BinaryColor::On));
    oled.page_bytes(a.rows[0]..a.rows[1]).len()
}

#[no_mangle]
pub unsafe extern "C" fn expand(a: &Arguments, small: &Palette<Rgb565, 16>, large: &Palette<Rgb565, 256>) {
    let (from, to) = (slice::from_raw_parts(a.source, a.source_len), slice::from_raw_parts_mut(a.bytes, a.len));
    small.expand::<Index4, Be<Rgb565>>(from, to);
    large.expand::<Index8, Rgb565>(from, to);
    large.map(|color| Gray2::new(color.r())).expand::<Index8, Gray2>(from, to);
}

#[no_mangle]
pub unsafe extern "C" fn palette(
    p: &mut Palette<Rgb888, 16>,
    range: [usize; 2],
    by: usize,
    index: u8,
    bits: u32,
) -> u8 {
    p.rotate(range[0]..range[1], by);
    p.set(index, Rgb888::unpack(bits));
    p.nearest(p.get(index).unwrap_or_default())
}

#[no_mangle]
pub unsafe extern "C" fn triangulate(
    a: &Arguments,
    starts: *const u16,
    further: usize,
    nodes: *mut SideSlot,
    slots: usize,
    triangles: *mut [u16; 3],
    most: usize,
) -> u32 {
    let (vertices, starts) = (a.outline(), slice::from_raw_parts(starts, further));
    let (nodes, triangles) = (slice::from_raw_parts_mut(nodes, slots), slice::from_raw_parts_mut(triangles, most));
    let mut sum = 0_u32;
    let each = triangulate::each(vertices, starts, nodes, |[a, ..]| sum = sum.wrapping_add(a.into()));
    match each.and_then(|()| triangulate::list(vertices, starts, nodes, triangles)) {
        Ok(_) => sum,
        Err(_) => !sum,
    }
}

#[no_mangle]
pub unsafe extern "C" fn refine(a: &Arguments, t: *mut [u16; 3], count: usize, s: *mut [u16; 3], slots: usize) -> u32 {
    let (triangles, neighbours) = (slice::from_raw_parts_mut(t, count), slice::from_raw_parts_mut(s, slots));
    delaunay::refine(a.outline(), triangles, neighbours).unwrap_or(0)
}

#[no_mangle]
pub unsafe extern "C" fn outlines(a: &Arguments, area: &mut i128) -> u8 {
    let outline = a.outline();
    *area = polygon::twice_area(outline);
    let inside = |rule: FillRule| polygon::contains([outline], rule, a.corners[0]);
    let inside = inside(FillRule::EvenOdd) | inside(FillRule::NonZero);
    polygon::is_convex(outline) as u8 | (inside as u8) << 1 | (polygon::orientation(outline).is_lt() as u8) << 2
}

#[no_mangle]
pub extern "C" fn signs(a: PointFx, b: PointFx, c: PointFx, d: PointFx, out: &mut Option<Clipped>) -> bool {
    *out = clip::segment(a, b, [c, d]);
    exact::turn(a, b, c).is_lt() ^ exact::in_circle(a, b, c, d).is_lt()
}

#[no_mangle]
pub extern "C" fn viewport(low: [i32; 2], high: [i32; 2], area: [i32; 4], at: [i32; 2], out: &mut PointFx) -> i32 {
    let [x0, y0, x1, y1] = area;
    let view = Viewport::from_bits(low, high, Rect { x0, y0, x1, y1 }).with_y_up();
    *out = view.bits_to_screen(at);
    let [x, y] = view.to_plane_bits(*out);
    x ^ y
}
