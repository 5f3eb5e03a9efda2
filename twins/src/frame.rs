//! [`Kind`] and [`Frame`]: the crate's framebuffers behind plain functions whose colours are bits.
//!
//! Laws are written once, for `&dyn Kind`, and compiled once; what is compiled for each format is the crate.

use std::{marker::PhantomData, ops::Range};

use embedded_graphics_core::{
    draw_target::DrawTarget,
    geometry::{Point, Size},
    image::GetPixel,
    primitives::Rectangle,
    Pixel,
};
use embedded_raster::{
    buffer_bytes,
    pixel::{row_bytes, Lsb0},
    Bitmap, BufferError, Canvas, EdgeSlot, Ellipse, FillRule, Framebuffer, Index1, PixelFormat, Rect, Span, Surface,
};

use super::{
    corners,
    memory::{Format, Naive},
    rng::Rng,
    runs_where,
    scenes::{ends_of_line, outline, Scale},
    shapes, vertices, Units,
};

/// A shape to draw on any surface.
#[derive(Debug)]
pub enum Shape {
    /// From pixel to pixel.
    Line((i32, i32), (i32, i32)),
    /// Filled.
    Triangle([Units; 3]),
    /// One contour, even-odd.
    Polygon(Vec<Units>),
    /// Filled, from the first place to the second.
    Rectangle([Units; 3]),
    /// A filled ellipse in a box.
    Disc(Rect),
    /// The outline of an ellipse in a box.
    Circle(Rect),
    /// The outline of a box.
    Outline(Rect),
}

impl Shape {
    /// For a window of about 45 x 33 pixels, most of them seen.
    pub fn random(rng: &mut Rng) -> Self {
        let scale = rng.pick(&Scale::ALL);
        let place = |rng: &mut Rng| (rng.int(-2_000, 14_000), rng.int(-1_500, 10_000));
        match rng.below(11) {
            0 => {
                let [a, b] = ends_of_line(rng, scale);
                Self::Line(a, b)
            }
            1 | 2 => {
                let end = |rng: &mut Rng| (rng.int(-4, 50), rng.int(-4, 40));
                let (a, b) = (end(rng), end(rng));
                match rng.below(4) {
                    0 => Self::Line(a, (b.0, a.1)),
                    1 => Self::Line(a, (a.0, b.1)),
                    _ => Self::Line(a, b),
                }
            }
            3 => Self::Triangle([place(rng), place(rng), place(rng)]),
            4 => {
                let far = outline(rng, scale, 3);
                Self::Triangle([place(rng), far[0], far[1]])
            }
            5 => Self::Rectangle([place(rng), place(rng), place(rng)]),
            9 | 10 => {
                let (x, y) = (rng.int(-9, 40), rng.int(-9, 30));
                let (width, height) = (rng.int(0, 33), rng.int(0, 33));
                // Most of them round, and many of those wholly inside.
                let height = if rng.below(4) == 0 { height } else { width };
                let area = Rect::new(x, y, x + width, y + height);
                if rng.below(2) == 0 {
                    Self::Disc(area)
                } else {
                    Self::Circle(area)
                }
            }
            6 => {
                let mut end = || (rng.int(-4, 50), rng.int(-4, 40));
                let (a, b) = (end(), end());
                Self::Outline(Rect { x0: a.0, y0: a.1, x1: b.0, y1: b.1 })
            }
            _ => Self::Polygon((0..rng.range(3, 9)).map(|_| place(rng)).collect()),
        }
    }

    /// By the crate.
    pub fn draw<S: Surface>(&self, surface: &mut S, color: S::Color) {
        match self {
            Self::Line(a, b) => surface.draw_line(Point::new(a.0, a.1), Point::new(b.0, b.1), color),
            Self::Triangle(units) => surface.fill_triangle_fx(corners(*units), color),
            Self::Polygon(units) => {
                let mut table = [EdgeSlot::EMPTY; 16];
                surface.fill_polygon_fx(&vertices(units), FillRule::EvenOdd, &mut table, color).expect("enough slots");
            }
            Self::Rectangle(units) => {
                let [a, b, _] = corners(*units);
                surface.fill_rectangle_fx(a, b, color);
            }
            Self::Disc(area) => surface.fill_ellipse_fx(Ellipse::in_box(*area), color),
            Self::Circle(area) => surface.draw_ellipse(*area, color),
            Self::Outline(area) => surface.draw_rectangle(*area, color),
        }
    }

    /// Its pixels, by the naive twins.
    pub fn pixels(&self, window: Rect) -> Vec<(i32, i32)> {
        let runs = match self {
            Self::Line(a, b) => return shapes::line(*a, *b, window),
            Self::Triangle(units) => shapes::triangle(*units, window),
            Self::Polygon(units) => shapes::polygon(std::slice::from_ref(units), FillRule::EvenOdd, window),
            Self::Rectangle([a, b, _]) => shapes::rectangle(*a, *b, window),
            Self::Disc(area) => runs_where(window, |x, y| shapes::box_ellipse_has(*area, x, y)),
            Self::Circle(area) => runs_where(window, |x, y| shapes::outline_has(*area, x, y)),
            Self::Outline(area) => runs_where(window, |x, y| shapes::rectangle_outline_has(*area, x, y)),
        };
        runs.into_iter().flat_map(|(y, x0, x1)| (x0..x1).map(move |x| (x, y))).collect()
    }
}

