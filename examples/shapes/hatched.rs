//! The page where there are only two colours: areas are told apart by patterns, lines and points are solid.
#![allow(unreachable_pub, reason = "firmwares have this as a module of a library")]

use embedded_graphics_core::geometry::Point;
use embedded_raster::{
    paint::{
        pattern::{self, Pattern},
        Paint,
    },
    raster::flood::{self, Connectivity, FloodSlot, FloodTarget},
    ClippedSpan, EdgeSlot, Error, Framebuffer, Index1, Index8, Octants, Rect, Steps, Surface,
};

use super::page;

const PAPER: Index1 = Index1::new(0);
const INK: Index1 = Index1::new(1);

/// Of the eight colours of areas.
const PATTERNS: [[u8; 8]; 8] = [
    pattern::DIAGONAL,
    pattern::CHECKER,
    pattern::DOTS,
    pattern::VERTICAL,
    // Darker than half: what is left is points.
    [0x77, 0xff, 0xdd, 0xff, 0x77, 0xff, 0xdd, 0xff],
    pattern::BACK_DIAGONAL,
    pattern::HORIZONTAL,
    pattern::BRICKS,
];

/// Draws everything but what pours.
///
/// # Errors
/// As [`page::draw`].
pub fn draw(page: &mut Framebuffer<'_, Index1>, table: &mut [EdgeSlot]) -> Result<(), Error> {
    page::draw_with(&mut Hatched(page), table, Index8::new, |_| Index8::new(SOLID))
}

/// Pours a pattern into the maze, and sets glyphs down.
///
/// # Errors
/// None, as the glyphs are as long as they say.
pub fn pour(page: &mut Framebuffer<'_, Index1>, table: &mut [FloodSlot]) -> Result<(), Error> {
    let mut basin = Basin { page, is_wet: [0; 60], rows: PATTERNS[3] };
    flood::fill(&mut basin, page::SEED, Connectivity::Sides, table);
    page::arrow(page, INK)
}

/// What is no pattern.
const SOLID: u8 = 9;

/// The page on a surface of two colours. Its own are 0 for the paper, 1 to 8 for patterns, and [`SOLID`].
struct Hatched<'a, S>(&'a mut S);

impl<S: Surface<Color = Index1>> Surface for Hatched<'_, S> {
    type Color = Index8;

    fn window(&self) -> Rect {
        self.0.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: Index8) {
        match (color.index(), PATTERNS.get(usize::from(color.index()).wrapping_sub(1))) {
            (0, _) => self.0.fill_span(span, PAPER),
            (_, None) => self.0.fill_span(span, INK),
            (_, Some(rows)) => Pattern::new(*rows, INK, Some(PAPER)).span(self.0, span),
        }
    }

    /// Lines are solid.
    fn fill_steps(&mut self, steps: Steps, _: Index8) {
        self.0.fill_steps(steps, INK);
    }

    /// Circles are lines, too.
    fn fill_octants(&mut self, octants: Octants, _: Index8) -> bool {
        self.0.fill_octants(octants, INK)
    }
}

/// The tile of the maze, and which of its pixels a pattern was poured on: the pattern itself does not tell.
struct Basin<'a, 'b> {
    page: &'a mut Framebuffer<'b, Index1>,
    /// A bit for each pixel of the tile, whose rows are 64 pixels wide.
    is_wet: [u64; 60],
    rows: [u8; 8],
}

impl Basin<'_, '_> {
    /// The top left corner of the tile.
    fn corner() -> Point {
        Point::new(page::SEED.x - 32, page::SEED.y - 4)
    }

    /// The bits of a span in the tile: `x0..x1` of a row.
    fn bits(x0: i32, x1: i32) -> u64 {
        let below = |x: i32| match u32::try_from(x - Self::corner().x).unwrap_or(0) {
            64.. => u64::MAX,
            n => (1 << n) - 1,
        };
        below(x1) & !below(x0)
    }

    fn row(y: i32) -> usize {
        usize::try_from(y - Self::corner().y).unwrap_or(0)
    }
}

impl FloodTarget for Basin<'_, '_> {
    fn window(&self) -> Rect {
        let Point { x, y } = Self::corner();
        Rect::new(x, y, x + 64, y + 60).intersection(self.page.window())
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        let wet = self.is_wet.get(Self::row(y)).is_none_or(|row| row & Self::bits(x, x + 1) != 0);
        !wet && self.page.get((x, y)) == Some(PAPER)
    }

    fn paint(&mut self, span: ClippedSpan) {
        let (row, bits) = (Self::row(span.y()), Self::bits(span.x0(), span.x1()));
        if let Some(wet) = self.is_wet.get_mut(row) {
            *wet |= bits;
        }
        Pattern::new(self.rows, INK, Some(PAPER)).span(self.page, span);
    }
}
