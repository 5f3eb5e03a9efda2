//! Cases that break rasterizers, each by name. Where a case is a known bug of another renderer, its report is named.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "coordinates of small windows, made to fit"
)]

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray8, Rgb888},
};
use embedded_raster::{
    buffer_bytes,
    raster::{line, polygon, rectangle, triangle},
    Canvas, EdgeSlot, EdgeTableFull, FillRule, Framebuffer, Index1, PointFx, Rect, Surface,
};
use twins::{
    assert_runs, collect, corners, hits::Hits, picture, rng::Rng, runs_where, tiles, vertices, Run, Units, TILE_SIZES,
};

const WINDOW: Rect = Rect::new(-2, -2, 34, 30);

/// A pixel in units; its centre is 128 further.
const PX: i32 = 256;
const HALF: i32 = 128;

/// All three fillers against the twin.
fn check_triangle(units: [Units; 3], window: Rect) -> Vec<Run> {
    let wanted = twins::triangle(units, window);
    let filled = collect(window, |emit| triangle::fill(corners(units), window, emit));
    assert_runs(window, &filled, &wanted, || format!("fill {units:?}"));
    let walked = collect(window, |emit| triangle::walk(corners(units), window, emit));
    assert_runs(window, &walked, &wanted, || format!("walk {units:?}"));
    assert_runs(window, &fill_polygon(&units, FillRule::NonZero, window), &wanted, || format!("polygon {units:?}"));
    wanted
}

fn fill_polygon(outline: &[Units], rule: FillRule, window: Rect) -> Vec<Run> {
    let outline = vertices(outline);
    let mut table = vec![EdgeSlot::EMPTY; outline.len()];
    collect(window, |emit| polygon::fill([&outline[..]], rule, &mut table, window, emit).expect("a slot for each side"))
}

fn check_polygon(outline: &[Units], window: Rect) -> Vec<Run> {
    let mut last = vec![];
    for rule in [FillRule::EvenOdd, FillRule::NonZero] {
        last = twins::polygon(&[outline.to_vec()], rule, window);
        assert_runs(window, &fill_polygon(outline, rule, window), &last, || format!("{rule:?} {outline:?}"));
    }
    last
}

fn draw_line(a: (i32, i32), b: (i32, i32), window: Rect) -> Vec<(i32, i32)> {
    let mut pixels = vec![];
    if let Some(steps) = line::clip(Point::new(a.0, a.1), Point::new(b.0, b.1), window) {
        steps.spans(|s| pixels.extend((s.x0()..s.x1()).map(|x| (x, s.y()))));
    }
    pixels.sort_unstable();
    pixels
}

fn check_line(a: (i32, i32), b: (i32, i32), window: Rect) -> Vec<(i32, i32)> {
    let mut wanted = twins::line(a, b, window);
    wanted.sort_unstable();
    assert_eq!(draw_line(a, b, window), wanted, "{a:?} to {b:?} in {window:?}");
    wanted
}

fn pixels(runs: &[Run]) -> i32 {
    runs.iter().map(|r| r.2 - r.1).sum()
}

/// All six orders of three corners.
fn orders([a, b, c]: [Units; 3]) -> [[Units; 3]; 6] {
    [[a, b, c], [a, c, b], [b, a, c], [b, c, a], [c, a, b], [c, b, a]]
}

/// A side through many centres, in each of eight directions, with the third corner on either side of it.
#[test]
fn centres_exactly_on_a_side_in_eight_directions() {
    let middle = (14 * PX + HALF, 12 * PX + HALF);
    for (dx, dy) in [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1), (2, 1), (-1, 2)] {
        let end = (middle.0 + dx * 5 * PX, middle.1 + dy * 5 * PX);
        let (left, right) =
            ((middle.0 - dy * 4 * PX, middle.1 + dx * 4 * PX), (middle.0 + dy * 4 * PX, middle.1 - dx * 4 * PX));
        let mut hits = Hits::new(WINDOW);
        for third in [left, right] {
            for order in orders([middle, end, third]) {
                check_triangle(order, WINDOW);
            }
            hits.add(&check_triangle([middle, end, third], WINDOW));
        }
        // Both together: nothing twice, and the centres between the ends of the side are painted by one of them.
        hits.runs();
        for step in 1..5 {
            assert_eq!(hits.count(14 + dx * step, 12 + dy * step), 1, "({dx}, {dy}) step {step}");
        }
    }
}

