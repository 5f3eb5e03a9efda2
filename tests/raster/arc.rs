//! Arcs, sectors, rings and rounded rectangles, pixel by pixel.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::cast_lossless,
    reason = "tests mix widths on purpose"
)]

use std::collections::HashSet;

use embedded_raster::{
    raster::{
        arc::{self, Sector},
        ellipse::Ellipse,
        rounded::{self, Radii},
    },
    Angle, Canvas, ClippedSpan, PointFx, Rect,
};
use fixed::types::{I16F16, I24F8};
use twins::{
    assert_runs, collect,
    rng::{cases, Rng},
    rounds::{from_box, rounded_enclosed_has, rounded_has, rounded_outline_has, sector_has},
    runs_where,
    scenes::window_near,
    tiles, Run, TILE_SIZES,
};

/// What draws its pixels to a function.
type Shape<'a> = dyn Fn(&mut dyn FnMut(ClippedSpan)) + 'a;

fn check(area: Rect, inner: Rect, (start, end): (Angle, Angle), window: Rect) {
    let sector = Sector::new(start, end);
    let (outer, hole) = (Ellipse::in_box(area), Ellipse::in_box(inner));
    let inside = |x: i32, y: i32| sector_has(start, end, from_box(area, x, y));
    let what = |name: &str| format!("{name} {area:?} {inner:?} from {start:?} to {end:?}");

    let got = collect(window, |emit| arc::outline(area, sector, window, emit));
    let wanted = runs_where(window, |x, y| twins::outline_has(area, x, y) && inside(x, y));
    assert_runs(window, &got, &wanted, || what("arc"));
    let got = collect(window, |emit| arc::fill(outer, sector, window, emit));
    let wanted = runs_where(window, |x, y| twins::box_ellipse_has(area, x, y) && inside(x, y));
    assert_runs(window, &got, &wanted, || what("sector"));
    let ring = |x, y| twins::box_ellipse_has(area, x, y) && !twins::box_ellipse_has(inner, x, y);
    let got = collect(window, |emit| arc::ring(outer, hole, window, emit));
    assert_runs(window, &got, &runs_where(window, ring), || what("ring"));
    let got = collect(window, |emit| arc::ring_sector(outer, hole, sector, window, emit));
    let wanted = runs_where(window, |x, y| ring(x, y) && inside(x, y));
    assert_runs(window, &got, &wanted, || what("sector of a ring"));
}

fn part(n: u32) -> Angle {
    Angle::from_bits(n << 26)
}

/// Every start and end in 1/64 turns, for diameters up to 12.
#[test]
fn every_arc_of_64ths() {
    let mut rng = Rng::new(401);
    for size in 1..=12 {
        let area = Rect::new(1, 0, 1 + size, size);
        let window = Rect::new(0, -1, 14, 13);
        let width = rng.int(0, size / 2);
        let inner = Rect::new(1 + width, width, 1 + size - width, size - width);
        for start in 0..64 {
            for end in 0..64 {
                check(area, inner, (part(start), part(end)), window);
            }
        }
    }
}

#[test]
fn random_arcs() {
    let mut rng = Rng::new(402);
    for i in 0..cases(40_000) {
        let bits = rng.range(1, 31);
        let size = |rng: &mut Rng| ((1_i64 << bits) + rng.range(-3, 3)).clamp(1, (1 << 32) - 1);
        let (width, height) = (size(&mut rng), if i % 2 == 0 { size(&mut rng) } else { 1 + rng.range(0, 40) });
        let place = |rng: &mut Rng, size: i64| {
            let (low, high) = (i64::from(i32::MIN), i64::from(i32::MAX) - size);
            rng.pick(&[low, high, 0]).clamp(low, high)
        };
        let (x0, y0) = (place(&mut rng, width), place(&mut rng, height));
        let area = Rect::new(x0 as i32, y0 as i32, (x0 + width) as i32, (y0 + height) as i32);
        let thick = rng.range(0, 9).min(width.min(height) / 2);
        let inner = Rect::new(
            (x0 + thick) as i32,
            (y0 + thick) as i32,
            (x0 + width - thick) as i32,
            (y0 + height - thick) as i32,
        );
        let angle = |rng: &mut Rng| match rng.below(3) {
            0 => part(rng.below(64) as u32),
            1 => part(rng.below(64) as u32).plus(rng.int(-2, 2)),
            _ => Angle::from_bits(rng.bits() as u32),
        };
        let (start, end) = (angle(&mut rng), angle(&mut rng));
        let (x, y) = match rng.below(3) {
            0 => (x0 + width / 2, y0 + height / 2),
            1 => (x0 + width / 2, y0),
            _ => {
                let turn = f64::from(start.to_bits()) / 4_294_967_296.0 * std::f64::consts::TAU;
                let on = |from: i64, size: i64, part: f64| from + size / 2 + (part * 0.5 * size as f64) as i64;
                (on(x0, width, turn.cos()), on(y0, height, turn.sin()))
            }
        };
        check(area, inner, (start, end), window_near(&mut rng, x, y));
    }
}

