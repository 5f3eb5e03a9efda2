//! The calls, each with arguments that the optimiser cannot know.

use core::{convert::Infallible, slice};

use embedded_graphics_core::{
    geometry::{Point, Size},
    pixelcolor::{BinaryColor, Rgb565, Rgb888},
    prelude::DrawTarget,
    primitives::Rectangle,
};
use embedded_raster::{
    pixel::Be, raster::triangle, surface::Paged, Bitmap, Canvas, Edge, FillRule, Framebuffer, Index4, Index8, Palette,
    PixelFormat, Rect, Surface, Vertex,
};

/// Everything that a call is given. Vertices and edges have any bits in them.
#[repr(C)]
pub struct Arguments {
    bytes: *mut u8,
    len: usize,
    source: *const u8,
    source_len: usize,
    outline: *const Vertex,
    outline_len: usize,
    table: *mut Edge,
    table_len: usize,
    size: [u16; 2],
    rows: [u16; 2],
    stride: usize,
    area: [i32; 4],
    points: [Point; 2],
    corners: [Vertex; 3],
    color: u32,
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

    fn area(&self) -> Rect {
        let [x0, y0, x1, y1] = self.area;
        Rect { x0, y0, x1, y1 }
    }
}

unsafe fn shapes<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (frame, color) = (&mut a.frame::<F>()?, F::unpack(a.color));
    let (outline, table) =
        (slice::from_raw_parts(a.outline, a.outline_len), slice::from_raw_parts_mut(a.table, a.table_len));
    frame.clear(color);
    frame.draw_line(a.points[0], a.points[1], color);
    frame.fill_rectangle(a.corners[0], a.corners[1], color);
    frame.draw_point(a.corners[2], color);
    let view = &mut frame.view(a.area());
    view.fill_triangle(a.corners, color);
    triangle::walk(a.corners, view.window(), |span| view.fill_span(span, color));
    view.fill_polygon(outline, FillRule::NonZero, table, color).ok()?;
    view.fill_polygon(outline, FillRule::EvenOdd, table, color).ok()
}

unsafe fn pictures<F: PixelFormat>(a: &Arguments) -> Option<()> {
    let (frame, color, source) = (&mut a.frame::<F>()?, F::unpack(a.color), a.source::<F>()?.part(a.area()));
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
    ($($shapes:ident $pictures:ident $target:ident: $format:ty;)*) => {$(
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
    shapes4 pictures4 target4: Index4;
    shapes16 pictures16 target16: Rgb565;
    shapes24 pictures24 target24: Be<Rgb888>;
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
    part.fill_triangle(a.corners, BinaryColor::On);
    part.draw_line(a.points[0], a.points[1], BinaryColor::On);
    part.set(a.points[0], part.get(a.points[1]).unwrap_or(BinaryColor::On));
    oled.page_bytes(a.rows[0]..a.rows[1]).len()
}

#[no_mangle]
pub unsafe extern "C" fn expand(a: &Arguments, small: &Palette<Rgb565, 16>, large: &Palette<Rgb565, 256>) {
    let (from, to) = (slice::from_raw_parts(a.source, a.source_len), slice::from_raw_parts_mut(a.bytes, a.len));
    small.expand::<Index4, Be<Rgb565>>(from, to);
    large.expand::<Index8, Rgb565>(from, to);
}
