//! [`World`]: a map on its way to the screen.

use std::collections::BTreeSet;

use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
use embedded_raster::{
    paint::Add,
    surface::{Accumulator, Counter},
    Antialias, Canvas, CoverageSlot, EdgeSlot, EdgeTableFull, FillRule, PointFx, Rect, Surface,
};

use super::{Map, Part, Place, Screen};

/// What of the world is drawn.
#[derive(Copy, Clone, Debug, Default, PartialEq, Eq)]
pub enum Layer {
    /// Every country in a colour that its neighbours do not have, and the borders.
    #[default]
    Countries,
    /// Coasts and borders only.
    Borders,
    /// All countries as one shape of hundreds of contours, in one colour.
    Continents,
}

impl Layer {
    /// All there are.
    pub const ALL: [Self; 3] = [Self::Countries, Self::Borders, Self::Continents];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Self::Countries => "countries",
            Self::Borders => "borders",
            Self::Continents => "continents",
        }
    }
}

/// A map projected to a screen: the numbers that a firmware would keep in flash.
#[derive(Clone, Debug)]
pub struct World {
    screen: Screen,
    /// The rim of the globe.
    rim: Vec<PointFx>,
    /// Meridians and parallels.
    grid: Vec<Vec<Point>>,
    /// The rings of each country.
    countries: Vec<Vec<Vec<PointFx>>>,
    /// A colour for each country.
    colors: Vec<usize>,
    /// Lines of the coasts, then of the borders.
    lines: [Vec<[Point; 2]>; 2],
}

impl World {
    /// Projects a map to a screen.
    pub fn new(map: &Map, screen: Screen) -> Self {
        let project = |ring: &Vec<Place>| ring.iter().map(|&place| screen.vertex(place)).collect::<Vec<_>>();
        let countries = map.countries.iter().map(|country| country.rings.iter().map(project).collect()).collect();
        Self {
            screen,
            rim: project(&rim()),
            grid: grid().iter().map(|line| project(line).into_iter().map(PointFx::pixel).collect()).collect(),
            countries,
            colors: map.colors(Part::LAND_COLORS),
            lines: [true, false].map(|is_coast| lines(map, screen, is_coast)),
        }
    }

    /// Draws it: fills by the polygon filler, lines by Bresenham.
    ///
    /// * `table`: scratch memory for the edges of one country; a small one takes longer, but draws the same.
    /// * `ink`: what a part is painted with.
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a row of a country has more edges than `table`.
    pub fn draw<S: Surface>(
        &self,
        surface: &mut S,
        table: &mut [EdgeSlot],
        layer: Layer,
        ink: impl Fn(Part) -> S::Color,
    ) -> Result<(), EdgeTableFull> {
        surface.fill_window(ink(Part::Sea));
        for line in &self.grid {
            surface.draw_polyline(line.iter().copied(), ink(Part::Grid));
        }
        // The screen with the globe as a hole in it.
        surface.fill_contours_fx(
            [&self.screen.corners()[..], &self.rim],
            FillRule::EvenOdd,
            table,
            ink(Part::Paper),
        )?;
        match layer {
            Layer::Borders => {}
            Layer::Continents => {
                let rings = self.countries.iter().flatten();
                surface.fill_contours_fx(rings, FillRule::NonZero, table, ink(Part::Land { country: 0, color: 0 }))?;
                return Ok(());
            }
            Layer::Countries => {
                for (country, (rings, &color)) in self.countries.iter().zip(&self.colors).enumerate() {
                    // Even-odd: the ring of an enclave is a hole in the country around it, whichever way it turns.
                    surface.fill_contours_fx(rings, FillRule::EvenOdd, table, ink(Part::Land { country, color }))?;
                }
            }
        }
        for (lines, part) in self.lines.iter().zip([Part::Coast, Part::Border]) {
            for &[a, b] in lines {
                surface.draw_line(a, b, ink(part));
            }
        }
        Ok(())
    }

