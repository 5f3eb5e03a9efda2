//! The countries of the world in a framebuffer of 320 x 240 pixels at 4 bits each: 38,400 bytes.
//!
//! `cargo run --release --example world_map` writes `world_map.png` and shows it in the terminal; `-- --help` tells the rest.
//! How a country is drawn stands in `simulator/src/world/scene.rs`: a call of `fill_contours`, and `draw_line` for borders.

use std::{cmp::Reverse, error::Error, fs, process::ExitCode};

use embedded_graphics::pixelcolor::{Rgb565, Rgb888};
use embedded_raster::{
    buffer_bytes,
    pixel::{row_bytes, Channels, Xrgb8888},
    raster::coverage,
    surface::{Accumulator, Counter, Sum},
    CoverageSlot, EdgeSlot, Framebuffer, Index1, Index2, Index4, Index8,
};
use embedded_raster_simulator::{
    finish, show,
    world::{Depth, Layer, Map, Projection, Screen, World},
    Key, Picture, Shot,
};

const USAGE: &str = "\
usage: world_map [--bits 1|2|4|8|16|24|32] [--size WxH] [--projection equirectangular|robinson|miller]
                 [--antialias] [--band ROWS] [--input FILE] [--out FILE.png] [--window]

--antialias        soft rims, at 16, 24 or 32 bits: what countries cover of a pixel is added up, so there is no seam between them
--band ROWS        draws the screen in bands of that many rows: the same picture with less memory
--input FILE       another map: `country NAME`, then lines `ring X,Y X,Y ...` in hundredths of a degree
--out FILE.png     where the picture goes; world_map.png unless told
--window           shows it: D depth, P projection, L layer, C cycles the palette, Esc quits";

/// Edges of the scratch table, at 32 bytes each. No row crosses more than 24 of one country and 80 of all together; where a
/// whole shape has more, the filler works on fewer rows at a time.
const EDGES: usize = 80;

/// Sides that touch a row of one country, at 44 bytes each.
const TOUCHED: usize = 120;

fn main() -> ExitCode {
    finish("world_map", run(lexopt::Parser::from_env()))
}

/// Does what the arguments say, and returns what there is to say of it.
fn run(arguments: lexopt::Parser) -> Result<String, Box<dyn Error>> {
    let Some(options) = Options::parse(arguments)? else {
        return Ok(format!("{USAGE}\n"));
    };
    let map = match &options.input {
        None => Map::parse(include_bytes!("../assets/world-110m.txt"))?,
        Some(path) => fs::read(path)
            .map_err(|error| format!("{path}: {error}"))
            .and_then(|text| Map::parse(&text).map_err(|error| format!("{path}: {error}")))?,
    };
    if options.window {
        return watch(&map, options);
    }
    let world = World::new(&map, options.screen);
    let drawing = draw(&world, &options, 0)?;
    drawing.picture.write_png(&options.output)?;
    drawing.picture.show(100);
    report(&map, &world, &options, &drawing)
}

/// A drawn map.
struct Drawing {
    picture: Picture,
    /// Bytes of the framebuffer, or of a band of it.
    memory: usize,
    /// Pixels written, counted anew each time.
    pixels: u64,
}

/// Draws at the depth that was asked for.
fn draw(world: &World, options: &Options, turns: usize) -> Result<Drawing, embedded_raster::Error> {
    match (options.antialias, options.bits) {
        (true, 24) => return draw_softly::<Rgb888>(world, options),
        (true, 32) => return draw_softly::<Xrgb8888>(world, options),
        (true, _) => return draw_softly::<Rgb565>(world, options),
        (false, _) => {}
    }
    match options.bits {
        1 => draw_as::<Index1>(world, options, turns),
        2 => draw_as::<Index2>(world, options, turns),
        4 => draw_as::<Index4>(world, options, turns),
        8 => draw_as::<Index8>(world, options, turns),
        16 => draw_as::<Rgb565>(world, options, turns),
        24 => draw_as::<Rgb888>(world, options, turns),
        _ => draw_as::<Xrgb8888>(world, options, turns),
    }
}

/// Draws band by band; without `--band`, the whole screen is the only one.
fn draw_as<C: Depth>(world: &World, options: &Options, turns: usize) -> Result<Drawing, embedded_raster::Error> {
    let Screen { width, height, .. } = options.screen;
    let rows = options.band.unwrap_or(height).clamp(1, height.max(1));
    let mut table = [EdgeSlot::EMPTY; EDGES];
    let mut ram = vec![0; buffer_bytes::<C>(width, rows)];
    // What a display would have received: each band is sent before the next one is drawn in the same memory.
    let mut screen = Vec::with_capacity(buffer_bytes::<C>(width, height));
    for start in (0..height).step_by(rows.into()) {
        let end = height.min(start.saturating_add(rows));
        let mut frame = Framebuffer::<C>::band(&mut ram, width, height, start..end)?;
        world.draw(&mut frame, &mut table, options.layer, C::ink)?;
        screen.extend_from_slice(frame.row_bytes(start..end));
    }
    let mut counter = Counter::new(world.window());
    world.draw(&mut counter, &mut table, options.layer, C::ink)?;
    let frame = Framebuffer::<C>::new(&mut screen, width, height)?;
    Ok(Drawing {
        picture: C::picture(&frame, turns),
        memory: row_bytes::<C>(width) * usize::from(rows),
        pixels: counter.pixels,
    })
}

