//! The list of calls is complete, and every call keeps the promises: with any arguments no panic, and nothing changed outside of
//! the window; through a wrapper that forwards nothing but spans, the same pixels.

#![allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "random numbers, cut on purpose")]

use std::{cell::Cell, collections::BTreeSet, fs, path::Path as File};

use calls::{call, Arguments, NAMES};
use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Rgb565, Rgb888},
};
use embedded_raster::{
    pixel::{Be, Lsb0, Rgb444},
    raster::{
        flood::FloodSlot,
        stroke::{Cap, Join},
    },
    surface::{Grid, Packed12, Pages, Planes, Rows},
    Angle, ClippedSpan, EdgeSlot, Ellipse, Frame, Index1, Index2, Index4, Index8, Layout, PathSegment, PixelFormat,
    PointFx, Radii, Readable, Rect, Sector, Stroke, Surface,
};
use fixed::types::I24F8;
use twins::{
    rng::{cases, Rng},
    watched::Watched,
};

/// Whether the numbers are those of a small screen, or any.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Size {
    Screen,
    Wild,
}

impl Size {
    fn int(self, rng: &mut Rng, low: i32, high: i32) -> i32 {
        match self {
            Self::Wild if rng.one_in(3) => rng.bits() as i32,
            Self::Wild if rng.one_in(3) => rng.pick(&[i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX]),
            _ => rng.int(low, high),
        }
    }

    fn point(self, rng: &mut Rng) -> Point {
        Point::new(self.int(rng, -9, 50), self.int(rng, -9, 40))
    }

    fn place(self, rng: &mut Rng) -> PointFx {
        PointFx::from_bits(self.int(rng, -2_000, 12_000), self.int(rng, -2_000, 9_000))
    }

    fn area(self, rng: &mut Rng) -> Rect {
        let [x0, y0] = [(-5, 30), (-5, 20)].map(|(low, high)| self.int(rng, low, high));
        let [x1, y1] = [45, 33].map(|high| self.int(rng, 5, high));
        Rect { x0, y0, x1, y1 }
    }

    fn ellipse(self, rng: &mut Rng) -> Ellipse {
        let at = self.place(rng);
        let [x, y] = [0, 0].map(|_| I24F8::from_bits(self.int(rng, 0, 4_000)));
        Ellipse::new(at, x, y)
    }

    fn segment(self, rng: &mut Rng) -> PathSegment {
        let mut place = || self.place(rng);
        let [a, b, c] = [place(), place(), place()];
        match rng.below(6) {
            0 => PathSegment::MoveTo(a),
            1 | 2 => PathSegment::LineTo(a),
            3 => PathSegment::QuadraticTo(a, b),
            4 => PathSegment::CubicTo(a, b, c),
            _ => PathSegment::Close,
        }
    }
}

/// What arguments borrow.
struct Borrowed {
    corners: Vec<Point>,
    contour: Vec<PointFx>,
    segments: Vec<PathSegment>,
    dashes: Vec<I24F8>,
    table: Vec<EdgeSlot>,
    slots: Vec<FloodSlot>,
    bytes: Vec<u8>,
}

impl Borrowed {
    fn new(rng: &mut Rng, size: Size) -> Self {
        Self {
            corners: (0..rng.index(6)).map(|_| size.point(rng)).collect(),
            contour: (0..rng.index(6)).map(|_| size.place(rng)).collect(),
            segments: (0..rng.index(4)).map(|_| size.segment(rng)).collect(),
            dashes: (0..rng.index(4)).map(|_| I24F8::from_bits(size.int(rng, 100, 2_000))).collect(),
            table: (0..rng.index(64)).map(|_| EdgeSlot::EMPTY).collect(),
            slots: vec![FloodSlot::EMPTY; rng.index(9)],
            bytes: (0..500).map(|_| rng.bits() as u8).collect(),
        }
    }