/// Sectors that follow each other draw every pixel once, wherever the centre lies.
#[test]
fn pies_are_whole() {
    let mut rng = Rng::new(403);
    let window = Rect::new(-12, -12, 13, 13);
    for _ in 0..cases(2_000) {
        let centre = PointFx::from_bits(128 * rng.int(-4, 4), 128 * rng.int(-4, 4) + rng.int(0, 1));
        let pie = Ellipse::circle(centre, I24F8::from_bits(rng.int(1, 2_500)));
        let mut angles: Vec<u32> = (0..rng.range(2, 7))
            .map(|_| (rng.bits() as u32 & 0xfc00_0000).wrapping_add_signed(rng.int(-1, 1)))
            .collect();
        angles.sort_unstable();
        angles.dedup();
        let mut hits = twins::hits::Hits::new(window);
        for (i, &start) in angles.iter().enumerate() {
            let end = angles[(i + 1) % angles.len()];
            if start == end {
                continue;
            }
            let sector = Sector::new(Angle::from_bits(start), Angle::from_bits(end));
            hits.add(&collect(window, |emit| arc::fill(pie, sector, window, emit)));
        }
        if angles.len() > 1 {
            let whole = collect(window, |emit| embedded_raster::raster::ellipse::fill(pie, window, emit));
            assert_runs(window, &hits.runs(), &whole, || format!("{angles:?} around {centre:?}"));
        }
    }
}

fn check_rounded(area: Rect, radii: Radii, window: Rect) {
    let filled = |x, y| rounded_has(area, radii, x, y);
    let border = |x, y| rounded_outline_has(area, radii, x, y);
    let got = collect(window, |emit| rounded::fill(area, radii, window, emit));
    assert_runs(window, &got, &runs_where(window, filled), || format!("filled {area:?} {radii:?}"));
    let mut hits = twins::hits::Hits::new(window);
    hits.fill_rounded(area, radii, embedded_graphics_core::pixelcolor::BinaryColor::On);
    assert_runs(window, &hits.runs(), &runs_where(window, filled), || format!("canvas {area:?} {radii:?}"));
    let got = collect(window, |emit| rounded::outline(area, radii, window, emit));
    assert_runs(window, &got, &runs_where(window, border), || format!("outline of {area:?} {radii:?}"));
    let enclosed = |x, y| rounded_enclosed_has(area, radii, x, y);
    let got = collect(window, |emit| rounded::enclosed(area, radii, window, emit));
    assert_runs(window, &got, &runs_where(window, enclosed), || format!("enclosed by {area:?} {radii:?}"));
}

#[test]
fn rounded_rectangles_of_small_sizes() {
    let mut rng = Rng::new(404);
    for width in 0..=26 {
        for height in 0..=26 {
            let area = Rect::new(2, -1, 2 + width, height - 1);
            let window = Rect::new(0, -2, width + 4, height);
            for radius in 0..=14 {
                check_rounded(area, Radii::all(radius), window);
            }
            for _ in 0..20 {
                let mut r = || rng.below(16) as u32;
                let radii = Radii { top_left: r(), top_right: r(), bottom_right: r(), bottom_left: r() };
                check_rounded(area, radii, window);
                let (x, y) = (rng.range(0, 26), rng.range(0, 26));
                check_rounded(area, radii, window_near(&mut rng, x, y));
            }
        }
    }
}

