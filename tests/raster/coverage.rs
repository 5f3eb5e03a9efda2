//! Coverage against exact areas in wide integers: how far off, how often not the nearest level, no pixel tinted that is empty or
//! full; and the same bytes with any window, table and number of cells.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "small numbers, and sums of small numbers"
)]

use embedded_raster::{
    raster::coverage::{self, CoverageSlot},
    ClippedSpan, EdgeTableFull, FillRule, Path, PathSegment, PointFx, Rect, Sink,
};
use twins::{
    coverage::{area, sides, winding_area, Levels, PIXEL},
    rng::{cases, Rng},
    scenes::{outline, window_on, Scale},
    tiles, vertices, Units,
};

/// Polygons per scale.
const POLYGONS: usize = 6_000;
const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

fn covered(
    contours: &[Vec<Units>],
    rule: FillRule,
    window: Rect,
    (slots, cells): (usize, usize),
) -> Result<Levels, EdgeTableFull> {
    let contours: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
    let mut table = vec![CoverageSlot::EMPTY; slots];
    // What is in the memory does not matter.
    let mut cells = vec![0x1234_5678; cells];
    let mut levels = Levels::new(window);
    let result = coverage::fill(contours.iter(), rule, &mut table, &mut cells, window, &mut levels);
    assert!(result.is_ok() || levels.calls == 0, "something was told before {result:?}");
    result.map(|()| levels)
}

/// With memory enough for anything.
fn picture(contours: &[Vec<Units>], rule: FillRule, window: Rect) -> Levels {
    let enough = (sides(contours).count(), coverage::cells(window.width() as u16));
    covered(contours, rule, window, enough).expect("a slot for each side is enough")
}

/// How good levels are, over all pixels that are looked at.
#[derive(Default, Debug)]
struct Judge {
    pixels: u64,
    partial: u64,
    not_nearest: u64,
    /// The largest error where one side goes through the pixel, and with any number of them, in millionths of a level.
    worst: [i128; 2],
}

impl Judge {
    /// Compares a picture with exact areas.
    fn look(&mut self, contours: &[Vec<Units>], rule: FillRule, got: &Levels) {
        let window = got.window;
        let tiny = sides(contours).count() as i128;
        for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
            let (exact, found) = (area(contours, rule, (x, y)), got.at(x, y));
            let what = || format!("({x}, {y}): {found} for {exact}, {rule:?} of {contours:?} in {window:?}");
            self.pixels += 1;
            if exact <= tiny {
                assert_eq!(found, 0, "an empty pixel is tinted: {}", what());
                continue;
            }
            if exact >= PIXEL - tiny {
                assert_eq!(found, 255, "a full pixel is tinted: {}", what());
                continue;
            }
            self.partial += 1;
            let error = (exact * 255 - i128::from(found) * PIXEL).abs() * 1_000_000 / PIXEL;
            let through = sides(contours).filter(|&side| touches(side, (x, y))).count();
            self.worst[usize::from(through != 1)] = self.worst[usize::from(through != 1)].max(error);
            assert!(error <= 500_000 + 8_300 * through.max(1) as i128, "{error} millionths off: {}", what());
            // Half way between two levels either one is nearest; the exact area is cut a little.
            self.not_nearest += u64::from((exact * 255 - i128::from(found) * PIXEL).abs() > PIXEL / 2 + 255 * tiny);
        }
    }
}

/// Whether the box of a side has something in common with a pixel.
fn touches((a, b): (Units, Units), (x, y): (i32, i32)) -> bool {
    let meets = |a: i32, b: i32, pixel: i32| {
        let (low, high) = (i64::from(a.min(b)), i64::from(a.max(b)));
        low < (i64::from(pixel) + 1) * 256 && high >= i64::from(pixel) * 256
    };
    meets(a.0, b.0, x) && meets(a.1, b.1, y)
}

