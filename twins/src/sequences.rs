//! [`sequence`]: calls of the list, one after the other, on memory and on a naive twin of it.
//!
//! The twin implements only what a surface must, pixel by pixel in [`Naive`]. So every default of the crate's traits is compared
//! with what a layout does instead, through views of views and bands, on whatever the calls before have left. After each call
//! all memory is the same: in the window, around it, between the rows and before and after the pixels.

use std::fmt::Write;

use calls::{call, frames, Arguments};
use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Rgb565},
};
use embedded_raster::{
    pixel::{Lsb0, Rgb444},
    raster::line,
    surface::{Packed12, Pages, Rows},
    ClippedSpan, Frame, Index1, Index4, Layout, PixelFormat, Readable, Rect, Span, Surface,
};

use super::{
    arguments::{Ground, Scratch},
    input::Input,
    memory::{pixels, Arrangement, Format, Naive},
    rng::Rng,
};
#[cfg(feature = "all-layouts")]
use {
    embedded_graphics_core::pixelcolor::{Gray2, Rgb888},
    embedded_raster::{
        pixel::{Be, Xrgb8888},
        surface::Planes,
        Index2, Index8,
    },
};

/// A way to a part of a surface.
#[derive(Clone, Copy, Debug)]
enum Step {
    View(Rect),
    Clip(Rect),
}

/// What a frame shows of its memory, in numbers that cannot overflow.
#[derive(Clone, Copy)]
struct Seen {
    /// x0, y0, x1, y1 of the pixels that can be painted.
    window: [i64; 4],
    /// Column and row in memory of (0, 0).
    origin: [i64; 2],
}

impl Seen {
    fn after(self, step: Step) -> Self {
        let Self { window: [x0, y0, x1, y1], origin: [column, row] } = self;
        let (Step::View(area) | Step::Clip(area)) = step;
        let [a, b, c, d] = [area.x0, area.y0, area.x1, area.y1].map(i64::from);
        let common = |c: i64, d: i64| [x0.max(a), y0.max(b), x1.min(c), y1.min(d)];
        match step {
            Step::Clip(_) => Self { window: common(c, d), ..self },
            Step::View(_) => {
                let [x0, y0, x1, y1] = common(c.min(a + 65_535), d.min(b + 65_535));
                Self { window: [x0 - a, y0 - b, x1 - a, y1 - b], origin: [column + a, row + b] }
            }
        }
    }

    fn is_empty(self) -> bool {
        let [x0, y0, x1, y1] = self.window;
        x0 >= x1 || y0 >= y1
    }

    fn window(self) -> Rect {
        if self.is_empty() {
            return Rect::default();
        }
        let [x0, y0, x1, y1] = self.window.map(|n| i32::try_from(n).expect("a window that is seen lies in i32"));
        Rect { x0, y0, x1, y1 }
    }
}

/// A naive surface: no more than a surface must do, and nothing may be painted outside.
struct Plain<'a, F> {
    memory: &'a mut Naive,
    seen: Seen,
    /// Whether the layout has its own way through corridors.
    corridors: bool,
    format: std::marker::PhantomData<F>,
}

impl<F: PixelFormat> Plain<'_, F> {
    fn place(&self, x: i32, y: i32) -> (i32, i32) {
        assert!(self.seen.window().contains(x, y), "{x}, {y} lies outside of {:?}", self.seen.window());
        let [column, row] = self.seen.origin;
        let memory = |n: i32, origin: i64| i32::try_from(i64::from(n) + origin).expect("memory is small");
        (memory(x, column), memory(y, row))
    }
}

impl<F: PixelFormat> Surface for Plain<'_, F> {
    type Color = F::Color;

    fn window(&self) -> Rect {
        self.seen.window()
    }

    fn fill_span(&mut self, span: ClippedSpan, color: F::Color) {
        assert!(span.x0() < span.x1(), "an empty span");
        for x in span.x0()..span.x1() {
            let (x, y) = self.place(x, span.y());
            self.memory.set(x, y, F::pack(color));
        }
    }
}

impl<F: PixelFormat> Readable for Plain<'_, F> {
    fn color_at(&self, x: i32, y: i32) -> F::Color {
        let (x, y) = self.place(x, y);
        F::unpack(self.memory.get(x, y).expect("it lies in memory"))
    }

    fn fill_corridor(
        &mut self,
        from: Point,
        down: bool,
        color: F::Color,
        is_open: impl Fn(F::Color) -> bool,
    ) -> Option<i32> {
        let Point { x, mut y } = from;
        let open = |surface: &Self, x, y| surface.get(Point::new(x, y)).is_some_and(&is_open);
        while self.corridors && open(self, x, y) && !open(self, x - 1, y) && !open(self, x + 1, y) {
            self.set(Point::new(x, y), color);
            y += if down { 1 } else { -1 };
        }
        self.corridors.then_some(y)
    }
}

