//! The workloads: what is drawn, as data that is the same for every engine and every chip.
//!
//! Everything lies inside the frame, so that engines without clipping can take part. Corners are
//! pixel centres; they are given as pixels and as 24.8 units, and rectangles by size and by sides,
//! because neither kind of engine should pay for a conversion.

mod lcg;
mod letters;
mod make;
mod picture;

use embedded_graphics::geometry::Point;
use embedded_graphics::primitives::Rectangle;

pub use lcg::Lcg;
pub use letters::text;
pub use picture::{Format, Pictures};

/// Radius of the corners of rounded rectangles.
pub const fn corner() -> u32 {
    make::CORNER
}

/// Pixels across thick lines.
pub const THICK: u32 = 7;

/// Pixels in a row of the frame.
pub const WIDTH: usize = 320;
/// Rows of the frame.
pub const HEIGHT: usize = 240;

/// A colour: its low bits are the pixel value in every format. The lowest bit is always set, so that
/// no ink is the black of an empty frame, nor the colour key.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub struct Ink(pub u16);

/// A place in 24.8: 256 units to a pixel, pixel centres at 128.
pub type Units = [i32; 2];

/// A filled rectangle; also a run of pixels.
#[derive(Copy, Clone)]
pub struct Rect {
    /// Its pixels.
    pub area: Rectangle,
    /// The same pixels.
    pub sides: embedded_raster::Rect,
    /// Its colour.
    pub ink: Ink,
}

impl Rect {
    /// Both ways to say which pixels.
    pub fn new(area: Rectangle, ink: Ink) -> Self {
        Self { area, sides: area.into(), ink }
    }
}

/// A line, both ends drawn.
#[derive(Copy, Clone)]
pub struct Segment {
    /// First and last pixel.
    pub ends: [Point; 2],
    /// Its colour.
    pub ink: Ink,
}

/// A filled triangle.
#[derive(Copy, Clone)]
pub struct Triangle {
    /// Its corners as pixels.
    pub px: [Point; 3],
    /// The same corners.
    pub units: [Units; 3],
    /// Its colour.
    pub ink: Ink,
}

/// A filled simple polygon.
pub struct Outline<'a> {
    /// Its corners as pixels.
    pub px: &'a [Point],
    /// The same corners.
    pub units: &'a [Units],
    /// Its colour.
    pub ink: Ink,
}

/// A cubic Bézier curve.
#[derive(Copy, Clone)]
pub struct Curve {
    /// Its start, its control points, its end.
    pub units: [Units; 4],
    /// Its colour.
    pub ink: Ink,
}

/// What cubic curves enclose, each from the end of the one before.
pub struct Blob<'a> {
    /// The curves.
    pub curves: &'a [[Units; 4]; Blob::CURVES],
    /// Its colour.
    pub ink: Ink,
}

impl Blob<'_> {
    /// How many curves there are.
    pub const CURVES: usize = 8;
}

/// Lines with a width, round corners and no caps.
pub struct Track<'a> {
    /// From the first place to the last one.
    pub units: &'a [Units; Track::PLACES],
    /// In pixels.
    pub width: u16,
    /// Pixels with and without colour in turn.
    pub dashes: Option<[u16; 2]>,
    /// Its colour.
    pub ink: Ink,
}

impl Track<'_> {
    /// How many places there are.
    pub const PLACES: usize = 12;
}

/// A region to flood, and what it is made of.
pub struct Flooded<'a> {
    /// The region, as filled ellipses or rectangles.
    pub shapes: &'a [Rect],
    /// Whether these are ellipses.
    pub round: bool,
    /// A pixel in it.
    pub seed: Point,
    /// The colour of the region, and the two that it is flooded with, one after the other.
    pub inks: [Ink; 3],
    /// Its pixels.
    pub pixels: u32,
}

/// A picture of `Sprite::SIDE` pixels square, at several places.
pub struct Sprite<'a> {
    /// Its rows, packed as the frame is; 0 is transparent where a colour key is asked for.
    pub bytes: &'a [u8],
    /// Top left corners.
    pub at: &'a [Point],
}

impl Sprite<'_> {
    /// Pixels in a row and rows.
    pub const SIDE: usize = 64;
}

/// A whole screen of 8-bit indices.
pub struct Indexed<'a> {
    /// `WIDTH` to a row.
    pub indices: &'a [u8],
    /// RGB565.
    pub palette: &'a [u16; 256],
}

/// A line of text in embedded-graphics' 6 x 10 font.
#[derive(Copy, Clone)]
pub struct Label<'a> {
    /// The text.
    pub text: &'a str,
    /// The left end of its baseline.
    pub at: Point,
    /// Colour of the letters.
    pub ink: Ink,
    /// Colour around the letters, if any.
    pub paper: Option<Ink>,
}