fn random_polygon(rng: &mut Rng, scale: Scale) -> Vec<Vec<Units>> {
    let contours = rng.pick(&[1, 1, 1, 2, 3]);
    let all = outline(rng, scale, 18);
    let mut rest = &all[..];
    let mut sizes = || if rng.one_in(12) { rng.index(3) } else { 3 + rng.index(3) };
    (0..contours)
        .map(|_| {
            let (contour, other) = rest.split_at(sizes());
            rest = other;
            contour.to_vec()
        })
        .collect()
}

fn window_for(rng: &mut Rng, contours: &[Vec<Units>]) -> Rect {
    let window = match contours.iter().find(|c| !c.is_empty()) {
        Some(contour) => window_on(rng, contour),
        None => Rect::new(-3, -3, 3, 3),
    };
    Rect { x1: window.x1.min(window.x0.saturating_add(70)), y1: window.y1.min(window.y0.saturating_add(40)), ..window }
}

fn random(scale: Scale) {
    let mut rng = Rng::new(1_400 + scale as u64);
    let mut judge = Judge::default();
    for _ in 0..cases(POLYGONS) {
        let contours = random_polygon(&mut rng, scale);
        let window = window_for(&mut rng, &contours);
        for rule in RULES {
            judge.look(&contours, rule, &picture(&contours, rule, window));
        }
    }
    println!("{scale:?}: {judge:?}");
    assert!(judge.partial > cases(POLYGONS) as u64, "too few rims: {judge:?}");
    assert!(judge.not_nearest * 1_000 <= judge.partial * 3, "less than 99.7 % nearest: {judge:?}");
    assert!(judge.worst[0] <= 510_000, "{judge:?}");
}

#[test]
fn tiny_polygons_are_exact() {
    random(Scale::Tiny);
}

#[test]
fn polygons_of_a_screen_are_exact() {
    random(Scale::Screen);
}

#[test]
fn polygons_of_a_hundred_screens_are_exact() {
    random(Scale::Hundred);
}

#[test]
fn polygons_at_the_ends_of_the_type_are_exact() {
    random(Scale::Ends);
}

#[test]
fn windows_tables_and_cells_change_nothing() {
    let mut rng = Rng::new(1_410);
    for i in 0..cases(4_000) {
        let scale = Scale::ALL[i % 4];
        let contours = random_polygon(&mut rng, scale);
        let window = window_for(&mut rng, &contours);
        let rule = RULES[i / 4 % 2];
        let whole = picture(&contours, rule, window);
        let what = || format!("{rule:?} of {contours:?} in {window:?}");
        for cells in [0, 1, 33, 34, 35, 36, 60] {
            let got = covered(&contours, rule, window, (sides(&contours).count(), cells)).expect("enough slots");
            assert!(got.levels == whole.levels, "{cells} cells: {}\n{}\n{}", what(), got.picture(), whole.picture());
        }
        for size in [(1, 1), (70, 1), (3, 40), (9, 7), (40, 16)] {
            for tile in tiles(window, size) {
                let got = picture(&contours, rule, tile);
                for (x, y) in (tile.y0..tile.y1).flat_map(|y| (tile.x0..tile.x1).map(move |x| (x, y))) {
                    assert_eq!(got.at(x, y), whole.at(x, y), "({x}, {y}) in {tile:?}: {}", what());
                }
            }
        }
        for slots in 0..sides(&contours).count() {
            match covered(&contours, rule, window, (slots, 40)) {
                Ok(got) => assert!(got.levels == whole.levels, "{slots} slots: {}", what()),
                Err(error) => {
                    let rows = Rect { y0: error.row, y1: error.row + 1, ..window };
                    let again = covered(&contours, rule, rows, (error.needed, 40));
                    assert!(error.capacity == slots && again.is_ok(), "{error:?} for {slots} slots: {}", what());
                    assert!(covered(&contours, rule, rows, (error.needed - 1, 40)).is_err(), "{error:?}: {}", what());
                }
            }
        }
    }
}

