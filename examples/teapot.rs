//! M. Newell's teapot, or any OBJ file, through the 3D pipeline: 320 x 240 pixels with a depth buffer, in 307,200 bytes.
//!
//! `cargo run --release --example teapot` writes `teapot.png` and shows it in the terminal; `-- --help` tells the rest.
//! How it is drawn stands in `simulator/src/teapot/scene.rs`: a vertex stage and a fragment stage for each view.

use std::{
    error::Error,
    fs,
    io::{self, ErrorKind, Write},
    process::ExitCode,
};

use embedded_graphics::prelude::Point;
use embedded_raster::Angle;
use embedded_raster_simulator::{
    film,
    teapot::{draw, Camera, Drawing, Mesh, Patches, View},
    watch, Event, Key, Picture, Shot,
};
use fixed::types::I16F16;
use indicatif::{ProgressBar, ProgressStyle};

const USAGE: &str = "\
usage: teapot [--input FILE] [--view wire|flat|gouraud|textured|depth|id|normal|barycentric|overdraw]
              [--size WxH] [--bits 1|2|4|8|16|24|32] [--frames N] [--band ROWS] [--out FILE.png|.apng|.gif] [--window]

--input FILE  an OBJ file; the teapot of 32 patches unless told
--view VIEW   what is shown of it: gouraud
--size WxH    size of the picture: 320x240, at most 4096x4096
--bits BITS   depth of the picture: 16. Up to 4 bits are dithered, 8 bits are grey
--frames N    a whole turn in so many pictures: 1
--band ROWS   draws in bands of that many rows: the same picture with less memory
--out FILE    where the pictures go; teapot.png unless told
--window      shows it: arrows or the mouse turn it, + and - change the distance, Space pauses, V changes the view,
              D the depth, Esc quits";