/// What an outline encloses, told by a flood: all that cannot be reached from outside, from side to side, without a pixel of the
/// outline. For all sizes up to 24 x 24, all radii that differ, and corners that differ. So what is filled never shows beyond the outline
/// that is drawn over it, and no ground shows between the two.
#[test]
fn what_is_filled_inside_of_an_outline_is_what_a_flood_cannot_reach() {
    let mut rng = Rng::new(406);
    for (width, height) in (1..=24).flat_map(|w| (1..=24).map(move |h| (w, h))) {
        let (area, window) = (Rect::new(0, 0, width, height), Rect::new(-1, -1, width + 1, height + 1));
        let mut r = || rng.below(14) as u32;
        let mixed = [(); 4].map(|()| Radii { top_left: r(), top_right: r(), bottom_right: r(), bottom_left: r() });
        for radii in (0..=width.min(height) as u32 / 2).map(Radii::all).chain(mixed) {
            let border: HashSet<(i32, i32)> = collect(window, |emit| rounded::outline(area, radii, window, emit))
                .into_iter()
                .flat_map(|(y, x0, x1)| (x0..x1).map(move |x| (x, y)))
                .collect();
            let (mut outside, mut next) = (HashSet::new(), vec![(-1, -1)]);
            while let Some((x, y)) = next.pop() {
                if window.contains(x, y) && !border.contains(&(x, y)) && outside.insert((x, y)) {
                    next.extend([(x + 1, y), (x - 1, y), (x, y + 1), (x, y - 1)]);
                }
            }
            let got = collect(window, |emit| rounded::enclosed(area, radii, window, emit));
            let wanted = runs_where(window, |x, y| !outside.contains(&(x, y)));
            assert_runs(window, &got, &wanted, || format!("{area:?} {radii:?}"));
        }
    }
}

#[test]
fn rounded_rectangles_of_every_size() {
    let mut rng = Rng::new(405);
    for _ in 0..cases(60_000) {
        let size = |rng: &mut Rng| ((1_i64 << rng.range(0, 32)) + rng.range(-3, 3)).clamp(1, (1 << 32) - 1);
        let (width, height) = (size(&mut rng), size(&mut rng));
        let place = |rng: &mut Rng, size: i64| {
            let (low, high) = (i64::from(i32::MIN), i64::from(i32::MAX) - size);
            rng.pick(&[low, high, 0, 100]).clamp(low, high)
        };
        let (x0, y0) = (place(&mut rng, width), place(&mut rng, height));
        let area = Rect::new(x0 as i32, y0 as i32, (x0 + width) as i32, (y0 + height) as i32);
        let mut r = || rng.pick(&[0, 1, 5, 300, 20_000, 1 << 16, 1 << 30, u32::MAX]).wrapping_sub(rng.below(3) as u32);
        let radii = Radii { top_left: r(), top_right: r(), bottom_right: r(), bottom_left: r() };
        // Near a corner, along a diagonal of it, where the curve is.
        let limit = i64::from(radii.top_left).min(width.min(height) / 2);
        let inset = (limit as f64 * 0.292_893) as i64;
        let (x, y) = match rng.below(4) {
            0 => (x0, y0),
            1 => (x0 + inset, y0 + inset),
            2 => (x0 + width - 1 - inset, y0 + inset),
            _ => (x0 + width - 1, y0 + height - 1),
        };
        check_rounded(area, radii, window_near(&mut rng, x, y));
    }
}