/// A pixel format of the crate.
#[allow(missing_docs, reason = "each is called as what it stands for")]
pub trait Kind {
    fn format(&self) -> Format;
    fn bytes(&self, width: u16, height: u16) -> (usize, usize);
    /// The surface that `twin` is the twin of, in other bytes.
    fn open<'a>(&self, twin: &Naive, bytes: &'a mut [u8]) -> Box<dyn Frame + 'a>;
    fn packed<'a>(&self, memory: &'a mut [u8], width: u16, height: u16) -> Result<Box<dyn Frame + 'a>, BufferError>;
    fn strided(&self, memory: &mut [u8], width: u16, height: u16, stride: usize) -> Result<(), BufferError>;
    fn band<'a>(
        &self,
        memory: &'a mut [u8],
        size: (u16, u16),
        rows: Range<u16>,
    ) -> Result<Box<dyn Frame + 'a>, BufferError>;
    fn packed_bitmap(&self, memory: &[u8], width: u16, height: u16) -> Result<(), BufferError>;
    fn strided_bitmap(&self, memory: &[u8], width: u16, height: u16, stride: usize) -> Result<(), BufferError>;
    /// The bytes of some pixels of a bitmap in the memory of `twin`.
    fn bitmap_bytes(&self, twin: &Naive, area: Rect) -> Vec<Vec<u8>>;
}

/// What a framebuffer does.
#[allow(missing_docs, reason = "each is called as what it stands for")]
pub trait Frame {
    fn window(&self) -> Rect;
    fn size(&self) -> Size;
    fn stride(&self) -> usize;
    fn view<'a>(&'a mut self, area: Rect) -> Box<dyn Frame + 'a>;
    fn clipped<'a>(&'a mut self, area: Rect) -> Box<dyn Frame + 'a>;

    fn fill_span(&mut self, span: Span, color: u32);
    fn fill_area(&mut self, area: Rect, color: u32);
    fn clear(&mut self, color: u32);
    fn fill_window(&mut self, color: u32);
    fn set(&mut self, p: Point, color: u32);
    fn draw(&mut self, shape: &Shape, color: u32);

    fn get(&self, p: Point) -> Option<u32>;
    fn colors(&self, area: Rect) -> Vec<u32>;
    fn bytes(&self, area: Rect) -> Vec<Vec<u8>>;
    fn row_bytes(&self, rows: Range<u16>) -> Vec<u8>;
    /// Of the framebuffer as a bitmap: a pixel, its window, its size.
    fn as_bitmap(&self, p: Point) -> (Option<u32>, Rect, Size);

    fn blit(&mut self, at: Point, source: &Naive, part: Rect, key: Option<u32>);
    /// `mask` holds pixels of one bit, the first in the low bit of its bytes if `lsb0`.
    fn blit_mask(&mut self, at: Point, mask: &Naive, part: Rect, on: u32, off: Option<u32>);
    fn move_area(&mut self, area: Rect, to: Point, key: Option<u32>);

    fn draw_iter(&mut self, pixels: &[(Point, u32)]);
    fn fill_contiguous(&mut self, area: &Rectangle, colors: &[u32]);
    fn fill_solid(&mut self, area: &Rectangle, color: u32);
    fn pixel(&self, p: Point) -> Option<u32>;
}

/// The [`Kind`] of a format.
pub struct Of<F>(pub PhantomData<F>);

fn boxed<'a, F: PixelFormat>(frame: Framebuffer<'a, F>) -> Box<dyn Frame + 'a> {
    Box::new(frame)
}

fn lists<'a>(rows: impl Iterator<Item = &'a [u8]>) -> Vec<Vec<u8>> {
    rows.map(<[u8]>::to_vec).collect()
}

impl<F: PixelFormat> Kind for Of<F> {
    fn format(&self) -> Format {
        Format::of::<F>()
    }

    fn bytes(&self, width: u16, height: u16) -> (usize, usize) {
        (row_bytes::<F>(width), buffer_bytes::<F>(width, height))
    }