/// Calls the frame at the end of a way of views and clips.
fn at_the_end<L: Layout, R, A>(frame: &mut Frame<&mut [u8], L>, steps: &[Step], act: &mut A) -> R
where
    A: FnMut(&mut Frame<&mut [u8], L>) -> R,
{
    match steps.split_first() {
        None => act(frame),
        Some((Step::View(area), rest)) => at_the_end(&mut frame.view(*area), rest, act),
        Some((Step::Clip(area), rest)) => at_the_end(&mut frame.clipped(*area), rest, act),
    }
}

/// Calls of embedded-graphics that a frame answers itself, and the ones of the list that do the same.
const TWICE: [(&str, &str); 4] = [
    ("Frame::clear", "Canvas::fill_window"),
    ("Frame::draw_iter", "SurfaceTarget::draw_iter"),
    ("Frame::fill_contiguous", "SurfaceTarget::fill_contiguous"),
    ("Frame::fill_solid", "SurfaceTarget::fill_solid"),
];

/// By its own way if it has one.
fn call_frame<L: Layout>(frame: &mut Frame<&mut [u8], L>, a: &mut Arguments<'_, L>, number: usize) -> usize {
    if let Some(answer) = a.flag.then(|| call_past_the_window(frame, a, number)).flatten() {
        return answer;
    }
    let own = TWICE.iter().find(|(_, name)| a.flag && *name == calls::name(number));
    match own.and_then(|(own, _)| frames::NAMES.iter().position(|name| name == own)) {
        Some(number) => frames::call(frame, a, number),
        None => call(frame, a, number),
    }
}

/// A span or a line that was clipped against more than the window: a frame paints what lies in it.
fn call_past_the_window<L: Layout>(
    frame: &mut Frame<&mut [u8], L>,
    a: &mut Arguments<'_, L>,
    number: usize,
) -> Option<usize> {
    let (window, area, [from, to, _]) = (frame.window(), a.areas[0], a.points);
    let around = window.inset(-50);
    let span = Span { y: area.y0, x0: area.x0, x1: area.x1 };
    match calls::name(number) {
        "Surface::fill_span" => {
            if let Some(span) = span.clip(around) {
                frame.fill_span(span, a.colors[0]);
            }
            Some(span.clip(window).is_some().into())
        }
        "Surface::fill_steps" => {
            if let Some(steps) = line::clip(from, to, around) {
                frame.fill_steps(steps, a.colors[0]);
            }
            Some(line::clip(from, to, window).is_some().into())
        }
        _ => None,
    }
}

/// Copies by their rule, pixel by pixel: what a call does that the traits would do with the arithmetic of frames.
fn copied<L: Layout, F: PixelFormat<Color = L::Color>>(
    on: &mut Plain<'_, F>,
    a: &Arguments<'_, L>,
    number: usize,
) -> bool {
    let [color, other] = a.colors;
    let (keyed, off) = (Some(other), a.flag.then_some(other));
    match calls::name(number) {
        "Canvas::blit" => on.put(a.points[0], a.picture.window(), |at| a.picture.get(at)),
        "Canvas::blit_keyed" => {
            on.put(a.points[0], a.picture.window(), |at| a.picture.get(at).filter(|&c| keyed != Some(c)));
        }
        "Surface::copy_picture" => {
            on.put(a.points[0], a.picture.window(), |at| a.picture.get(at).filter(|&c| off != Some(c)));
        }
        "Canvas::blit_mask" | "Surface::copy_mask" => {
            let first = calls::name(number) == "Canvas::blit_mask";
            let (window, is_set): (_, &dyn Fn(Point) -> _) = if first {
                (a.mask.window(), &|at| a.mask.get(at) == Some(Index1::new(1)))
            } else {
                (a.mask_msb0.window(), &|at| a.mask_msb0.get(at) == Some(Index1::new(1)))
            };
            on.put(a.points[0], window, |at| if is_set(at) { Some(color) } else { off });
        }
        "Canvas::move_area" | "Readable::copy_area" => on.move_area(a.areas[0], a.points[0], None),
        "Canvas::move_area_keyed" => on.move_area(a.areas[0], a.points[0], keyed),
        _ => return false,
    }
    true
}