    fn arguments<L: Layout>(&mut self, rng: &mut Rng, size: Size, colors: [L::Color; 2]) -> Arguments<'_, L> {
        let width = match size {
            Size::Screen => I24F8::from_bits(rng.int(1, 1_500)),
            Size::Wild => I24F8::from_bits(size.int(rng, -9, 9_000)),
        };
        Arguments {
            points: [(); 3].map(|()| size.point(rng)),
            places: [(); 4].map(|()| size.place(rng)),
            areas: [(); 2].map(|()| size.area(rng)),
            ellipses: [(); 2].map(|()| size.ellipse(rng)),
            size: I24F8::from_bits(size.int(rng, 0, 3_000)),
            radii: Radii { top_left: rng.below(20) as u32, ..Radii::all(size.int(rng, 0, 9) as u32) },
            sector: Sector::new(Angle::from_bits(rng.bits() as u32), Angle::from_bits(rng.bits() as u32)),
            corners: &self.corners,
            contour: &self.contour,
            segments: &self.segments,
            stroke: Stroke::new(width)
                .with_cap(rng.pick(&[Cap::Butt, Cap::Round, Cap::Square]))
                .with_join(rng.pick(&[Join::Miter, Join::Round, Join::Bevel])),
            dashes: &self.dashes,
            phase: I24F8::from_bits(size.int(rng, 0, 3_000)),
            flag: rng.one_in(2),
            table: &mut self.table,
            slots: &mut self.slots,
            colors,
            picture: Frame::new(&self.bytes[..], 9, 8).expect("enough bytes"),
            mask: Frame::new(&self.bytes[..], 11, 7).expect("enough bytes"),
        }
    }
}

const SCREEN: (u16, u16) = (41, 29);

/// Sequences of calls on a part of a screen: directly, and through a wrapper.
fn check<F: PixelFormat, L: Layout<Color = F::Color>>(seed: u64, size: Size) {
    let mut rng = Rng::new(seed);
    let (width, height) = SCREEN;
    let needed = L::bytes(width, Grid { stride: L::row_bytes(width), rows: height.into() });
    let all: Vec<Point> = (0..29).flat_map(|y| (0..41).map(move |x| Point::new(x, y))).collect();
    for _ in 0..cases(60) {
        let mut plain: Vec<u8> = (0..needed).map(|_| if rng.one_in(3) { rng.bits() as u8 } else { 0 }).collect();
        let before = plain.clone();
        let mut wrapped = plain.clone();
        let window = if rng.one_in(2) { Rect::new(0, 0, 41, 29) } else { Rect::new(3, 2, 30, 25) };
        let mut log = vec![];
        let mut seen = BTreeSet::new();
        for _ in 0..rng.range(1, 40) {
            let number = rng.index(NAMES.len());
            // By itself it is a shortcut that a wrapper does not have; floods use it.
            if NAMES[number] == "fill_corridor" {
                continue;
            }
            log.push(NAMES[number]);
            let mut color = || F::unpack(rng.bits() as u32 & (u32::MAX >> (32 - F::BITS)));
            let colors = [color(), color()];
            let mut borrowed = Borrowed::new(&mut rng, size);
            let again = rng.clone();
            let frame = |bytes| Frame::<_, L>::new(bytes, width, height).expect("the right size");
            let mut arguments = borrowed.arguments::<L>(&mut rng, size, colors);
            let answer = call(&mut frame(&mut plain[..]).clipped(window), &mut arguments, number);
            let mut arguments = borrowed.arguments::<L>(&mut again.clone(), size, colors);
            let mut screen = frame(&mut wrapped[..]);
            let mut watched = Watched::new(screen.clipped(window));
            assert_eq!(call(&mut watched, &mut arguments, number), answer, "answers after {log:?} in {window:?}");
            seen.append(&mut watched.seen);
            assert!(plain == wrapped, "pixels after {log:?} in {window:?}");
        }
        let [old, new] =
            [&before, &plain].map(|bytes| Frame::<_, L>::new(&bytes[..], width, height).expect("the right size"));
        for &at in &all {
            let changed = old.get(at) != new.get(at);
            assert!(!changed || window.contains(at.x, at.y), "{log:?} changed {at} outside of {window:?}");
            assert!(!changed || seen.contains(&(at.x, at.y)), "{log:?} changed {at} and no wrapper saw it");
        }
    }
}

fn check_all(seed: u64, size: Size) {
    check::<Index1, Rows<Index1>>(seed, size);
    check::<Index2, Rows<Lsb0<Index2>>>(seed + 1, size);
    check::<Index4, Rows<Index4>>(seed + 2, size);
    check::<Index8, Rows<Index8>>(seed + 3, size);
    check::<Rgb565, Rows<Rgb565>>(seed + 4, size);
    check::<Rgb888, Rows<Be<Rgb888>>>(seed + 5, size);
    check::<Index1, Pages<Index1>>(seed + 6, size);
    check::<Index2, Planes<Index2>>(seed + 7, size);
    check::<Rgb444, Packed12>(seed + 8, size);
}