    /// Adds it to sums, with soft rims: what is in front comes first, and the sea fills what is left. Countries have no lines around them:
    /// they end where their neighbours begin.
    ///
    /// # Errors
    /// [`EdgeTableFull`] if a row touches more sides of a country than `table` holds.
    pub fn add(
        &self,
        sums: &mut Accumulator<'_>,
        table: &mut [CoverageSlot],
        cells: &mut [i32],
    ) -> Result<(), EdgeTableFull> {
        let corners = self.screen.corners();
        let paper = [&corners[..], &self.rim];
        sums.fill_contours_aa(paper, FillRule::EvenOdd, table, cells, Add(Part::Paper.rgb()))?;
        for (country, (rings, &color)) in self.countries.iter().zip(&self.colors).enumerate() {
            let paint = Add(Part::Land { country, color }.rgb());
            sums.fill_contours_aa(rings, FillRule::EvenOdd, table, cells, paint)?;
        }
        for line in &self.grid {
            for ends in line.windows(2) {
                let [a, b] = [ends[0], ends[1]].map(PointFx::centre_of);
                sums.draw_line_aa(a, b, Add(Part::Grid.rgb()));
            }
        }
        sums.fill_window(Part::Sea.rgb());
        Ok(())
    }

    /// The rings of each country on the screen.
    pub fn countries(&self) -> &[Vec<Vec<PointFx>>] {
        &self.countries
    }

    /// The pixels of the screen.
    pub fn window(&self) -> Rect {
        Rect::new(0, 0, self.screen.width.into(), self.screen.height.into())
    }

    /// How many pixels each country covers, borders not drawn.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub fn areas(&self, table: &mut [EdgeSlot]) -> Result<Vec<u64>, EdgeTableFull> {
        self.countries.iter().map(|rings| self.area(rings.iter(), table)).collect()
    }

    /// How many pixels the globe covers, land and sea.
    ///
    /// # Errors
    /// As [`draw`](Self::draw).
    pub fn globe(&self, table: &mut [EdgeSlot]) -> Result<u64, EdgeTableFull> {
        self.area([&self.rim].into_iter(), table)
    }

    fn area<'a>(
        &self,
        rings: impl Iterator<Item = &'a Vec<PointFx>> + Clone,
        table: &mut [EdgeSlot],
    ) -> Result<u64, EdgeTableFull> {
        let mut counter = Counter::new(self.window());
        counter.fill_contours_fx(rings, FillRule::EvenOdd, table, BinaryColor::On)?;
        Ok(counter.pixels)
    }
}

/// Sides of rings as lines between pixels, each once. What the map was cut at, the date line and the pole, is no border.
fn lines(map: &Map, screen: Screen, is_coast: bool) -> Vec<[Point; 2]> {
    let is_cut =
        |[a, b]: [Place; 2]| (a.lon == b.lon && a.lon.abs() == 18_000) || (a.lat == b.lat && a.lat.abs() == 9_000);
    let borders = map.borders().into_iter().filter(|border| border.is_coast == is_coast && !is_cut(border.ends));
    let lines = borders.map(|border| border.ends.map(|place| screen.vertex(place).pixel()));
    // At a small size many sides become the same line.
    lines
        .map(|[a, b]| [(a.x, a.y), (b.x, b.y)])
        .collect::<BTreeSet<_>>()
        .into_iter()
        .map(|ends| ends.map(Point::from))
        .collect()
}

/// The outline of the whole globe, from pole to pole and back.
fn rim() -> Vec<Place> {
    let side = |lon: i32| (-18..=18).map(move |i| Place { lon, lat: 500 * i * lon.signum() });
    side(18_000).chain(side(-18_000)).collect()
}

/// A meridian and a parallel every 30 degrees, as far as there is a next one on both sides.
fn grid() -> Vec<Vec<Place>> {
    let meridians = (-5..=5).map(|i| (-18..=18).map(|j| Place { lon: 3_000 * i, lat: 500 * j }).collect());
    let parallels = (-2..=2).map(|j| [-18_000, 18_000].map(|lon| Place { lon, lat: 3_000 * j }).to_vec());
    meridians.chain(parallels).collect()
}