/// Eight triangles around a vertex that is a centre: that pixel belongs to exactly one of them.
#[test]
fn a_centre_exactly_on_a_vertex_of_many_triangles() {
    let middle = (14 * PX + HALF, 12 * PX + HALF);
    let ring = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]
        .map(|(dx, dy)| (middle.0 + dx * 6 * PX, middle.1 + dy * 6 * PX));
    let mut hits = Hits::new(WINDOW);
    for i in 0..8 {
        hits.add(&check_triangle([middle, ring[i], ring[(i + 1) % 8]], WINDOW));
    }
    let square = runs_where(WINDOW, |x, y| (8..20).contains(&x) && (6..18).contains(&y));
    assert_runs(WINDOW, &hits.runs(), &square, || "eight triangles".into());
}

/// The corner of a square on a centre: left and top sides in, right and bottom sides out.
#[test]
fn a_square_with_its_corners_on_centres() {
    let (a, b) = ((2 * PX + HALF, 3 * PX + HALF), (6 * PX + HALF, 5 * PX + HALF));
    let wanted = [(3, 2, 6), (4, 2, 6)];
    assert_eq!(check_polygon(&[a, (b.0, a.1), b, (a.0, b.1)], WINDOW), wanted);
    assert_eq!(rectangle::pixels(PointFx::from_bits(a.0, a.1), PointFx::from_bits(b.0, b.1)), Rect::new(2, 3, 6, 5));
    let halves = [[a, (b.0, a.1), b], [a, b, (a.0, b.1)]].map(|t| pixels(&check_triangle(t, WINDOW)));
    assert_eq!(halves.iter().sum::<i32>(), 8);
}

/// Twice the area is a single square unit, over 60 pixels: nearly horizontal, vertical, diagonal. A sliver may cover no
/// centre at all, or a row of them if it lies just so.
#[test]
fn slivers_of_one_square_unit() {
    let long = 60 * PX;
    let window = Rect::new(-1, -1, 63, 63);
    for (dx, dy) in
        [(long, 1), (1, long), (long, long - 1), (long - 1, long), (long, 257), (-long, 1), (long - 1, -long)]
    {
        // A corner next to the side such that the cross product is one: an inverse of dx modulo dy, by search.
        let near = (1..=i64::from(dx.abs().max(dy.abs()))).find_map(|t| {
            let (dx, dy) = (i64::from(dx), i64::from(dy));
            let (x, y) =
                if dx.abs() >= dy.abs() { (t, (t * dy + 1).div_euclid(dx)) } else { ((t * dx - 1).div_euclid(dy), t) };
            ((dx * y - dy * x).abs() == 1).then_some((x as i32, y as i32))
        });
        let near = near.expect("dx and dy have no common factor");
        for origin in [(0, 0), (HALF, HALF), (HALF, HALF - 1), (HALF - 1, HALF), (17, 200), (HALF, 60 * PX + HALF)] {
            let move_to = |p: Units| (p.0 + origin.0, p.1 + origin.1);
            let units = [(0, 0), (dx, dy), near].map(move_to);
            assert_eq!(twins::twice_area(units[0], units[1], units[2]).abs(), 1, "{units:?}");
            for order in orders(units) {
                check_triangle(order, window);
            }
        }
    }
}

