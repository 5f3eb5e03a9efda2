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
    pixel::Lsb0,
    raster::flood::{Connectivity, FloodSlot},
    surface::{Grid, Rows},
    BufferError, Canvas, EdgeSlot, Ellipse, FillRule, Frame as Memory, Index1, Layout, PixelFormat, Readable, Rect,
    Span, Surface,
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

/// A layout of the crate.
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
    /// Colours from the start of the span on; nothing where there is none.
    fn write_some(&mut self, span: Span, colors: &[Option<u32>]);
    fn edit_span(&mut self, span: Span, edit: &dyn Fn(i32, u32) -> u32);
    fn read_span(&self, span: Span) -> Vec<u32>;
    /// The first column of a wanted colour, and where wanted colours begin that reach the end.
    fn find(&self, span: Span, wanted: u32) -> Option<(i32, i32)>;
    fn fill_area(&mut self, area: Rect, color: u32);
    fn clear(&mut self, color: u32);
    fn fill_window(&mut self, color: u32);
    fn set(&mut self, p: Point, color: u32);
    fn draw(&mut self, shape: &Shape, color: u32);

    fn get(&self, p: Point) -> Option<u32>;
    fn colors(&self, area: Rect) -> Vec<u32>;
    /// Of the framebuffer as a bitmap: a pixel, its window, its size.
    fn as_bitmap(&self, p: Point) -> (Option<u32>, Rect, Size);

    fn flood(&mut self, seed: Point, boundary: Option<u32>, slots: usize, color: u32);
    fn blit(&mut self, at: Point, source: &Naive, part: Rect, key: Option<u32>);
    /// A picture in rows.
    fn blit_rows(&mut self, at: Point, source: &Naive, part: Rect, key: Option<u32>);
    /// `mask` holds pixels of one bit, the first in the low bit of its bytes if `lsb0`.
    fn blit_mask(&mut self, at: Point, mask: &Naive, part: Rect, on: u32, off: Option<u32>);
    fn move_area(&mut self, area: Rect, to: Point, key: Option<u32>);

    fn draw_iter(&mut self, pixels: &[(Point, u32)]);
    fn fill_contiguous(&mut self, area: &Rectangle, colors: &[u32]);
    fn fill_solid(&mut self, area: &Rectangle, color: u32);
    fn pixel(&self, p: Point) -> Option<u32>;
}

/// The [`Kind`] of a layout whose colours have the bits of the format `F`.
pub struct Of<L, F>(pub PhantomData<(L, F)>, pub Format);

impl<F: PixelFormat> Of<Rows<F>, F> {
    /// Rows of a format.
    pub fn rows() -> Self {
        Self(PhantomData, Format::of::<F>())
    }
}

/// Memory in a layout whose colours have the bits of the format `F`.
struct InBits<'a, L, F>(Memory<&'a mut [u8], L>, PhantomData<F>);

fn boxed<'a, F: PixelFormat, L: Layout<Color = F::Color>>(frame: Memory<&'a mut [u8], L>) -> Box<dyn Frame + 'a> {
    Box::new(InBits(frame, PhantomData::<F>))
}

impl<F: PixelFormat, L: Layout<Color = F::Color>> Kind for Of<L, F> {
    fn format(&self) -> Format {
        self.1
    }

    fn bytes(&self, width: u16, height: u16) -> (usize, usize) {
        let stride = L::row_bytes(width);
        (stride, L::bytes(width, Grid { stride, rows: height.into() }))
    }

    fn open<'a>(&self, twin: &Naive, bytes: &'a mut [u8]) -> Box<dyn Frame + 'a> {
        boxed::<F, L>(twin.frame(bytes))
    }

    fn packed<'a>(&self, memory: &'a mut [u8], width: u16, height: u16) -> Result<Box<dyn Frame + 'a>, BufferError> {
        Memory::new(memory, width, height).map(boxed::<F, L>)
    }

    fn strided(&self, memory: &mut [u8], width: u16, height: u16, stride: usize) -> Result<(), BufferError> {
        Memory::<_, L>::with_stride(memory, width, height, stride).map(|_| ())
    }

    fn band<'a>(
        &self,
        memory: &'a mut [u8],
        size: (u16, u16),
        rows: Range<u16>,
    ) -> Result<Box<dyn Frame + 'a>, BufferError> {
        Memory::band(memory, size.0, size.1, rows).map(boxed::<F, L>)
    }

    fn packed_bitmap(&self, memory: &[u8], width: u16, height: u16) -> Result<(), BufferError> {
        Memory::<_, L>::new(memory, width, height).map(|_| ())
    }

    fn strided_bitmap(&self, memory: &[u8], width: u16, height: u16, stride: usize) -> Result<(), BufferError> {
        Memory::<_, L>::with_stride(memory, width, height, stride).map(|_| ())
    }
}

