//! True areas where sides cross inside of pixels, against areas in wide integers; and hard cases, which are the same for both ways.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    reason = "small numbers, and sums of small numbers"
)]

use embedded_raster::{
    raster::coverage::{self, CoverageSlot},
    EdgeTableFull, FillRule, Path, PathSegment, PointFx, Rect, Stroke,
};
use twins::{
    coverage::{area, sides, true_area, Levels, PIXEL},
    rng::{cases, Rng},
    scenes::{outline, window_on, Scale},
    tiles, vertices, Units,
};

const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

fn covered(
    contours: &[Vec<Units>],
    rule: FillRule,
    window: Rect,
    (slots, cells): (usize, usize),
    is_true: bool,
) -> Result<Levels, EdgeTableFull> {
    let contours: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
    let (mut table, mut cells) = (vec![CoverageSlot::EMPTY; slots], vec![0x1234_5678; cells]);
    let mut levels = Levels::new(window);
    let result = if is_true {
        coverage::fill_true(contours.iter(), rule, &mut table, &mut cells, window, &mut levels)
    } else {
        coverage::fill(contours.iter(), rule, &mut table, &mut cells, window, &mut levels)
    };
    result.map(|()| levels)
}

fn picture(contours: &[Vec<Units>], rule: FillRule, window: Rect, is_true: bool) -> Levels {
    let enough = (sides(contours).count(), coverage::cells(window.width() as u16));
    covered(contours, rule, window, enough, is_true).expect("a slot for each side is enough")
}

/// The largest error in a window, in millionths of a level, and how many pixels are covered in part.
fn judge(contours: &[Vec<Units>], rule: FillRule, window: Rect, is_true: bool) -> (i128, u32) {
    let got = picture(contours, rule, window, is_true);
    let (mut worst, mut partial) = (0, 0);
    let exact = if is_true { true_area } else { area };
    for (x, y) in (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y))) {
        let (exact, found) = (exact(contours, rule, (x, y)), i128::from(got.at(x, y)));
        let error = (exact * 255 - found * PIXEL).abs() * 1_000_000 / PIXEL;
        // Sides and crossings in the pixel: any number of each here.
        let sides = sides(contours).count() as i128;
        let most = 500_000 + 9_000 * sides + if is_true { 16_000 * sides * (sides - 1) / 2 } else { 0 };
        assert!(error <= most, "{error} millionths off at ({x}, {y}): {found}, {rule:?} of {contours:?} in {window:?}");
        worst = worst.max(error);
        partial += u32::from(exact > 0 && exact < PIXEL);
    }
    (worst, partial)
}

fn polygon(rng: &mut Rng, scale: Scale) -> Vec<Vec<Units>> {
    let all = outline(rng, scale, 12);
    let cut = 3 + rng.index(7);
    if rng.one_in(3) {
        vec![all[..cut].to_vec(), all[cut..].to_vec()]
    } else {
        vec![all[..cut].to_vec()]
    }
}

fn small(window: Rect) -> Rect {
    Rect { x1: window.x1.min(window.x0.saturating_add(40)), y1: window.y1.min(window.y0.saturating_add(24)), ..window }
}

#[test]
fn areas_are_true_where_sides_cross() {
    let (mut rng, mut worst, mut partial) = (Rng::new(1_460), 0, 0);
    for i in 0..cases(3_000) {
        let contours = polygon(&mut rng, [Scale::Tiny, Scale::Screen, Scale::Tiny][i % 3]);
        let window = small(window_on(&mut rng, &contours[0]));
        let (error, pixels) = judge(&contours, RULES[i % 2], window, true);
        (worst, partial) = (worst.max(error), partial + pixels);
    }
    println!("at most {worst} millionths of a level off, in {partial} pixels");
    assert!(partial > 3 * cases(3_000) as u32, "too few: {partial}");
}