/// A strip 1/256 pixel high that has the centres of a row on its top side paints the row; one that has them on its bottom
/// side, or just misses them, paints nothing.
#[test]
fn strips_one_unit_high_on_a_row_of_centres() {
    let row = 5 * PX + HALF;
    for (top, painted) in [(row - 2, 0), (row - 1, 0), (row, 30), (row + 1, 0)] {
        let (a, b, c, d) = ((0, top), (30 * PX, top), (30 * PX, top + 1), (0, top + 1));
        assert_eq!(pixels(&check_polygon(&[a, b, c, d], WINDOW)), painted, "top at {top}");
        let halves = pixels(&check_triangle([a, b, c], WINDOW)) + pixels(&check_triangle([a, c, d], WINDOW));
        assert_eq!(halves, painted, "as two triangles, top at {top}");
    }
    let column = 5 * PX + HALF;
    for (left, painted) in [(column - 2, 0), (column - 1, 0), (column, 20), (column + 1, 0)] {
        let (a, b, c, d) = ((left, 0), (left + 1, 0), (left + 1, 20 * PX), (left, 20 * PX));
        assert_eq!(pixels(&check_polygon(&[a, b, c, d], WINDOW)), painted, "left at {left}");
    }
}

/// Points, lines and spikes have no area and paint nothing, wherever they lie.
///
/// Known: a filled triangle of zero height divided by zero (hoglet67/PiTubeDirect#138).
#[test]
fn shapes_without_area_paint_nothing() {
    let mut rng = Rng::new(100);
    for _ in 0..2_000 {
        let (a, b) = ((rng.int(-300, 8000), rng.int(-300, 7000)), (rng.int(-300, 8000), rng.int(-300, 7000)));
        let snapped = |p: Units| (p.0 & !255 | HALF, p.1 & !255 | HALF);
        let (a, b) = if rng.one_in(2) { (snapped(a), snapped(b)) } else { (a, b) };
        let beyond = (2 * b.0 - a.0, 2 * b.1 - a.1);
        for flat in
            [[a, a, a], [a, a, b], [a, b, a], [a, b, b], [a, b, beyond], [a, (b.0, a.1), (rng.int(0, 8000), a.1)]]
        {
            assert!(check_triangle(flat, WINDOW).is_empty(), "{flat:?}");
        }
        // There and back along the same way, with stops.
        for spike in [&[][..], &[a], &[a, b], &[a, b, a, b], &[a, b, beyond, b], &[a, a, b, b]] {
            assert!(check_polygon(spike, WINDOW).is_empty(), "{spike:?}");
        }
    }
}

/// Vertices given twice, and vertices on a straight side, change nothing.
#[test]
fn repeated_and_collinear_vertices_change_nothing() {
    let plain = [(300, 200), (7000, 900), (6000, 6100), (1100, 5000)];
    let middle = |a: Units, b: Units| (i32::midpoint(a.0, b.0), i32::midpoint(a.1, b.1));
    let [a, b, c, d] = plain;
    let wanted = check_polygon(&plain, WINDOW);
    for same in [vec![a, a, b, c, c, c, d], vec![a, middle(a, b), b, c, middle(c, d), d, a], vec![a, b, c, d, a]] {
        assert_eq!(check_polygon(&same, WINDOW), wanted, "{same:?}");
    }
}

/// A T-junction whose vertex lies exactly on the side that it meets leaves no gap.
///
/// Known: gaps between adjacent triangles (nesbox/TIC-80#776, ssloy/tinyrenderer#32), pixels of both
/// (zesterer/euc#17).
#[test]
fn representable_t_junctions() {
    let mut rng = Rng::new(101);
    for _ in 0..3_000 {
        // The side a..b has its points on multiples of its n-th part.
        let n = rng.int(2, 9);
        let (dx, dy) = (rng.int(-700, 700), rng.int(-600, 600));
        let a = (4000 - dx * n / 2, 3400 - dy * n / 2);
        let on_side = |i: i32| (a.0 + dx * i, a.1 + dy * i);
        let b = on_side(n);
        let (left, right) = ((a.0 - dy * n, a.1 + dx * n), (b.0 + dy * n, b.1 - dx * n));
        let mut hits = Hits::new(WINDOW);
        hits.add(&check_triangle([a, b, left], WINDOW));
        for i in 0..n {
            hits.add(&check_triangle([on_side(i), on_side(i + 1), right], WINDOW));
        }
        assert_runs(WINDOW, &hits.runs(), &check_polygon(&[a, right, b, left], WINDOW), || {
            format!("{a:?} {b:?} in {n}")
        });
    }
}

