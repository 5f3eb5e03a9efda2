//! Every shape and every way to draw it, on one screen in any format of up to 16 bits.

use embedded_graphics::prelude::{Point, Size};
use embedded_raster::raster::triangle;
use embedded_raster::{
    buffer_bytes, Canvas, EdgeSlot, EdgeTableFull, Error, FillRule, Framebuffer, PixelFormat, PointFx, Rect, Surface,
};

use crate::{HEIGHT, WIDTH};

/// Draws the scene on `memory` from its first byte on.
///
/// # Errors
/// `memory` is shorter than the frame, or `table` than the ten sides of a star.
pub fn draw<F: PixelFormat>(memory: &mut [u8], table: &mut [EdgeSlot]) -> Result<(), Error> {
    let mut frame = Framebuffer::<F>::new(memory, WIDTH, HEIGHT)?;
    frame.clear(color::<F>(0));
    rectangles(&mut frame);
    triangles(&mut frame);
    stars(&mut frame, table)?;
    sprites(&mut frame)?;
    views(&mut frame);
    lines(&mut frame);
    Ok(())
}

/// One of many colours, and at one bit both of them.
fn color<F: PixelFormat>(n: u32) -> F::Color {
    F::unpack(n.wrapping_mul(0x9E37_79B1) >> (32 - F::BITS))
}

/// Of all widths, at all places within a byte or a word.
fn rectangles<F: PixelFormat>(frame: &mut Framebuffer<'_, F>) {
    for i in 0..40 {
        let a = PointFx::from_bits(i * 1_777, i * 331);
        let b = PointFx::from_bits(i * 1_777 + i * 257, i * 331 + 9_000);
        frame.fill_rectangle_fx(a, b, color::<F>(i as u32 + 3));
    }
}

/// A fan around a point between pixels: by the sides, and below it by edge functions.
fn triangles<F: PixelFormat>(frame: &mut Framebuffer<'_, F>) {
    let rim = rim(70 * 256);
    for i in 0..16 {
        let color = color::<F>(i as u32 + 50);
        let corners = |y| [(0, 0), rim[i], rim[(i + 1) % 16]].map(|(dx, dy)| PointFx::from_bits(20_333 + dx, y + dy));
        frame.fill_triangle_fx(corners(22_222), color);
        triangle::walk(corners(45_678), frame.window(), |span| frame.fill_span(span, color));
    }
}

/// The same crossing star by both rules, the second one partly off the screen.
fn stars<F: PixelFormat>(frame: &mut Framebuffer<'_, F>, table: &mut [EdgeSlot]) -> Result<(), EdgeTableFull> {
    let rim = rim(60 * 256);
    // Every fifth of sixteen: crosses itself many times.
    let star = |x: i32, y: i32| {
        core::array::from_fn::<_, 16, _>(|i| {
            let (dx, dy) = rim[i * 5 % 16];
            PointFx::from_bits(x + dx, y + dy)
        })
    };
    frame.fill_polygon_fx(&star(60_000, 20_100), FillRule::NonZero, table, color::<F>(70))?;
    frame.fill_polygon_fx(&star(72_000, 50_300), FillRule::EvenOdd, table, color::<F>(71))?;
    let (outer, hole) = (star(48_000, 40_000), star(48_256, 40_128).map(|v| PointFx::new(v.x, v.y / 2)));
    frame.fill_contours_fx([outer, hole], FillRule::EvenOdd, table, color::<F>(72))
}

/// A picture drawn in its own memory, set down with and without a key; then a part of the screen moved over itself.
fn sprites<F: PixelFormat>(frame: &mut Framebuffer<'_, F>) -> Result<(), Error> {
    const SIDE: u16 = 24;
    let mut memory = [0; buffer_bytes::<embedded_graphics::pixelcolor::Rgb565>(SIDE, SIDE)];
    let mut sprite = Framebuffer::<F>::new(&mut memory, SIDE, SIDE)?;
    sprite.clear(color::<F>(80));
    sprite.fill_triangle_fx([PointFx::px(12, 1), PointFx::px(23, 22), PointFx::px(1, 18)], color::<F>(82));
    sprite.draw_line(Point::new(0, 23), Point::new(23, 0), color::<F>(83));
    for i in 0..12 {
        frame.blit(Point::new(i * 29 - 5, 3 * i - 4), &sprite.as_bitmap());
        frame.blit_keyed(Point::new(i * 27 - 5, 214 - 2 * i), &sprite.as_bitmap(), color::<F>(80));
    }
    frame.move_area(Rect::new(13, 90, 150, 130), Point::new(16, 97));
    frame.move_area_keyed(Rect::new(201, 30, 290, 80), Point::new(198, 35), color::<F>(70));
    Ok(())
}

/// Shapes cut off by a view with its own origin, and by a clip without one.
fn views<F: PixelFormat>(frame: &mut Framebuffer<'_, F>) {
    let mut view = frame.view(Rect::new(131, 101, 187, 139));
    view.clear(color::<F>(90));
    let Size { width, height } = view.size();
    view.draw_line(Point::new(-9, 4), Point::new(width as i32 + 9, height as i32 - 4), color::<F>(91));
    view.fill_triangle_fx([PointFx::px(-20, 10), PointFx::px(30, -5), PointFx::px(80, 60)], color::<F>(92));
    let mut clipped = frame.clipped(Rect::new(7, 151, 66, 203));
    clipped.fill_rectangle_fx(PointFx::px(-100, 170), PointFx::px(40, 500), color::<F>(93));
    clipped.draw_polyline(rim(90 * 256).map(|(dx, dy)| Point::new(40 + dx / 256, 180 + dy / 256)), color::<F>(94));
}

/// In all directions, from within and from far outside; and single points.
fn lines<F: PixelFormat>(frame: &mut Framebuffer<'_, F>) {
    for (i, (dx, dy)) in rim(100 * 256).into_iter().enumerate() {
        let (near, far) = (Point::new(245 + dx / 2_000, 120 + dy / 2_000), Point::new(160 + dx / 90, 120 + dy / 40));
        frame.draw_line(near, far, color::<F>(i as u32 + 100));
        frame.draw_point_fx(PointFx::from_bits(40_960 + dx, 30_720 + dy), color::<F>(101));
        frame.set(Point::new(160 + dx / 300, 120 + dy / 300), color::<F>(102));
    }
    frame.draw_line(Point::new(-100_000, -71_234), Point::new(90_001, 65_432), color::<F>(103));
}

/// Sixteen points of a circle.
fn rim(radius: i32) -> [(i32, i32); 16] {
    // cos(i * 22.5 degrees) * 256
    const COSINE: [i32; 16] = [256, 237, 181, 98, 0, -98, -181, -237, -256, -237, -181, -98, 0, 98, 181, 237];
    core::array::from_fn(|i| (radius * COSINE[i] / 256, radius * COSINE[(i + 12) % 16] / 256))
}