fn main() -> ExitCode {
    match run() {
        Ok(()) => ExitCode::SUCCESS,
        // Who reads the output has heard enough.
        Err(error) if error.downcast_ref::<io::Error>().is_some_and(|error| error.kind() == ErrorKind::BrokenPipe) => {
            ExitCode::SUCCESS
        }
        Err(error) => {
            _ = writeln!(io::stderr(), "teapot: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> Result<(), Box<dyn Error>> {
    let Some(mut options) = Options::from_command_line()? else {
        writeln!(io::stdout(), "{USAGE}")?;
        return Ok(());
    };
    let body = Body::load(options.input.as_deref())?;
    if let Body::Patches(_) = body {
        // A teapot is wider than high, and stays so when it turns.
        options.camera.zoom = I16F16::from_num(1.25);
    }
    if options.window {
        return open(&body, options);
    }
    let drawings = write(&body, &options)?;
    report(&options, &drawings)
}

/// What is shown.
enum Body {
    Patches(Patches),
    Mesh(Mesh),
}

impl Body {
    fn load(input: Option<&str>) -> Result<Self, Box<dyn Error>> {
        let Some(path) = input else {
            return Ok(Self::Patches(Patches::parse(include_str!("../assets/teapot-patches.txt"))?));
        };
        let mesh = fs::read(path)
            .map_err(|error| format!("{path}: {error}"))
            .and_then(|text| Mesh::parse_obj(&text).map_err(|error| format!("{path}: {error}")))?;
        Ok(Self::Mesh(mesh))
    }

    /// Its triangles: of patches as fine as the picture asks for.
    fn mesh(&self, options: &Options) -> Mesh {
        match self {
            Self::Patches(patches) => patches.mesh(options.camera.tolerance(options.view)),
            Self::Mesh(mesh) => mesh.clone(),
        }
    }
}

/// Draws a picture.
fn shoot(mesh: &Mesh, options: &Options) -> Result<Drawing, embedded_raster::Error> {
    draw(options.bits, mesh, options.view, &options.camera, options.band)
}

/// What writing took.
struct Totals {
    last: Drawing,
    fragments: u64,
}

/// Draws and writes all pictures.
fn write(body: &Body, options: &Options) -> Result<Totals, Box<dyn Error>> {
    let (mesh, count) = (body.mesh(options), options.frames);
    let bar = if count > 1 { progress(count) } else { ProgressBar::hidden() };
    let (mut last, mut fragments) = (None, 0);
    let next = |number: u16| -> Result<Picture, Box<dyn Error>> {
        let mut camera = options.camera;
        camera.yaw += Angle::turns(number.into(), count);
        let drawing = draw(options.bits, &mesh, options.view, &camera, options.band)?;
        fragments += drawing.fragments;
        bar.inc(1);
        let picture = drawing.picture.clone();
        last = Some(drawing);
        Ok(picture)
    };
    let bytes = match options.kind {
        Kind::Png => film::apng(count, next)?,
        Kind::Gif => film::gif(count, next)?,
    };
    bar.finish_and_clear();
    fs::write(&options.out, bytes).map_err(|error| format!("{}: {error}", options.out))?;
    Ok(Totals { last: last.ok_or("no pictures")?, fragments })
}

/// A bar on a terminal, and nothing elsewhere.
fn progress(count: u16) -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:40} {pos} of {len} pictures, {eta} to go");
    ProgressBar::new(count.into()).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

/// Shows the last picture, and says what it took.
fn report(options: &Options, totals: &Totals) -> Result<(), Box<dyn Error>> {
    let Totals { last, fragments } = totals;
    let mut out = io::stdout().lock();
    if io::IsTerminal::is_terminal(&out) {
        write!(out, "{}", last.picture.preview(100))?;
    }
    let (Camera { width, height, .. }, bits) = (options.camera, counted(options.bits.into(), "bit"));
    writeln!(out, "{}: {width} x {height} at {bits} per pixel, {} view", options.out, options.view.name())?;
    let pictures = if options.frames > 1 { format!(" in {} pictures", options.frames) } else { String::new() };
    let [triangles, fragments] = [counted(last.triangles as u64, "triangle"), counted(*fragments, "fragment")];
    writeln!(out, "drawn: {triangles}, {fragments}{pictures}")?;
    writeln!(out, "RAM: {} bytes of colour, {} of depth, {} of scratch", last.color, last.depth, last.scratch)?;
    Ok(())
}

fn counted(n: u64, one: &str) -> String {
    format!("{n} {one}{}", if n == 1 { "" } else { "s" })
}

/// Shows the body in a window, and does what keys and mouse say.
fn open(body: &Body, options: Options) -> Result<(), Box<dyn Error>> {
    let mut desk = Desk { mesh: body.mesh(&options), body, options, is_paused: false, drag: None };
    let first = desk.shot()?;
    watch::<Box<dyn Error>>("teapot", first, |events| desk.go(events).then(|| desk.shot()).transpose())
        .map_err(|error| format!("{error} (a window needs a display; without --window, a file is written)").into())
}

/// A body in a window.
struct Desk<'a> {
    body: &'a Body,
    mesh: Mesh,
    options: Options,
    is_paused: bool,
    /// Where the mouse is, while its button is down.
    drag: Option<Point>,
}

impl Desk<'_> {
    fn shot(&self) -> Result<Shot, Box<dyn Error>> {
        let Drawing { picture, fragments, color, depth, scratch, .. } = shoot(&self.mesh, &self.options)?;
        let caption = format!("{}, {}", self.options.view.name(), counted(self.options.bits.into(), "bit"));
        Ok(Shot { picture, caption, ram: color + depth + scratch, drawn: fragments })
    }

    /// Says whether there is something new to see.
    fn go(&mut self, events: &[Event]) -> bool {
        let mut is_new = !self.is_paused && self.drag.is_none();
        if is_new {
            // A turn in ten seconds.
            self.turn(Angle::turns(1, 600), Angle::turns(0, 1));
        }
        for event in events {
            is_new |= match *event {
                Event::Key(key, _) => self.key(key),
                Event::Press(at) => {
                    self.drag = Some(at);
                    false
                }
                Event::Release(_) => self.drag.take().is_some(),
                Event::Move(at) => self.drag(at),
                Event::Menu(_) => false,
            };
        }
        is_new
    }

    fn turn(&mut self, yaw: Angle, pitch: Angle) {
        self.options.camera.yaw += yaw;
        self.options.camera.pitch += pitch;
    }

    /// Turns the body as if it were touched.
    fn drag(&mut self, to: Point) -> bool {
        let Some(from) = self.drag.replace(to) else { return false };
        // Half a turn over the whole picture.
        let angle = |pixels: i32, size: u16| Angle::turns(1, 2 * size.clamp(1, 4096)) * pixels;
        let Camera { width, height, .. } = self.options.camera;
        self.turn(angle(to.x - from.x, width), angle(to.y - from.y, height));
        true
    }

    fn key(&mut self, key: Key) -> bool {
        let (step, none) = (Angle::turns(1, 72), Angle::turns(0, 1));
        let zoom = &mut self.options.camera.zoom;
        match key {
            Key::Left => self.turn(-step, none),
            Key::Right => self.turn(step, none),
            Key::Up => self.turn(none, -step),
            Key::Down => self.turn(none, step),
            Key::Equal | Key::NumPadPlus => *zoom = (*zoom * 9 / 8).min(I16F16::from_num(16)),
            Key::Minus | Key::NumPadMinus => *zoom = (*zoom * 8 / 9).max(I16F16::ONE / 16),
            Key::Space => self.is_paused = !self.is_paused,
            Key::D => self.options.bits = next(&[1, 2, 4, 8, 16, 24, 32], self.options.bits),
            Key::V => {
                self.options.view = next(&View::ALL, self.options.view);
                self.mesh = self.body.mesh(&self.options);
            }
            _ => return false,
        }
        true
    }
}

