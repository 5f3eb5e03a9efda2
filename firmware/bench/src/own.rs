//! This crate, used as its documentation shows.

use core::marker::PhantomData;

use embedded_graphics::pixelcolor::raw::RawU16;
use embedded_graphics::pixelcolor::{BinaryColor, Gray4, Gray8, Rgb565};
use embedded_raster::pixel::{row_bytes, Be};
use embedded_raster::raster::flood::{Connectivity, FloodSlot};
use embedded_raster::text::{Style, FONT_6X10};
use embedded_raster::{
    Bitmap, Canvas, EdgeSlot, Ellipse, FillRule, Framebuffer, Index4, Index8, Join, Palette, Path, PathSegment,
    PixelFormat, PointFx, Radii, Stroke, Surface,
};

use fixed::types::I24F8;

use crate::engine::Engine;
use crate::scene::{
    corner, Blob, Curve, Flooded, Format, Indexed, Ink, Label, Outline, Rect, Segment, Sprite, Track, Triangle, HEIGHT,
    THICK, WIDTH,
};

/// Memory of a frame, as a firmware has it in a `static`, and the table of polygons.
#[repr(align(4))]
pub struct Frame<F> {
    memory: [u8; Format::Rgb565.frame_bytes()],
    table: [EdgeSlot; 256],
    format: PhantomData<F>,
}

impl<F: PixelFormat> Frame<F> {
    /// All zero.
    pub const fn new() -> Self {
        Self { memory: [0; Format::Rgb565.frame_bytes()], table: [EdgeSlot::EMPTY; 256], format: PhantomData }
    }

    /// The frame, to be drawn on.
    pub fn surface(&mut self) -> Framebuffer<'_, F> {
        Framebuffer::new(&mut self.memory, WIDTH as u16, HEIGHT as u16).unwrap()
    }

    fn bytes(&self) -> &[u8] {
        &self.memory[..row_bytes::<F>(WIDTH as u16) * HEIGHT]
    }
}

impl<F: PixelFormat> Default for Frame<F> {
    fn default() -> Self {
        Self::new()
    }
}

/// At 16 bits.
pub const RGB565: Engine<Frame<Rgb565>> = {
    let mut engine = engine(Format::Rgb565);
    engine.expand = Some(expand);
    engine.expand_pairs = Some(expand_pairs);
    engine.expand_rows = Some(expand_rows);
    engine
};
/// At 8 bits.
pub const GRAY8: Engine<Frame<Gray8>> = engine(Format::Gray8);
/// At 4 bits.
pub const GRAY4: Engine<Frame<Gray4>> = engine(Format::Gray4);
/// At 1 bit.
pub const BINARY: Engine<Frame<BinaryColor>> = engine(Format::Binary);

const fn engine<F: PixelFormat>(format: Format) -> Engine<Frame<F>> {
    let mut engine = Engine::new("embedded-raster", format, |frame| frame.memory.fill(0), Frame::bytes);
    engine.clear = Some(|frame, ink| frame.surface().clear(color::<F>(ink)));
    engine.rects = Some(rects);
    engine.rows = Some(rects);
    engine.columns = Some(rects);
    engine.lines = Some(lines);
    engine.triangles = Some(triangles);
    engine.discs = Some(discs);
    engine.circles = Some(circles);
    engine.rounded = Some(rounded);
    engine.flood = Some(flood);
    engine.polygon = Some(polygon);
    engine.curves = Some(curves);
    engine.blob = Some(blob);
    engine.thick = Some(thick);
    engine.track = Some(track);
    engine.blit = Some(|frame, sprite| {
        let source = bitmap::<F>(sprite);
        sprite.at.iter().for_each(|&at| frame.surface().blit(at, &source));
    });
    engine.blit_key = Some(|frame, sprite| {
        let source = bitmap::<F>(sprite);
        sprite.at.iter().for_each(|&at| frame.surface().blit_keyed(at, &source, F::unpack(0)));
    });
    engine.text = Some(text);
    engine
}

/// The colour whose value is the low bits of an ink.
pub fn color<F: PixelFormat>(ink: Ink) -> F::Color {
    F::unpack(u32::from(ink.0) & (1 << F::BITS) - 1)
}

fn rects<F: PixelFormat>(frame: &mut Frame<F>, rects: &[Rect]) {
    let mut surface = frame.surface();
    for rect in rects {
        surface.fill_area(rect.sides, color::<F>(rect.ink));
    }
}

fn lines<F: PixelFormat>(frame: &mut Frame<F>, lines: &[Segment]) {
    let mut surface = frame.surface();
    for line in lines {
        surface.draw_line(line.ends[0], line.ends[1], color::<F>(line.ink));
    }
}

fn triangles<F: PixelFormat>(frame: &mut Frame<F>, triangles: &[Triangle]) {
    let mut surface = frame.surface();
    for triangle in triangles {
        surface.fill_triangle_fx(triangle.units.map(vertex), color::<F>(triangle.ink));
    }
}

fn discs<F: PixelFormat>(frame: &mut Frame<F>, discs: &[Rect]) {
    let mut surface = frame.surface();
    for disc in discs {
        surface.fill_ellipse_fx(Ellipse::in_box(disc.sides), color::<F>(disc.ink));
    }
}

fn circles<F: PixelFormat>(frame: &mut Frame<F>, circles: &[Rect]) {
    let mut surface = frame.surface();
    for circle in circles {
        surface.draw_ellipse(circle.sides, color::<F>(circle.ink));
    }
}

fn rounded<F: PixelFormat>(frame: &mut Frame<F>, rects: &[Rect]) {
    let mut surface = frame.surface();
    for rect in rects {
        surface.fill_rounded(rect.sides, Radii::all(corner()), color::<F>(rect.ink));
    }
}

