//! The calls.

use core::{convert::Infallible, slice};

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray2, Gray8, Rgb565, Rgb888},
    prelude::DrawTarget,
    primitives::Rectangle,
};
use embedded_raster::{
    geom::{
        clip::{self, Clipped},
        delaunay, exact,
        polygon::{self, Crossing},
        triangulate::{self, SideSlot},
        Outlines, Viewport,
    },
    pixel::{Be, Lsb0, Rgb444, Xrgb8888},
    raster::{
        flood::{Connectivity, FloodSlot},
        triangle,
    },
    surface::{Counter, Packed12, Paged, Pages, Planes, Rows},
    Angle, Bitmap, Canvas, EdgeSlot, Ellipse, FillRule, Frame, Framebuffer, Index1, Index4, Index8, Palette, Path,
    PathSegment, PixelFormat, PointFx, Radii, Readable, Rect, Sector, Span, Stroke, Surface,
};
use fixed::types::{I16F16, I24F8};

/// A framebuffer as a driver hands it over.
#[repr(C)]
pub struct Memory {
    bytes: *mut u8,
    len: usize,
    width: u16,
    height: u16,
    stride: usize,
    /// A window in it.
    area: [i32; 4],
    color: u32,
}

impl Memory {
    unsafe fn with<F: PixelFormat>(&self, draw: impl FnOnce(&mut Framebuffer<'_, F>, F::Color)) -> bool {
        let bytes = slice::from_raw_parts_mut(self.bytes, self.len);
        match Framebuffer::with_stride(bytes, self.width, self.height, self.stride) {
            Ok(mut frame) => {
                draw(&mut frame.clipped(self.area()), F::unpack(self.color));
                true
            }
            Err(_) => false,
        }
    }

    fn area(&self) -> Rect {
        let [x0, y0, x1, y1] = self.area;
        Rect { x0, y0, x1, y1 }
    }
}

fn vertex([x, y]: [i32; 2]) -> PointFx {
    PointFx::from_bits(x, y)
}

macro_rules! entry_points {
    ($($format:ty: $round:ident $flood:ident $clear:ident $area:ident $line:ident $triangle:ident $polygon:ident $set:ident $blit:ident $mask:ident $move:ident $read:ident $target:ident;)*) => {$(
        #[no_mangle]
        pub unsafe extern "C" fn $round(m: &Memory, v: [[i32; 2]; 3], radii: &Radii, angles: [u32; 2]) -> bool {
            let [at, size, inner] = v.map(vertex);
            let (ring, hole) = (Ellipse::new(at, size.x, size.y), Ellipse::splat(at, inner.x));
            let sector = Sector::new(Angle::from_bits(angles[0]), Angle::from_bits(angles[1]));
            let area = Rect { x0: v[0][0], y0: v[0][1], x1: v[1][0], y1: v[1][1] };
            m.with::<$format>(|frame, color| {
                frame.fill_ellipse_fx(ring, color);
                frame.fill_ellipse_fx(Ellipse::in_box(area), color);
                frame.draw_ellipse(area, color);
                frame.fill_outlined_ellipse(area, color);
                frame.fill_square_point_fx(at, size.x, color);
                frame.fill_rounded(area, *radii, color);
                frame.draw_rounded(area, *radii, color);
                frame.draw_rectangle(area, color);
                frame.draw_arc(area, sector, color);
                frame.fill_ring_sector_fx(ring, hole, sector, color);
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $flood(m: &Memory, at: [i32; 2], p: *mut FloodSlot, slots: usize, border: u32, corners: bool) -> bool {
            let (at, table) = (Point::new(at[0], at[1]), slice::from_raw_parts_mut(p, slots));
            let reach = if corners { Connectivity::Corners } else { Connectivity::Sides };
            m.with::<$format>(|frame, color| {
                frame.flood_fill(at, reach, table, color);
                frame.flood_fill_to(at, <$format>::unpack(border), reach, table, color);
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $clear(m: &Memory) -> bool {
            m.with::<$format>(|frame, color| frame.clear(color))
        }
        #[no_mangle]
        pub unsafe extern "C" fn $area(m: &Memory, a: [i32; 2], b: [i32; 2]) -> bool {
            m.with::<$format>(|frame, color| {
                frame.fill_rectangle_fx(vertex(a), vertex(b), color);
                frame.draw_point_fx(vertex(a), color);
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $line(m: &Memory, a: [i32; 2], b: [i32; 2]) -> bool {
            m.with::<$format>(|frame, color| {
                let (a, b) = (Point::new(a[0], a[1]), Point::new(b[0], b[1]));
                frame.draw_line(a, b, color);
                frame.draw_polygon([a, b, Point::new(a.x, b.y)], color);
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $triangle(m: &Memory, corners: [[i32; 2]; 3]) -> bool {
            m.with::<$format>(|frame, color| frame.fill_triangle_fx(corners.map(vertex), color))
        }
        #[no_mangle]
        pub unsafe extern "C" fn $polygon(m: &Memory, v: *const PointFx, n: usize, e: *mut EdgeSlot, slots: usize, odd: bool) -> bool {
            let rule = if odd { FillRule::EvenOdd } else { FillRule::NonZero };
            let (outline, table) = (slice::from_raw_parts(v, n), slice::from_raw_parts_mut(e, slots));
            let mut fits = false;
            m.with::<$format>(|frame, color| fits = frame.fill_polygon_fx(outline, rule, table, color).is_ok()) && fits
        }
        #[no_mangle]
        pub unsafe extern "C" fn $set(m: &Memory, at: [i32; 2]) -> u32 {
            let (mut bits, at) = (0, Point::new(at[0], at[1]));
            m.with::<$format>(|frame, color| {
                bits = frame.get(at).map_or(0, |c| <$format>::pack(c));
                frame.set(at, color);
            });
            bits
        }
        #[no_mangle]
        pub unsafe extern "C" fn $blit(m: &Memory, s: &Memory, at: [i32; 2], keyed: bool) -> bool {
            let bytes = slice::from_raw_parts(s.bytes, s.len);
            let Ok(source) = Bitmap::<$format>::with_stride(bytes, s.width, s.height, s.stride) else { return false };
            let (source, at) = (source.clipped(s.area()), Point::new(at[0], at[1]));
            m.with::<$format>(|frame, color| match keyed {
                true => frame.blit_keyed(at, &source, color),
                false => frame.blit(at, &source),
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $mask(m: &Memory, s: &Memory, at: [i32; 2], opaque: bool, lsb0: bool) -> bool {
            let (bytes, at) = (slice::from_raw_parts(s.bytes, s.len), Point::new(at[0], at[1]));
            m.with::<$format>(|frame, color| {
                let off = opaque.then(|| <$format>::unpack(s.color));
                if lsb0 {
                    if let Ok(mask) = Bitmap::<Lsb0<Index1>>::with_stride(bytes, s.width, s.height, s.stride) {
                        frame.blit_mask(at, &mask.clipped(s.area()), color, off);
                    }
                } else if let Ok(mask) = Bitmap::<BinaryColor>::with_stride(bytes, s.width, s.height, s.stride) {
                    frame.blit_mask(at, &mask.clipped(s.area()), color, off);
                }
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $move(m: &Memory, at: [i32; 2], keyed: bool) -> bool {
            let at = Point::new(at[0], at[1]);
            m.with::<$format>(|frame, color| match keyed {
                true => frame.move_area_keyed(m.area(), at, color),
                false => frame.move_area(m.area(), at),
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $read(m: &Memory, rows: [u16; 2]) -> usize {
            let mut sum = 0;
            m.with::<$format>(|frame, _| {
                sum = frame.bytes(m.area()).map(<[u8]>::len).fold(0, usize::wrapping_add);
                sum = sum.wrapping_add(frame.row_bytes(rows[0]..rows[1]).len());
                sum = sum.wrapping_add(frame.colors(m.area()).fold(0, |n, _| n ^ 1));
            });
            sum
        }
        #[no_mangle]
        pub unsafe extern "C" fn $target(m: &Memory, p: [i32; 2], size: [u32; 2]) -> bool {
            let area = Rectangle::new(Point::new(p[0], p[1]), Size::new(size[0], size[1]));
            m.with::<$format>(|frame, color| {
                let all: Result<(), Infallible> = frame
                    .fill_solid(&area, color)
                    .and_then(|()| frame.fill_contiguous(&area, core::iter::repeat(color)))
                    .and_then(|()| DrawTarget::clear(frame, color));
                let Ok(()) = all;
            })
        }
    )*};
}

entry_points! {
    Index1: round1 flood1 clear1 area1 line1 triangle1 polygon1 set1 blit1 mask1 move1 read1 target1;
    Lsb0<Gray2>: round2 flood2 clear2 area2 line2 triangle2 polygon2 set2 blit2 mask2 move2 read2 target2;
    Index4: round4 flood4 clear4 area4 line4 triangle4 polygon4 set4 blit4 mask4 move4 read4 target4;
    Index8: round8 flood8 clear8 area8 line8 triangle8 polygon8 set8 blit8 mask8 move8 read8 target8;
    Rgb565: round16 flood16 clear16 area16 line16 triangle16 polygon16 set16 blit16 mask16 move16 read16 target16;
    Be<Rgb888>: round24 flood24 clear24 area24 line24 triangle24 polygon24 set24 blit24 mask24 move24 read24 target24;
    Xrgb8888: round32 flood32 clear32 area32 line32 triangle32 polygon32 set32 blit32 mask32 move32 read32 target32;
}

/// What every layout does, by its own ways and by the naive ones.
macro_rules! layouts {
    ($($name:ident: $layout:ty, $color:ty;)*) => {$(
        #[no_mangle]
        pub unsafe extern "C" fn $name(m: &Memory, s: &Memory, v: &[[i32; 2]; 3], rows: [u16; 2], slots: &mut [FloodSlot; 4]) -> bool {
            let (bytes, source) = (slice::from_raw_parts_mut(m.bytes, m.len), slice::from_raw_parts(s.bytes, s.len));
            let Ok(mut band) = Frame::<_, $layout>::band(bytes, m.width, m.height, rows[0]..rows[1]) else { return false };
            band.clear(<$color>::unpack(m.color));
            let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
            let Ok(mut whole) = Frame::<_, $layout>::with_stride(bytes, m.width, m.height, m.stride) else { return false };
            let Ok(source) = Frame::<_, $layout>::with_stride(source, s.width, s.height, s.stride) else { return false };
            let (color, at) = (<$color>::unpack(m.color), Point::new(v[0][0], v[0][1]));
            let mut view = whole.view(m.area());
            view.fill_area(s.area(), color);
            view.draw_line(at, Point::new(v[1][0], v[1][1]), color);
            view.draw_ellipse(s.area(), color);
            view.fill_triangle_fx((*v).map(vertex), color);
            view.set(at, color);
            view.blit(at, &source.clipped(s.area()));
            view.blit_keyed(at, &source, color);
            view.move_area(s.area(), at);
            view.move_area_keyed(s.area(), at, color);
            view.flood_fill(at, Connectivity::Corners, slots, color);
            if let Ok(mask) = Bitmap::<Index1>::new(slice::from_raw_parts(s.bytes, s.len), s.width, s.height) {
                view.blit_mask(at, &mask, color, None);
            }
            if let Some(span) = (Span { y: v[2][1], x0: v[2][0], x1: v[1][0] }).clip(view.window()) {
                view.write_span(span, |_| color);
                view.write_some(span, |x| (x & 1 == 0).then_some(color));
                view.edit_span(span, |x, old| if x & 1 == 0 { color } else { old });
                let mut sum = 0_u32;
                view.read_span(span, |c| sum ^= <$color>::pack(c));
                return sum == 0;
            }
            view.get(at).is_some()
        }
    )*};
}

layouts! {
    layout_pages: Pages<Index1>, Index1;
    layout_pages_lsb0: Pages<Lsb0<BinaryColor>>, BinaryColor;
    layout_planes: Planes<Gray2>, Gray2;
    layout_packed12: Packed12, Rgb444;
    layout_rows2: Rows<Gray2>, Gray2;
    layout_rows16: Rows<Rgb565>, Rgb565;
    layout_rows24: Rows<Be<Rgb888>>, Rgb888;
}

#[no_mangle]
pub unsafe extern "C" fn path_fill(
    m: &Memory,
    p: *const PathSegment,
    n: usize,
    e: *mut EdgeSlot,
    slots: usize,
) -> bool {
    let (path, table) = (Path::new(slice::from_raw_parts(p, n)), slice::from_raw_parts_mut(e, slots));
    let mut fits = false;
    m.with::<Rgb565>(|frame, color| {
        fits = frame.fill_path_fx(path, FillRule::NonZero, table, color).is_ok();
        frame.draw_path_fx(path, color);
    }) && fits
}

#[no_mangle]
pub unsafe extern "C" fn path_stroke(
    m: &Memory,
    p: *const PathSegment,
    n: usize,
    e: *mut EdgeSlot,
    slots: usize,
    stroke: &Stroke,
    lengths: *const I24F8,
    count: usize,
    phase: i32,
) -> bool {
    let (path, table) = (Path::new(slice::from_raw_parts(p, n)), slice::from_raw_parts_mut(e, slots));
    let dashed = stroke.dashed(slice::from_raw_parts(lengths, count), I24F8::from_bits(phase));
    let mut fits = false;
    m.with::<Index4>(|frame, color| {
        fits = frame.stroke_path_fx(path, stroke, table, color).is_ok();
        fits &= frame.stroke_path_fx(path, &dashed, table, color).is_ok();
    }) && fits
}

#[no_mangle]
pub unsafe extern "C" fn line_stroke(
    m: &Memory,
    v: *const PointFx,
    n: usize,
    e: *mut EdgeSlot,
    slots: usize,
    stroke: &Stroke,
) -> bool {
    let (places, table) = (slice::from_raw_parts(v, n), slice::from_raw_parts_mut(e, slots));
    let mut fits = false;
    m.with::<Gray8>(|frame, color| {
        fits = frame.stroke_polyline_fx(places, slots > 9, stroke, table, color).is_ok();
    }) && fits
}

#[no_mangle]
pub unsafe extern "C" fn band(m: &Memory, rows: [u16; 2], corners: [[i32; 2]; 3]) -> bool {
    let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
    let Ok(mut band) = Framebuffer::<Index4>::band(bytes, m.width, m.height, rows[0]..rows[1]) else { return false };
    band.view(m.area()).fill_triangle_fx(corners.map(vertex), Index4::MAX);
    true
}

#[no_mangle]
pub unsafe extern "C" fn paged(m: &Memory, corners: [[i32; 2]; 3], at: [i32; 2], pages: [u16; 2]) -> usize {
    let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
    let Ok(mut oled) = Paged::<BinaryColor>::new(bytes, m.width, m.height) else { return 0 };
    let (a, b) = (Point::new(at[0], at[1]), Point::new(at[1], at[0]));
    oled.clear(BinaryColor::Off);
    let mut part = oled.clipped(m.area());
    part.fill_triangle_fx(corners.map(vertex), BinaryColor::On);
    part.draw_line(a, b, BinaryColor::On);
    part.fill_area(m.area(), BinaryColor::On);
    part.set(a, part.get(b).unwrap_or(BinaryColor::On));
    oled.page_bytes(pages[0]..pages[1]).len()
}

#[no_mangle]
pub extern "C" fn walk(corners: [[i32; 2]; 3], area: [i32; 4]) -> u64 {
    let [x0, y0, x1, y1] = area;
    let mut counter = Counter::<BinaryColor>::new(Rect { x0, y0, x1, y1 });
    triangle::walk(corners.map(vertex), counter.window(), |span| counter.fill_span(span, BinaryColor::On));
    counter.pixels
}

#[no_mangle]
pub unsafe extern "C" fn expand4(p: &Palette<Rgb565, 16>, from: *const u8, n: usize, to: *mut u8, len: usize) {
    p.expand::<Index4, Be<Rgb565>>(slice::from_raw_parts(from, n), slice::from_raw_parts_mut(to, len));
}

#[no_mangle]
pub unsafe extern "C" fn expand8(p: &Palette<Rgb565, 256>, from: *const u8, n: usize, to: *mut u8, len: usize) {
    p.expand::<Index8, Rgb565>(slice::from_raw_parts(from, n), slice::from_raw_parts_mut(to, len));
}

#[no_mangle]
pub unsafe extern "C" fn expand2(p: &Palette<Gray2, 256>, from: *const u8, n: usize, to: *mut u8, len: usize) {
    p.expand::<Index8, Gray2>(slice::from_raw_parts(from, n), slice::from_raw_parts_mut(to, len));
}

#[no_mangle]
pub unsafe extern "C" fn expand1(p: &Palette<Rgb888, 2>, from: *const u8, n: usize, to: *mut u8, len: usize) {
    p.expand::<Index1, Rgb888>(slice::from_raw_parts(from, n), slice::from_raw_parts_mut(to, len));
}

#[no_mangle]
pub extern "C" fn palette(p: &mut Palette<Rgb888, 16>, range: [usize; 2], by: usize, index: u8, bits: u32) -> u8 {
    p.rotate(range[0]..range[1], by);
    p.set(index, Rgb888::unpack(bits));
    p.nearest(p.get(index).unwrap_or_default())
}

#[no_mangle]
pub unsafe extern "C" fn triangulate(
    v: *const PointFx,
    n: usize,
    s: *const u16,
    further: usize,
    nodes: *mut SideSlot,
    slots: usize,
    t: *mut [u16; 3],
    most: usize,
) -> usize {
    let (vertices, starts) = (slice::from_raw_parts(v, n), slice::from_raw_parts(s, further));
    let (nodes, triangles) = (slice::from_raw_parts_mut(nodes, slots), slice::from_raw_parts_mut(t, most));
    let mut sum = 0_usize;
    let each = triangulate::each(vertices, starts, nodes, |[a, ..]| sum = sum.wrapping_add(a.into()));
    let some = triangulate::to_vec::<40>(vertices, starts, nodes).map_or(0, |triangles| triangles.len());
    match each.and_then(|()| triangulate::list(vertices, starts, nodes, triangles)) {
        Ok(count) => count,
        Err(_) => sum.wrapping_add(some),
    }
}

#[no_mangle]
pub unsafe extern "C" fn outlines(p: *const PathSegment, n: usize, out: &mut Outlines<200, 3>) -> usize {
    let Ok(outlines) = Path::new(slice::from_raw_parts(p, n)).outlines() else { return 0 };
    *out = outlines;
    out.contours().fold(0, |sum, contour| sum ^ contour.len())
}

#[no_mangle]
pub unsafe extern "C" fn crossings(v: *const PointFx, n: usize, y: i32, out: &mut heapless::Vec<Crossing, 9>) -> bool {
    let Ok(crossings) = polygon::crossings([slice::from_raw_parts(v, n)], I24F8::from_bits(y)) else { return false };
    *out = crossings;
    true
}

#[no_mangle]
pub extern "C" fn places(a: [i32; 2], b: [i32; 2], factor: i32, out: &mut PointFx) {
    let (a, b) = (vertex(a), vertex(b));
    *out = -(a + b - a * I24F8::from_bits(factor));
    *out += PointFx::from(Point::new(factor, 0));
    *out -= b;
}

#[no_mangle]
pub extern "C" fn angles(bits: u32, degrees: i32, times: i32) -> u32 {
    let (mut a, b) = (Angle::from_bits(bits), Angle::degrees_fx(I16F16::from_bits(degrees)));
    a += b * times;
    a -= Angle::degrees(degrees) + Angle::turns(bits, 365);
    (-a).to_degrees().to_bits() as u32
}

#[no_mangle]
pub extern "C" fn rectangles(a: [i32; 4], b: [i32; 4], n: i32, out: &mut [Rect; 4]) {
    let rect = |[x0, y0, x1, y1]: [i32; 4]| Rect { x0, y0, x1, y1 };
    let (a, b) = (rect(a), rect(b));
    let around = Rect::from_center(b.top_left(), a.size());
    *out = [a.union(b), a.intersection(b), a.translate(n, b.x0).inset(n), around];
}

#[no_mangle]
pub unsafe extern "C" fn refine(
    v: *const PointFx,
    n: usize,
    t: *mut [u16; 3],
    count: usize,
    s: *mut [u16; 3],
    slots: usize,
) -> u32 {
    let (triangles, neighbours) = (slice::from_raw_parts_mut(t, count), slice::from_raw_parts_mut(s, slots));
    delaunay::refine(slice::from_raw_parts(v, n), triangles, neighbours).unwrap_or(0)
}

#[no_mangle]
pub unsafe extern "C" fn outline(v: *const PointFx, n: usize, at: [i32; 2], area: &mut i128) -> u8 {
    let outline = slice::from_raw_parts(v, n);
    *area = polygon::twice_area(outline);
    let inside = polygon::contains([outline], FillRule::EvenOdd, vertex(at));
    let inside = inside | polygon::contains([outline], FillRule::NonZero, vertex(at));
    polygon::is_convex(outline) as u8 | (inside as u8) << 1 | (polygon::orientation(outline).is_lt() as u8) << 2
}

#[no_mangle]
pub extern "C" fn signs(p: [[i32; 2]; 4]) -> bool {
    let [a, b, c, d] = p.map(vertex);
    exact::turn(a, b, c).is_lt() ^ exact::in_circle(a, b, c, d).is_lt()
}

#[no_mangle]
pub extern "C" fn clip_segment(p: [[i32; 2]; 4], out: &mut Option<Clipped>) {
    let [a, b, c, d] = p.map(vertex);
    *out = clip::segment(a, b, [c, d]);
}

#[no_mangle]
pub extern "C" fn viewport(low: [i32; 2], high: [i32; 2], area: [i32; 4], at: [i32; 2], out: &mut PointFx) -> i32 {
    let [x0, y0, x1, y1] = area;
    let view = Viewport::from_bits(low, high, Rect { x0, y0, x1, y1 }).with_y_up();
    *out = view.bits_to_screen(at);
    let [x, y] = view.to_plane_bits(vertex(at));
    x ^ y
}