/// The other orders and windings of two triangles with a common side: still exactly once.
#[test]
fn shared_sides_in_all_orders_and_both_windings() {
    let (a, b, c, d) = ((400, 300), (7000, 1500), (5600, 6200), (900, 5000));
    let whole = check_polygon(&[a, b, c, d], WINDOW);
    for first in orders([a, b, c]) {
        for second in orders([a, c, d]) {
            let mut hits = Hits::new(WINDOW);
            hits.add(&check_triangle(first, WINDOW));
            hits.add(&check_triangle(second, WINDOW));
            assert_eq!(hits.runs(), whole, "{first:?} {second:?}");
        }
    }
}

/// The largest triangle there is, and the thinnest of that length.
#[test]
fn vertices_at_the_ends_of_the_type() {
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 128, i32::MAX - 1, i32::MAX];
    let windows = [
        Rect::new(-3, -2, 4, 3),
        Rect::new(-8_388_608, -8_388_608, -8_388_600, -8_388_604),
        Rect::new(8_388_600, 8_388_603, 8_388_609, 8_388_609),
        Rect::new(i32::MIN, i32::MIN, i32::MIN + 5, i32::MIN + 4),
        Rect::new(i32::MAX - 5, i32::MAX - 4, i32::MAX, i32::MAX),
    ];
    let mut rng = Rng::new(102);
    for _ in 0..6_000 {
        let mut place = || (rng.pick(&ends), rng.pick(&ends));
        let units = [place(), place(), place()];
        for window in windows {
            check_triangle(units, window);
        }
    }
}

/// Windows of one row of a huge shape, one after the other: every row is solved anew, and they fit together.
#[test]
fn a_huge_triangle_row_by_row() {
    let units = [(-2_000_000_000, -1_900_000_007), (2_000_000_111, 1_700_000_013), (-1_234_567_890, 2_147_483_647)];
    let whole = Rect::new(-20, -24, 20, 24);
    for rows in [whole, Rect::new(-20, 7_000, 20, 7_048), Rect::new(-4_800_020, 8_000_000, -4_799_980, 8_000_048)] {
        let wanted = check_triangle(units, rows);
        let mut pieces = Hits::new(rows);
        for tile in tiles(rows, (40, 1)) {
            pieces.add(&check_triangle(units, tile));
        }
        assert_eq!(pieces.runs(), wanted, "{rows:?}");
    }
}

/// The error of a side that is added up, row after row: none after 4,095 rows, for slopes that are no fraction of two.
#[test]
fn no_drift_over_4095_rows() {
    let window = Rect::new(0, 0, 4095, 4095);
    for (dx, dy) in
        [(1, 4095 * 256), (4095 * 256, 4095 * 256 - 1), (333_333, 1_048_319), (-77, 1_048_303), (1_048_320, 7)]
    {
        let units = [(2000 * PX + 3, 1), (2000 * PX + 3 + dx / 2, 1 + dy), (2400 * PX + dx / 3, 1 + dy)];
        let spans = collect(window, |emit| triangle::fill(corners(units), window, emit));
        let mut next = 0;
        for y in 0..4095 {
            // Only the ends are tested here, every one of them: the pixel inside and the one outside.
            match spans.get(next).filter(|run| run.0 == y) {
                Some(&(_, x0, x1)) => {
                    let has = |x: i32| twins::triangle_has(units, x, y);
                    assert!(has(x0) && has(x1 - 1), "row {y} of {units:?} paints too much");
                    assert!(
                        (x0 == 0 || !has(x0 - 1)) && (x1 == 4095 || !has(x1)),
                        "row {y} of {units:?} paints too little"
                    );
                    next += 1;
                }
                None => {
                    assert!((1900..2500).all(|x| !twins::triangle_has(units, x, y)), "row {y} of {units:?} is missing");
                }
            }
        }
        assert_eq!(next, spans.len(), "{units:?}");
    }
    for b in [(4094, 4093), (4094, 1), (3, 4094), (4094, 2047)] {
        check_line((0, 0), b, window);
        check_line(b, (0, 0), window);
    }
}