/// A random place in a pixel, often on its border or at a corner.
fn in_pixel(rng: &mut Rng, (x, y): Units) -> Units {
    let mut inset = || {
        let anywhere = rng.int(0, 256);
        rng.pick(&[0, 256, 128, 1, 255, anywhere])
    };
    (x * 256 + inset(), y * 256 + inset())
}

#[test]
fn hard_cases_are_right_both_ways() {
    let mut rng = Rng::new(1_470);
    for i in 0..cases(12_000) {
        let window = Rect::new(-4, -3, 8, 5);
        let contour: Vec<Units> = match i % 6 {
            // All in one pixel: bow-ties, stars, and several times around.
            0 | 1 => (0..rng.range(3, 7)).map(|_| in_pixel(&mut rng, (2, 1))).collect(),
            // Thinner than a pixel, at any angle.
            2 => {
                let (a, b) =
                    ((rng.int(-1_500, 2_500), rng.int(-900, 1_400)), (rng.int(-1_500, 2_500), rng.int(-900, 1_400)));
                let w = (rng.int(-40, 40), rng.int(-40, 40));
                vec![a, b, (b.0 + w.0, b.1 + w.1), (a.0 + w.0, a.1 + w.1)]
            }
            // Through corners of pixels.
            3 => (0..4).map(|_| (rng.int(-6, 10) * 256, rng.int(-5, 7) * 256)).collect(),
            // Left of the window, but for a corner.
            4 => (0..5).map(|_| (rng.int(-9_000, -900), rng.int(-2_000, 2_000))).collect(),
            // Flat.
            _ => (0..4).map(|_| (rng.int(-3_000, 4_000), 300 + rng.int(0, 30))).collect(),
        };
        for rule in RULES {
            for is_true in [false, true] {
                judge(std::slice::from_ref(&contour), rule, window, is_true);
            }
        }
    }
}

#[test]
fn windows_tables_and_cells_change_no_true_area() {
    let mut rng = Rng::new(1_480);
    for i in 0..cases(1_200) {
        let scale = Scale::ALL[i % 4];
        let contours = polygon(&mut rng, scale);
        let window = small(window_on(&mut rng, &contours[0]));
        let rule = RULES[i / 4 % 2];
        let whole = picture(&contours, rule, window, true);
        let what = || format!("{rule:?} of {contours:?} in {window:?}");
        for (slots, cells) in [(0, 0), (0, 35), (0, 60), (1, 40), (2, 40)] {
            let slots = sides(&contours).count() - slots.min(sides(&contours).count());
            if let Ok(got) = covered(&contours, rule, window, (slots, cells), true) {
                assert!(got.levels == whole.levels, "{cells} cells, {slots} slots: {}", what());
            }
        }
        for size in [(1, 1), (9, 7), (40, 3)] {
            for tile in tiles(window, size) {
                let got = picture(&contours, rule, tile, true);
                for (x, y) in (tile.y0..tile.y1).flat_map(|y| (tile.x0..tile.x1).map(move |x| (x, y))) {
                    assert_eq!(got.at(x, y), whole.at(x, y), "({x}, {y}) in {tile:?}: {}", what());
                }
            }
        }
    }
}

/// A side along the left border of the window, from whose end another one goes to the right: in either order, up and down.
#[test]
fn sides_along_the_left_border() {
    let window = Rect::new(2, 0, 8, 6);
    for (near, far) in [((512, 0), (900, 1_536)), ((512, 1_536), (900, 0)), ((512, 0), (512 + 6 * 256, 1_536))] {
        let straight = (512, 1_536 - near.1);
        for contour in [vec![near, straight, far], vec![near, far, straight]] {
            for (rule, is_true) in RULES.into_iter().flat_map(|rule| [(rule, false), (rule, true)]) {
                let (_, partial) = judge(std::slice::from_ref(&contour), rule, window, is_true);
                assert!(partial >= 6, "{contour:?}");
            }
        }
    }
}

