//! The countries of the world: real contours with shared borders, an enclave, a lake between five neighbours, and a date line.

use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray8, Rgb888},
    prelude::{GrayColor, Point},
};
use embedded_raster::{
    buffer_bytes,
    paint::{Add, Cover},
    raster::coverage,
    surface::{Accumulator, Rows, Sum},
    Antialias, Canvas, ClippedSpan, CoverageSlot, EdgeSlot, EdgeTableFull, Error, FillRule, Frame, Framebuffer, Index1,
    Index4, Index8, PixelFormat, PointFx, Rect, Surface,
};
use embedded_raster_simulator::{
    world::{Depth, Layer, Map, Part, Place, Projection, Screen, World},
    Picture,
};
use twins::coverage::Levels;

use crate::pictures::compare;

const SIZES: [(u16, u16); 6] = [(16, 9), (160, 120), (320, 240), (480, 800), (720, 360), (1001, 777)];

/// Enough for the sides of all countries at once.
const ALL_EDGES: usize = 11_000;

fn map() -> Map {
    Map::parse(include_bytes!("../../assets/world-110m.txt")).expect("the map is well-formed")
}

fn screens() -> impl Iterator<Item = Screen> {
    let screen = |projection| SIZES.map(move |(width, height)| Screen { projection, width, height });
    Projection::ALL.into_iter().flat_map(screen)
}

/// Counts how often each pixel is painted.
struct Tally {
    window: Rect,
    times: Vec<u8>,
}

impl Tally {
    fn new(world: &World) -> Self {
        let window = world.window();
        Self { window, times: vec![0; (window.width() * window.height()) as usize] }
    }

    fn of(world: &World, rings: &[&[PointFx]], rule: FillRule) -> Self {
        let mut tally = Self::new(world);
        tally.add(rings, rule);
        tally
    }

    fn add(&mut self, rings: &[&[PointFx]], rule: FillRule) {
        let mut table = vec![EdgeSlot::EMPTY; ALL_EDGES];
        self.fill_contours_fx(rings.iter().copied(), rule, &mut table, BinaryColor::On)
            .expect("the table is large enough");
    }

    fn at(&self, p: Point) -> u8 {
        self.times[usize::try_from(p.y * self.window.x1 + p.x).expect("inside")]
    }
}

impl Surface for Tally {
    type Color = BinaryColor;

    fn window(&self) -> Rect {
        self.window
    }

    fn fill_span(&mut self, span: ClippedSpan, _: BinaryColor) {
        for x in span.x0()..span.x1() {
            self.times[usize::try_from(span.y() * self.window.x1 + x).expect("inside")] += 1;
        }
    }
}

fn rings(country: &[Vec<PointFx>]) -> Vec<&[PointFx]> {
    country.iter().map(Vec::as_slice).collect()
}

#[test]
fn every_land_pixel_belongs_to_one_country() {
    let map = map();
    for screen in screens() {
        let world = World::new(&map, screen);
        let mut owners = Tally::new(&world);
        for country in world.countries() {
            owners.add(&rings(country), FillRule::EvenOdd);
        }
        let shared = owners.times.iter().filter(|&&times| times > 1).count();
        assert_eq!(shared, 0, "pixels of several countries on {screen:?}");

        // All countries at once cover the same pixels: no gap between neighbours either.
        let all: Vec<_> = world.countries().iter().flatten().map(Vec::as_slice).collect();
        for rule in [FillRule::NonZero, FillRule::EvenOdd] {
            let union = Tally::of(&world, &all, rule);
            let differing = union.times.iter().zip(&owners.times).filter(|(a, b)| a != b).count();
            assert_eq!(differing, 0, "pixels by {rule:?} on {screen:?}");
        }
        let land = owners.times.iter().copied().map(u64::from).sum::<u64>();
        let mut table = vec![EdgeSlot::EMPTY; ALL_EDGES];
        let areas = world.areas(&mut table).expect("the table is large enough");
        assert_eq!(areas.iter().sum::<u64>(), land, "the sum of the areas on {screen:?}");
        assert!(world.globe(&mut table).expect("the table is large enough") > land, "sea is left on {screen:?}");
    }
}