/// The one after `current`, the first one after the last.
fn next<T: Copy + PartialEq>(all: &[T], current: T) -> T {
    let at = all.iter().position(|&one| one == current).unwrap_or(0);
    all[(at + 1) % all.len()]
}

/// What kind of file is written.
#[derive(Copy, Clone)]
enum Kind {
    Png,
    Gif,
}

struct Options {
    input: Option<String>,
    view: View,
    camera: Camera,
    bits: u32,
    frames: u16,
    band: Option<u16>,
    out: String,
    kind: Kind,
    window: bool,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            input: None,
            view: View::Gouraud,
            camera: Camera::new(320, 240),
            bits: 16,
            frames: 1,
            band: None,
            out: "teapot.png".into(),
            kind: Kind::Png,
            window: false,
        }
    }
}

impl Options {
    /// `None` if help was asked for.
    fn from_command_line() -> Result<Option<Self>, lexopt::Error> {
        use lexopt::prelude::*;
        let mut options = Self::default();
        let mut arguments = lexopt::Parser::from_env();
        while let Some(argument) = arguments.next()? {
            match argument {
                Long("input") => options.input = Some(arguments.value()?.string()?),
                Long("view") => options.view = arguments.value()?.parse_with(parse_view)?,
                Long("size") => {
                    let (width, height) = arguments.value()?.parse_with(parse_size)?;
                    options.camera = Camera::new(width, height);
                }
                Long("bits") => options.bits = arguments.value()?.parse_with(parse_bits)?,
                Long("frames") => options.frames = arguments.value()?.parse_with(parse_count)?,
                Long("band") => options.band = Some(arguments.value()?.parse_with(parse_count)?),
                Long("out" | "output") => {
                    let out = arguments.value()?;
                    options.kind = out.parse_with(parse_kind)?;
                    options.out = out.string()?;
                }
                Long("window") => options.window = true,
                Short('h') | Long("help") => return Ok(None),
                _ => return Err(argument.unexpected()),
            }
        }
        Ok(Some(options))
    }
}

fn parse_view(text: &str) -> Result<View, String> {
    let found = View::ALL.into_iter().find(|view| view.name() == text);
    found.ok_or_else(|| format!("one of {}", View::ALL.map(View::name).join(", ")))
}

fn parse_size(text: &str) -> Result<(u16, u16), &'static str> {
    let size = text.split_once(['x', 'X']).and_then(|(w, h)| Some((w.parse().ok()?, h.parse().ok()?)));
    let fits = |&(w, h): &(u16, u16)| (1..=4096).contains(&w) && (1..=4096).contains(&h);
    size.filter(fits).ok_or("WIDTHxHEIGHT, each from 1 to 4096")
}