/// Combs with teeth of 1 to 40 units: far thinner than a pixel, each row crossed by hundreds of sides.
#[test]
fn combs_with_teeth_thinner_than_a_pixel() {
    let window = Rect::new(-1, -1, 17, 13);
    for tooth in 1..=40 {
        for (tip, base) in [(HALF, 12 * PX), (HALF - 1, 10 * PX + HALF), (0, 11 * PX + 3)] {
            let teeth = (15 * PX / tooth).min(260);
            let outline: Vec<Units> =
                (0..2 * teeth).map(|i| (i * tooth, if i % 2 == 0 { base } else { tip })).collect();
            check_polygon(&outline, window);
            // Lying on its side.
            let lying: Vec<Units> = outline.iter().map(|&(x, y)| (y, x)).collect();
            check_polygon(&lying, window);
            // Nearly horizontal teeth: the tips differ in height by one unit.
            let low: Vec<Units> = (0..2 * teeth).map(|i| (i % 2 * 15 * PX, HALF + i * tooth / 2 + i % 2)).collect();
            check_polygon(&low, window);
        }
    }
}

/// Ties: at half a pixel the minor axis steps. The line back breaks the tie the other way, so that the two differ there
/// and nowhere else.
#[test]
fn ties_of_lines_and_of_lines_reversed() {
    let window = Rect::new(-40, -40, 40, 40);
    assert_eq!(check_line((0, 0), (2, 1), window), [(0, 0), (1, 1), (2, 1)]);
    assert_eq!(check_line((2, 1), (0, 0), window), [(0, 0), (1, 0), (2, 1)]);
    assert_eq!(check_line((0, 0), (1, 2), window), [(0, 0), (1, 1), (1, 2)]);
    assert_eq!(check_line((0, 0), (-2, -1), window), [(-2, -1), (-1, -1), (0, 0)]);
    let mut rng = Rng::new(103);
    for _ in 0..3_000 {
        let [a, b] = [(); 2].map(|()| (rng.int(-30, 30), rng.int(-30, 30)));
        let (there, back) = (check_line(a, b, window), check_line(b, a, window));
        assert_eq!(there.len(), back.len(), "{a:?} {b:?}");
        let (dx, dy) = ((b.0 - a.0).abs(), (b.1 - a.1).abs());
        let (da, db) = (dx.max(dy), dx.min(dy));
        for &(x, y) in there.iter().filter(|p| !back.contains(p)) {
            let k = (x - a.0).abs().max((y - a.1).abs());
            assert_eq!((2 * k * db + da) % (2 * da), 0, "{a:?} to {b:?} differ at ({x}, {y}) without a tie");
        }
    }
}

/// A window of one pixel shows it exactly if the line goes through it, wherever that is.
#[test]
fn lines_that_touch_the_window_in_one_pixel() {
    for (a, b) in
        [((0, 0), (20, 13)), ((20, 13), (0, 0)), ((0, 13), (20, 0)), ((3, 0), (5, 20)), ((-900, -41), (1900, 133))]
    {
        let around = Rect::new(-2, -2, 24, 24);
        let whole = check_line(a, b, around);
        for y in around.y0..around.y1 {
            for x in around.x0..around.x1 {
                let seen = draw_line(a, b, Rect::new(x, y, x + 1, y + 1));
                assert_eq!(!seen.is_empty(), whole.contains(&(x, y)), "({x}, {y}) of {a:?} to {b:?}");
            }
        }
    }
    // Past the corner of a window, with one pixel in common or none.
    let window = Rect::new(10, 10, 20, 20);
    assert_eq!(check_line((0, 20), (20, 0), window), [(10, 10)]);
    assert_eq!(check_line((0, 19), (19, 0), window), []);
    assert_eq!(check_line((9, 29), (29, 9), window), [(19, 19)]);
    assert_eq!(check_line((19, 5), (19, 10), window), [(19, 10)]);
}

