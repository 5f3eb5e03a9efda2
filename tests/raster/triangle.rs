//! Triangles against three edge functions per pixel in wide integers: not one pixel differs, from either filler, in any
//! order of the corners.

use embedded_graphics_core::pixelcolor::BinaryColor;
use embedded_raster::{raster::triangle, Canvas, Rect};
use twins::{
    assert_runs, collect, corners,
    hits::Hits,
    rng::{cases, Rng},
    scenes::{outline, window_on, Scale},
    tiles, Run, Units, TILE_SIZES,
};

/// Triangles per scale.
const TRIANGLES: usize = 400_000;

fn filled(units: [Units; 3], window: Rect) -> Vec<Run> {
    collect(window, |emit| triangle::fill(corners(units), window, emit))
}

fn walked(units: [Units; 3], window: Rect) -> Vec<Run> {
    collect(window, |emit| triangle::walk(corners(units), window, emit))
}

fn in_blocks(units: [Units; 3], window: Rect) -> Vec<Run> {
    collect(window, |emit| triangle::walk_blocks(corners(units), window, emit))
}

fn check(units: [Units; 3], window: Rect) -> bool {
    let wanted = twins::triangle(units, window);
    assert_runs(window, &filled(units, window), &wanted, || format!("fill {units:?}"));
    assert_runs(window, &walked(units, window), &wanted, || format!("walk {units:?}"));
    assert_runs(window, &in_blocks(units, window), &wanted, || format!("walk_blocks {units:?}"));
    !wanted.is_empty()
}

fn random_triangle(rng: &mut Rng, scale: Scale) -> [Units; 3] {
    let places = outline(rng, scale, 3);
    [places[0], places[1], places[2]]
}

fn random(scale: Scale) {
    let mut rng = Rng::new(10 + scale as u64);
    let (count, mut seen) = (cases(TRIANGLES), 0);
    for _ in 0..count {
        let units = random_triangle(&mut rng, scale);
        let window = window_on(&mut rng, &units);
        seen += usize::from(check(units, window));
    }
    assert!(seen >= count / 5, "only {seen} triangles were seen");
}

#[test]
fn tiny_triangles() {
    random(Scale::Tiny);
}

#[test]
fn screen_triangles() {
    random(Scale::Screen);
}

#[test]
fn triangles_of_a_hundred_screens() {
    random(Scale::Hundred);
}

#[test]
fn triangles_at_the_ends_of_the_type() {
    random(Scale::Ends);
}

/// Every corner on a grid of half pixels: ties everywhere.
#[test]
fn every_triangle_of_a_half_pixel_grid() {
    let window = Rect::new(-1, -1, 4, 4);
    let places: Vec<Units> = (0..25).map(|i| (i % 5 * 128, i / 5 * 128)).collect();
    for &a in &places {
        for &b in &places {
            for &c in &places {
                check([a, b, c], window);
            }
        }
    }
}

/// Every corner on a grid of units around one centre: the finest decisions there are.
#[test]
fn every_triangle_of_units_around_a_centre() {
    let window = Rect::new(-1, -1, 2, 2);
    let places: Vec<Units> = (0..25).map(|i| (126 + i % 5, 126 + i / 5)).collect();
    for &a in &places {
        for &b in &places {
            for &c in &places {
                check([a, b, c], window);
            }
        }
    }
}

#[test]
fn all_orders_of_the_corners_give_the_same_pixels() {
    let mut rng = Rng::new(21);
    for i in 0..cases(40_000) {
        let [a, b, c] = random_triangle(&mut rng, Scale::ALL[i % 4]);
        let window = window_on(&mut rng, &[a, b, c]);
        let wanted = filled([a, b, c], window);
        for order in [[a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]] {
            assert_runs(window, &filled(order, window), &wanted, || format!("fill {order:?}"));
            assert_runs(window, &walked(order, window), &wanted, || format!("walk {order:?}"));
            assert_runs(window, &in_blocks(order, window), &wanted, || format!("walk_blocks {order:?}"));
        }
    }
}

/// Rows are where a solver goes wrong that is right on the first row: tall windows, thin triangles.
#[test]
fn tall_thin_windows() {
    let mut rng = Rng::new(22);
    for i in 0..cases(4_000) {
        let units = random_triangle(&mut rng, Scale::ALL[1 + i % 3]);
        let w = window_on(&mut rng, &units);
        let (x0, y0) = (w.x0, w.y0.clamp(i32::MIN + 400, i32::MAX - 400));
        check(units, Rect::new(x0, y0 - 150, x0 + 2, y0 + 150));
        let (x0, y0) = (w.x0.clamp(i32::MIN + 400, i32::MAX - 400), w.y0);
        check(units, Rect::new(x0 - 150, y0, x0 + 150, y0 + 2));
    }
}

/// Around the sizes where the set-up changes from narrow to wide numbers.
#[test]
fn boxes_where_the_arithmetic_changes() {
    let mut rng = Rng::new(23);
    for _ in 0..cases(60_000) {
        let limit = rng.pick(&[1 << 15, 1 << 16, 1 << 17, 1 << 19, 1 << 20]);
        let near = |rng: &mut Rng| if rng.one_in(2) { rng.int(-3, 3) } else { limit + rng.int(-3, 3) };
        let origin = (rng.int(-9_000, 9_000), rng.int(-9_000, 9_000));
        let mut place = || (origin.0 + near(&mut rng), origin.1 + near(&mut rng));
        let units = [place(), place(), place()];
        let window = window_on(&mut rng, &units);
        check(units, window);
    }
}

#[test]
fn tiles_of_every_size_show_the_same_triangle() {
    let mut rng = Rng::new(24);
    let whole = Rect::new(-9, -5, 39, 31);
    for _ in 0..200 {
        let units = [(); 3].map(|()| (rng.int(-9_000, 16_000), rng.int(-9_000, 14_000)));
        let mut wanted = Hits::new(whole);
        wanted.fill_triangle_fx(corners(units), BinaryColor::On);
        let wanted = wanted.runs();
        assert_runs(whole, &wanted, &twins::triangle(units, whole), || format!("{units:?}"));
        for size in TILE_SIZES {
            let (mut solved, mut stepped) = (Hits::new(whole), Hits::new(whole));
            for tile in tiles(whole, size) {
                solved.add(&filled(units, tile));
                stepped.add(&walked(units, tile));
            }
            assert_runs(whole, &solved.runs(), &wanted, || format!("fill {units:?} in tiles of {size:?}"));
            assert_runs(whole, &stepped.runs(), &wanted, || format!("walk {units:?} in tiles of {size:?}"));
        }
    }
}