#[test]
fn tiles_of_every_size_show_the_same() {
    let mut rng = Rng::new(406);
    let whole = Rect::new(-9, -5, 39, 31);
    for _ in 0..40 {
        let mut at = |low, high| rng.int(low, high);
        let (x, y) = (at(-20, 30), at(-20, 20));
        let area = Rect::new(x, y, x + at(1, 60), y + at(1, 50));
        let radii = Radii { top_left: at(0, 30) as u32, bottom_right: at(0, 30) as u32, ..Radii::all(7) };
        let sector = Sector::new(Angle::degrees(at(0, 360)), Angle::degrees(at(0, 360)));
        let (outer, inner) =
            (Ellipse::in_box(area), Ellipse::circle(PointFx::px(x + 9, y + 9), I24F8::from_bits(at(1, 4_000))));
        let shapes: [&dyn Fn(Rect) -> Vec<Run>; 5] = [
            &|window| collect(window, |emit| rounded::fill(area, radii, window, emit)),
            &|window| collect(window, |emit| rounded::outline(area, radii, window, emit)),
            &|window| collect(window, |emit| arc::outline(area, sector, window, emit)),
            &|window| collect(window, |emit| arc::fill(inner, sector, window, emit)),
            &|window| collect(window, |emit| arc::ring_sector(outer, inner, sector, window, emit)),
        ];
        for (kind, shape) in shapes.iter().enumerate() {
            let wanted = shape(whole);
            for size in TILE_SIZES {
                let mut hits = twins::hits::Hits::new(whole);
                for tile in tiles(whole, size) {
                    hits.add(&shape(tile));
                }
                assert_runs(whole, &hits.runs(), &wanted, || format!("kind {kind} of {area:?} in {size:?}"));
            }
        }
    }
}

/// The picture of the documentation.
#[test]
fn picture() {
    let area = Rect::new(0, 0, 11, 6);
    let radii = Radii { top_left: 3, top_right: 3, bottom_right: 1, bottom_left: 2 };
    let all = "###########\n".repeat(4);
    let got = twins::picture(area, &collect(area, |emit| rounded::fill(area, radii, area, emit)));
    assert_eq!(got, format!(".#########.\n{all}.##########\n"));
    let sides = "#.........#\n".repeat(4);
    let got = twins::picture(area, &collect(area, |emit| rounded::outline(area, radii, area, emit)));
    assert_eq!(got, format!(".#########.\n{sides}.##########\n"));
}

/// How many pixels of the disc of nine pixels a sector paints, and whether all in row 4 right of the middle are among them.
fn painted(sector: Sector) -> (usize, Vec<(i32, i32, i32)>) {
    let area = Rect::new(0, 0, 9, 9);
    let mut rows = vec![];
    arc::fill(Ellipse::in_box(area), sector, area, |s: ClippedSpan| rows.push((s.y(), s.x0(), s.x1())));
    (rows.iter().map(|&(_, x0, x1)| (x1 - x0) as usize).sum(), rows)
}

/// Directions that differ by one unit are told apart, next to eighths of a turn too.
#[test]
fn sectors_of_one_unit_and_of_all_but_one() {
    let [first, last] = [0, u32::MAX].map(Angle::from_bits);
    assert!(Sector::new(first, last).contains(-1, 0));
    assert_eq!(painted(Sector::new(first, last)).0, 69, "no centre lies in the last unit");
    assert_eq!(painted(Sector::new(first, Angle::from_bits(1))), (5, vec![(4, 4, 9)]), "the half axis with the middle");
    let axes = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];
    // Which of the two sectors that meet in it a ray belongs to.
    let is_first = [true, true, false, false, false, true, true, false];
    for (i, (axis, is_first)) in (0..).zip(axes.into_iter().zip(is_first)) {
        let at = Angle::turns(i, 8);
        let [before, after] = [at.plus(-1), at.plus(1)];
        let has = |start, end, (u, v): (i64, i64)| Sector::new(start, end).contains(5 * u, 5 * v);
        for other in axes {
            let same = axis == other;
            assert_eq!(has(at, after, other), same && is_first, "one unit from eighth {i} on: {other:?}");
            assert_eq!(has(before, at, other), same && !is_first, "one unit up to eighth {i}: {other:?}");
            assert_eq!(has(before, after, other), same, "two units around eighth {i}: {other:?}");
            let others = |is_first| !same || is_first;
            assert_eq!(has(after, at, other), others(!is_first), "all but one unit after eighth {i}: {other:?}");
            assert_eq!(has(after, before, other), !same, "all but two units around eighth {i}: {other:?}");
            assert_eq!(has(at, before, other), others(is_first), "all but the unit before eighth {i}: {other:?}");
        }
    }
}

