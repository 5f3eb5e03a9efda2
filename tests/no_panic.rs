//! Any bits in any argument: no panic, no overflow, no endless loop. Tests run with every overflow check on.
//!
//! Nothing is compared here; what comes out is the business of the other tests. What is called is all of the list `calls`.
//! Windows that are painted are small, as work depends on what is visible; everything else may be as large and as wrong as the
//! types allow.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "any bits will do"
)]

use std::hint::black_box;

use calls::{computing, damage, frames, Arguments};
use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray2, Gray8, Rgb555, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    eg::draw_on,
    geom::{polygon::crossings, triangulate},
    pixel::{Be, Lsb0, Rgb444, Xrgb8888},
    raster::polygon,
    surface::{Counter, Damage, Grid, Packed12, Pages, Planes, Rows},
    Angle, Bitmap, Canvas, Error, FillRule, Frame, Framebuffer, Index1, Index2, Index4, Index8, Layout, Mat4, Palette,
    Patch, Path, PixelFormat, PointFx, Rect, Vec4,
};
use fixed::types::I16F16;
use twins::{
    arguments::{Ground, Scratch},
    input::{Input, EXTREMES},
    memory::color,
    rng::{cases, Rng},
    ALL_LAYOUTS,
};

/// Hands out inputs of random bytes, each long enough for the arguments of a call.
struct Random {
    rng: Rng,
    bytes: Vec<u8>,
}

impl Random {
    fn new(seed: u64) -> Self {
        Self { rng: Rng::new(seed), bytes: vec![0; 1_200] }
    }

    fn input(&mut self) -> Input<'_> {
        for bytes in self.bytes.chunks_exact_mut(8) {
            bytes.copy_from_slice(&self.rng.bits().to_le_bytes());
        }
        Input(&self.bytes)
    }
}

/// All that computes, with the same arguments; what those before have left in scratch memory is there for the next.
fn compute(a: &mut Arguments<'_, Rows<Index1>>, is_wanted: impl Fn(&str) -> bool) {
    let mut palette = Palette::new([Rgb888::RED; 16]);
    for (number, _) in computing::NAMES.iter().enumerate().filter(|(_, name)| is_wanted(name)) {
        black_box(computing::call(&mut palette, a, number));
    }
}

const COLORS: [Index1; 2] = [Index1::new(0), Index1::new(1)];

#[test]
fn shapes_and_tools() {
    let (mut random, mut scratch) = (Random::new(110), Scratch::new(110));
    for _ in 0..cases(90_000) {
        compute(&mut scratch.arguments(&mut random.input(), Ground::Wild, COLORS), |_| true);
    }
}

/// All of the plane at once, where little of it is seen.
#[test]
fn small_shapes_in_windows_without_end() {
    let (mut random, mut scratch) = (Random::new(111), Scratch::new(111));
    for _ in 0..cases(15_000) {
        let mut input = random.input();
        let ground = Ground::Close(input.wild(), input.wild());
        // A flood would fill the plane.
        compute(&mut scratch.arguments(&mut input, ground, COLORS), |name| name != "flood::fill");
    }
    // Rows without end, and no slot at all.
    let huge = [(i32::MIN, i32::MIN), (i32::MAX, 0), (0, i32::MAX)].map(|(x, y)| PointFx::from_bits(x, y));
    let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    assert!(polygon::fill([&huge], FillRule::EvenOdd, &mut [], everything, |_| ()).is_err(), "no slots");
}

/// Every four of the numbers that break arithmetic, for what is short enough to be called with all of them.
#[test]
fn every_extreme() {
    let short = ["Rect", "Rectangle", "Span", "ClippedSpan", "PointFx", "Angle", "rectangle", "line", "Steps"];
    // The window may be all of the plane here.
    let long = ["rectangle::fill", "rectangle::outline", "line::draw", "line::line"];
    let (mut random, mut scratch) = (Random::new(112), Scratch::new(112));
    let mut a = scratch.arguments::<Rows<Index1>>(&mut random.input(), Ground::Wild, COLORS);
    let mut others = Rng::new(112);
    let short: Vec<usize> = (0..computing::NAMES.len())
        .filter(|&number| {
            let name = computing::NAMES[number];
            short.contains(&name.split("::").next().expect("an owner")) && !long.contains(&name)
        })
        .collect();
    let mut palette = Palette::new([Rgb888::RED; 16]);
    for x0 in EXTREMES {
        for y0 in EXTREMES {
            for x1 in EXTREMES {
                for y1 in EXTREMES {
                    let bytes = [(); 24].map(|()| others.bits() as u8);
                    let other = Input(&bytes).wild_area();
                    a.points = [Point::new(x0, y0), Point::new(x1, y1), other.top_left()];
                    a.areas = [Rect::new(x0, y0, x1, y1), other];
                    a.window = if others.one_in(2) { other } else { Input(&bytes).small_window() };
                    let place = |(x, y)| PointFx::from_bits(x, y);
                    a.places = [(x0, y0), (x1, y1), (x1, y0), (x0, y1)].map(place);
                    a.numbers = [x0, y0, x1, y1, x0, y0];
                    for &number in &short {
                        black_box(computing::call(&mut palette, &mut a, number));
                    }
                }
            }
        }
    }
}