/// A side from far left that ends just beyond the last strip, which is narrower than the others; then a shape in its columns.
#[test]
fn strips_leave_nothing_behind() {
    let window = Rect::new(0, 0, 40, 4);
    for end in [10_241, 10_368, 10_495, 10_496, 10_600] {
        let far = vec![(-17_920_000, -17_930_000), (end, 380), (-17_920_000, 380)];
        let contours = [far, vec![(2_300, 512), (2_600, 512), (2_450, 1_000)]];
        let whole = picture(&contours, RULES[0], window);
        for cells in [0, 34, 35, 36, 40, 42] {
            let got = covered(&contours, RULES[0], window, (6, cells)).expect("enough slots");
            assert!(got.levels == whole.levels, "{cells} cells, {end}\n{}\n{}", got.picture(), whole.picture());
        }
    }
}

#[test]
fn shapes_that_share_a_side_add_up() {
    let mut rng = Rng::new(1_420);
    let mut seen = [0_u32; 4];
    for _ in 0..cases(20_000) {
        let reach = rng.pick(&[700, 3_000, 12_000]);
        let mut place = || (rng.int(-reach, reach), rng.int(-reach, reach));
        // Four triangles around a place, all turned the same way or not.
        let (middle, corners) = ((0, 0), [place(), place(), place(), place()]);
        let window = Rect::new(-12, -12, 12, 12);
        let parts: Vec<Levels> =
            (0..2).map(|i| picture(&[vec![middle, corners[i], corners[i + 1]]], FillRule::NonZero, window)).collect();
        let exact = |i: usize, pixel| winding_area(&[vec![middle, corners[i], corners[i + 1]]], pixel);
        for (x, y) in (-12..12).flat_map(|y| (-12..12).map(move |x| (x, y))) {
            let (a, b) = (exact(0, (x, y)), exact(1, (x, y)));
            // On both sides of the line that they share, and full together.
            if a.signum() == b.signum() && (a + b).abs() >= PIXEL - 6 && a.abs() > 6 && b.abs() > 6 {
                let sum = u32::from(parts[0].at(x, y)) + u32::from(parts[1].at(x, y));
                assert!((254..=256).contains(&sum), "{sum} at ({x}, {y}): {corners:?}");
                seen[sum as usize - 254] += 1;
            }
        }
    }
    println!("sums of 254, 255, 256: {seen:?}");
    assert!(seen[1] > 1_000, "too few: {seen:?}");
}

/// What the module says of sides that cross inside of a pixel.
#[test]
fn sides_that_cross_in_a_pixel() {
    let window = Rect::new(0, 0, 3, 1);
    let levels = |contours: &[Vec<Units>], rule| picture(contours, rule, window).levels;
    // A bow-tie in the pixel: its loops turn in opposite directions.
    let bow_tie = [vec![(256, 0), (512, 256), (512, 0), (256, 256)]];
    assert_eq!(RULES.map(|rule| levels(&bow_tie, rule)), [[0, 0, 0], [0, 0, 0]]);
    // The left half twice: the true area is 1/2.
    let half = vec![(256, 0), (384, 0), (384, 256), (256, 256)];
    assert_eq!(levels(&[half.clone(), half.clone()], FillRule::NonZero), [0, 255, 0], "where 128 would be right");
    assert_eq!(levels(&[half.clone(), half.clone()], FillRule::EvenOdd), [0, 255, 0], "where 0 would be right");
    let back: Vec<Units> = half.iter().rev().copied().collect();
    assert_eq!(levels(&[half.clone(), back], FillRule::NonZero), [0, 0, 0]);
    // Halves beside each other are right, whichever way they turn, by the even-odd rule or if they turn the same way.
    let other = vec![(384, 0), (512, 0), (512, 256), (384, 256)];
    assert_eq!(RULES.map(|rule| levels(&[half.clone(), other.clone()], rule)), [[0, 255, 0], [0, 255, 0]]);
    // The neighbours of a pixel with a crossing are right: a bow-tie over three pixels that crosses in the middle one.
    let wide = [vec![(0, 0), (768, 256), (768, 0), (0, 256)]];
    let got = levels(&wide, FillRule::EvenOdd);
    assert_eq!((got[0], got[2]), (170, 170));
    assert!(got[1] < 43, "the loops cancel out in the middle: {got:?}, where 43 would be right");
}