/// What an engine is asked to draw.
pub enum Work<'a> {
    /// The whole frame in one colour.
    Clear(Ink),
    /// Filled rectangles.
    Rects(&'a [Rect]),
    /// Rectangles one pixel high.
    Rows(&'a [Rect]),
    /// Rectangles one pixel wide.
    Columns(&'a [Rect]),
    /// Lines.
    Lines(&'a [Segment]),
    /// Filled triangles.
    Triangles(&'a [Triangle]),
    /// Filled circles in boxes.
    Discs(&'a [Rect]),
    /// Their outlines.
    Circles(&'a [Rect]),
    /// Filled rectangles with corners of radius 16.
    Rounded(&'a [Rect]),
    /// A region to flood twice.
    Flood(Flooded<'a>),
    /// A filled polygon.
    Polygon(Outline<'a>),
    /// Curves one pixel wide.
    Curves(&'a [Curve]),
    /// A filled path.
    Blob(Blob<'a>),
    /// Thick lines.
    Thick(&'a [Segment]),
    /// Thick lines around corners.
    Track(Track<'a>),
    /// A picture.
    Blit(Sprite<'a>),
    /// A picture with transparent pixels.
    BlitKey(Sprite<'a>),
    /// Indices to colours.
    Expand(Indexed<'a>),
    /// Indices of four bits, two to a byte, to colours as a display wants them.
    ExpandPairs(Indexed<'a>),
    /// The same, row by row, as a display is sent them.
    ExpandRows(Indexed<'a>),
    /// Text.
    Text(&'a [Label<'a>]),
}

/// A row of the table.
pub struct Workload<'a> {
    /// As it appears in the table.
    pub name: &'static str,
    /// How many items are drawn.
    pub calls: usize,
    /// Pixels that are drawn, every item by itself; areas where edges are slanted. It belongs to the
    /// workload, so that an engine that draws more or fewer pixels is measured by the same number.
    pub pixels: u32,
    /// The data.
    pub work: Work<'a>,
}

/// All data that does not depend on the pixel format.
pub struct Scene {
    rect: [Rect; 1],
    rects: [Rect; 256],
    rows: [Rect; 64],
    columns: [Rect; 64],
    long: [Segment; 64],
    short: [Segment; 256],
    large: [Triangle; 1],
    small: [Triangle; 256],
    slivers: [Triangle; 32],
    star: ([Point; 10], [Units; 10]),
    outline: ([Point; 200], [Units; 200]),
    sprites: [Point; 8],
    text: [Label<'static>; 16],
    opaque_text: [Label<'static>; 16],
    disc: [Rect; 1],
    discs: [Rect; 64],
    rounded: [Rect; 1],
    flood: [Rect; 1],
    maze: [Rect; make::MAZE],
    curves: [Curve; 16],
    blob: [[Units; 4]; Blob::CURVES],
    thick: [Segment; 32],
    track: [Units; Track::PLACES],
    halls: [Rect; make::HALLS],
}

impl Scene {
    /// Number of workloads.
    pub const LEN: usize = 31;

    /// Makes all data, the same each time.
    pub fn new() -> Self {
        let random = &mut Lcg::new(0x5EED);
        Self {
            rect: [make::rect(random, Point::new(33, 41), 200, 151)],
            rects: make::rects(random, 8, 8),
            rows: make::rects(random, 200, 1),
            columns: make::rects(random, 1, 150),
            long: make::long_lines(random),
            short: make::short_lines(random),
            large: [make::triangle(random, [(30, 20), (290, 70), (114, 190)])],
            small: make::small_triangles(random),
            slivers: make::slivers(random),
            star: make::both(make::star()),
            outline: make::both(make::outline(random)),
            sprites: make::odd_places(random),
            text: make::labels(random, false),
            opaque_text: make::labels(random, true),
            disc: [make::rect(random, Point::new(111, 67), 101, 101)],
            discs: make::rects(random, 13, 13),
            rounded: [make::rect(random, Point::new(77, 61), 161, 101)],
            flood: [make::rect(random, Point::new(60, 20), 199, 199)],
            maze: make::spiral(random),
            curves: make::curves(random),
            blob: make::blob(),
            thick: make::thick_lines(random),
            track: make::track(random),
            halls: make::halls(random),
        }
    }

    /// All workloads, with pictures of the engine's format.
    pub fn workloads<'a>(&'a self, pictures: &'a Pictures) -> [Workload<'a>; Self::LEN] {
        let ink = make::INK;
        let sprite = || Sprite { bytes: &pictures.sprite, at: &self.sprites };
        let polygon = |(px, units): (&'a [Point], &'a [Units])| Outline { px, units, ink };
        let (star, outline) = (&self.star, &self.outline);
        let track = |width, dashes| Track { units: &self.track, width, dashes, ink };
        [
            ("clear", Work::Clear(ink)),
            ("rect-200x151", Work::Rects(&self.rect)),
            ("rects-8x8", Work::Rects(&self.rects)),
            ("rows-200", Work::Rows(&self.rows)),
            ("columns-150", Work::Columns(&self.columns)),
            ("lines-long", Work::Lines(&self.long)),
            ("lines-12", Work::Lines(&self.short)),
            ("triangle-20000", Work::Triangles(&self.large)),
            ("triangles-29", Work::Triangles(&self.small)),
            ("slivers-200x2", Work::Triangles(&self.slivers)),
            ("star-10", Work::Polygon(polygon((&star.0, &star.1)))),
            ("outline-200", Work::Polygon(polygon((&outline.0, &outline.1)))),
            ("disc-101", Work::Discs(&self.disc)),
            ("discs-13", Work::Discs(&self.discs)),
            ("circle-101", Work::Circles(&self.disc)),
            ("rounded-161x101", Work::Rounded(&self.rounded)),
            ("flood-disc", Work::Flood(make::flood(&self.flood, true))),
            ("flood-maze", Work::Flood(make::flood(&self.maze, false))),
            ("flood-halls", Work::Flood(make::flood(&self.halls, false))),
            ("curves-thin", Work::Curves(&self.curves)),
            ("blob-8", Work::Blob(Blob { curves: &self.blob, ink })),
            ("lines-7-wide", Work::Thick(&self.thick)),
            ("stroke-9-wide", Work::Track(track(9, None))),
            ("stroke-dashed", Work::Track(track(5, Some([12, 8])))),
            ("blit-64", Work::Blit(sprite())),
            ("blit-key-64", Work::BlitKey(sprite())),
            ("expand-8bit", Work::Expand(pictures.indexed())),
            ("expand-4bit", Work::ExpandPairs(pictures.indexed())),
            ("expand-4bit-rows", Work::ExpandRows(pictures.indexed())),
            ("text", Work::Text(&self.text)),
            ("text-opaque", Work::Text(&self.opaque_text)),
        ]
        .map(|(name, work)| Workload { name, calls: work.calls(), pixels: work.pixels(), work })
    }
}

impl Default for Scene {
    fn default() -> Self {
        Self::new()
    }
}

impl Work<'_> {
    /// How many items are drawn.
    fn calls(&self) -> usize {
        match self {
            Self::Clear(_) | Self::Polygon(_) | Self::Blob(_) | Self::Track(_) => 1,
            Self::Expand(_) | Self::ExpandPairs(_) => 1,
            Self::ExpandRows(_) => HEIGHT,
            Self::Rects(rects) | Self::Rows(rects) | Self::Columns(rects) => rects.len(),
            Self::Discs(boxes) | Self::Circles(boxes) | Self::Rounded(boxes) => boxes.len(),
            Self::Flood(_) => 2,
            Self::Lines(lines) | Self::Thick(lines) => lines.len(),
            Self::Curves(curves) => curves.len(),
            Self::Triangles(triangles) => triangles.len(),
            Self::Blit(sprite) | Self::BlitKey(sprite) => sprite.at.len(),
            Self::Text(labels) => labels.len(),
        }
    }

    /// How many pixels are drawn; see [`Workload::pixels`].
    fn pixels(&self) -> u32 {
        match self {
            Self::Clear(_) | Self::Expand(_) | Self::ExpandPairs(_) | Self::ExpandRows(_) => (WIDTH * HEIGHT) as u32,
            Self::Rects(rects) | Self::Rows(rects) | Self::Columns(rects) => {
                rects.iter().map(|r| r.area.size.width * r.area.size.height).sum()
            }
            Self::Lines(lines) => lines.iter().map(|line| make::length(line.ends)).sum(),
            Self::Triangles(all) => all.iter().map(|t| make::twice_area(&t.px)).sum::<u32>() / 2,
            Self::Polygon(outline) => make::twice_area(outline.px) / 2,
            Self::Curves(curves) => curves.iter().map(|curve| make::curve_pixels(&curve.units)).sum(),
            Self::Blob(blob) => make::blob_pixels(blob.curves),
            Self::Thick(lines) => lines.iter().map(|line| make::thick_pixels(line.ends)).sum(),
            Self::Track(track) => make::track_pixels(track),
            Self::Discs(boxes) => boxes.iter().map(make::disc_pixels).sum(),
            Self::Circles(boxes) => boxes.iter().map(make::circle_pixels).sum(),
            Self::Rounded(boxes) => boxes.iter().map(make::rounded_pixels).sum(),
            Self::Flood(flooded) => 2 * flooded.pixels,
            Self::Blit(sprite) => sprite.at.len() as u32 * picture::PIXELS,
            Self::BlitKey(sprite) => sprite.at.len() as u32 * picture::opaque_pixels(),
            Self::Text(labels) => make::text_pixels(labels),
        }
    }
}
