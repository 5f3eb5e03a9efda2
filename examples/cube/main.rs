//! A cube that turns with a spindle in it: lit, shaded from corner to corner, and hidden by depth.
//!
//! `cargo run --release --example cube` writes `cube.png` and shows it in the terminal; `-- --help` tells the rest. What is drawn
//! stands in `scene.rs`, which chips draw too: a Cortex-M0+ with 16 kB of RAM in bands of 16 rows.

mod scene;

use std::{cell::Cell, error::Error, process::ExitCode};

use embedded_graphics::{
    pixelcolor::{BinaryColor, Gray2, Gray4, Gray8, GrayColor, PixelColor, Rgb565, Rgb888},
    prelude::Point,
};
use embedded_raster::{
    buffer_bytes,
    geom::{Mix, Varying},
    paint::Bayer,
    pipeline::Pipeline,
    pixel::{row_bytes, Depth16, Xrgb8888},
    surface::DepthBuffer,
    Angle, Framebuffer, PixelFormat,
};
use embedded_raster_simulator::{show, Key, Picture, Shot};
use scene::{Scene, BACKGROUND, HEIGHT, WIDTH};

const USAGE: &str = "\
usage: cube [--bits 1|2|4|8|16|24|32] [--size WxH] [--frames N] [--band ROWS] [--out FILE.png] [--window]

--bits        of a pixel: 16 unless told. 1, 2, 4 and 8 are levels of grey, the first three dithered
--size WxH    160x128 unless told, at most 4096x4096
--frames N    as many pictures of one turn, in FILE-0.png, FILE-1.png ... if there are more than one
--band ROWS   draws the screen in bands of that many rows: the same picture with less memory
--out FILE    where the picture goes: cube.png unless told
--window      shows it: D changes the depth of colours, the space bar stops and goes on, Esc quits";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("cube: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let Some(options) = Options::from_command_line()? else {
        println!("{USAGE}");
        return Ok(());
    };
    if options.window {
        return watch(options);
    }
    for number in 0..options.frames {
        let drawing = draw(&options, options.turn(number))?;
        let path = options.path(number);
        drawing.picture.write_png(&path)?;
        if number == 0 {
            drawing.picture.show(100);
            let (width, height) = options.size;
            let plural = if options.bits == 1 { "" } else { "s" };
            println!("{width} x {height} at {} bit{plural} per pixel", options.bits);
            let [colors, depths, vertices] = drawing.memory;
            println!("RAM in bytes: {colors} of colours, {depths} of depths, {vertices} of vertices");
        }
        println!("{path}: fragments painted: {}", drawing.fragments);
    }
    Ok(())
}

/// What was drawn.
struct Drawing {
    picture: Picture,
    /// Bytes of colours and of depths, of a band if there are bands; and of the scene.
    memory: [usize; 3],
    /// Pixels that passed the depth test.
    fragments: u64,
}

/// Draws at the depth that was asked for.
fn draw(options: &Options, turn: Angle) -> Result<Drawing, embedded_raster::Error> {
    let dithered = |at: Point, level: u8, most: u8| Bayer::<4>::shade(level, most, at);
    let gray = |color: Rgb888| Gray8::from(color).luma();
    match options.bits {
        1 => draw_as(options, turn, gray, |at, level| BinaryColor::from(dithered(at, level, 1) > 0)),
        2 => draw_as(options, turn, gray, |at, level| Gray2::new(dithered(at, level, 3))),
        4 => draw_as(options, turn, gray, |at, level| Gray4::new(dithered(at, level, 15))),
        8 => draw_as(options, turn, gray, |_, level| Gray8::new(level)),
        16 => draw_as(options, turn, Rgb565::from, |_, color| color),
        24 => draw_as(options, turn, |color| color, |_, color| color),
        _ => draw_as(options, turn, Xrgb8888::from, |_, color| color),
    }
}

/// Draws band by band; without `--band`, the whole screen is the only one.
fn draw_as<V, C>(
    options: &Options,
    turn: Angle,
    value: impl Fn(Rgb888) -> V,
    color: impl Fn(Point, V) -> C,
) -> Result<Drawing, embedded_raster::Error>
where
    V: Varying + Mix,
    C: PixelFormat<Color = C> + PixelColor + Into<Rgb888>,
{
    let (width, height) = options.size;
    let rows = options.band.unwrap_or(height).clamp(1, height);
    let (mut ram, mut depth_ram) =
        (vec![0; buffer_bytes::<C>(width, rows)], vec![0; 2 * usize::from(width) * usize::from(rows)]);
    let scene = Scene::new(Pipeline::new(width, height)?, [width, height], turn, &value);
    let background = color(Point::new(3, 0), value(BACKGROUND));
    let fragments = Cell::new(0);
    // What a display would have received: each band is sent before the next one is drawn in the same memory.
    let mut screen = Vec::with_capacity(buffer_bytes::<C>(width, height));
    for start in (0..height).step_by(rows.into()) {
        let end = height.min(start.saturating_add(rows));
        let mut frame = Framebuffer::<C>::band(&mut ram, width, height, start..end)?;
        let mut depths = DepthBuffer::<Depth16>::band(&mut depth_ram, width, height, start..end)?;
        scene.draw(&mut frame, &mut depths, background, |at, value| {
            fragments.set(fragments.get() + 1);
            color(at, value)
        });
        screen.extend_from_slice(frame.row_bytes(start..end));
    }
    let picture = Picture::of(&Framebuffer::<C>::new(&mut screen, width, height)?);
    let colors = row_bytes::<C>(width) * usize::from(rows);
    Ok(Drawing { picture, memory: [colors, depth_ram.len(), size_of_val(&scene)], fragments: fragments.get() })
}