/// The longest lines there are, seen through a window far from both ends.
#[test]
fn lines_from_end_to_end_of_the_type() {
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    let windows = [
        Rect::new(-9, -7, 9, 8),
        Rect::new(i32::MIN, i32::MIN, i32::MIN + 12, i32::MIN + 9),
        Rect::new(i32::MAX - 12, i32::MAX - 9, i32::MAX, i32::MAX),
        Rect::new(i32::MIN, -5, i32::MIN + 12, 5),
    ];
    for x0 in ends {
        for y0 in ends {
            for x1 in ends {
                for y1 in ends {
                    for window in windows {
                        check_line((x0, y0), (x1, y1), window);
                    }
                }
            }
        }
    }
}

/// Known: clipping that moves an end of the line bends it (lispbuilder/lispbuilder#60, Sid-Bhatia-0/SimpleDraw.jl#34),
/// differently for each order of the ends (CE-Programming/toolchain#471, whose numbers these are).
#[test]
fn clipping_does_not_bend_lines() {
    let (screen, larger) = (Rect::new(0, 0, 320, 240), Rect::new(-200, -200, 500, 500));
    for (a, b) in [((-100, 20), (30, 40)), ((30, 40), (-100, 20)), ((-150, -199), (450, 300)), ((400, -90), (-30, 490))]
    {
        let mut whole = check_line(a, b, larger);
        whole.retain(|&(x, y)| screen.contains(x, y));
        assert_eq!(check_line(a, b, screen), whole, "{a:?} to {b:?}");
    }
}

/// The same drawing in a larger target, cut out afterwards: every primitive, every size of tile.
///
/// Known: shapes cut by tiles show the borders of the tiles (mapbox/mapbox-gl-native#1857).
#[test]
fn a_drawing_cut_into_tiles_is_the_drawing() {
    let mut rng = Rng::new(104);
    let whole = Rect::new(-7, -5, 41, 35);
    for _ in 0..60 {
        let place = |rng: &mut Rng| (rng.int(-9_000, 20_000), rng.int(-9_000, 18_000));
        let units = [(); 7].map(|()| place(&mut rng));
        let [a, b] = [(); 2].map(|()| Point::new(rng.int(-60, 90), rng.int(-60, 90)));
        let draw = |surface: &mut Hits, which: usize| match which {
            0 => surface.draw_line(a, b, BinaryColor::On),
            1 => surface.fill_triangle_fx(corners([units[0], units[1], units[2]]), BinaryColor::On),
            2 => {
                let mut table = [EdgeSlot::EMPTY; 7];
                let outline = vertices(&units);
                surface
                    .fill_polygon_fx(&outline, FillRule::EvenOdd, &mut table, BinaryColor::On)
                    .expect("enough slots");
            }
            3 => {
                let [a, b, _] = corners([units[0], units[1], units[2]]);
                surface.fill_rectangle_fx(a, b, BinaryColor::On);
            }
            4 => surface.draw_point_fx(corners([units[0]; 3])[0], BinaryColor::On),
            5 => surface.draw_rectangle(Rect::new(a.x, a.y, b.x, b.y), BinaryColor::On),
            _ => surface.fill_area(Rect::new(a.x, a.y, b.x, b.y), BinaryColor::On),
        };
        for which in 0..7 {
            let mut large = Hits::new(Rect::new(-70, -70, 120, 110));
            draw(&mut large, which);
            let wanted = runs_where(whole, |x, y| large.count(x, y) == 1);
            for size in TILE_SIZES {
                let mut pieces = Hits::new(whole);
                for tile in tiles(whole, size) {
                    let mut piece = Hits::new(tile);
                    draw(&mut piece, which);
                    pieces.add(&piece.runs());
                }
                assert_runs(whole, &pieces.runs(), &wanted, || format!("primitive {which} in tiles {size:?}"));
            }
        }
    }
}

