//! The page: twenty tiles, each a kind of shape. Integers only and no heap: a chip draws it with this same code.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    unreachable_pub,
    reason = "the numbers of a page are small; firmwares have this page as a module of a library"
)]

use embedded_graphics_core::{geometry::Point, pixelcolor::Rgb888};
use embedded_raster::{
    geom::{delaunay, triangulate, triangulate::SideSlot},
    px,
    raster::flood::{Connectivity, FloodSlot},
    Angle, Bitmap, Canvas, Cap, EdgeSlot, EdgeTableFull, Ellipse, Error, FillRule, Framebuffer, Index1, Join, Path,
    PathSegment,
    PathSegment::{Close, CubicTo, LineTo, MoveTo, QuadraticTo},
    PixelFormat, PointFx, Radii, Rect, Sector, Stroke, Surface,
};
use fixed::types::I24F8;

/// Columns and rows of the page.
pub const WIDTH: u16 = 320;
/// Rows of the page.
pub const HEIGHT: u16 = 240;
/// Edges that the table of the page needs at most.
pub const EDGES: usize = 96;

/// Paper and eight colours, as the page is shown; 1 and 2 bits have fewer.
pub const COLORS: [Rgb888; 9] = [
    Rgb888::new(0xf6, 0xf1, 0xe3),
    Rgb888::new(0x1d, 0x33, 0x4a),
    Rgb888::new(0xd1, 0x49, 0x5b),
    Rgb888::new(0xed, 0xae, 0x49),
    Rgb888::new(0x66, 0xa1, 0x82),
    Rgb888::new(0x2e, 0x6f, 0x95),
    Rgb888::new(0x9b, 0x5d, 0xe5),
    Rgb888::new(0xf1, 0x5b, 0xb5),
    Rgb888::new(0x6b, 0x70, 0x5c),
];

/// Columns and rows of a tile.
const TILE: (i32, i32) = (64, 60);

/// What the page is drawn with: 0 is the paper, 1 to 8 are colours.
pub type Ink = u8;

/// Draws everything but what pours: on a band of the screen it draws the part of it that is there.
///
/// # Errors
/// [`EdgeTableFull`] if `table` is shorter than a row of the page needs.
pub fn draw<S: Surface>(page: &mut S, table: &mut [EdgeSlot], ink: impl Fn(Ink) -> S::Color) -> Result<(), Error> {
    draw_with(page, table, &ink, &ink)
}

/// The same with inks for areas, and others for lines and points: where areas have patterns, those are too thin for them.
///
/// # Errors
/// As [`draw`].
pub fn draw_with<S: Surface>(
    page: &mut S,
    table: &mut [EdgeSlot],
    ink: impl Fn(Ink) -> S::Color,
    thin: impl Fn(Ink) -> S::Color,
) -> Result<(), Error> {
    page.fill_window(ink(0));
    for (i, tile) in TILES.iter().enumerate() {
        let i = i as i32;
        let mut pen = Pen { page, table, ink: &ink, thin: &thin, at: (i % 5 * TILE.0, i / 5 * TILE.1) };
        // A generic function cannot stand in a table: the tiles are told apart by their names.
        match tile {
            Tile::Lines => pen.lines(),
            Tile::Triangles => pen.triangles(),
            Tile::Rectangles => pen.rectangles(),
            Tile::Circles => pen.circles(),
            Tile::Ellipses => pen.ellipses(),
            Tile::Arcs => pen.arcs(),
            Tile::Sectors => pen.sectors(),
            Tile::Rings => pen.rings(),
            Tile::Points => pen.points(),
            Tile::Star(rule) => pen.star(*rule)?,
            Tile::Holes => pen.holes()?,
            Tile::Quadratics => pen.quadratics(),
            Tile::Cubics => pen.cubics(),
            Tile::Heart => pen.heart()?,
            Tile::Widths => pen.widths()?,
            Tile::Joins => pen.joins()?,
            Tile::Dashes => pen.dashes()?,
            Tile::Triangulation => pen.triangulation()?,
            Tile::Maze => pen.maze(),
        }
    }
    Ok(())
}

/// A pixel in the maze, from which colour is poured.
pub const SEED: Point = Point::new(4 * TILE.0 + 32, 3 * TILE.1 + 4);

/// Pours colour into the maze, and sets glyphs down: these read pixels or memory, so they need the whole page at once.
///
/// # Errors
/// None, as the glyphs are as long as they say.
pub fn pour<F: PixelFormat>(
    page: &mut Framebuffer<'_, F>,
    table: &mut [FloodSlot],
    ink: impl Fn(Ink) -> F::Color,
) -> Result<(), Error> {
    page.flood_fill(SEED, Connectivity::Sides, table, ink(4));
    // The pixels of an outline are connected by their corners.
    page.flood_fill(Point::new(SEED.x, SEED.y - 2), Connectivity::Corners, table, ink(1));
    arrow(page, ink(2))
}