fn parse_bits(text: &str) -> Result<u32, &'static str> {
    let bits = text.parse().ok().filter(|bits| [1, 2, 4, 8, 16, 24, 32].contains(bits));
    bits.ok_or("one of 1, 2, 4, 8, 16, 24, 32")
}

fn parse_count(text: &str) -> Result<u16, &'static str> {
    text.parse().ok().filter(|&count| count > 0).ok_or("a number from 1 to 65535")
}

/// By the end of its name.
fn parse_kind(text: &str) -> Result<Kind, &'static str> {
    let end = text.rsplit_once('.').map(|(_, end)| end.to_ascii_lowercase());
    match end.as_deref() {
        Some("png" | "apng") => Ok(Kind::Png),
        Some("gif") => Ok(Kind::Gif),
        _ => Err("a name that ends with .png, .apng or .gif"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_are_what_the_usage_says() {
        assert!(View::ALL.iter().all(|view| USAGE.contains(view.name()) && parse_view(view.name()) == Ok(*view)));
        assert!(parse_view("solid").is_err_and(|error| error.starts_with("one of wire, flat, ")));
        assert_eq!((parse_size("160x120"), parse_size("1X4096")), (Ok((160, 120)), Ok((1, 4096))));
        assert!(["", "160", "0x1", "1x4097", "1x-1", "1x1x1"].iter().all(|text| parse_size(text).is_err()));
        assert!([1, 2, 4, 8, 16, 24, 32].iter().all(|bits| parse_bits(&bits.to_string()) == Ok(*bits)));
        assert!(["0", "3", "x"]
            .iter()
            .all(|text| parse_bits(text).is_err() && parse_count(&format!("-{text}")).is_err()));
        assert!(["a.png", "b.APNG", "c.x/d.apng"].iter().all(|name| matches!(parse_kind(name), Ok(Kind::Png))));
        assert!(
            matches!(parse_kind("e.gif"), Ok(Kind::Gif))
                && ["f", "g.jpg", "png"].iter().all(|name| parse_kind(name).is_err())
        );
    }

    #[test]
    fn keys_and_mouse_turn_it() {
        let body = Body::load(None).unwrap();
        let options = Options { camera: Camera::new(32, 24), ..Options::default() };
        let mut desk = Desk { mesh: body.mesh(&options), body: &body, options, is_paused: true, drag: None };
        let start = desk.options.camera;
        let key = |key| [Event::Key(key, false)];
        assert!(!desk.go(&[]), "it pauses");
        for (there, back) in [(Key::Left, Key::Right), (Key::Up, Key::Down)] {
            assert!(desk.go(&key(there)) && desk.options.camera != start, "{there:?}");
            assert!(desk.go(&key(back)) && desk.options.camera == start, "{back:?}");
        }
        assert!(desk.go(&key(Key::Equal)) && desk.options.camera.zoom > start.zoom, "nearer");
        for _ in 0..99 {
            assert!(desk.go(&key(Key::Minus)), "further away");
        }
        assert_eq!(desk.options.camera.zoom, I16F16::ONE / 16, "but not for ever");
        assert!(!desk.go(&[Event::Move(Point::new(9, 9))]), "no button is down");
        let [a, b] = [Point::new(1, 2), Point::new(17, 2)];
        assert!(desk.go(&[Event::Press(a), Event::Move(b), Event::Release(b)]), "a drag");
        assert_eq!(
            desk.options.camera.yaw,
            start.yaw + Angle::turns(1, 4),
            "half of the picture is a quarter of a turn"
        );
        for view in View::ALL.into_iter().cycle().skip(3).take(9) {
            assert!(desk.go(&key(Key::V)) && desk.options.view == view, "the next view");
            assert!(desk.shot().is_ok_and(|shot| shot.picture.width() == 32), "{view:?} is shown");
        }
        assert!(desk.go(&key(Key::Space)) && desk.go(&[]), "it turns again");
    }
}