/// Draws band by band with soft rims: all that a pixel has is added up, and then written, once.
fn draw_softly<C: Depth + Channels>(world: &World, options: &Options) -> Result<Drawing, embedded_raster::Error> {
    let Screen { width, height, .. } = options.screen;
    let rows = options.band.unwrap_or(height).clamp(1, height.max(1));
    let mut table = [CoverageSlot::EMPTY; TOUCHED];
    let mut cells = vec![0; coverage::cells(width)];
    let mut memory = vec![Sum::EMPTY; usize::from(width) * usize::from(rows)];
    let mut ram = vec![0; buffer_bytes::<C>(width, rows)];
    let mut screen = Vec::with_capacity(buffer_bytes::<C>(width, height));
    for start in (0..height).step_by(rows.into()) {
        let end = height.min(start.saturating_add(rows));
        let mut frame = Framebuffer::<C>::band(&mut ram, width, height, start..end)?;
        let mut sums = Accumulator::new(&mut memory, frame.window())?;
        world.add(&mut sums, &mut table, &mut cells)?;
        sums.show(&mut frame, Sum::over);
        screen.extend_from_slice(frame.row_bytes(start..end));
    }
    let frame = Framebuffer::<C>::new(&mut screen, width, height)?;
    Ok(Drawing {
        picture: C::picture(&frame, 0),
        memory: row_bytes::<C>(width) * usize::from(rows) + size_of_val(&memory[..]),
        pixels: u64::from(width) * u64::from(height),
    })
}

/// Says what it took and what was covered.
fn report(map: &Map, world: &World, options: &Options, drawing: &Drawing) -> Result<String, Box<dyn Error>> {
    let Screen { projection, width, height } = options.screen;
    let mut table = [EdgeSlot::EMPTY; EDGES];
    let (areas, globe) = (world.areas(&mut table)?, world.globe(&mut table)?);
    let land: u64 = areas.iter().sum();
    let vertices: usize = map.countries.iter().flat_map(|country| &country.rings).map(Vec::len).sum();
    let what = if options.band.is_some() { "band" } else { "framebuffer" };
    let mut sizes: Vec<_> = areas.iter().zip(map.countries.iter().map(|country| &country.name)).collect();
    sizes.sort_unstable_by_key(|&(&area, name)| (Reverse(area), name));
    let (seen, unseen) = sizes.split_at(sizes.partition_point(|(&area, _)| area > 0));
    let sized = |&(area, name): &(&u64, &String)| format!("{name} {area}");
    let bits = counted(options.bits as usize, "bit", "bits");
    let (countries, vertices) = (counted(areas.len(), "country", "countries"), counted(vertices, "vertex", "vertices"));
    let lines = [
        format!("{}: {width} x {height} at {bits} per pixel, {} projection", options.output, projection.name()),
        format!("RAM: {} bytes of {what}, {} of edge table", drawing.memory, size_of_val(&table)),
        format!("drawn: {countries}, {vertices}, {} pixels written", drawing.pixels),
        format!("covered: {land} pixels of land, {} of sea", globe.saturating_sub(land)),
        format!("largest: {}", listed(seen.iter().take(3).map(sized))),
        format!("smallest: {}", listed(seen.iter().rev().take(3).map(sized))),
        format!("without a pixel: {}", listed(unseen.iter().map(|&(_, name)| name.clone()))),
    ];
    Ok(lines.map(|line| line + "\n").concat())
}

fn counted(n: usize, one: &str, many: &str) -> String {
    format!("{n} {}", if n == 1 { one } else { many })
}

fn listed(names: impl Iterator<Item = String>) -> String {
    let names: Vec<_> = names.collect();
    if names.is_empty() {
        return "none".into();
    }
    names.join(", ")
}

/// Shows the map in a window, and does what the keys say.
fn watch(map: &Map, mut options: Options) -> Result<String, Box<dyn Error>> {
    let (mut turns, mut ticks, mut is_cycling) = (0, 0_u32, false);
    let first = shoot(map, &options, turns)?;
    show::<Box<dyn Error>>("world map", first, |keys| {
        let mut is_new = false;
        for key in keys {
            match key {
                Key::D => options.bits = next(&[1, 2, 4, 8, 16, 24, 32], options.bits),
                Key::P => options.screen.projection = next(&Projection::ALL, options.screen.projection),
                Key::L => options.layer = next(&Layer::ALL, options.layer),
                Key::C => is_cycling = !is_cycling,
                _ => continue,
            }
            is_new = true;
        }
        ticks = ticks.wrapping_add(1);
        if is_cycling && ticks % 10 == 0 {
            turns += 1;
            is_new = true;
        }
        is_new.then(|| shoot(map, &options, turns)).transpose()
    })
    .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)"))?;
    Ok(String::new())
}