impl<F: PixelFormat, L: Layout<Color = F::Color>> Frame for InBits<'_, L, F> {
    fn window(&self) -> Rect {
        Surface::window(&self.0)
    }

    fn size(&self) -> Size {
        self.0.size()
    }

    fn stride(&self) -> usize {
        self.0.stride()
    }

    fn view<'a>(&'a mut self, area: Rect) -> Box<dyn Frame + 'a> {
        boxed::<F, L>(self.0.view(area))
    }

    fn clipped<'a>(&'a mut self, area: Rect) -> Box<dyn Frame + 'a> {
        boxed::<F, L>(self.0.clipped(area))
    }

    fn fill_span(&mut self, span: Span, color: u32) {
        if let Some(span) = span.clip(self.0.window()) {
            self.0.fill_span(span, F::unpack(color));
        }
    }

    fn write_some(&mut self, span: Span, colors: &[Option<u32>]) {
        if let Some(clipped) = span.clip(self.0.window()) {
            let color = |x: i32| colors[(x - span.x0) as usize].map(F::unpack);
            self.0.write_some(clipped, color);
        }
    }

    fn edit_span(&mut self, span: Span, edit: &dyn Fn(i32, u32) -> u32) {
        if let Some(span) = span.clip(self.0.window()) {
            self.0.edit_span(span, |x, old| F::unpack(edit(x, F::pack(old))));
        }
    }

    fn read_span(&self, span: Span) -> Vec<u32> {
        let mut colors = vec![];
        if let Some(span) = span.clip(self.0.window()) {
            self.0.read_span(span, |color| colors.push(F::pack(color)));
        }
        colors
    }

    fn find(&self, span: Span, wanted: u32) -> Option<(i32, i32)> {
        let span = span.clip(self.0.window())?;
        let is_wanted = |color| F::pack(color) == wanted;
        Some((self.0.find(span, is_wanted), self.0.find_start(span, is_wanted)))
    }

    fn fill_area(&mut self, area: Rect, color: u32) {
        Surface::fill_area(&mut self.0, area, F::unpack(color));
    }

    fn clear(&mut self, color: u32) {
        Memory::clear(&mut self.0, F::unpack(color));
    }

    fn fill_window(&mut self, color: u32) {
        self.0.fill_window(F::unpack(color));
    }

    fn set(&mut self, p: Point, color: u32) {
        self.0.set(p, F::unpack(color));
    }

    fn draw(&mut self, shape: &Shape, color: u32) {
        shape.draw(&mut self.0, F::unpack(color));
    }

    fn get(&self, p: Point) -> Option<u32> {
        let read = Readable::get(&self.0, p);
        assert!(read == Memory::get(&self.0, p), "by the trait and by the method");
        read.map(F::pack)
    }

    fn colors(&self, area: Rect) -> Vec<u32> {
        self.0.colors(area).map(F::pack).collect()
    }

    fn as_bitmap(&self, p: Point) -> (Option<u32>, Rect, Size) {
        let bitmap = self.0.as_bitmap();
        (bitmap.get(p).map(F::pack), bitmap.window(), bitmap.size())
    }

    fn flood(&mut self, seed: Point, boundary: Option<u32>, slots: usize, color: u32) {
        let (mut table, color) = (vec![FloodSlot::EMPTY; slots], F::unpack(color));
        match boundary {
            Some(to) => self.0.flood_fill_to(seed, F::unpack(to), Connectivity::Sides, &mut table, color),
            None => self.0.flood_fill(seed, Connectivity::Sides, &mut table, color),
        };
    }

    fn blit(&mut self, at: Point, source: &Naive, part: Rect, key: Option<u32>) {
        let source = source.bitmap::<L>().clipped(part);
        match key {
            Some(key) => self.0.blit_keyed(at, &source, F::unpack(key)),
            None => self.0.blit(at, &source),
        }
    }

    fn blit_rows(&mut self, at: Point, source: &Naive, part: Rect, key: Option<u32>) {
        let source = source.bitmap::<Rows<F>>().clipped(part);
        match key {
            Some(key) => self.0.blit_keyed(at, &source, F::unpack(key)),
            None => self.0.blit(at, &source),
        }
    }

    fn blit_mask(&mut self, at: Point, mask: &Naive, part: Rect, on: u32, off: Option<u32>) {
        let (on, off) = (F::unpack(on), off.map(F::unpack));
        if mask.format.lsb0 {
            self.0.blit_mask(at, &mask.bitmap::<Rows<Lsb0<Index1>>>().clipped(part), on, off);
        } else {
            self.0.blit_mask(at, &mask.bitmap::<Rows<Index1>>().clipped(part), on, off);
        }
    }

    fn move_area(&mut self, area: Rect, to: Point, key: Option<u32>) {
        match key {
            Some(key) => self.0.move_area_keyed(area, to, F::unpack(key)),
            None => self.0.move_area(area, to),
        }
    }

    fn draw_iter(&mut self, pixels: &[(Point, u32)]) {
        let Ok(()) = self.0.draw_iter(pixels.iter().map(|&(p, color)| Pixel(p, F::unpack(color))));
    }

    fn fill_contiguous(&mut self, area: &Rectangle, colors: &[u32]) {
        let Ok(()) = self.0.fill_contiguous(area, colors.iter().map(|&color| F::unpack(color)));
    }

    fn fill_solid(&mut self, area: &Rectangle, color: u32) {
        let Ok(()) = self.0.fill_solid(area, F::unpack(color));
    }

    fn pixel(&self, p: Point) -> Option<u32> {
        GetPixel::pixel(&self.0, p).map(F::pack)
    }
}