/// Where nothing crosses, the true area is what sides sum up to, to the byte.
#[test]
fn simple_shapes_are_the_same_both_ways() {
    let mut rng = Rng::new(1_490);
    for i in 0..cases(3_000) {
        let corners = outline(&mut rng, Scale::ALL[i % 4], 3);
        let window = small(window_on(&mut rng, &corners));
        let [sums, areas] = [false, true].map(|way| picture(std::slice::from_ref(&corners), RULES[i % 2], window, way));
        // Two sides that end at a corner may be rounded one by one or together.
        let apart = sums.levels.iter().zip(&areas.levels).map(|(a, b)| a.abs_diff(*b)).max();
        assert!(apart <= Some(1), "{corners:?} in {window:?}\n{}\n{}", sums.picture(), areas.picture());
    }
}

#[test]
fn what_the_module_says_is_wrong_is_right_then() {
    let window = Rect::new(0, 0, 3, 1);
    let levels = |contours: &[Vec<Units>], rule| picture(contours, rule, window, true).levels;
    let bow_tie = [vec![(256, 0), (512, 256), (512, 0), (256, 256)]];
    assert_eq!(RULES.map(|rule| levels(&bow_tie, rule)), [[0, 128, 0], [0, 128, 0]]);
    let half = vec![(256, 0), (384, 0), (384, 256), (256, 256)];
    assert_eq!(levels(&[half.clone(), half.clone()], FillRule::NonZero), [0, 128, 0]);
    assert_eq!(levels(&[half.clone(), half], FillRule::EvenOdd), [0, 0, 0]);
    // Upper halves, so that no side goes through the pixels between.
    let upper = vec![(0, 0), (768, 0), (768, 128), (0, 128)];
    assert_eq!(levels(&[upper.clone(), upper.clone()], FillRule::NonZero), [128, 128, 128]);
    assert_eq!(levels(&[upper.clone(), upper], FillRule::EvenOdd), [0, 0, 0]);
    let wide = [vec![(0, 0), (768, 256), (768, 0), (0, 256)]];
    // A sixth of the pixel are 42.5.
    let got = levels(&wide, FillRule::EvenOdd);
    assert!(got == [170, 42, 170] || got == [170, 43, 170], "{got:?}");
}

/// Paths and strokes have the same pixels as their lines.
#[test]
fn paths_and_strokes_have_true_areas() {
    let window = Rect::new(0, 0, 12, 12);
    let place = |(x, y)| PointFx::from_bits(x, y);
    let corners = [(300, 300), (2_800, 2_500), (2_800, 300), (300, 2_500)];
    let mut segments = vec![PathSegment::MoveTo(place(corners[0]))];
    segments.extend(corners[1..].iter().map(|&v| PathSegment::LineTo(place(v))));
    let (mut table, mut levels) = ([CoverageSlot::EMPTY; 40], Levels::new(window));
    coverage::path_true(Path::new(&segments), RULES[0], &mut table, &mut [], window, &mut levels)
        .expect("enough slots");
    assert!(levels.levels == picture(&[corners.to_vec()], RULES[0], window, true).levels, "{}", levels.picture());
    // Two bars that cross: what they share counts once.
    let mut levels = Levels::new(window);
    let bars = [(512, 600), (2_560, 600), (1_500, 512), (1_500, 2_560)].map(place);
    let bars = [
        PathSegment::MoveTo(bars[0]),
        PathSegment::LineTo(bars[1]),
        PathSegment::MoveTo(bars[2]),
        PathSegment::LineTo(bars[3]),
    ];
    coverage::stroke_true(Path::new(&bars), &Stroke::px(1), &mut table, &mut [], window, &mut levels)
        .expect("enough slots");
    let sum: f64 = levels.levels.iter().map(|&level| f64::from(level) / 255.0).sum();
    let shared = 1.0 * (600.0 + 128.0 - 512.0) / 256.0;
    assert!((sum - (16.0 - shared)).abs() < 0.05, "{sum}\n{}", levels.picture());
}
