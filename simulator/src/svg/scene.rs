//! [`draw`]: shapes to pixels of any depth.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb565, Rgb888},
};
use embedded_raster::{
    buffer_bytes,
    pixel::Xrgb8888,
    raster::{
        polygon::{
            self,
            drop_out::{self, DropOut},
            EdgeSlots,
        },
        stroke,
    },
    Canvas, EdgeSlot, EdgeTableFull, Error, FillRule, Framebuffer, Index1, Index2, Index4, Index8, Path, PathSegment,
    Rect, Stroke, Surface,
};
use fixed::types::I24F8;

use super::tone::Tone;
use crate::picture::Picture;

/// A path with its colours.
#[derive(Clone, Debug)]
pub struct Shape {
    /// Where it lies on the screen.
    pub path: Vec<PathSegment>,
    /// Which regions are inside, and their colour.
    pub fill: Option<(FillRule, Rgb888)>,
    /// What is drawn of regions between the centres of pixels.
    pub drop_out: Option<DropOut>,
    /// Its outline, drawn over them.
    pub outline: Option<Outline>,
}

/// An outline.
#[derive(Clone, Debug)]
pub struct Outline {
    /// Its width, least width, ends and corners.
    pub stroke: Stroke,
    /// Lengths of dashes and gaps: none for a solid one.
    pub dashes: Vec<I24F8>,
    /// Where in them it begins.
    pub phase: I24F8,
    /// What it is painted with.
    pub color: Rgb888,
}

/// What is drawn on, and how.
#[derive(Copy, Clone, Debug)]
pub struct Screen {
    /// Columns.
    pub width: u16,
    /// Rows.
    pub height: u16,
    /// Bits of a pixel: 1, 2, 4, 8, 16, 24 or 32.
    pub bits: u32,
    /// How many rows there is memory for.
    pub band: u16,
    /// Slots of the edge table.
    pub slots: usize,
    /// What is there before.
    pub paper: Rgb888,
}

/// Drawn shapes.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// What they look like.
    pub picture: Picture,
    /// Pixels that were painted, each counted once.
    pub pixels: usize,
}

/// Draws shapes, one over the other.
///
/// # Errors
/// If the edge table is too small for a row of a shape.
pub fn draw(shapes: &[Shape], screen: &Screen) -> Result<Drawing, Error> {
    match screen.bits {
        1 => draw_as::<Index1>(shapes, screen),
        2 => draw_as::<Index2>(shapes, screen),
        4 => draw_as::<Index4>(shapes, screen),
        8 => draw_as::<Index8>(shapes, screen),
        16 => draw_as::<Rgb565>(shapes, screen),
        24 => draw_as::<Rgb888>(shapes, screen),
        _ => draw_as::<Xrgb8888>(shapes, screen),
    }
}

/// Draws band by band, each in the same memory.
fn draw_as<C: Tone>(shapes: &[Shape], screen: &Screen) -> Result<Drawing, Error> {
    let &Screen { width, height, slots, .. } = screen;
    let rows = screen.band.clamp(1, height.max(1));
    let mut table = vec![EdgeSlot::EMPTY; slots];
    let mut ram = vec![0; buffer_bytes::<C>(width, rows)];
    let mut stencil = vec![0; buffer_bytes::<Index1>(width, rows)];
    let (mut shown, mut pixels) = (Vec::with_capacity(buffer_bytes::<C>(width, height)), 0);
    for start in (0..height).step_by(rows.into()) {
        let band = start..height.min(start.saturating_add(rows));
        let mut frame = Framebuffer::<C>::band(&mut ram, width, height, band.clone())?;
        frame.fill_window(C::of(screen.paper));
        let mut painted = Framebuffer::<Index1>::band(&mut stencil, width, height, band.clone())?;
        painted.fill_window(Index1::new(0));
        for shape in shapes {
            shape.draw(&mut frame, &mut table, C::of)?;
            shape.draw(&mut painted, &mut table, |_| Index1::MAX)?;
        }
        let window = painted.window();
        let places = (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| Point::new(x, y)));
        pixels += places.filter(|&at| painted.get(at) == Some(Index1::MAX)).count();
        shown.extend_from_slice(frame.row_bytes(band));
    }
    let frame = Framebuffer::<C>::new(&mut shown, width, height)?;
    Ok(Drawing { picture: C::picture(&frame), pixels })
}

/// How many slots of an edge table the shapes need, on the whole screen.
pub fn slots(shapes: &[Shape], screen: &Screen) -> EdgeSlots {
    let window = Rect::new(0, 0, screen.width.into(), screen.height.into());
    shapes.iter().map(|shape| shape.slots(window)).fold(EdgeSlots::default(), more)
}

/// As many as both need.
fn more(a: EdgeSlots, b: EdgeSlots) -> EdgeSlots {
    EdgeSlots { whole: a.whole.max(b.whole), least: a.least.max(b.least) }
}

impl Shape {
    fn slots(&self, window: Rect) -> EdgeSlots {
        let path = Path::new(&self.path);
        let inside = self.fill.map(|_| match self.drop_out {
            None => polygon::edge_slots(path.contours_in(window), window),
            Some(_) => drop_out::edge_slots(path.contours_in(window.inset(-1)), window),
        });
        let around = self.outline.as_ref().map(|outline| match &outline.dashes[..] {
            [] => stroke::edge_slots(path, &outline.stroke, window),
            dashes => stroke::edge_slots(path, &outline.stroke.dashed(dashes, outline.phase), window),
        });
        more(inside.unwrap_or_default(), around.unwrap_or_default())
    }

    /// Draws it with what `tone` makes of its colours.
    fn draw<S: Surface>(
        &self,
        on: &mut S,
        table: &mut [EdgeSlot],
        tone: impl Fn(Rgb888) -> S::Color,
    ) -> Result<(), EdgeTableFull> {
        let path = Path::new(&self.path);
        if let Some((rule, color)) = self.fill {
            match self.drop_out {
                None => on.fill_path_fx(path, rule, table, tone(color))?,
                Some(drop_out) => on.fill_path_drop_out_fx(path, rule, drop_out, table, tone(color))?,
            }
        }
        let Some(outline) = &self.outline else { return Ok(()) };
        let (stroke, color) = (outline.stroke, tone(outline.color));
        match &outline.dashes[..] {
            [] => on.stroke_path_fx(path, &stroke, table, color),
            dashes => on.stroke_path_fx(path, &stroke.dashed(dashes, outline.phase), table, color),
        }
    }
}
