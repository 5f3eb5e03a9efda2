//! The calls.

use core::{convert::Infallible, slice};

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Gray2, Rgb565, Rgb888},
    prelude::DrawTarget,
    primitives::Rectangle,
};
use embedded_raster::{
    pixel::{Be, Lsb0, Xrgb8888},
    raster::triangle,
    surface::{Counter, Paged},
    Bitmap, Canvas, Edge, FillRule, Framebuffer, Index1, Index4, Index8, Palette, PixelFormat, Rect, Surface, Vertex,
};

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

fn vertex([x, y]: [i32; 2]) -> Vertex {
    Vertex::from_bits(x, y)
}

macro_rules! entry_points {
    ($($format:ty: $clear:ident $area:ident $line:ident $triangle:ident $polygon:ident $set:ident $blit:ident $mask:ident $move:ident $read:ident $target:ident;)*) => {$(
        #[no_mangle]
        pub unsafe extern "C" fn $clear(m: &Memory) -> bool {
            m.with::<$format>(|frame, color| frame.clear(color))
        }
        #[no_mangle]
        pub unsafe extern "C" fn $area(m: &Memory, a: [i32; 2], b: [i32; 2]) -> bool {
            m.with::<$format>(|frame, color| {
                frame.fill_rectangle(vertex(a), vertex(b), color);
                frame.draw_point(vertex(a), color);
            })
        }
        #[no_mangle]
        pub unsafe extern "C" fn $line(m: &Memory, a: [i32; 2], b: [i32; 2]) -> bool {
            m.with::<$format>(|frame, color| frame.draw_line(Point::new(a[0], a[1]), Point::new(b[0], b[1]), color))
        }
        #[no_mangle]
        pub unsafe extern "C" fn $triangle(m: &Memory, corners: [[i32; 2]; 3]) -> bool {
            m.with::<$format>(|frame, color| frame.fill_triangle(corners.map(vertex), color))
        }
        #[no_mangle]
        pub unsafe extern "C" fn $polygon(m: &Memory, v: *const Vertex, n: usize, e: *mut Edge, slots: usize, odd: bool) -> bool {
            let rule = if odd { FillRule::EvenOdd } else { FillRule::NonZero };
            let (outline, table) = (slice::from_raw_parts(v, n), slice::from_raw_parts_mut(e, slots));
            let mut fits = false;
            m.with::<$format>(|frame, color| fits = frame.fill_polygon(outline, rule, table, color).is_ok()) && fits
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
            let (source, at) = (source.part(s.area()), Point::new(at[0], at[1]));
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
                        frame.blit_mask(at, &mask.part(s.area()), color, off);
                    }
                } else if let Ok(mask) = Bitmap::<BinaryColor>::with_stride(bytes, s.width, s.height, s.stride) {
                    frame.blit_mask(at, &mask.part(s.area()), color, off);
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
    Index1: clear1 area1 line1 triangle1 polygon1 set1 blit1 mask1 move1 read1 target1;
    Lsb0<Gray2>: clear2 area2 line2 triangle2 polygon2 set2 blit2 mask2 move2 read2 target2;
    Index4: clear4 area4 line4 triangle4 polygon4 set4 blit4 mask4 move4 read4 target4;
    Index8: clear8 area8 line8 triangle8 polygon8 set8 blit8 mask8 move8 read8 target8;
    Rgb565: clear16 area16 line16 triangle16 polygon16 set16 blit16 mask16 move16 read16 target16;
    Be<Rgb888>: clear24 area24 line24 triangle24 polygon24 set24 blit24 mask24 move24 read24 target24;
    Xrgb8888: clear32 area32 line32 triangle32 polygon32 set32 blit32 mask32 move32 read32 target32;
}

#[no_mangle]
pub unsafe extern "C" fn band(m: &Memory, rows: [u16; 2], corners: [[i32; 2]; 3]) -> bool {
    let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
    let Ok(mut band) = Framebuffer::<Index4>::band(bytes, m.width, m.height, rows[0]..rows[1]) else { return false };
    band.view(m.area()).fill_triangle(corners.map(vertex), Index4::MAX);
    true
}

#[no_mangle]
pub unsafe extern "C" fn paged(m: &Memory, corners: [[i32; 2]; 3], at: [i32; 2], pages: [u16; 2]) -> usize {
    let bytes = slice::from_raw_parts_mut(m.bytes, m.len);
    let Ok(mut oled) = Paged::<BinaryColor>::new(bytes, m.width, m.height) else { return 0 };
    let (a, b) = (Point::new(at[0], at[1]), Point::new(at[1], at[0]));
    oled.clear(BinaryColor::Off);
    let mut part = oled.clipped(m.area());
    part.fill_triangle(corners.map(vertex), BinaryColor::On);
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
pub unsafe extern "C" fn expand1(p: &Palette<Rgb888, 2>, from: *const u8, n: usize, to: *mut u8, len: usize) {
    p.expand::<Index1, Rgb888>(slice::from_raw_parts(from, n), slice::from_raw_parts_mut(to, len));
}

#[no_mangle]
pub extern "C" fn palette(p: &mut Palette<Rgb888, 16>, range: [usize; 2], by: usize, index: u8, bits: u32) -> u8 {
    p.rotate(range[0]..range[1], by);
    p.set(index, Rgb888::unpack(bits));
    p.nearest(p.get(index).unwrap_or_default())
}