/// A glyph in the middle of the maze.
///
/// # Errors
/// None, as it is as long as it says.
pub fn arrow<S: Surface>(page: &mut S, color: S::Color) -> Result<(), Error> {
    let arrow = Bitmap::<Index1>::new(&[0x08, 0x0c, 0xfe, 0xff, 0xfe, 0x0c, 0x08], 8, 7)?;
    page.blit_mask(Point::new(SEED.x - 6, SEED.y + 23), &arrow, color, None);
    Ok(())
}

enum Tile {
    Lines,
    Triangles,
    Rectangles,
    Circles,
    Ellipses,
    Arcs,
    Sectors,
    Rings,
    Points,
    Star(FillRule),
    Holes,
    Quadratics,
    Cubics,
    Heart,
    Widths,
    Joins,
    Dashes,
    Triangulation,
    Maze,
}

#[rustfmt::skip]
const TILES: [Tile; 20] = [
    Tile::Lines, Tile::Triangles, Tile::Rectangles, Tile::Circles, Tile::Ellipses,
    Tile::Arcs, Tile::Sectors, Tile::Rings, Tile::Points, Tile::Star(FillRule::NonZero),
    Tile::Star(FillRule::EvenOdd), Tile::Holes, Tile::Quadratics, Tile::Cubics, Tile::Heart,
    Tile::Widths, Tile::Joins, Tile::Dashes, Tile::Triangulation, Tile::Maze,
];

/// Draws in a tile: all places count from its corner.
struct Pen<'a, S, I, T> {
    page: &'a mut S,
    table: &'a mut [EdgeSlot],
    ink: &'a I,
    thin: &'a T,
    at: (i32, i32),
}