/// What the window shows, and what its title says of it.
fn shoot(map: &Map, options: &Options, turns: usize) -> Result<Shot, Box<dyn Error>> {
    let Drawing { picture, memory: ram, pixels: drawn } = draw(&World::new(map, options.screen), options, turns)?;
    let bits = counted(options.bits as usize, "bit", "bits");
    let caption = format!("{bits}, {}, {}", options.screen.projection.name(), options.layer.name());
    Ok(Shot { picture, caption, ram, drawn })
}

/// The one after `current`, the first one after the last.
fn next<T: Copy + PartialEq>(all: &[T], current: T) -> T {
    let at = all.iter().position(|&one| one == current).unwrap_or(0);
    all[(at + 1) % all.len()]
}

struct Options {
    /// 0 until told.
    bits: u32,
    screen: Screen,
    layer: Layer,
    antialias: bool,
    band: Option<u16>,
    input: Option<String>,
    output: String,
    window: bool,
}

impl Options {
    /// `None` if help was asked for.
    fn parse(mut arguments: lexopt::Parser) -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let screen = Screen { projection: Projection::default(), width: 320, height: 240 };
        let output = "world_map.png".into();
        let mut options = Self {
            bits: 0,
            screen,
            layer: Layer::Countries,
            antialias: false,
            band: None,
            input: None,
            output,
            window: false,
        };
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("bits") => options.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("antialias") => options.antialias = true,
                Long("size") => {
                    (options.screen.width, options.screen.height) = arguments.value()?.parse_with(parse_size)?;
                }
                Long("projection") => options.screen.projection = arguments.value()?.parse_with(parse_projection)?,
                Long("band") => options.band = Some(arguments.value()?.parse_with(parse_rows)?),
                Long("input") => options.input = Some(arguments.value()?.string()?),
                Long("out" | "output") => options.output = arguments.value()?.string()?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        match (options.antialias, options.bits) {
            (antialias, 0) => options.bits = if antialias { 16 } else { 4 },
            (true, bits @ ..16) => {
                let error = format!("--antialias mixes colours, so it takes --bits 16, 24 or 32, not {bits}");
                return Err(lexopt::Error::Custom(error.into()));
            }
            _ => {}
        }
        Ok(Some(options))
    }
}

fn parse_bits(text: &str) -> Result<u32, &'static str> {
    let bits = text.parse().ok().filter(|bits| [1, 2, 4, 8, 16, 24, 32].contains(bits));
    bits.ok_or("--bits takes one of 1, 2, 4, 8, 16, 24, 32")
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    // Every depth draws as many in some hundred megabytes.
    let fits = |&(w, h): &(u16, u16)| w > 0 && h > 0 && u32::from(w) * u32::from(h) <= 1 << 25;
    size.filter(fits).ok_or("--size takes WIDTHxHEIGHT, each from 1 to 65535, together at most 33554432 pixels")
}

fn parse_rows(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&rows| rows > 0).ok_or("--band takes rows from 1 to 65535")
}

fn parse_projection(text: &str) -> Result<Projection, &'static str> {
    let found = Projection::ALL.into_iter().find(|projection| projection.name() == text);
    found.ok_or("--projection takes equirectangular, robinson or miller")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn wrong_arguments_are_told_in_a_line() {
        let size = "--size takes WIDTHxHEIGHT, each from 1 to 65535, together at most 33554432 pixels";
        for (arguments, expected) in [
            ("--size 0x0", &format!(r#"cannot parse argument "0x0": {size}"#)[..]),
            ("--size 65535x65535", &format!(r#"cannot parse argument "65535x65535": {size}"#)),
            ("--size 65536x1", &format!(r#"cannot parse argument "65536x1": {size}"#)),
            ("--band 0", r#"cannot parse argument "0": --band takes rows from 1 to 65535"#),
            ("--band 65536", r#"cannot parse argument "65536": --band takes rows from 1 to 65535"#),
            ("--bits 3", r#"cannot parse argument "3": --bits takes one of 1, 2, 4, 8, 16, 24, 32"#),
            ("--bits 4 --antialias", "--antialias mixes colours, so it takes --bits 16, 24 or 32, not 4"),
            ("--projection mercator", r#"cannot parse argument "mercator": --projection takes equirectangular,"#),
            ("--input", "missing argument for option '--input'"),
            ("map.txt", r#"unexpected argument "map.txt""#),
            ("--input no-such-file.txt", "no-such-file.txt: "),
            ("--input assets/paint-demo.txt", "assets/paint-demo.txt: line 4: `palette` is neither"),
            ("--out /no/such/folder/x.png", "/no/such/folder/x.png: "),
        ] {
            let error = run(lexopt::Parser::from_args(arguments.split(' '))).expect_err(arguments).to_string();
            assert!(error.starts_with(expected) && !error.contains('\n'), "{arguments}: {error}");
        }
        let help = run(lexopt::Parser::from_args(["--help"])).expect("help");
        assert!(help.starts_with("usage: world_map"), "{help}");
    }
}