/// Shows it turning in a window, and does what the keys say.
fn watch(mut options: Options) -> Result<(), Box<dyn Error>> {
    // Six seconds for a turn.
    const STEP: Angle = Angle::turns(1, 360);
    let (mut turn, mut is_turning) = (Angle::default(), true);
    let first = shoot(&options, turn)?;
    show::<Box<dyn Error>>("cube", first, |keys| {
        for key in keys {
            match key {
                Key::D => options.bits = next_depth(options.bits),
                Key::Space => is_turning = !is_turning,
                _ => {}
            }
        }
        if is_turning {
            turn += STEP;
        }
        (is_turning || !keys.is_empty()).then(|| shoot(&options, turn)).transpose()
    })
    .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)").into())
}

/// What the window shows, and what its title says of it.
fn shoot(options: &Options, turn: Angle) -> Result<Shot, Box<dyn Error>> {
    let Drawing { picture, memory, fragments } = draw(options, turn)?;
    Ok(Shot { picture, caption: format!("{} bits", options.bits), ram: memory.iter().sum(), drawn: fragments })
}

/// Depths of colours that there are.
const DEPTHS: [u32; 7] = [1, 2, 4, 8, 16, 24, 32];

fn next_depth(bits: u32) -> u32 {
    let at = DEPTHS.iter().position(|&one| one == bits).unwrap_or(0);
    DEPTHS[(at + 1) % DEPTHS.len()]
}

struct Options {
    bits: u32,
    size: (u16, u16),
    frames: u16,
    band: Option<u16>,
    out: String,
    window: bool,
}

impl Options {
    /// `None` if help was asked for.
    fn from_command_line() -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options =
            Self { bits: 16, size: (WIDTH, HEIGHT), frames: 1, band: None, out: "cube.png".into(), window: false };
        let mut arguments = lexopt::Parser::from_env();
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("bits") => options.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("size") => options.size = arguments.value()?.parse_with(parse_size)?,
                Long("frames") => options.frames = arguments.value()?.parse_with(parse_frames)?,
                Long("band") => options.band = Some(arguments.value()?.parse_with(parse_rows)?),
                Long("out" | "output") => options.out = arguments.value()?.string()?,
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }

    /// How far the scene has turned in a frame. The first one is not seen straight from a side.
    fn turn(&self, number: u16) -> Angle {
        Angle::degrees(30) + Angle::turns(number.into(), self.frames)
    }

    /// Where a frame goes.
    fn path(&self, number: u16) -> String {
        match self.out.strip_suffix(".png") {
            Some(name) if self.frames > 1 => format!("{name}-{number}.png"),
            None if self.frames > 1 => format!("{}-{number}", self.out),
            _ => self.out.clone(),
        }
    }
}

fn parse_bits(text: &str) -> Result<u32, &'static str> {
    text.parse().ok().filter(|bits| DEPTHS.contains(bits)).ok_or("one of 1, 2, 4, 8, 16, 24, 32")
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let sides = 1..=4096;
    size.filter(|(w, h)| sides.contains(w) && sides.contains(h)).ok_or("WIDTHxHEIGHT, from 1x1 to 4096x4096")
}

fn parse_frames(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&frames| frames > 0).ok_or("a number from 1 to 65535")
}

fn parse_rows(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&rows| rows > 0).ok_or("rows from 1 to 65535")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Bands of any height show the whole, at every depth and many angles.
    #[test]
    fn bands_are_the_whole() {
        for (i, bits) in (0..).zip(DEPTHS) {
            let turn = Angle::turns(i, 7);
            let options = |band| Options { bits, size: (80, 64), frames: 1, band, out: String::new(), window: false };
            let whole = draw(&options(None), turn).unwrap();
            assert!(whole.fragments > 500, "{} fragments", whole.fragments);
            for rows in [1, 16, 23, 32] {
                let bands = draw(&options(Some(rows)), turn).unwrap();
                assert!(bands.picture == whole.picture, "{bits} bits in bands of {rows} rows");
                assert_eq!(bands.fragments, whole.fragments, "{bits} bits in bands of {rows} rows");
            }
        }
    }

    /// Cube and spindle are seen from outside, from every side: no pixel of the cube's middle shows the background.
    #[test]
    fn the_bodies_are_closed() {
        for i in 0..32 {
            let options =
                Options { bits: 24, size: (80, 64), frames: 1, band: None, out: String::new(), window: false };
            let Drawing { picture, .. } = draw(&options, Angle::turns(i, 32)).unwrap();
            for (x, y) in (30..50).flat_map(|x| (22..42).map(move |y| (x, y))) {
                assert_ne!(picture.color(x, y), Some(BACKGROUND), "{x}, {y} at {i} of 32");
            }
        }
    }
}