/// All that can be done with a frame of a layout, with the same arguments.
fn every_call<L: Layout>(frame: &mut Frame<&mut [u8], L>, a: &mut Arguments<'_, L>) {
    for number in 0..calls::COUNT {
        black_box(calls::call(frame, a, number));
    }
    for number in 0..frames::NAMES.len() {
        black_box(frames::call(frame, a, number));
    }
    for number in 0..calls::texts::NAMES.len() {
        black_box(calls::texts::call(frame, a, number));
    }
}

/// Screens of a layout, views of views of them, and bands.
fn screens<F: PixelFormat, L: Layout<Color = F::Color>>(seed: u64) {
    let (mut random, mut scratch, mut rng) = (Random::new(seed), Scratch::new(seed), Rng::new(seed));
    let mut memory = vec![0; 65_535 * 4 * 8];
    for _ in 0..cases(4_000) {
        let mut input = random.input();
        let (width, height) = (input.below(17) as u16, input.below(17) as u16);
        let needed = L::bytes(width, Grid { stride: L::row_bytes(width), rows: height.into() });
        let memory = &mut memory[..needed + input.index(9)];
        let mut frame = Frame::<_, L>::new(memory, width, height).expect("it is large enough");
        let mut view = frame.view(input.wild_area());
        let mut view = view.clipped(input.wild_area());
        let mut view = if input.one_in(2) { view.view(input.wild_area()) } else { view };
        let colors = [(); 2].map(|()| color::<F>(&mut rng));
        let mut arguments = scratch.arguments::<L>(&mut input, Ground::Wild, colors);
        every_call(&mut view, &mut arguments);
    }
    // Of any size and stride, as long as there is memory; of any rows.
    for _ in 0..cases(4_000) {
        let mut input = random.input();
        let mut size = || if input.one_in(3) { input.wild() as u16 } else { input.below(20) as u16 };
        let (width, height, start, rows) = (size(), size(), size(), input.below(4) as u16);
        let (start, rows) = (start / L::PAGE * L::PAGE, rows * L::PAGE);
        let stride = if input.one_in(2) { L::row_bytes(width) } else { input.wild() as usize };
        let colors = [(); 2].map(|()| color::<F>(&mut rng));
        let area = input.wild_area();
        let mut arguments = scratch.arguments::<L>(&mut input, Ground::Wild, colors);
        let length = if rng.one_in(2) { rng.index(601) } else { memory.len() };
        if let Ok(mut band) = Frame::<_, L>::band(&mut memory[..], width, height, start..start.saturating_add(rows)) {
            every_call(&mut band, &mut arguments);
            every_call(&mut band.view(area), &mut arguments);
        }
        // A stride without end is fine as long as there is one row, or none.
        match Frame::<_, L>::with_stride(&mut memory[..length], width, height, stride) {
            Ok(mut frame) if width < 100 && height < 100 => every_call(&mut frame.as_mut(), &mut arguments),
            other => drop(black_box(other.map_err(|error| format!("{error} {error:?}")))),
        }
    }
}

/// Through the crate's own adapter, there and back. It draws all that a view claims to have, so that is not too much.
fn draw_target<F: PixelFormat, L: Layout<Color = F::Color>>(seed: u64) {
    let (mut random, mut scratch, mut rng) = (Random::new(seed), Scratch::new(seed), Rng::new(seed));
    let mut memory = vec![0; 999];
    for _ in 0..cases(1_000) {
        let mut input = random.input();
        let mut frame = Frame::<_, L>::new(&mut memory[..], 17, 16).expect("it is large enough");
        let (x, y) = (input.within(-40, 60), input.within(-40, 60));
        let mut view = frame.view(Rect::new(x, y, x + input.within(-1, 99), y + input.within(-1, 99)));
        let colors = [(); 2].map(|()| color::<F>(&mut rng));
        let mut arguments = scratch.arguments::<L>(&mut input, Ground::Wild, colors);
        let drawn = draw_on(&mut view, |canvas| {
            (0..calls::DRAWING.len()).map(|number| calls::draw(canvas, &mut arguments, number)).max()
        });
        black_box(drawn.is_ok());
    }
}