#[test]
fn sequences_of_calls_are_the_same_through_a_wrapper() {
    check_all(970, Size::Screen);
}

#[test]
fn sequences_of_calls_with_wild_arguments() {
    check_all(980, Size::Wild);
}

/// A surface that counts what is asked for.
struct Counted<'a> {
    inner: Frame<&'a mut [u8], Rows<Index4>>,
    written: usize,
    read: Cell<usize>,
}

impl Surface for Counted<'_> {
    type Color = Index4;

    fn window(&self) -> Rect {
        self.inner.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: Index4) {
        self.written += span.len() as usize;
        self.inner.fill_span(span, color);
    }
}

impl Readable for Counted<'_> {
    fn color_at(&self, x: i32, y: i32) -> Index4 {
        self.read.set(self.read.get() + 1);
        self.inner.color_at(x, y)
    }
}

/// How often a call may write and read a pixel, on a window of so many columns and rows. What is new in the list and not here
/// may paint each pixel of the window once, and read none.
fn bound(name: &str, (w, h): (usize, usize), a: &Arguments<'_, Rows<Index4>>, answer: usize) -> (usize, usize) {
    let (all, line) = (w * h, w.max(h));
    match name {
        "draw_line" | "fill_steps" => (line, 0),
        "draw_triangle" => (3 * line, 0),
        "draw_polyline" | "draw_polygon" => ((a.corners.len() + 1) * line, 0),
        // A cubic curve passes a column three times, and a row.
        "draw_path_fx" => ((a.segments.len() + 1) * 3 * (w + h), 0),
        "draw_quadratic_fx" | "draw_cubic_fx" => (3 * (w + h), 0),
        "draw_ellipse" | "draw_arc" | "draw_rounded" | "draw_rectangle" => (2 * (w + h), 0),
        "draw_point" | "draw_point_fx" | "set" => (1, 0),
        "blit" | "blit_keyed" | "copy_picture" => (all.min(9 * 8), 0),
        "blit_mask" | "copy_mask" => (all.min(11 * 7), 0),
        "move_area" | "move_area_keyed" | "copy_area" => (all, all),
        "fill_span" | "write_span" | "write_some" => (w, 0),
        "edit_span" => (w, w),
        "read_span" | "find" | "find_start" => (0, w),
        "color_at" | "get" => (0, 1),
        // What is connected is painted once. With too few slots, how often it is read is counted in `raster::flood`.
        "flood_fill" | "flood_fill_to" if answer > a.slots.len() => (all, usize::MAX),
        "flood_fill" | "flood_fill_to" => (all, 9 * (all + 1)),
        // A triangle, a box in outline, a line; and pixel by pixel, back again.
        "draw_on" => (all + 2 * (w + h) + line, 0),
        _ => (all, 0),
    }
}

/// No call writes or reads more than the window and its arguments allow, whatever the arguments are.
#[test]
fn calls_write_and_read_what_the_window_shows() {
    let mut rng = Rng::new(990);
    let mut most = vec![0; NAMES.len()];
    for _ in 0..cases(1_000) {
        let mut bytes: Vec<u8> = (0..21 * 29).map(|_| if rng.one_in(3) { rng.bits() as u8 } else { 0 }).collect();
        for (number, &name) in NAMES.iter().enumerate() {
            let size = if rng.one_in(2) { Size::Wild } else { Size::Screen };
            let window = if rng.one_in(2) { Rect::new(0, 0, 41, 29) } else { Rect::new(3, 2, 30, 25) };
            let colors = [Index4::new(rng.below(16) as u8), Index4::new(rng.below(16) as u8)];
            let mut borrowed = Borrowed::new(&mut rng, size);
            let mut arguments = borrowed.arguments::<Rows<Index4>>(&mut rng, size, colors);
            let mut frame = Frame::<_, Rows<Index4>>::new(&mut bytes[..], 41, 29).expect("the right size");
            let mut counted = Counted { inner: frame.clipped(window), written: 0, read: Cell::new(0) };
            let answer = call(&mut counted, &mut arguments, number);
            let (written, read) = (counted.written, counted.read.get());
            let (writes, reads) = bound(name, (window.width() as usize, window.height() as usize), &arguments, answer);
            assert!(written <= writes, "{name} wrote {written} pixels, at most {writes}: answer {answer}");
            assert!(read <= reads, "{name} read {read} pixels, at most {reads}: answer {answer}");
            most[number] = most[number].max(written + read);
        }
    }
    let idle: Vec<_> = NAMES.iter().zip(&most).filter(|(_, &most)| most == 0).map(|(&name, _)| name).collect();
    assert_eq!(idle, ["fill_octants", "fill_corridor"], "shortcuts that a surface need not have, and no others");
}

