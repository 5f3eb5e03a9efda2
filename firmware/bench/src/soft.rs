//! This crate with soft rims: the same workloads, antialiased, in formats whose colours can be mixed.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::{Gray4, Gray8, Rgb565};
use embedded_raster::paint::Cover;
use embedded_raster::pixel::{row_bytes, Channels};
use embedded_raster::raster::coverage;
use embedded_raster::{
    Antialias, CoverageSlot, Ellipse, FillRule, Framebuffer, Path, PathSegment, PixelFormat, PointFx, Radii, Stroke,
};

use crate::engine::Engine;
use crate::scene::{corner, Blob, Format, Ink, Outline, Rect, Segment, Triangle, HEIGHT, THICK, WIDTH};

/// Memory of a frame, and scratch memory.
#[repr(align(4))]
pub struct Frame<F> {
    memory: [u8; Format::Rgb565.frame_bytes()],
    table: [CoverageSlot; 256],
    cells: [i32; coverage::cells(WIDTH as u16)],
    format: PhantomData<F>,
}

impl<F> Frame<F> {
    /// All zero.
    pub const fn new() -> Self {
        Self {
            memory: [0; Format::Rgb565.frame_bytes()],
            table: [CoverageSlot::EMPTY; 256],
            cells: [0; coverage::cells(WIDTH as u16)],
            format: PhantomData,
        }
    }
}

impl<F: PixelFormat> Frame<F> {
    /// A surface, and the scratch memory.
    fn parts(&mut self) -> (Framebuffer<'_, F>, &mut [CoverageSlot], &mut [i32]) {
        let surface = Framebuffer::new(&mut self.memory, WIDTH as u16, HEIGHT as u16).unwrap();
        (surface, &mut self.table, &mut self.cells)
    }

    fn bytes(&self) -> &[u8] {
        &self.memory[..row_bytes::<F>(WIDTH as u16) * HEIGHT]
    }
}

impl<F> Default for Frame<F> {
    fn default() -> Self {
        Self::new()
    }
}

/// At 16 bits.
pub const RGB565: Engine<Frame<Rgb565>> = engine(Format::Rgb565);
/// At 8 bits.
pub const GRAY8: Engine<Frame<Gray8>> = engine(Format::Gray8);
/// At 4 bits.
pub const GRAY4: Engine<Frame<Gray4>> = engine(Format::Gray4);

const fn engine<F: PixelFormat<Color: Channels>>(format: Format) -> Engine<Frame<F>> {
    let mut engine = Engine::new("antialiased", format, |frame| frame.memory.fill(0), Frame::bytes);
    engine.lines = Some(lines);
    engine.triangles = Some(triangles);
    engine.discs = Some(discs);
    engine.rounded = Some(rounded);
    engine.polygon = Some(polygon);
    engine.blob = Some(blob);
    engine.thick = Some(thick);
    engine
}

/// The colour whose value is the low bits of an ink.
fn paint<F: PixelFormat>(ink: Ink) -> Cover<F::Color> {
    Cover(F::unpack(u32::from(ink.0) & (1 << F::BITS) - 1))
}

fn vertex([x, y]: [i32; 2]) -> PointFx {
    PointFx::from_bits(x, y)
}

fn lines<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, lines: &[Segment]) {
    let (mut surface, ..) = frame.parts();
    for line in lines {
        let [a, b] = line.ends.map(PointFx::centre_of);
        surface.draw_line_aa(a, b, paint::<F>(line.ink));
    }
}

fn triangles<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, triangles: &[Triangle]) {
    let (mut surface, _, cells) = frame.parts();
    for triangle in triangles {
        surface.fill_triangle_aa(triangle.units.map(vertex), cells, paint::<F>(triangle.ink));
    }
}

fn discs<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, discs: &[Rect]) {
    let (mut surface, ..) = frame.parts();
    for disc in discs {
        surface.fill_ellipse_aa(Ellipse::in_box(disc.sides), paint::<F>(disc.ink));
    }
}

fn rounded<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, rects: &[Rect]) {
    let (mut surface, table, cells) = frame.parts();
    for rect in rects {
        surface.fill_rounded_aa(rect.sides, Radii::all(corner()), table, cells, paint::<F>(rect.ink)).unwrap();
    }
}

fn polygon<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, outline: &Outline<'_>) {
    let (mut surface, table, cells) = frame.parts();
    let vertices = outline.units.iter().map(|&v| vertex(v));
    surface.fill_contours_aa([vertices], FillRule::NonZero, table, cells, paint::<F>(outline.ink)).unwrap();
}

fn blob<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, blob: &Blob<'_>) {
    let (mut surface, table, cells) = frame.parts();
    let mut segments = [PathSegment::MoveTo(vertex(blob.curves[0][0])); Blob::CURVES + 1];
    for (segment, curve) in segments[1..].iter_mut().zip(blob.curves) {
        let [_, c, d, b] = curve.map(vertex);
        *segment = PathSegment::CubicTo(c, d, b);
    }
    surface.fill_path_aa(Path::new(&segments), FillRule::NonZero, table, cells, paint::<F>(blob.ink)).unwrap();
}

fn thick<F: PixelFormat<Color: Channels>>(frame: &mut Frame<F>, lines: &[Segment]) {
    let (mut surface, table, cells) = frame.parts();
    let stroke = Stroke::px(THICK as u16);
    for line in lines {
        let ends = line.ends.map(PointFx::centre_of);
        surface.stroke_line_aa(ends, &stroke, table, cells, paint::<F>(line.ink)).unwrap();
    }
}