#[test]
fn an_enclave_and_a_lake() {
    let map = map();
    let number = |name| map.countries.iter().position(|country| country.name == name).expect("it is on the map");
    for screen in screens().filter(|screen| screen.width >= 320) {
        let world = World::new(&map, screen);
        let owners_of = |lon, lat| {
            let pixel = screen.vertex(Place { lon, lat }).pixel();
            let owns =
                |country: &Vec<Vec<PointFx>>| Tally::of(&world, &rings(country), FillRule::EvenOdd).at(pixel) > 0;
            let all = world.countries().iter().enumerate();
            all.filter(|(_, country)| owns(country)).map(|(i, _)| i).collect::<Vec<_>>()
        };
        assert_eq!(owners_of(2825, -2950), [number("Lesotho")], "Lesotho lies in South Africa on {screen:?}");
        assert_eq!(owners_of(2450, -2950), [number("South Africa")], "around it on {screen:?}");
        assert_eq!(owners_of(5100, 4150), [0; 0], "the Caspian Sea lies between countries on {screen:?}");
    }
}

/// The map in one framebuffer, drawn with an edge table of `edges`.
fn whole<C: Depth>(world: &World, layer: Layer, edges: usize) -> Result<Vec<u8>, Error> {
    let Rect { x1, y1, .. } = world.window();
    let (width, height) = (u16::try_from(x1).expect("a screen"), u16::try_from(y1).expect("a screen"));
    let mut ram = vec![0; buffer_bytes::<C>(width, height)];
    let mut frame = Framebuffer::<C>::new(&mut ram, width, height)?;
    world.draw(&mut frame, &mut vec![EdgeSlot::EMPTY; edges], layer, C::ink)?;
    Ok(ram)
}

/// The same in bands of `rows` rows, one after the other in the same memory.
fn banded<C: Depth>(world: &World, layer: Layer, rows: u16, edges: usize) -> Result<Vec<u8>, Error> {
    let Rect { x1, y1, .. } = world.window();
    let (width, height) = (u16::try_from(x1).expect("a screen"), u16::try_from(y1).expect("a screen"));
    let mut ram = vec![0; buffer_bytes::<C>(width, rows)];
    let mut table = vec![EdgeSlot::EMPTY; edges];
    let mut sent = vec![];
    for start in (0..height).step_by(rows.into()) {
        let band = start..height.min(start + rows);
        let mut frame = Framebuffer::<C>::band(&mut ram, width, height, band.clone())?;
        world.draw(&mut frame, &mut table, layer, C::ink)?;
        sent.extend_from_slice(frame.row_bytes(band));
    }
    Ok(sent)
}

/// What each country covers of each pixel.
fn coverage_of(world: &World) -> Vec<Levels> {
    let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; 400], vec![0; 400]);
    let window = world.window();
    let mut levels = |country: &Vec<Vec<PointFx>>| {
        let mut levels = Levels::new(window);
        coverage::fill(country, FillRule::EvenOdd, &mut table, &mut cells, window, &mut levels).expect("enough slots");
        levels
    };
    world.countries().iter().map(&mut levels).collect()
}

/// With soft rims no pixel on a border is lighter than both of the countries that share it; painted one after the other, thousands are.
#[test]
fn soft_rims_leave_no_seams() {
    let map = map();
    for (width, height, projection) in [(320, 240, Projection::Miller), (217, 160, Projection::Robinson)] {
        let world = World::new(&map, Screen { projection, width, height });
        let (window, covered) = (world.window(), coverage_of(&world));
        // Darker than the ground, each country and its neighbours by another shade.
        let colors: Vec<u8> = map
            .colors(Part::LAND_COLORS)
            .into_iter()
            .map(|color| 40 + 16 * u8::try_from(color).expect("one of six"))
            .collect();
        let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; 400], vec![0; coverage::cells(width)]);
        let white = || Frame::<_, Rows<Gray8>>::new(vec![255; usize::from(width) * usize::from(height)], width, height);
        let (mut shown, mut painted) = (white().expect("enough memory"), white().expect("enough memory"));
        let mut memory = vec![Sum::EMPTY; usize::from(width) * usize::from(height)];
        let mut sums = Accumulator::new(&mut memory, window).expect("enough memory");
        for (rings, &grey) in world.countries().iter().zip(&colors) {
            let (rule, add) = (FillRule::EvenOdd, Add(Rgb888::new(grey, grey, grey)));
            sums.fill_contours_aa(rings, rule, &mut table, &mut cells, add).expect("enough slots");
            painted
                .fill_contours_aa(rings, rule, &mut table, &mut cells, Cover(Gray8::new(grey)))
                .expect("enough slots");
        }
        sums.show(&mut shown, Sum::over);
        let (mut borders, mut seams) = (0, [0, 0]);
        for (x, y) in (0..window.y1).flat_map(|y| (0..window.x1).map(move |x| (x, y))) {
            let here = || covered.iter().zip(&colors).filter(|(levels, _)| levels.at(x, y) > 0);
            let sum: u32 = here().map(|(levels, _)| u32::from(levels.at(x, y))).sum();
            if here().count() == 2 && sum >= 254 {
                borders += 1;
                let lightest = here().map(|(_, &grey)| grey).max().expect("two");
                for (seams, frame) in seams.iter_mut().zip([&shown, &painted]) {
                    *seams += usize::from(frame.get((x, y)).expect("a pixel").luma() > lightest);
                }
            }
        }
        println!("{width} x {height}: of {borders} pixels on borders, {seams:?} are lighter than both sides");
        assert!(borders > 800 && seams[0] == 0 && seams[1] > borders / 4, "{seams:?} of {borders}");
    }
}