#[test]
fn many_windings_are_counted() {
    let window = Rect::new(0, 0, 2, 1);
    // The first pixel and half of the second one, so many times.
    let turns = |n: usize| [(0..n).flat_map(|_| [(0, 0), (384, 0), (384, 256), (0, 256)]).collect::<Vec<Units>>()];
    for n in [1, 2, 3, 255, 256, 4_095, 8_191] {
        let wanted = [vec![255, if n == 1 { 128 } else { 255 }], vec![255 * (n % 2) as u8, [0, 128, 255, 128][n % 4]]];
        assert_eq!(RULES.map(|rule| picture(&turns(n), rule, window).levels), [&wanted[0][..], &wanted[1][..]], "{n}");
    }
}

/// The sum of all levels.
struct Sum(u64);
impl Sink for &mut Sum {
    fn span(&mut self, span: ClippedSpan) {
        self.0 += u64::from(span.len()) * 255;
    }

    fn coverage(&mut self, _: ClippedSpan, levels: &[u8]) {
        self.0 += levels.iter().map(|&level| u64::from(level)).sum::<u64>();
    }
}

/// A window may be as large as the type allows: only what the shape has of it is looked at.
#[test]
fn windows_without_end_cost_nothing() {
    let mut rng = Rng::new(1_440);
    let endless = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    for i in 0..cases(600) {
        let contours = random_polygon(&mut rng, Scale::Tiny);
        let rule = RULES[i % 2];
        let contours: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
        let window = coverage::extent(contours.iter());
        let sum = |window, cells: &mut [i32]| {
            let (mut sum, mut table) = (Sum(0), [CoverageSlot::EMPTY; 18]);
            coverage::fill(contours.iter(), rule, &mut table, cells, window, &mut sum).expect("enough slots");
            sum.0
        };
        let wanted = sum(window, &mut [0; 70]);
        assert_eq!(sum(endless, &mut []), wanted, "{contours:?}");
        // Cut off on one side or on two.
        let half = Rect { x1: i32::MAX, y1: i32::MAX, ..window };
        assert_eq!(sum(half, &mut [0; 40]), wanted, "{contours:?} in {half:?}");
    }
}

/// A pixel-aligned shape is plain spans, and so is the middle of any other.
#[test]
fn full_pixels_are_plain_spans() {
    let window = Rect::new(0, 0, 200, 20);
    let aligned =
        picture(&[vec![(256, 256), (256 * 190, 256), (256 * 190, 256 * 9), (256, 256 * 9)]], RULES[0], window);
    assert_eq!((aligned.plain, aligned.calls), (189 * 8, 8));
    let shifted = picture(&[vec![(300, 300), (48_000, 300), (48_000, 2_400), (300, 2_400)]], RULES[0], window);
    // From column 2 to 186, in rows 2 to 8.
    assert_eq!(shifted.plain, 185 * 7);
}

#[test]
fn fine_curves_are_within_their_tolerance() {
    let mut rng = Rng::new(1_430);
    let mut worst = 0.0_f64;
    for i in 0..cases(3_000) {
        let reach = [300, 2_000, 20_000, 60_000][i % 4];
        let mut place = || (rng.int(-reach, reach), rng.int(-reach, reach));
        let points = [place(), place(), place(), place()];
        let [a, c, d, b] = points.map(|(x, y)| PointFx::from_bits(x, y));
        let segments = [PathSegment::MoveTo(a), PathSegment::CubicTo(c, d, b)];
        let all = Rect::new(-1_000, -1_000, 1_000, 1_000);
        let places: Vec<Units> =
            Path::new(&segments).fine_contours_in(all).flatten().map(|v| (v.x.to_bits(), v.y.to_bits())).collect();
        worst = worst.max(twins::coverage::distance_of_curve(points, &places));
    }
    println!("lines are at most {worst} units from their curves");
    assert!(worst <= 4.0, "{worst} units from the curve");
}