/// The rows of a sector of the disc in a box, as runs.
fn sector_runs(area: Rect, start: i32, end: i32) -> Vec<Run> {
    let sector = Sector::new(Angle::degrees(start), Angle::degrees(end));
    collect(area, |emit| arc::fill(Ellipse::in_box(area), sector, area, emit))
}

/// The row of the centre belongs to the half disc below as a whole, its column to the half disc on the right.
#[test]
fn half_discs_are_symmetric() {
    let area = Rect::new(0, 0, 9, 9);
    let whole = collect(area, |emit| embedded_raster::raster::ellipse::fill(Ellipse::in_box(area), area, emit));
    let wanted: Vec<Run> = whole.iter().copied().filter(|run| run.0 >= 4).collect();
    assert_runs(area, &sector_runs(area, 0, 180), &wanted, || "below".into());
    assert_eq!(wanted[0], (4, 0, 9), "the row of the centre");
    let wanted: Vec<Run> = whole.iter().copied().filter(|run| run.0 < 4).collect();
    assert_runs(area, &sector_runs(area, 180, 0), &wanted, || "above".into());
    let wanted: Vec<Run> = whole.iter().map(|&(y, _, x1)| (y, 4, x1)).collect();
    assert_runs(area, &sector_runs(area, -90, 90), &wanted, || "on the right".into());
}

/// From an angle to its mirror image, a sector is its own mirror image: whatever the angle, whatever the parity of the box.
#[test]
fn sectors_are_as_symmetric_as_their_angles() {
    let mut rng = Rng::new(407);
    for (width, height) in (1..=14).flat_map(|width| (1..=14).map(move |height| (width, height))) {
        let area = Rect::new(0, 0, width, height);
        for i in 0..40 {
            let angle = if i < 16 { Angle::turns(i, 16) } else { Angle::from_bits(rng.bits() as u32) };
            let half = Angle::degrees(180);
            for (other, is_sideways) in [(half - angle, true), (-angle, false)] {
                let inner = Rect::new(2, 2, width - 2, height - 2);
                let shapes: [&Shape<'_>; 3] = [
                    &|emit| arc::fill(Ellipse::in_box(area), Sector::new(angle, other), area, emit),
                    &|emit| arc::outline(area, Sector::new(angle, other), area, emit),
                    &|emit| {
                        let [outer, inner] = [area, inner].map(Ellipse::in_box);
                        arc::ring_sector(outer, inner, Sector::new(angle, other), area, emit);
                    },
                ];
                for shape in shapes {
                    let got = collect(area, shape);
                    let mirrored = runs_where(area, |x, y| {
                        let (x, y) = if is_sideways { (width - 1 - x, y) } else { (x, height - 1 - y) };
                        // The pixel in the middle has no other.
                        got.iter().any(|run| run.0 == y && run.1 <= x && x < run.2)
                    });
                    assert_runs(area, &got, &mirrored, || format!("from {angle:?} to {other:?}"));
                }
            }
        }
    }
}