impl<F: PixelFormat> Plain<'_, F> {
    /// The pixels of `area`, the top left one at `at`, in the colours that they have.
    fn put(&mut self, at: Point, area: Rect, color: impl Fn(Point) -> Option<F::Color>) {
        for (x, y) in pixels(area) {
            let to = |at: i32, n: i32, from: i32| i32::try_from(i64::from(at) + i64::from(n) - i64::from(from));
            if let (Ok(to_x), Ok(to_y), Some(color)) =
                (to(at.x, x, area.x0), to(at.y, y, area.y0), color(Point::new(x, y)))
            {
                self.set(Point::new(to_x, to_y), color);
            }
        }
    }

    fn move_area(&mut self, area: Rect, to: Point, key: Option<F::Color>) {
        let shift = |to: i32, from: i32, n: i32| i32::try_from(i64::from(to) - i64::from(from) + i64::from(n));
        let seen = area.intersection(self.window());
        let old: Vec<_> = pixels(seen).map(|(x, y)| (x, y, self.color_at(x, y))).collect();
        for (x, y, color) in old.into_iter().filter(|&(_, _, color)| key != Some(color)) {
            if let (Ok(x), Ok(y)) = (shift(to.x, area.x0, x), shift(to.y, area.y0, y)) {
                self.set(Point::new(x, y), color);
            }
        }
    }
}

/// Runs a sequence of calls that bytes describe. Panics where memory and twin differ.
///
/// With the feature `all-layouts` on 19 layouts, else on 4 of different kinds, which are compiled in a fifth of the time.
///
/// Generic in the bytes, so that all calls on all layouts are compiled for who makes them, not for every test that has a twin.
pub fn sequence(bytes: impl AsRef<[u8]>) {
    let mut input = Input(bytes.as_ref());
    macro_rules! kinds {
        ($($(#[$attribute:meta])? $layout:ty, $format:ty, $arrangement:ident, $bits:literal;)*) => {{
            let runs: &[fn(&mut Input<'_>)] = &[$($(#[$attribute])? |input| {
                let format = Format::of::<$format>().arranged(Arrangement::$arrangement, $bits);
                Run::<$layout, $format>::new(input, format).go(input);
            }),*];
            runs[input.index(runs.len())](&mut input);
        }};
    }
    kinds! {
        #[cfg(feature = "all-layouts")]
        Rows<Index1>, Index1, Rows, 1;
        #[cfg(feature = "all-layouts")]
        Rows<Lsb0<Index1>>, Lsb0<Index1>, Rows, 1;
        #[cfg(feature = "all-layouts")]
        Rows<Index2>, Index2, Rows, 2;
        #[cfg(feature = "all-layouts")]
        Rows<Lsb0<Index2>>, Lsb0<Index2>, Rows, 2;
        #[cfg(feature = "all-layouts")]
        Rows<Index4>, Index4, Rows, 4;
        Rows<Lsb0<Index4>>, Lsb0<Index4>, Rows, 4;
        #[cfg(feature = "all-layouts")]
        Rows<Index8>, Index8, Rows, 8;
        Rows<Rgb565>, Rgb565, Rows, 16;
        #[cfg(feature = "all-layouts")]
        Rows<Be<Rgb565>>, Be<Rgb565>, Rows, 16;
        #[cfg(feature = "all-layouts")]
        Rows<embedded_graphics_core::pixelcolor::Rgb555>, embedded_graphics_core::pixelcolor::Rgb555, Rows, 16;
        #[cfg(feature = "all-layouts")]
        Rows<Rgb888>, Rgb888, Rows, 24;
        #[cfg(feature = "all-layouts")]
        Rows<Be<Rgb888>>, Be<Rgb888>, Rows, 24;
        #[cfg(feature = "all-layouts")]
        Rows<Xrgb8888>, Xrgb8888, Rows, 32;
        #[cfg(feature = "all-layouts")]
        Rows<Be<Xrgb8888>>, Be<Xrgb8888>, Rows, 32;
        #[cfg(feature = "all-layouts")]
        Pages<Index1>, Index1, Pages, 1;
        Pages<Lsb0<BinaryColor>>, Lsb0<BinaryColor>, Pages, 1;
        #[cfg(feature = "all-layouts")]
        Planes<Index2>, Index2, Planes, 2;
        #[cfg(feature = "all-layouts")]
        Planes<Lsb0<Gray2>>, Lsb0<Gray2>, Planes, 2;
        Packed12, Rgb444, Stream, 12;
    }
}

/// A sequence on a layout.
struct Run<L, F: PixelFormat> {
    twin: Naive,
    real: Vec<u8>,
    /// Of the screen that the memory is a band of.
    height: u16,
    /// The first row in memory, if it is a band.
    band: Option<u16>,
    palette: [F::Color; 3],
    scratch: Scratch,
    log: String,
    layout: std::marker::PhantomData<L>,
}

