//! The entries: all calls of the list, and what computes.

use core::{convert::Infallible, slice};

use calls::{call, Arguments};
use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray2, Rgb565, Rgb888},
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
    pixel::{Be, Lsb0},
    surface::{Pages, Rows},
    Angle, FillRule, Frame, Index1, Index4, Index8, Palette, Path, PathSegment, PixelFormat, PointFx, Rect,
};
#[cfg(not(target_os = "none"))]
use embedded_raster::{
    pixel::{Rgb444, Xrgb8888},
    surface::{Packed12, Planes},
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
    fn area(&self) -> Rect {
        let [x0, y0, x1, y1] = self.area;
        Rect { x0, y0, x1, y1 }
    }
}

fn vertex([x, y]: [i32; 2]) -> PointFx {
    PointFx::from_bits(x, y)
}

/// All calls of the list, by number, and what frames do besides.
macro_rules! layouts {
    ($($layout:ty, $color:ty: $draw:ident $read:ident;)*) => {$(
        #[no_mangle]
        pub unsafe extern "C" fn $draw(m: &Memory, a: &mut Arguments<'_, $layout>, number: usize) -> usize {
            let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
            let Ok(mut frame) = Frame::<_, $layout>::with_stride(bytes, m.width, m.height, m.stride) else { return 0 };
            call(&mut frame.clipped(m.area()), a, number)
        }
        #[no_mangle]
        pub unsafe extern "C" fn $read(m: &Memory, rows: [u16; 2], p: [i32; 2], size: [u32; 2]) -> usize {
            let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
            let Ok(mut band) = Frame::<_, $layout>::band(bytes, m.width, m.height, rows[0]..rows[1]) else { return 0 };
            let color = <$color>::unpack(m.color);
            band.clear(color);
            let mut view = band.view(m.area());
            let area = Rectangle::new(Point::new(p[0], p[1]), Size::new(size[0], size[1]));
            let all: Result<(), Infallible> = view
                .fill_solid(&area, color)
                .and_then(|()| view.fill_contiguous(&area, core::iter::repeat(color)))
                .and_then(|()| DrawTarget::clear(&mut view, color));
            let Ok(()) = all;
            view.colors(m.area()).filter(|&c| c == color).fold(0, |n, _| n ^ 1)
        }
    )*};
}

layouts! {
    Rows<Index4>, Index4: draw4 read4;
    Rows<Rgb565>, Rgb565: draw16 read16;
    Rows<Be<Rgb888>>, Rgb888: draw24 read24;
    Pages<Lsb0<BinaryColor>>, BinaryColor: draw_pages read_pages;
}

// One of each kind is enough for a chip: the linker has twice as much to do with all of them.
#[cfg(not(target_os = "none"))]
layouts! {
    Rows<Index1>, Index1: draw1 read1;
    Rows<Lsb0<Gray2>>, Gray2: draw2 read2;
    Rows<Index8>, Index8: draw8 read8;
    Rows<Xrgb8888>, Xrgb8888: draw32 read32;
    Planes<Gray2>, Gray2: draw_planes read_planes;
    Packed12, Rgb444: draw_packed12 read_packed12;
}

#[no_mangle]
pub unsafe extern "C" fn rows(m: &Memory, rows: [u16; 2]) -> usize {
    let bytes = slice::from_raw_parts(m.bytes, m.len);
    let Ok(frame) = Frame::<_, Rows<Index4>>::with_stride(bytes, m.width, m.height, m.stride) else { return 0 };
    let sum = frame.bytes(m.area()).map(<[u8]>::len).fold(0, usize::wrapping_add);
    sum.wrapping_add(frame.row_bytes(rows[0]..rows[1]).len())
}

#[no_mangle]
pub unsafe extern "C" fn pages(m: &Memory, pages: [u16; 2]) -> usize {
    let bytes = slice::from_raw_parts(m.bytes, m.len);
    let Ok(oled) = Frame::<_, Pages<BinaryColor>>::new(bytes, m.width, m.height) else { return 0 };
    oled.page_bytes(pages[0]..pages[1]).len()
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

#[no_mangle]
pub extern "C" fn space(a: &calls::space::Arguments, number: usize) -> u32 {
    calls::space::call(a, number)
}