#[test]
fn draw_targets() {
    draw_target::<Rgb565, Rows<Rgb565>>(135);
    if ALL_LAYOUTS {
        draw_target::<Index1, Pages<Index1>>(136);
    }
}

/// What sequences of calls are tried on is not tried here as well, but with the feature `all-layouts` of the twins.
#[test]
fn frames_of_bits() {
    screens::<Gray2, Rows<Lsb0<Gray2>>>(121);
    if ALL_LAYOUTS {
        screens::<Index1, Rows<Index1>>(120);
        screens::<Index4, Rows<Index4>>(122);
    }
}

#[test]
fn frames_of_bytes() {
    if ALL_LAYOUTS {
        screens::<Rgb555, Rows<Be<Rgb555>>>(126);
        screens::<Gray8, Rows<Gray8>>(123);
        screens::<Index8, Rows<Index8>>(124);
        screens::<Rgb565, Rows<Rgb565>>(125);
    }
}

#[test]
fn frames_of_words() {
    if ALL_LAYOUTS {
        screens::<Rgb888, Rows<Be<Rgb888>>>(127);
    }
    screens::<Xrgb8888, Rows<Xrgb8888>>(128);
}

#[test]
fn frames_of_other_layouts() {
    if ALL_LAYOUTS {
        screens::<Index1, Pages<Index1>>(130);
        screens::<BinaryColor, Pages<Lsb0<BinaryColor>>>(129);
        screens::<Index2, Planes<Index2>>(131);
        screens::<Rgb444, Packed12>(132);
    }
}

/// What can go wrong can be said.
#[test]
fn errors() {
    let (mut random, mut scratch) = (Random::new(134), Scratch::new(134));
    let look = |error: Option<Error>| black_box(error.map(|error| format!("{error} {error:?}")));
    for _ in 0..cases(10_000) {
        let a = scratch.arguments::<Rows<Index1>>(&mut random.input(), Ground::Wild, COLORS);
        look(polygon::fill([a.contour], FillRule::NonZero, a.table, a.window, |_| ()).err().map(Error::from));
        look(triangulate::list(a.contour, a.starts, a.sides, a.triangles).err().map(Error::from));
        look(Path::new(a.segments).outlines::<50, 2>().err().map(Error::from));
        look(crossings::<_, 4>([a.contour], a.size).err().map(Error::from));
    }
}

/// Surfaces anywhere.
#[test]
fn counters() {
    let (mut random, mut scratch) = (Random::new(133), Scratch::new(133));
    for _ in 0..cases(60_000) {
        let mut input = random.input();
        let mut counter = Counter::<Rgb565>::new(input.small_window());
        let mut arguments = scratch.arguments::<Rows<Rgb565>>(&mut input, Ground::Wild, [Rgb565::RED, Rgb565::BLUE]);
        for number in 0..calls::DRAWING.len() {
            black_box(calls::draw(&mut counter, &mut arguments, number));
        }
        black_box((counter.pixels, counter.spans));
    }
    // One row as long as rows get.
    let mut counter = Counter::<Rgb565>::new(Rect::new(i32::MIN, 5, i32::MAX, 6));
    counter.fill_window(Rgb565::RED);
    counter.draw_line(Point::new(i32::MIN, 5), Point::new(i32::MIN + 1000, 5), Rgb565::RED);
    assert_eq!(counter.pixels, u64::from(u32::MAX) + 1001);
}

fn wild(rng: &mut Rng) -> i32 {
    match rng.below(8) {
        0 => rng.bits() as i32,
        1 | 2 => rng.int(-40, 60),
        3 => rng.int(-9_000, 9_000),
        _ => rng.pick(&EXTREMES),
    }
}