impl<L: Layout, F: PixelFormat<Color = L::Color>> Run<L, F> {
    fn new(input: &mut Input<'_>, format: Format) -> Self {
        let (seed, kind) = (u64::from(input.byte()), input.byte());
        let mut rng = Rng::new(seed);
        let (width, rows) = (input.below(91) as u16, input.below(41) as u16);
        let (start, gap) = (input.index(8), input.pick(&[0, 0, 1, 2, 3, 5]));
        let page = format.page();
        // Rows before and after a band; a band of pages begins with a page, and ends with one or with the screen.
        let band = (kind % 4 == 0).then(|| input.below(40) as u16 * page);
        let after = if rows.is_multiple_of(page) { input.below(9) as u16 } else { 0 };
        let gap = if band.is_some() { 0 } else { gap };
        let mut twin = Naive::random(&mut rng, format, (width, rows), start, gap);
        let palette = [(); 3].map(|()| format.random(&mut rng));
        // Noise stops every flood at once. Others begin with an empty picture, or with stripes.
        for (x, y) in pixels(twin.window()) {
            match kind / 4 % 4 {
                0 => {}
                1 => twin.set(x, y, palette[usize::from(x % 5 == 0 && y % 7 != 0)]),
                _ => twin.set(x, y, palette[0]),
            }
        }
        Self {
            real: twin.bytes.clone(),
            height: band.map_or(rows, |first| first + rows + after),
            band,
            palette: palette.map(F::unpack),
            scratch: Scratch::new(seed),
            log: String::new(),
            layout: std::marker::PhantomData,
            twin,
        }
    }

    fn go(&mut self, input: &mut Input<'_>) {
        while input.goes_on() {
            let first = self.band.unwrap_or(0);
            let rows = [i64::from(first), i64::from(first) + i64::from(self.twin.height)];
            let mut seen =
                Seen { window: [0, rows[0], self.twin.width.into(), rows[1]], origin: [0, -i64::from(first)] };
            let mut steps = vec![];
            for _ in 0..input.below(4) {
                let window = seen.window();
                let area = if input.one_in(12) { input.wild_area() } else { input.area_near(window) };
                // Most of them show most of it.
                let area = if input.one_in(2) { area } else { area.union(window) };
                let step = if input.one_in(2) { Step::View(area) } else { Step::Clip(area) };
                // What shows nothing is seldom of interest.
                if !seen.after(step).is_empty() || input.one_in(16) {
                    seen = seen.after(step);
                    steps.push(step);
                }
            }
            let _ = write!(self.log, "\n{steps:?}:");
            for _ in 0..=input.below(6) {
                self.call(input, seen, &steps);
            }
        }
    }

    fn call(&mut self, input: &mut Input<'_>, seen: Seen, steps: &[Step]) {
        let (number, choice) = (input.index(calls::COUNT), input.byte());
        let ground = if input.one_in(10) { Ground::Wild } else { Ground::Near(seen.window()) };
        let colors = [(); 2].map(|()| input.pick(&self.palette));
        let _ = write!(self.log, " {}", calls::name(number));
        let mut again = input.clone();
        let mut arguments = self.scratch.arguments::<L>(input, ground, colors);
        let rows = self.band.map(|first| first..first + self.twin.height);
        let memory = &mut self.real[self.twin.place.clone()];
        let (width, stride) = (self.twin.width, self.twin.stride);
        let frame = match rows {
            Some(rows) => Frame::<_, L>::band(memory, width, self.height, rows),
            None => Frame::with_stride(memory, width, self.height, stride),
        };
        let answer = at_the_end(&mut frame.expect("the memory is as large as the twin says"), steps, &mut |frame| {
            let window = frame.window();
            assert!(
                if seen.is_empty() { window.is_empty() } else { window == seen.window() },
                "{window:?} instead of {:?}{}",
                seen.window(),
                self.log
            );
            call_frame(frame, &mut arguments, number)
        });
        let corridors = answer != 0;
        let mut plain = Plain::<F> { memory: &mut self.twin, seen, corridors, format: std::marker::PhantomData };
        let mut arguments = self.scratch.arguments::<L>(&mut again, ground, colors);
        // Half of the copies by their rule, half as a surface does them that knows nothing of memory.
        let by_rule = choice & 1 == 0 && copied(&mut plain, &arguments, number);
        let wanted = if by_rule { 0 } else { call(&mut plain, &mut arguments, number) };
        let log = &self.log;
        assert_eq!(answer, wanted, "the answers in {:?}{log}", seen.window());
        self.twin.assert_same(&self.real, &|| format!("in {:?} of {:?}, {log}", seen.window(), self.band));
    }
}
