//! Lines between places against the crossings of a straight line with the middles of columns, as exact ratios; between centres of
//! pixels they are Bresenham's.

use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
use embedded_raster::{
    raster::{line, line_fx},
    Canvas, PointFx, Rect, Steps,
};
use twins::{
    hits::Hits,
    lines,
    rng::{cases, Rng},
    scenes::{ends_of_line, outline, window_on, window_on_line, Scale},
    tiles, vertices, Run, Units, TILE_SIZES,
};

fn place((x, y): Units) -> PointFx {
    PointFx::from_bits(x, y)
}

/// The pixels that single steps give, from the top down.
fn stepped(steps: Option<Steps>) -> Vec<(i32, i32)> {
    let Some(mut steps) = steps else { return vec![] };
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
    assert_eq!(pixels.last(), Some(&steps.last()), "{steps:?}");
    pixels
}

fn check([a, b]: [Units; 2], window: Rect) -> usize {
    let mut wanted = lines::line_fx(a, b, window);
    if a.1 > b.1 {
        wanted.reverse();
    }
    let steps = line_fx::clip(place(a), place(b), window);
    assert_eq!(stepped(steps), wanted, "{a:?} to {b:?} in {window:?}");
    let whole = line_fx::extent(place(a), place(b));
    assert!(wanted.iter().all(|&(x, y)| whole.contains(x, y)), "{a:?} to {b:?} leaves {whole:?}");
    wanted.len()
}

fn random(scale: Scale) {
    let mut rng = Rng::new(1 + scale as u64);
    let (count, mut seen) = (cases(300_000), 0);
    for _ in 0..count {
        let places = outline(&mut rng, scale, 2);
        let ends = [places[0], places[1]];
        seen += usize::from(check(ends, window_on(&mut rng, &ends)) > 0);
    }
    assert!(seen >= count / 3, "only {seen} lines were seen");
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

/// All ends on a grid of quarters of pixels: corners, middles of sides, centres; through all octants, and single places.
#[test]
fn every_line_of_a_small_grid() {
    let all = || (0..17).flat_map(|y| (0..17).map(move |x| (64 * x, 64 * y)));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        for window in [Rect::new(-2, -2, 8, 8), Rect::new(1, 1, 3, 2), Rect::new(2, 0, 3, 9)] {
            check([a, b], window);
        }
    }
}

/// One unit beside corners of pixels, where the choice of a pixel hangs on it.
#[test]
fn ends_beside_corners() {
    let near = [-1, 0, 1, 127, 128, 129, 255, 256, 257];
    let all = || near.iter().flat_map(|&y| near.map(|x| (x, y)));
    for (a, b) in all().flat_map(|a| all().map(move |b| (a, b))) {
        check([a, b], Rect::new(-3, -3, 4, 4));
        let far = |(x, y): Units| (x + 256_000, y + 51_200);
        check([a, far(b)], Rect::new(-3, -3, 400, 400));
        check([far(a), b], Rect::new(500, 90, 510, 120));
    }
}

/// Between centres of pixels the line is Bresenham's, with its choice at ties, step by step.
#[test]
fn between_centres_it_is_bresenhams_line() {
    let mut rng = Rng::new(9);
    for scale in [Scale::Tiny, Scale::Screen, Scale::Hundred] {
        for _ in 0..cases(200_000) {
            let ends = ends_of_line(&mut rng, scale)
                .map(|(x, y)| (x.clamp(-8_000_000, 8_000_000), y.clamp(-8_000_000, 8_000_000)));
            let window = window_on_line(&mut rng, ends);
            let [a, b] = ends.map(|(x, y)| Point::new(x, y));
            let (got, wanted) = (line_fx::clip(a.into(), b.into(), window), line::clip(a, b, window));
            assert_eq!(stepped(got), stepped(wanted), "{a} to {b} in {window:?}");
        }
    }
}

/// Pixels beside each other touch, whatever lies between the ends.
#[test]
fn lines_have_no_gaps() {
    let mut rng = Rng::new(10);
    let window = Rect::new(-400, -400, 400, 400);
    for _ in 0..cases(20_000) {
        let ends = [(); 2].map(|()| (rng.int(-90_000, 90_000), rng.int(-90_000, 90_000)));
        let pixels = stepped(line_fx::clip(place(ends[0]), place(ends[1]), window));
        let touch = |pair: &[(i32, i32)]| (pair[0].0 - pair[1].0).abs() <= 1 && (pair[0].1 - pair[1].1).abs() <= 1;
        assert!(pixels.windows(2).all(touch), "{ends:?}");
        // It begins and ends where it should, or a pixel aside.
        for (end, pixel) in [ends.iter().min_by_key(|p| p.1), ends.iter().max_by_key(|p| p.1)]
            .into_iter()
            .zip([pixels.first(), pixels.last()])
        {
            let (&end, &pixel) = (end.expect("two"), pixel.expect("one at least"));
            let off = ((end.0 >> 8) - pixel.0).abs() + ((end.1 >> 8) - pixel.1).abs();
            assert!(off <= 1, "{ends:?}: {end:?} is far from {pixel:?}");
        }
    }
}

/// A window of many pieces shows the same line as the whole.
#[test]
fn tiles_of_every_size_show_the_same_line() {
    let mut rng = Rng::new(78);
    let whole = Rect::new(-13, -7, 35, 33);
    for _ in 0..300 {
        let [a, b] = [(); 2].map(|()| place((rng.int(-15_000, 23_000), rng.int(-15_000, 23_000))));
        let mut wanted = Hits::new(whole);
        wanted.draw_line_fx(a, b, BinaryColor::On);
        let wanted = wanted.runs();
        for size in TILE_SIZES {
            let mut pieces = Hits::new(whole);
            for tile in tiles(whole, size) {
                let mut runs: Vec<Run> = vec![];
                line_fx::draw(a, b, tile, |s: embedded_raster::ClippedSpan| runs.push((s.y(), s.x0(), s.x1())));
                pieces.add(&runs);
            }
            assert_eq!(pieces.runs(), wanted, "{a:?} to {b:?} in tiles of {size:?}");
        }
    }
}

/// Windows without pixels show nothing.
#[test]
fn windows_without_pixels() {
    const ENDS: [i32; 5] = [i32::MIN, i32::MIN + 1, 0, i32::MAX - 1, i32::MAX];
    let ends = || ENDS.iter().flat_map(|&x| ENDS.map(|y| (x, y)));
    for (low, high) in ends().filter(|(low, high)| low >= high) {
        for places in ends().flat_map(|a| ends().map(move |b| [a, b])) {
            let [a, b] = [places[0], places[1]].map(|p| vertices(&[p])[0]);
            assert!(line_fx::clip(a, b, Rect::new(low, -9, high, 9)).is_none());
            assert!(line_fx::clip(a, b, Rect::new(-9, low, 9, high)).is_none());
        }
    }
}