#[test]
fn a_whole_turn_is_everything() {
    let third = Angle::turns(1, 3);
    let thirds = [0, 1, 2].map(|i| painted(Sector::new(third * i, third * (i + 1))).0);
    assert_eq!(thirds.iter().sum::<usize>(), 69, "three times a third, rounded down: {thirds:?}");
    let sweep = |start, degrees: f64| Sector::sweep(Angle::degrees(start), I16F16::from_num(degrees));
    for degrees in [360.0, -360.0, 360.5, 720.0, 32_767.0, -32_768.0] {
        for start in [0, 45, -90] {
            assert_eq!(painted(sweep(start, degrees)).0, 69, "{degrees} degrees from {start} on");
        }
    }
    assert_eq!(painted(sweep(30, 0.0)).0, 0, "no sweep");
    for degrees in [1.0, 90.0, 179.5, 180.0, 200.0, 359.75] {
        let end = Angle::degrees(10) + Angle::degrees_fx(I16F16::from_num(degrees));
        assert_eq!(sweep(10, degrees), Sector::new(Angle::degrees(10), end), "{degrees} degrees");
        assert_eq!(Sector::sweep(end, I16F16::from_num(-degrees)), sweep(10, degrees), "{degrees} degrees back");
    }
    assert_eq!(painted(Sector::slice(7, 5, 0)).0, 0, "of no parts");
    for of in [1, 2, 3, 7, 100, u16::MAX] {
        let parts = u32::from(of);
        for start in [0, 1, parts - 1, parts, u32::MAX] {
            assert_eq!(painted(Sector::slice(start, 0, of)).0, 0, "nothing of {of}");
            for length in [parts, parts + 1, u32::MAX] {
                assert_eq!(painted(Sector::slice(start, length, of)).0, 69, "{length} of {of} from {start} on");
            }
        }
    }
    for of in [1_u16, 2, 3, 7, 12, 100] {
        let slices = (0..of.into()).map(|i| painted(Sector::slice(i, 1, of)).0);
        assert_eq!(slices.sum::<usize>(), 69, "{of} slices");
    }
}

/// A border and what it encloses together are the outer shape, each pixel once.
#[test]
fn borders_nest() {
    use embedded_raster::raster::rounded::Align;
    let mut rng = Rng::new(570);
    let mut seen = 0;
    for i in 0..cases(6_000) {
        let large = if i % 8 == 0 { 400 } else { 24 };
        let (x, y) = (rng.int(-20, 20), rng.int(-20, 20));
        let area = Rect::new(x, y, x + rng.int(0, large), y + rng.int(0, large));
        let mut radius = || rng.pick(&[0, 1, 2, 3, 5, 9, 30, u32::MAX]);
        let radii = Radii { top_left: radius(), top_right: radius(), bottom_right: radius(), bottom_left: radius() };
        let width = rng.pick(&[0, 1, 2, 3, 4, 7, 30, u32::MAX]).min(1 << 16);
        let align = rng.pick(&[Align::Inside, Align::Centred, Align::Outside]);
        let (out, within) = match align {
            Align::Inside => (0, width as i32),
            Align::Centred => (width as i32 / 2, width as i32 - width as i32 / 2),
            Align::Outside => (width as i32, 0),
        };
        let moved = |by: i32| {
            let Rect { x0, y0, x1, y1 } = area;
            let moved = Rect::new(x0 - by, y0 - by, x1 + by, y1 + by);
            // A radius is at most half of the shorter side; a square corner stays square.
            let limit = area.width().min(area.height()) / 2;
            let radius = |r: u32| match r.min(limit) {
                0 => 0,
                r => (i64::from(r) + i64::from(by)).max(0) as u32,
            };
            let Radii { top_left: a, top_right: b, bottom_right: c, bottom_left: d } = radii;
            let [top_left, top_right, bottom_right, bottom_left] = [a, b, c, d].map(radius);
            let is_empty = area.is_empty() || moved.x0 >= moved.x1 || moved.y0 >= moved.y1;
            (!is_empty).then_some((moved, Radii { top_left, top_right, bottom_right, bottom_left }))
        };
        let has =
            |shape: Option<(Rect, Radii)>, x, y| shape.is_some_and(|(area, radii)| rounded_has(area, radii, x, y));
        let (outer, inner) = (moved(out), moved(-within));
        let window = window_near(&mut rng, x.into(), y.into());
        let got = collect(window, |emit| rounded::border(area, radii, width, align, window, emit));
        let wanted = runs_where(window, |x, y| has(outer, x, y) && !has(inner, x, y));
        assert_runs(window, &got, &wanted, || format!("{align:?} {width} of {area:?} {radii:?}"));
        for y in window.y0..window.y1 {
            for x in window.x0..window.x1 {
                assert!(has(outer, x, y) || !has(inner, x, y), "({x}, {y}) of {align:?} {width} {area:?} {radii:?}");
            }
        }
        seen += usize::from(!wanted.is_empty());
    }
    assert!(seen * 4 > cases(6_000), "only {seen} borders were seen");
}