#[test]
fn what_computes_in_space() {
    let mut rng = Rng::new(890);
    for _ in 0..twins::rng::cases(3_000) {
        let mut number = || I16F16::from_bits(wild(&mut rng));
        let mut place = || Vec4::new(number(), number(), number(), number());
        let arguments = calls::space::Arguments {
            numbers: [(); 6].map(|()| place().x),
            vectors: [(); 3].map(|()| place().xyz()),
            places: [(); 2].map(|()| place()),
            matrices: [(); 2].map(|()| Mat4 { rows: [(); 4].map(|()| place()) }),
            angle: Angle::from_bits(number().to_bits() as u32),
            patch: Patch {
                points: [(); 4].map(|()| [(); 4].map(|()| Vec4::new(number(), number(), number(), number()).xyz())),
            },
            levels: [(); 4].map(|()| if rng.one_in(400) { 255 } else { rng.below(9) as u8 }),
            parts: [(); 2].map(|()| [rng.below(70) as u8, rng.bits() as u8]),
            index: rng.bits() as u16,
        };
        for k in 0..=calls::space::NAMES.len() {
            black_box(calls::space::call(&arguments, k));
        }
    }
}

/// Of texts that are paths, and of any other.
#[test]
fn what_makes_paths() {
    let (mut rng, mut scratch) = (Rng::new(892), Scratch::new(892));
    for _ in 0..twins::rng::cases(10_000) {
        let bytes: Vec<u8> = (0..150).flat_map(|_| rng.bits().to_le_bytes()).collect();
        let letters = b"mMlLhVcCsSqQtTaAzZ0011299.-+eE,,    \n";
        let text: String = (0..rng.below(60)).map(|_| char::from(rng.pick(letters))).collect();
        // As long as it makes sense.
        let end = Path::svg(&text).map_or_else(|error| error.position, |_| text.len());
        let front = text.get(..text[..end].rfind(char::is_alphabetic).unwrap_or(0)).unwrap_or_default();
        for number in 0..=calls::paths::NAMES.len() {
            for text in [&text, front] {
                let mut arguments =
                    scratch.arguments::<Rows<Index1>>(&mut Input(&bytes), Ground::Wild, [Index1::new(0); 2]);
                black_box(calls::paths::call(text, &mut arguments, number));
            }
        }
    }
}

#[test]
fn what_has_changed() {
    let (mut random, mut scratch, mut changed) = (Random::new(893), Scratch::new(893), Damage::new());
    for _ in 0..twins::rng::cases(20_000) {
        let mut arguments = scratch.arguments::<Rows<Index1>>(&mut random.input(), Ground::Wild, COLORS);
        for k in 0..=damage::NAMES.len() {
            black_box(damage::call(&mut changed, &mut arguments, k));
        }
    }
}

#[test]
fn what_hands_frames_to_a_display() {
    let mut rng = Rng::new(891);
    for _ in 0..twins::rng::cases(20_000) {
        let arguments = calls::present::Arguments {
            operations: [(); 12].map(|()| rng.bits() as u8),
            size: [(); 3].map(|()| if rng.one_in(4) { rng.bits() as u16 } else { rng.below(40) as u16 }),
        };
        for k in 0..=calls::present::NAMES.len() {
            black_box(calls::present::call(&arguments, k));
        }
    }
}

#[test]
fn what_mixes_colors() {
    let (mut rng, mut scratch) = (Rng::new(893), Scratch::new(893));
    for _ in 0..twins::rng::cases(10_000) {
        let bytes: Vec<u8> = (0..150).flat_map(|_| rng.bits().to_le_bytes()).collect();
        let mut ram = bytes.clone();
        let (width, height) = (rng.below(9) as u16, rng.below(9) as u16);
        let mut frame = Framebuffer::<Rgb565>::new(&mut ram, width, height).expect("enough bytes");
        for number in 0..=calls::blending::NAMES.len() {
            let mut arguments =
                scratch.arguments::<Rows<Index1>>(&mut Input(&bytes), Ground::Wild, [Index1::new(0); 2]);
            black_box(calls::blending::call(&mut frame, &mut arguments, number));
        }
    }
}

#[test]
fn values_over_triangles() {
    let (mut rng, mut scratch) = (Rng::new(891), Scratch::new(891));
    for _ in 0..twins::rng::cases(10_000) {
        let bytes: Vec<u8> = (0..150).flat_map(|_| rng.bits().to_le_bytes()).collect();
        let (width, height) = (rng.below(9) as u16, rng.below(9) as u16);
        let texels = Bitmap::<Rgb565>::new(&bytes, width, height).expect("enough bytes");
        for number in 0..=calls::shading::NAMES.len() {
            let mut arguments =
                scratch.arguments::<Rows<Index1>>(&mut Input(&bytes), Ground::Wild, [Index1::new(0); 2]);
            black_box(calls::shading::call(&texels, &mut arguments, number));
        }
    }
}