/// Known: 16-bit products overflow for a triangle that lies wholly on a 320 x 240 screen
/// (adafruit/Adafruit-GFX-Library#164); a fill that never ends (embedded-graphics/embedded-graphics#308); a product of
/// large sides that overflows (embedded-graphics/embedded-graphics#719); one that goes beyond its top when that is flat
/// (peter-l5/framebuf2#1).
#[test]
fn triangles_that_broke_others() {
    let window = Rect::new(0, 0, 320, 240);
    for points in [
        [(314, 11), (14, 200), (97, 237)],
        [(10, 10), (20, 30), (30, -10)],
        [(10, 10), (10, 229), (309, 229)],
        [(120, 120), (70, 70), (170, 70)],
    ] {
        let units = points.map(|(x, y)| (x * PX, y * PX));
        for order in orders(units) {
            assert!(!check_triangle(order, window).is_empty(), "{points:?}");
        }
    }
}

/// Two adjacent triangles that had a pixel in common (zesterer/euc#17), at many sizes.
#[test]
fn two_triangles_that_overlapped_elsewhere() {
    let mesh = [(731_845, 3_382_193), (2_277_621, 6_909_972), (6_582_470, 8_374_755), (234_555, 9_771_846)];
    for size in 1..40 {
        let [a, b, c, d] = mesh.map(|(x, y): (i64, i64)| ((x * size / 12_000) as i32, (y * size / 12_000) as i32));
        let mut hits = Hits::new(WINDOW);
        hits.add(&check_triangle([a, b, c], WINDOW));
        hits.add(&check_triangle([b, a, d], WINDOW));
        hits.runs();
    }
}

/// Known: polygons far above the screen come out on it, as 16 bits wrap (espruino/BangleApps#2661); a side of 158 million
/// pixels overflows in the set-up (linebender/tiny-skia#178); vertices beyond 32,767 overflow (dkfans/keeperfx#4668).
#[test]
fn polygons_that_broke_others() {
    let screen = Rect::new(0, 0, 176, 176);
    let above = [(23_295, -64_801), (3_839, -530_209), (2_305, -530_143), (21_761, -64_735)];
    assert!(check_polygon(&above, screen).is_empty(), "nothing of it is on the screen");
    let long = [(3 * PX, 6 * PX), (11 * PX, 6 * PX), (11 * PX, i32::MIN)];
    assert_eq!(check_polygon(&long, Rect::new(0, 0, 32, 32)).len(), 6);
    let wide = [(-40_000 * PX, 3 * PX), (40_000 * PX, 9 * PX), (33_000 * PX, 30 * PX)];
    assert!(!check_polygon(&wide, Rect::new(0, 0, 64, 40)).is_empty(), "it crosses the screen");
}

/// Counters of 8 bits overflow at 256 sides (GraphiteEditor/Graphite#612).
#[test]
fn polygons_of_255_to_257_sides() {
    for n in [255, 256, 257, 1000] {
        let outline: Vec<Units> = (0..n)
            .map(|i| {
                let turn = f64::from(i) * std::f64::consts::TAU / f64::from(n);
                ((4000.0 + 3500.0 * turn.cos()) as i32, (3500.0 + 3300.0 * turn.sin()) as i32)
            })
            .collect();
        check_polygon(&outline, WINDOW);
    }
}