/// Sums are of bands as well as of the screen; and what is shown is what it was.
#[test]
fn soft_rims_in_bands() {
    let (map, (width, height)) = (map(), (200, 150));
    let world = World::new(&map, Screen { projection: Projection::Robinson, width, height });
    let draw = |rows: u16| {
        let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; 400], vec![0; 50]);
        let mut memory = vec![Sum::EMPTY; usize::from(width) * usize::from(rows)];
        let mut ram = vec![0; buffer_bytes::<Rgb888>(width, rows)];
        let mut sent = vec![];
        for start in (0..height).step_by(rows.into()) {
            let band = start..height.min(start + rows);
            let mut frame = Framebuffer::<Rgb888>::band(&mut ram, width, height, band.clone()).expect("enough memory");
            let mut sums = Accumulator::new(&mut memory, frame.window()).expect("enough memory");
            world.add(&mut sums, &mut table, &mut cells).expect("enough slots");
            sums.show(&mut frame, Sum::over);
            sent.extend_from_slice(frame.row_bytes(band));
        }
        sent
    };
    let mut whole = draw(height);
    for rows in [1, 7, 64] {
        assert!(draw(rows) == whole, "{rows} rows");
    }
    let frame = Framebuffer::<Rgb888>::new(&mut whole, width, height).expect("enough memory");
    assert_eq!(compare("world-soft", &Picture::of(&frame)), None, "the picture");
}

#[test]
fn bands_give_the_same_bytes() {
    fn check<C: Depth>(world: &World) {
        for layer in Layer::ALL {
            let expected = whole::<C>(world, layer, ALL_EDGES);
            for rows in [1, 7, 16, 239, 240] {
                let bits = <C as PixelFormat>::BITS;
                assert!(banded::<C>(world, layer, rows, 500) == expected, "{rows} rows of {layer:?} at {bits} bits");
            }
        }
    }
    let map = map();
    for (projection, width) in [(Projection::Miller, 320), (Projection::Robinson, 317)] {
        let world = World::new(&map, Screen { projection, width, height: 240 });
        check::<Index1>(&world);
        check::<Index4>(&world);
        check::<Index8>(&world);
        check::<embedded_graphics::pixelcolor::Rgb888>(&world);
    }
}

#[test]
fn a_small_edge_table_draws_the_same_or_nothing() {
    let world = World::new(&map(), Screen { projection: Projection::Miller, width: 320, height: 240 });
    for layer in Layer::ALL {
        let expected = whole::<Index4>(&world, layer, ALL_EDGES);
        let (mut edges, mut too_small) = (0, 0);
        // Whenever a row needs more, as many as it says: the last table is the smallest that is enough.
        while let Err(Error::EdgeTable(EdgeTableFull { capacity, needed, .. })) = whole::<Index4>(&world, layer, edges)
        {
            assert!(capacity == edges && needed > edges, "{needed} are more than {capacity}");
            (edges, too_small) = (needed, edges);
        }
        assert!(too_small < edges && edges < 500, "{edges} edges of {layer:?}");
        for edges in [edges, edges + 1, edges + 50, 2 * edges] {
            assert!(whole::<Index4>(&world, layer, edges) == expected, "{edges} edges of {layer:?}");
        }
    }
}

#[test]
fn a_country_that_fails_paints_nothing() {
    let map = map();
    let world = World::new(&map, Screen { projection: Projection::Miller, width: 320, height: 240 });
    for (country, Place { lon, lat }) in world.countries().iter().zip(map.countries.iter().map(|c| c.rings[0][0])) {
        for edges in 0..40 {
            let mut tally = Tally::new(&world);
            let mut table = vec![EdgeSlot::EMPTY; edges];
            if tally.fill_contours_fx(country, FillRule::EvenOdd, &mut table, BinaryColor::On).is_ok() {
                break;
            }
            assert!(tally.times.iter().all(|&times| times == 0), "{edges} edges for the country at {lon},{lat}");
        }
    }
}
