//! Lines against `m(k) = floor((2 k db + da) / (2 da))`, in wide integers: not one pixel differs, wherever the ends are
//! and however small the window.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray8, Rgb565, Rgb888, RgbColor},
};
use embedded_raster::{
    buffer_bytes,
    pixel::{Lsb0, Xrgb8888},
    raster::line,
    Canvas, ClippedSpan, Framebuffer, Index1, Index4, PixelFormat, Rect, Steps, Surface,
};
use twins::{
    hits::Hits,
    rng::{cases, Rng},
    scenes::{ends_of_line, window_on_line, Scale},
    tiles, Run, TILE_SIZES,
};

/// Lines per scale.
const LINES: usize = 500_000;

fn point((x, y): (i32, i32)) -> Point {
    Point::new(x, y)
}

/// The visible pixels in the order that they are painted: along the line, but never upwards.
fn downwards(a: (i32, i32), b: (i32, i32), window: Rect) -> Vec<(i32, i32)> {
    let mut pixels = twins::line(a, b, window);
    if a.1 > b.1 {
        pixels.reverse();
    }
    pixels
}

/// The pixels that single steps give.
fn stepped(mut steps: Steps) -> Vec<(i32, i32)> {
    let dx = if steps.goes_right() { 1 } else { -1 };
    let (mut x, mut y) = steps.first();
    let mut pixels = vec![];
    for left in (0..steps.len()).rev() {
        pixels.push((x, y));
        let minor = steps.next_is_minor();
        if left > 0 {
            x += if minor || !steps.is_steep() { dx } else { 0 };
            y += i32::from(minor || steps.is_steep());
        }
    }
    pixels
}

/// The runs of pixels with the same row, in their order.
fn runs(pixels: &[(i32, i32)]) -> Vec<Run> {
    let mut runs: Vec<Run> = vec![];
    for &(x, y) in pixels {
        match runs.last_mut() {
            Some(last) if last.0 == y => (last.1, last.2) = (last.1.min(x), last.2.max(x + 1)),
            _ => runs.push((y, x, x + 1)),
        }
    }
    runs
}

fn spans(steps: Option<Steps>) -> Vec<Run> {
    let mut runs = vec![];
    if let Some(steps) = steps {
        steps.spans(|s: ClippedSpan| runs.push((s.y(), s.x0(), s.x1())));
    }
    runs
}

/// Pixels, their order, and the runs they are painted in.
fn check([a, b]: [(i32, i32); 2], window: Rect) {
    let wanted = downwards(a, b, window);
    let steps = line::clip(point(a), point(b), window);
    if let Some(steps) = steps {
        assert_eq!((Some(&steps.first()), Some(&steps.last())), (wanted.first(), wanted.last()), "{a:?} to {b:?}");
    }
    assert_eq!(steps.map(stepped).unwrap_or_default(), wanted, "steps from {a:?} to {b:?} in {window:?}");
    assert_eq!(spans(steps), runs(&wanted), "spans from {a:?} to {b:?} in {window:?}");
}

fn random(scale: Scale) {
    let mut rng = Rng::new(1 + scale as u64);
    let (count, mut seen) = (cases(LINES), 0);
    for _ in 0..count {
        let ends = ends_of_line(&mut rng, scale);
        let window = window_on_line(&mut rng, ends);
        check(ends, window);
        seen += usize::from(line::clip(point(ends[0]), point(ends[1]), window).is_some());
    }
    assert!(seen >= count / 2, "only {seen} lines were seen");
}

#[test]
fn tiny_lines() {
    random(Scale::Tiny);
}

#[test]
fn screen_lines() {
    random(Scale::Screen);
}

#[test]
fn lines_of_a_hundred_screens() {
    random(Scale::Hundred);
}

#[test]
fn lines_at_the_ends_of_the_type() {
    random(Scale::Ends);
}

#[test]
fn every_line_of_a_small_grid_in_every_window() {
    let all = || (0..7).flat_map(|y| (0..7).map(move |x| (x, y)));
    for a in all() {
        for b in all() {
            for (x0, y0) in all().map(|(x, y)| (x - 1, y - 1)) {
                for (w, h) in [(1, 1), (1, 4), (3, 2), (9, 9)] {
                    check([a, b], Rect::new(x0, y0, x0 + w, y0 + h));
                }
            }
        }
    }
}

/// An empty window shows nothing, even where its end less one is the largest number.
#[test]
fn windows_without_pixels() {
    const ENDS: [i32; 5] = [i32::MIN, i32::MIN + 1, 0, i32::MAX - 1, i32::MAX];
    for (low, high) in ENDS.iter().flat_map(|&low| ENDS.map(|high| (low, high))).filter(|(low, high)| low >= high) {
        for (from, to) in ENDS.iter().flat_map(|&from| ENDS.map(|to| (from, to))) {
            for (a, b) in [((from, -3), (to, 4)), ((-3, from), (4, to)), ((from, from), (to, to))] {
                check([a, b], Rect::new(low, -9, high, 9));
                check([a, b], Rect::new(-9, low, 9, high));
            }
        }
    }
}

/// The worked case of the conventions, decisions included.
#[test]
fn the_worked_case() {
    let (a, b) = ((20, 41), (30, 44));
    let (pixels, decisions) = twins::bresenham(a, b);
    assert_eq!(decisions, [-4, 2, -12, -6, 0, -14, -8, -2, 4, -10]);
    #[rustfmt::skip]
    let wanted = [
        (20, 41), (21, 41), (22, 42), (23, 42), (24, 42), (25, 43), (26, 43), (27, 43), (28, 43), (29, 44), (30, 44),
    ];
    assert_eq!(pixels, wanted);
    let window = Rect::new(0, 0, 64, 64);
    assert_eq!(twins::line(a, b, window), wanted);
    let mut steps = line::clip(point(a), point(b), window).expect("it lies in the window");
    assert_eq!(stepped(steps), wanted);
    for p in decisions {
        assert_eq!(steps.next_is_minor(), p >= 0, "at decision {p}");
    }
}