/// A row crossed by more sides than fit: refused with the numbers, nothing painted.
#[test]
fn a_full_edge_table_paints_nothing() {
    let outline: Vec<Units> = (0..40).map(|i| (i * 200, if i % 2 == 0 { 0 } else { 20 * PX })).collect();
    let mut hits = Hits::new(WINDOW);
    let mut table = [EdgeSlot::EMPTY; 39];
    let result = hits.fill_polygon_fx(&vertices(&outline), FillRule::EvenOdd, &mut table, BinaryColor::On);
    assert_eq!(result, Err(EdgeTableFull { capacity: 39, needed: 40, row: 0, enough: 40 }));
    assert!(hits.runs().is_empty(), "{}", picture(WINDOW, &hits.runs()));
}

/// No pixels, one pixel, the widest and the highest surface: valid, and drawn to like any other.
#[test]
fn surfaces_of_extreme_sizes() {
    fn draw(surface: &mut impl Surface<Color = Gray8>) {
        let color = Gray8::new(7);
        surface.draw_line(Point::new(-9, -9), Point::new(i32::MAX, i32::MAX), color);
        surface.fill_triangle_fx([PointFx::px(-1, -1), PointFx::px(i32::MAX, -1), PointFx::px(-1, i32::MAX)], color);
        surface.fill_window(color);
    }
    for (width, height) in
        [(0, 0), (0, 9), (9, 0), (0, 65_535), (65_535, 0), (1, 1), (65_535, 1), (1, 65_535), (65_535, 2)]
    {
        let mut memory = vec![0; buffer_bytes::<Gray8>(width, height)];
        let mut frame = Framebuffer::<Gray8>::new(&mut memory, width, height).expect("the right size");
        assert_eq!(frame.window(), Rect::new(0, 0, width.into(), height.into()));
        draw(&mut frame);
        draw(&mut frame.view(Rect::new(0, 0, i32::MAX, i32::MAX)));
        assert_eq!(frame.colors(Rect::new(0, 0, i32::MAX, i32::MAX)).count(), usize::from(width) * usize::from(height));
        assert!(memory.iter().all(|&b| b == 7), "{width} x {height}");
    }
    // The largest screen there is does not fit here; a band of it does.
    let mut memory = vec![0; buffer_bytes::<Index1>(65_535, 2)];
    let mut band = Framebuffer::<Index1>::band(&mut memory, 65_535, 65_535, 65_533..65_535).expect("two rows");
    band.draw_line(Point::new(0, 0), Point::new(65_534, 65_534), Index1::MAX);
    assert_eq!(band.get(Point::new(65_534, 65_534)), Some(Index1::MAX));
    assert_eq!(memory.iter().map(|b| b.count_ones()).sum::<u32>(), 2);
    let whole = buffer_bytes::<Rgb888>(65_535, 65_535);
    assert_eq!(whole, 65_535 * 65_535 * 3, "the size of the largest screen is known all the same");
}

/// In memory of one pixel a row, a step down and to the left is no step at all: a loop that waits for the index to leave
/// the memory would go on for as long as the line is.
#[test]
fn lines_through_a_screen_one_pixel_wide() {
    for (a, b) in [((0, 3), (i32::MIN, i32::MAX)), ((9, 0), (-1_000_000_000, 1_000_000_008)), ((5, 0), (-5, 11))] {
        let (a, b) = (Point::new(a.0, a.1), Point::new(b.0, b.1));
        for (a, b) in [(a, b), (b, a)] {
            let mut ram = [0_u8; 8];
            Framebuffer::<Gray8>::new(&mut ram, 1, 8).expect("eight bytes").draw_line(a, b, Gray8::new(1));
            let wanted = twins::line((a.x, a.y), (b.x, b.y), Rect::new(0, 0, 1, 8));
            let painted: Vec<_> = (0..8).filter(|&y| ram[y] != 0).map(|y| (0, y as i32)).collect();
            let mut sorted = wanted.clone();
            sorted.sort_by_key(|p| p.1);
            assert_eq!(painted, sorted, "{a} to {b}");
        }
    }
}