fn flood<F: PixelFormat>(frame: &mut Frame<F>, flooded: &Flooded<'_>) {
    let mut surface = frame.surface();
    let [ground, first, second] = flooded.inks.map(color::<F>);
    if surface.get(flooded.seed).map(F::pack) == Some(0) {
        for shape in flooded.shapes {
            if flooded.round {
                surface.fill_ellipse_fx(Ellipse::in_box(shape.sides), ground);
            } else {
                surface.fill_area(shape.sides, ground);
            }
        }
    }
    let mut table = [FloodSlot::EMPTY; 16];
    surface.flood_fill(flooded.seed, Connectivity::Sides, &mut table, first);
    surface.flood_fill(flooded.seed, Connectivity::Sides, &mut table, second);
}

fn polygon<F: PixelFormat>(frame: &mut Frame<F>, outline: &Outline<'_>) {
    let mut surface = Framebuffer::<F>::new(&mut frame.memory, WIDTH as u16, HEIGHT as u16).unwrap();
    let vertices = outline.units.iter().map(|&v| vertex(v));
    let color = color::<F>(outline.ink);
    surface.fill_contours_fx([vertices], FillRule::NonZero, &mut frame.table, color).unwrap();
}

fn curves<F: PixelFormat>(frame: &mut Frame<F>, curves: &[Curve]) {
    let mut surface = frame.surface();
    for curve in curves {
        surface.draw_cubic_fx(curve.units.map(vertex), color::<F>(curve.ink));
    }
}

fn blob<F: PixelFormat>(frame: &mut Frame<F>, blob: &Blob<'_>) {
    let mut surface = Framebuffer::<F>::new(&mut frame.memory, WIDTH as u16, HEIGHT as u16).unwrap();
    let mut segments = [PathSegment::MoveTo(vertex(blob.curves[0][0])); Blob::CURVES + 1];
    for (segment, curve) in segments[1..].iter_mut().zip(blob.curves) {
        let [_, c, d, b] = curve.map(vertex);
        *segment = PathSegment::CubicTo(c, d, b);
    }
    let color = color::<F>(blob.ink);
    surface.fill_path_fx(Path::new(&segments), FillRule::NonZero, &mut frame.table, color).unwrap();
}

fn thick<F: PixelFormat>(frame: &mut Frame<F>, lines: &[Segment]) {
    let mut surface = Framebuffer::<F>::new(&mut frame.memory, WIDTH as u16, HEIGHT as u16).unwrap();
    let stroke = Stroke::px(THICK as u16);
    for line in lines {
        let ends = line.ends.map(PointFx::centre_of);
        surface.stroke_line_fx(ends, &stroke, &mut frame.table, color::<F>(line.ink)).unwrap();
    }
}

fn track<F: PixelFormat>(frame: &mut Frame<F>, track: &Track<'_>) {
    let mut surface = Framebuffer::<F>::new(&mut frame.memory, WIDTH as u16, HEIGHT as u16).unwrap();
    let (places, color) = (track.units.map(vertex), color::<F>(track.ink));
    let stroke = Stroke::px(track.width).with_join(Join::Round);
    match track.dashes {
        Some(lengths) => {
            let lengths = lengths.map(I24F8::from);
            let stroke = stroke.dashed(&lengths, I24F8::ZERO);
            surface.stroke_polyline_fx(&places, false, &stroke, &mut frame.table, color).unwrap();
        }
        None => surface.stroke_polyline_fx(&places, false, &stroke, &mut frame.table, color).unwrap(),
    }
}

fn vertex([x, y]: [i32; 2]) -> PointFx {
    PointFx::from_bits(x, y)
}

fn bitmap<'a, F: PixelFormat>(sprite: &Sprite<'a>) -> Bitmap<'a, F> {
    Bitmap::new(sprite.bytes, Sprite::SIDE as u16, Sprite::SIDE as u16).unwrap()
}

fn text<F: PixelFormat>(frame: &mut Frame<F>, labels: &[Label<'_>]) {
    let mut surface = frame.surface();
    for label in labels {
        style::<F>(label).draw(&mut surface, label.at, label.text);
    }
}

/// How a label looks.
pub fn style<F: PixelFormat>(label: &Label<'_>) -> Style<'static, F::Color> {
    let style = Style::new(&FONT_6X10, color::<F>(label.ink));
    label.paper.map_or(style, |paper| style.opaque(color::<F>(paper)))
}

fn expand(frame: &mut Frame<Rgb565>, indexed: &Indexed<'_>) {
    let palette = Palette::new(indexed.palette.map(|bits| Rgb565::from(RawU16::new(bits))));
    palette.expand::<Index8, Rgb565>(indexed.indices, &mut frame.memory);
}

/// The first sixteen colours.
fn sixteen(indexed: &Indexed<'_>) -> Palette<Rgb565, 16> {
    let colors = *indexed.palette.first_chunk().unwrap();
    Palette::new(colors.map(|bits| Rgb565::from(RawU16::new(bits))))
}

fn expand_pairs(frame: &mut Frame<Rgb565>, indexed: &Indexed<'_>) {
    let indices = &indexed.indices[..WIDTH * HEIGHT / 2];
    sixteen(indexed).expand::<Index4, Be<Rgb565>>(indices, &mut frame.memory);
}

fn expand_rows(frame: &mut Frame<Rgb565>, indexed: &Indexed<'_>) {
    let palette = sixteen(indexed);
    let rows = frame.memory.chunks_exact_mut(2 * WIDTH).zip(indexed.indices.chunks_exact(WIDTH / 2));
    rows.for_each(|(row, indices)| palette.expand::<Index4, Be<Rgb565>>(indices, row));
}