impl<S: Surface, I: Fn(Ink) -> S::Color, T: Fn(Ink) -> S::Color> Pen<'_, S, I, T> {
    /// For an area.
    fn ink(&self, n: i32) -> S::Color {
        (self.ink)(1 + (n as u32 % 8) as Ink)
    }

    /// For a line or a point.
    fn thin(&self, n: i32) -> S::Color {
        (self.thin)(1 + (n as u32 % 8) as Ink)
    }

    fn pixel(&self, x: i32, y: i32) -> Point {
        Point::new(self.at.0 + x, self.at.1 + y)
    }

    /// A place in quarters of a pixel.
    fn place(&self, (x, y): (i32, i32)) -> PointFx {
        PointFx::from_bits((self.at.0 << 8) + (x << 6), (self.at.1 << 8) + (y << 6))
    }

    fn places<const N: usize>(&self, places: [(i32, i32); N]) -> [PointFx; N] {
        places.map(|place| self.place(place))
    }

    fn area(&self, x0: i32, y0: i32, x1: i32, y1: i32) -> Rect {
        Rect::new(self.at.0 + x0, self.at.1 + y0, self.at.0 + x1, self.at.1 + y1)
    }

    /// The same path with its corner at the tile's, in quarters of a pixel.
    fn path<const N: usize>(&self, segments: [PathSegment; N]) -> [PathSegment; N] {
        let here = |v: PointFx| self.place((v.x.to_bits(), v.y.to_bits()));
        segments.map(|segment| match segment {
            MoveTo(a) => MoveTo(here(a)),
            LineTo(a) => LineTo(here(a)),
            QuadraticTo(a, b) => QuadraticTo(here(a), here(b)),
            CubicTo(a, b, c) => CubicTo(here(a), here(b), here(c)),
            Close => Close,
        })
    }

    fn lines(&mut self) {
        for (i, (dx, dy)) in rim(27).into_iter().enumerate() {
            let (a, b) = (self.pixel(32 + dx / 6, 30 + dy / 6), self.pixel(32 + dx, 30 + dy));
            self.page.draw_line(a, b, self.thin(i as i32));
        }
    }

    /// A fan: every pixel once.
    fn triangles(&mut self) {
        let rim = rim(4 * 27);
        for i in 0..16 {
            let at = |i: usize| (128 + rim[i % 16].0, 120 + rim[i % 16].1);
            self.page.fill_triangle_fx(self.places([(129, 121), at(i), at(i + 1)]), self.ink(i as i32));
        }
    }

    fn rectangles(&mut self) {
        let [a, b] = self.places([(13, 14), (121, 101)]);
        self.page.fill_rectangle_fx(a, b, self.ink(0));
        self.page.fill_rounded(self.area(24, 8, 60, 34), Radii::all(7), self.ink(3));
        let radii = Radii { top_left: 0, top_right: 12, bottom_right: 4, bottom_left: 18 };
        self.page.draw_rounded(self.area(5, 20, 50, 56), radii, self.thin(5));
    }

    /// Odd and even diameters, outlines around what they enclose.
    fn circles(&mut self) {
        for (i, size) in [52, 43, 34, 25, 16, 7].into_iter().enumerate() {
            let area = self.area(32 - size / 2, 30 - size / 2, 32 - size / 2 + size, 30 - size / 2 + size);
            self.page.fill_outlined_ellipse(area, self.ink(i as i32 + 4));
            self.page.draw_ellipse(area, self.thin(i as i32));
        }
    }

    fn ellipses(&mut self) {
        for (i, (x, y, rx, ry)) in
            [(60, 50, 12, 10), (190, 60, 14, 4), (80, 170, 3, 15), (180, 180, 16, 10)].into_iter().enumerate()
        {
            let centre = self.place((x, y));
            self.page.fill_ellipse_fx(Ellipse::new(centre, px(rx), px(ry)), self.ink(i as i32));
        }
        self.page.draw_ellipse(self.area(2, 2, 62, 58), self.thin(6));
        self.page.draw_ellipse(self.area(2, 28, 62, 31), self.thin(7));
    }

    fn arcs(&mut self) {
        for i in 0..6 {
            let (inset, start) = (4 * i, 40 * i);
            let sector = Sector::new(Angle::degrees(start), Angle::degrees(start + 230));
            self.page.draw_arc(self.area(4 + inset, 2 + inset, 60 - inset, 58 - inset), sector, self.thin(i));
        }
    }

    fn sectors(&mut self) {
        let pie = Ellipse::in_box(self.area(4, 2, 60, 58));
        for (i, ends) in [0, 75, 120, 200, 230, 310, 360].windows(2).enumerate() {
            let sector = Sector::new(Angle::degrees(ends[0]), Angle::degrees(ends[1]));
            self.page.fill_sector_fx(pie, sector, self.ink(i as i32));
        }
    }

    fn rings(&mut self) {
        let ellipse = |inset| Ellipse::in_box(self.area(4 + inset, 2 + inset, 60 - inset, 58 - inset));
        let (outer, middle, inner) = (ellipse(0), ellipse(9), ellipse(18));
        for i in 0..8 {
            let sector = Sector::new(Angle::turns(i, 8), Angle::turns(i + 1, 8));
            self.page.fill_ring_sector_fx(outer, middle, sector, self.ink(i as i32));
        }
        self.page.fill_ring_fx(middle, inner, self.ink(2));
    }

    /// Of 1 to 8 pixels, in steps of a quarter.
    fn points(&mut self) {
        for i in 0..28 {
            let size = I24F8::from_bits(256 + 64 * i);
            let (round, square) =
                (self.place((16 + i % 7 * 34, 16 + i / 7 * 30)), self.place((16 + i % 7 * 34, 136 + i / 7 * 30)));
            self.page.fill_round_point_fx(round, size, self.thin(i));
            self.page.fill_square_point_fx(square, size, self.thin(i + 3));
        }
    }

    /// Every fifth of sixteen points of a circle.
    fn star(&mut self, rule: FillRule) -> Result<(), EdgeTableFull> {
        let rim = rim(4 * 28);
        let outline = core::array::from_fn::<_, 16, _>(|i| {
            let (x, y) = rim[i * 5 % 16];
            self.place((128 + x, 120 + y))
        });
        self.page.fill_polygon_fx(&outline, rule, self.table, self.ink(rule as i32 + 1))
    }

    fn holes(&mut self) -> Result<(), EdgeTableFull> {
        let outer = self.places([(20, 30), (236, 14), (220, 220), (120, 170), (24, 226)]);
        let window = self.places([(60, 50), (110, 50), (110, 110), (60, 110)]);
        let other = self.places([(140, 60), (200, 90), (150, 140)]);
        let contours: [&[PointFx]; 3] = [&outer, &window, &other];
        let color = self.ink(5);
        self.page.fill_contours_fx(contours.iter().map(|c| c.iter()), FillRule::EvenOdd, self.table, color)
    }

    fn quadratics(&mut self) {
        for i in 0..7 {
            let [a, c, b] = self.places([(16 + 10 * i, 228), (128, -140 + 60 * i), (240 - 10 * i, 228)]);
            self.page.draw_quadratic_fx([a, c, b], self.thin(i));
        }
    }

    /// An S, a cusp and a loop.
    fn cubics(&mut self) {
        let curves = [
            [(12, 60), (120, -60), (130, 180), (244, 50)],
            [(12, 160), (240, 60), (12, 60), (240, 160)],
            [(60, 230), (300, 100), (-50, 100), (190, 230)],
        ];
        for (i, curve) in curves.into_iter().enumerate() {
            self.page.draw_cubic_fx(self.places(curve), self.thin(2 * i as i32));
        }
    }

    fn heart(&mut self) -> Result<(), Error> {
        let v = PointFx::from_bits;
        let heart = self.path([
            MoveTo(v(128, 220)),
            CubicTo(v(-40, 110), v(40, -20), v(128, 60)),
            CubicTo(v(216, -20), v(296, 110), v(128, 220)),
            Close,
        ]);
        self.page.fill_path_fx(Path::new(&heart), FillRule::NonZero, self.table, self.ink(0))?;
        self.page.draw_path_fx(Path::new(&heart), self.thin(7));
        Ok(())
    }

    /// From one pixel to eight, all caps.
    fn widths(&mut self) -> Result<(), Error> {
        for i in 0..6 {
            let cap = [Cap::Butt, Cap::Square, Cap::Round][i as usize % 3];
            let stroke = Stroke::new(I24F8::from_bits(256 + 320 * i)).with_cap(cap);
            let ends = self.places([(24, 20 + 36 * i), (228, 8 + 40 * i)]);
            self.page.stroke_line_fx(ends, &stroke, self.table, self.thin(i))?;
        }
        Ok(())
    }

    fn joins(&mut self) -> Result<(), Error> {
        for (i, join) in [Join::Miter, Join::Bevel, Join::Round].into_iter().enumerate() {
            let y = 64 * i as i32;
            let zigzag = self.places([(20, 80 + y), (90, 30 + y), (120, 90 + y), (232, 40 + y)]);
            let stroke = Stroke::px(6).with_join(join);
            self.page.stroke_polyline_fx(&zigzag, false, &stroke, self.table, self.thin(2 * i as i32))?;
        }
        Ok(())
    }

    fn dashes(&mut self) -> Result<(), EdgeTableFull> {
        let v = PointFx::from_bits;
        let wave = self.path([MoveTo(v(16, 180)), CubicTo(v(90, -160), v(150, 380), v(240, 40))]);
        let pattern = [9, 5, 2, 5].map(px);
        let stroke = Stroke::px(3).with_cap(Cap::Round).dashed(&pattern, px(0));
        self.page.stroke_path_fx(Path::new(&wave), &stroke, self.table, self.thin(4))?;
        let [a, b] = self.places([(16, 224), (240, 224)]);
        let pattern = [4, 4].map(px);
        self.page.stroke_line_fx([a, b], &Stroke::px(2).dashed(&pattern, px(0)), self.table, self.thin(1))
    }

    /// A ring cut into triangles, which are made as regular as they can be.
    fn triangulation(&mut self) -> Result<(), Error> {
        let (outer, inner) = (rim(4 * 28), rim(4 * 11));
        let at = |(x, y): (i32, i32)| self.place((128 + x, 120 + y));
        let vertices = core::array::from_fn::<_, 24, _>(|i| at(if i < 16 { outer[i] } else { inner[(i - 16) * 2] }));
        let (mut nodes, mut triangles) = ([SideSlot::EMPTY; 26], [[0; 3]; 24]);
        let count = triangulate::list(&vertices, &[16], &mut nodes, &mut triangles)?;
        delaunay::refine(&vertices, &mut triangles[..count], &mut [[0; 3]; 24])?;
        for (i, triangle) in triangles[..count].iter().enumerate() {
            let corners = triangle.map(|n| vertices[usize::from(n)]);
            self.page.fill_triangle_fx(corners, self.ink(i as i32));
        }
        Ok(())
    }

    /// Walls between which colour is poured.
    fn maze(&mut self) {
        let color = self.thin(7);
        self.page.draw_ellipse(self.area(2, 2, 62, 58), color);
        for i in 1..6 {
            let inset = 4 * i;
            let area = self.area(2 + inset, 2 + inset, 62 - inset, 58 - inset);
            let gap = Sector::new(Angle::degrees(60 * i + 25), Angle::degrees(60 * i - 5));
            self.page.draw_arc(area, gap, color);
        }
    }
}

/// Sixteen points of a circle around (0, 0).
fn rim(radius: i32) -> [(i32, i32); 16] {
    core::array::from_fn(|i| {
        let (cos, sin) = Angle::turns(i as u32, 16).cos_sin();
        let part = |n: i32| ((i64::from(n) * i64::from(radius) + (1 << 29)) >> 30) as i32;
        (part(cos), part(sin))
    })
}