/// The names of functions in a part of a source file, from a line on that begins a trait up to its end, or of all public ones.
fn functions(file: &str, of_trait: Option<&str>) -> BTreeSet<String> {
    let path = File::new(env!("CARGO_MANIFEST_DIR")).join("src").join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let text = match of_trait {
        Some(name) => {
            let start = text.find(&format!("pub trait {name}")).unwrap_or_else(|| panic!("{file} has no trait {name}"));
            let length = text[start..].find("\n}\n").expect("a trait ends");
            text[start..start + length].to_owned()
        }
        None => text,
    };
    let prefix = if of_trait.is_some() { "    fn " } else { "pub fn " };
    let hidden = |lines: &[&str], i: usize| lines[..i].iter().rev().take(3).any(|line| line.contains("#[doc(hidden)]"));
    let lines: Vec<&str> = text.lines().collect();
    let names =
        lines.iter().enumerate().filter(|&(i, _)| !hidden(&lines, i)).filter_map(|(_, line)| line.strip_prefix(prefix));
    names.map(|rest| rest.split(['(', '<']).next().expect("a name").to_owned()).collect()
}

#[test]
fn the_list_is_complete() {
    let mut wanted = BTreeSet::new();
    for (file, name) in [("canvas.rs", "Canvas"), ("surface/traits.rs", "Surface"), ("surface/traits.rs", "Readable")] {
        wanted.append(&mut functions(file, Some(name)));
    }
    wanted.append(&mut functions("eg.rs", None));
    wanted.append(&mut functions("raster/triangle/walk.rs", None));
    // Asked by every call.
    wanted.remove("window");
    let listed: BTreeSet<String> = NAMES.iter().map(|&name| name.to_owned()).collect();
    assert_eq!(listed.len(), NAMES.len(), "each once");
    assert_eq!(wanted.difference(&listed).collect::<Vec<_>>(), Vec::<&String>::new(), "calls that the list lacks");
    assert_eq!(listed.difference(&wanted).collect::<Vec<_>>(), Vec::<&String>::new(), "calls that do not exist");
}

/// The names of all public functions of a file: methods with their type.
fn methods(file: &str) -> BTreeSet<String> {
    let path = File::new(env!("CARGO_MANIFEST_DIR")).join("src").join(file);
    let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    let (mut names, mut of) = (BTreeSet::new(), String::new());
    for line in text.lines() {
        if let Some(rest) = line.strip_prefix("impl").filter(|rest| !rest.contains(" for ")) {
            // `impl<'a> Type<'a> {`
            let rest = if rest.starts_with('<') { rest.split_once("> ").map_or(rest, |(_, rest)| rest) } else { rest };
            of = format!("{}::", rest.trim().split(['<', ' ']).next().expect("a type"));
        } else if line.starts_with('}') {
            of.clear();
        }
        let function = ["pub fn ", "pub const fn "].iter().find_map(|start| line.trim_start().strip_prefix(start));
        if let Some(rest) = function {
            names.insert(format!("{of}{}", rest.split(['(', '<']).next().expect("a name")));
        }
    }
    names
}

#[test]
fn the_list_of_what_computes_in_space_is_complete() {
    let folder = File::new(env!("CARGO_MANIFEST_DIR")).join("src/geom/space");
    let mut wanted = BTreeSet::new();
    for entry in fs::read_dir(folder).expect("a folder") {
        let name = entry.expect("a file").file_name();
        wanted.append(&mut methods(&format!("geom/space/{}", name.to_string_lossy())));
    }
    let listed: BTreeSet<String> = calls::space::NAMES.iter().map(|&name| name.to_owned()).collect();
    assert_eq!(listed.len(), calls::space::NAMES.len(), "each once");
    assert_eq!(wanted.difference(&listed).collect::<Vec<_>>(), Vec::<&String>::new(), "calls that the list lacks");
    assert_eq!(listed.difference(&wanted).collect::<Vec<_>>(), Vec::<&String>::new(), "calls that do not exist");
}