/// The rule by floor division and Bresenham's loop are the same line.
#[test]
fn the_two_twins_agree() {
    let mut rng = Rng::new(77);
    let window = Rect::new(-400, -400, 400, 400);
    for _ in 0..5_000 {
        let ends = [(); 2].map(|()| (rng.int(-350, 350), rng.int(-350, 350)));
        assert_eq!(twins::bresenham(ends[0], ends[1]).0, twins::line(ends[0], ends[1], window), "{ends:?}");
    }
}

/// A window of many pieces shows the same line as the whole.
#[test]
fn tiles_of_every_size_show_the_same_line() {
    let mut rng = Rng::new(78);
    let whole = Rect::new(-13, -7, 35, 33);
    for _ in 0..300 {
        let [a, b] = [(); 2].map(|()| point((rng.int(-60, 90), rng.int(-60, 90))));
        let mut wanted = Hits::new(whole);
        wanted.draw_line(a, b, BinaryColor::On);
        let wanted = wanted.runs();
        for size in TILE_SIZES {
            let mut pieces = Hits::new(whole);
            for tile in tiles(whole, size) {
                pieces.add(&spans(line::clip(a, b, tile)));
            }
            assert_eq!(pieces.runs(), wanted, "{a} to {b} in tiles of {size:?}");
        }
    }
}

/// Every pixel of a line is painted once, by a surface that has nothing but spans.
#[test]
fn a_surface_of_spans_paints_each_pixel_once() {
    let mut rng = Rng::new(79);
    for _ in 0..cases(20_000) {
        let ends = ends_of_line(&mut rng, Scale::Screen);
        let mut hits = Hits::new(window_on_line(&mut rng, ends));
        hits.draw_line(point(ends[0]), point(ends[1]), BinaryColor::On);
        let mut wanted = twins::line(ends[0], ends[1], hits.window());
        wanted.sort_unstable_by_key(|&(x, y)| (y, x));
        assert_eq!(hits.runs(), runs(&wanted), "{ends:?}");
    }
}

/// Lines as long as a framebuffer can be, painted in its memory: whatever the loop that paints them adds up, it adds up
/// 65,535 times.
fn longest_lines<F: PixelFormat>(color: F::Color, (width, height): (u16, u16)) {
    let mut rng = Rng::new(81);
    let mut memory = vec![0; buffer_bytes::<F>(width, height)];
    let mut frame = Framebuffer::<F>::new(&mut memory, width, height).expect("the right size");
    let window = frame.window();
    let off = F::unpack(0);
    for i in 0..30 {
        let reach = rng.pick(&[0, 3, 40, 20_000]);
        let mut end = || (rng.int(-reach, window.x1 - 1 + reach), rng.int(-reach, window.y1 - 1 + reach));
        let (mut a, mut b) = (end(), end());
        if i % 2 == 0 {
            // From one side to the other.
            (a.0, b.0) = if width > height { (0, window.x1 - 1) } else { (a.0, b.0) };
            (a.1, b.1) = if width > height { (a.1, b.1) } else { (0, window.y1 - 1) };
        }
        let (a, b) = if rng.one_in(2) { (a, b) } else { (b, a) };
        frame.draw_line(point(a), point(b), color);
        for (x, y) in twins::line(a, b, window) {
            assert!(frame.get(Point::new(x, y)) == Some(color), "({x}, {y}) of {a:?} to {b:?} is missing");
            frame.set(Point::new(x, y), off);
        }
        assert!(frame.row_bytes(0..height).iter().all(|&b| b == 0), "{a:?} to {b:?} has other pixels too");
    }
}

#[test]
fn longest_lines_of_bits() {
    for size in [(1200, 900), (61, 65_535), (65_535, 61)] {
        longest_lines::<Index1>(Index1::MAX, size);
        longest_lines::<Lsb0<Index4>>(Index4::MAX, size);
    }
}

#[test]
fn longest_lines_of_bytes() {
    for size in [(1200, 900), (61, 65_535), (65_535, 61)] {
        longest_lines::<Gray8>(Gray8::new(7), size);
        longest_lines::<Rgb565>(Rgb565::RED, size);
        longest_lines::<Rgb888>(Rgb888::RED, size);
    }
    longest_lines::<Xrgb8888>(Xrgb8888::RED, (61, 65_535));
}

/// The references of the report on speed against error start where the line starts, and stay near it on a screen.
#[test]
fn references_are_lines() {
    let mut rng = Rng::new(80);
    let window = Rect::new(-400, -400, 400, 400);
    for _ in 0..2_000 {
        let [a, b] = [(); 2].map(|()| (rng.int(-350, 350), rng.int(-350, 350)));
        let exact = twins::line(a, b, window);
        for other in [twins::dda(point(a), point(b)), twins::slope_and_round(point(a), point(b))] {
            assert_eq!(other.len(), exact.len(), "{a:?} to {b:?}");
            for (p, &(x, y)) in other.iter().zip(&exact) {
                assert!((p.x - x).abs() + (p.y - y).abs() <= 1, "{p} is far from ({x}, {y}) on {a:?} to {b:?}");
            }
        }
    }
}