    fn open<'a>(&self, twin: &Naive, bytes: &'a mut [u8]) -> Box<dyn Frame + 'a> {
        boxed(twin.frame::<F>(bytes))
    }

    fn packed<'a>(&self, memory: &'a mut [u8], width: u16, height: u16) -> Result<Box<dyn Frame + 'a>, BufferError> {
        Framebuffer::<F>::new(memory, width, height).map(boxed)
    }

    fn strided(&self, memory: &mut [u8], width: u16, height: u16, stride: usize) -> Result<(), BufferError> {
        Framebuffer::<F>::with_stride(memory, width, height, stride).map(|_| ())
    }

    fn band<'a>(
        &self,
        memory: &'a mut [u8],
        size: (u16, u16),
        rows: Range<u16>,
    ) -> Result<Box<dyn Frame + 'a>, BufferError> {
        Framebuffer::<F>::band(memory, size.0, size.1, rows).map(boxed)
    }

    fn packed_bitmap(&self, memory: &[u8], width: u16, height: u16) -> Result<(), BufferError> {
        Bitmap::<F>::new(memory, width, height).map(|_| ())
    }

    fn strided_bitmap(&self, memory: &[u8], width: u16, height: u16, stride: usize) -> Result<(), BufferError> {
        Bitmap::<F>::with_stride(memory, width, height, stride).map(|_| ())
    }

    fn bitmap_bytes(&self, twin: &Naive, area: Rect) -> Vec<Vec<u8>> {
        lists(twin.bitmap::<F>().bytes(area))
    }
}

impl<F: PixelFormat> Frame for Framebuffer<'_, F> {
    fn window(&self) -> Rect {
        Surface::window(self)
    }

    fn size(&self) -> Size {
        Framebuffer::size(self)
    }

    fn stride(&self) -> usize {
        Framebuffer::stride(self)
    }

    fn view<'a>(&'a mut self, area: Rect) -> Box<dyn Frame + 'a> {
        boxed(Framebuffer::view(self, area))
    }

    fn clipped<'a>(&'a mut self, area: Rect) -> Box<dyn Frame + 'a> {
        boxed(Framebuffer::clipped(self, area))
    }

    fn fill_span(&mut self, span: Span, color: u32) {
        if let Some(span) = span.clip(Surface::window(self)) {
            Surface::fill_span(self, span, F::unpack(color));
        }
    }

    fn fill_area(&mut self, area: Rect, color: u32) {
        Surface::fill_area(self, area, F::unpack(color));
    }

    fn clear(&mut self, color: u32) {
        Framebuffer::clear(self, F::unpack(color));
    }

    fn fill_window(&mut self, color: u32) {
        Canvas::fill_window(self, F::unpack(color));
    }

    fn set(&mut self, p: Point, color: u32) {
        Surface::set(self, p, F::unpack(color));
    }

    fn draw(&mut self, shape: &Shape, color: u32) {
        shape.draw(self, F::unpack(color));
    }

    fn get(&self, p: Point) -> Option<u32> {
        Framebuffer::get(self, p).map(F::pack)
    }

    fn colors(&self, area: Rect) -> Vec<u32> {
        Framebuffer::colors(self, area).map(F::pack).collect()
    }

    fn bytes(&self, area: Rect) -> Vec<Vec<u8>> {
        lists(Framebuffer::bytes(self, area))
    }

    fn row_bytes(&self, rows: Range<u16>) -> Vec<u8> {
        Framebuffer::row_bytes(self, rows).to_vec()
    }

    fn as_bitmap(&self, p: Point) -> (Option<u32>, Rect, Size) {
        let bitmap = Framebuffer::as_bitmap(self);
        (bitmap.get(p).map(F::pack), bitmap.window(), bitmap.size())
    }

    fn blit(&mut self, at: Point, source: &Naive, part: Rect, key: Option<u32>) {
        let source = source.bitmap::<F>().clipped(part);
        match key {
            Some(key) => Canvas::blit_keyed(self, at, &source, F::unpack(key)),
            None => Canvas::blit(self, at, &source),
        }
    }

    fn blit_mask(&mut self, at: Point, mask: &Naive, part: Rect, on: u32, off: Option<u32>) {
        let (on, off) = (F::unpack(on), off.map(F::unpack));
        if mask.format.lsb0 {
            Canvas::blit_mask(self, at, &mask.bitmap::<Lsb0<Index1>>().clipped(part), on, off);
        } else {
            Canvas::blit_mask(self, at, &mask.bitmap::<Index1>().clipped(part), on, off);
        }
    }

    fn move_area(&mut self, area: Rect, to: Point, key: Option<u32>) {
        match key {
            Some(key) => Canvas::move_area_keyed(self, area, to, F::unpack(key)),
            None => Canvas::move_area(self, area, to),
        }
    }

    fn draw_iter(&mut self, pixels: &[(Point, u32)]) {
        let Ok(()) = DrawTarget::draw_iter(self, pixels.iter().map(|&(p, color)| Pixel(p, F::unpack(color))));
    }

    fn fill_contiguous(&mut self, area: &Rectangle, colors: &[u32]) {
        let Ok(()) = DrawTarget::fill_contiguous(self, area, colors.iter().map(|&color| F::unpack(color)));
    }

    fn fill_solid(&mut self, area: &Rectangle, color: u32) {
        let Ok(()) = DrawTarget::fill_solid(self, area, F::unpack(color));
    }

    fn pixel(&self, p: Point) -> Option<u32> {
        GetPixel::pixel(self, p).map(F::pack)
    }
}
