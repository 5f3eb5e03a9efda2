//! Polygons against a count of crossings per pixel in wide integers: not one pixel differs, by either fill rule, with an
//! edge table of any capacity, and a table that is too small is refused with the right numbers before anything is drawn.

use embedded_graphics_core::{geometry::Point, pixelcolor::BinaryColor};
use embedded_raster::{
    raster::{polygon, rectangle, triangle},
    Canvas, ClippedSpan, EdgeSlot, EdgeTableFull, FillRule, PointFx, Rect,
};
use twins::{
    assert_runs, collect, corners,
    hits::Hits,
    rng::{cases, Rng},
    runs_where,
    scenes::{outline, window_on, Scale},
    tiles, vertices, Run, Units, TILE_SIZES,
};

/// Polygons per scale.
const POLYGONS: usize = 260_000;
const RULES: [FillRule; 2] = [FillRule::NonZero, FillRule::EvenOdd];

fn filled(contours: &[Vec<Units>], rule: FillRule, window: Rect, capacity: usize) -> Result<Vec<Run>, EdgeTableFull> {
    let contours: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
    let mut table = vec![EdgeSlot::EMPTY; capacity];
    let mut result = Ok(());
    let mut emitted = 0;
    let runs = collect(window, |emit| {
        result = polygon::fill(contours.iter(), rule, &mut table, window, |span: ClippedSpan| {
            emitted += 1;
            emit(span);
        });
    });
    assert!(result.is_ok() || emitted == 0, "{emitted} spans were emitted before {result:?}");
    result.map(|()| runs)
}

fn count(contours: &[Vec<Units>]) -> usize {
    contours.iter().map(Vec::len).sum()
}

fn check(contours: &[Vec<Units>], window: Rect) -> bool {
    let mut seen = false;
    for rule in RULES {
        let wanted = twins::polygon(contours, rule, window);
        let got = filled(contours, rule, window, count(contours)).expect("a slot for every side is enough");
        assert_runs(window, &got, &wanted, || format!("{rule:?} {contours:?}"));
        seen |= !wanted.is_empty();
    }
    seen
}

/// One to three contours of a few vertices each; sometimes empty, a point or a line.
fn random_polygon(rng: &mut Rng, scale: Scale) -> Vec<Vec<Units>> {
    let contours = rng.pick(&[1, 1, 1, 1, 2, 2, 3]);
    let all = outline(rng, scale, 24);
    let mut rest = &all[..];
    let mut sizes = || match rng.below(12) {
        0 => rng.index(3),
        1 => 8,
        _ => 3 + rng.index(4),
    };
    (0..contours)
        .map(|_| {
            let (contour, other) = rest.split_at(sizes());
            rest = other;
            contour.to_vec()
        })
        .collect()
}

fn window_for(rng: &mut Rng, contours: &[Vec<Units>]) -> Rect {
    match contours.iter().find(|c| !c.is_empty()) {
        Some(contour) => window_on(rng, contour),
        None => Rect::new(-3, -3, 3, 3),
    }
}

fn random(scale: Scale) {
    let mut rng = Rng::new(30 + scale as u64);
    let (count, mut seen) = (cases(POLYGONS), 0);
    for _ in 0..count {
        let contours = random_polygon(&mut rng, scale);
        let window = window_for(&mut rng, &contours);
        seen += usize::from(check(&contours, window));
    }
    assert!(seen >= count / 4, "only {seen} polygons were seen");
}

#[test]
fn tiny_polygons() {
    random(Scale::Tiny);
}

#[test]
fn screen_polygons() {
    random(Scale::Screen);
}

#[test]
fn polygons_of_a_hundred_screens() {
    random(Scale::Hundred);
}

#[test]
fn polygons_at_the_ends_of_the_type() {
    random(Scale::Ends);
}

/// Many vertices, self-crossing, on a coarse grid: crossings coincide all the time.
#[test]
fn scribbles() {
    let mut rng = Rng::new(41);
    for i in 0..cases(3_000) {
        let n = 10 + rng.index(71);
        let step = rng.pick(&[1, 13, 64, 128, 256]);
        let contour: Vec<Units> = (0..n).map(|_| (rng.int(-3, 20) * step, rng.int(-3, 20) * step)).collect();
        let window = if i % 2 == 0 { Rect::new(-4, -4, 24, 24) } else { window_on(&mut rng, &contour) };
        check(&[contour], window);
    }
}

#[test]
fn polygons_agree_with_triangles() {
    let mut rng = Rng::new(42);
    for i in 0..cases(200_000) {
        let places = outline(&mut rng, Scale::ALL[i % 4], 3);
        let units = [places[0], places[1], places[2]];
        let window = window_on(&mut rng, &units);
        let wanted = collect(window, |emit| triangle::fill(corners(units), window, emit));
        for rule in RULES {
            let got = filled(std::slice::from_ref(&places), rule, window, 3).expect("three slots for three sides");
            assert_runs(window, &got, &wanted, || format!("{rule:?} {units:?}"));
        }
    }
}

/// The smallest thing wrong with the rule of an order: a contour may start anywhere and go round either way.
#[test]
fn any_start_and_either_direction_give_the_same_pixels() {
    let mut rng = Rng::new(43);
    for i in 0..cases(20_000) {
        let n = 3 + rng.index(6);
        let mut contour = outline(&mut rng, Scale::ALL[i % 4], n);
        let window = window_on(&mut rng, &contour);
        for rule in RULES {
            let wanted = filled(&[contour.clone()], rule, window, n).expect("enough slots");
            contour.rotate_left(rng.index(n));
            contour.reverse();
            let got = filled(&[contour.clone()], rule, window, n).expect("enough slots");
            assert_runs(window, &got, &wanted, || format!("{rule:?} {contour:?}"));
        }
    }
}

/// A capacity is enough when no single row is crossed by more sides; then the pixels are the same, in the same order.
/// Otherwise the error names the first row that has too many, and how many it has.
#[test]
fn edge_tables_of_every_capacity() {
    let mut rng = Rng::new(44);
    let (mut fitted, mut refused) = (0, 0);
    let shapes = cases(25_000);
    for i in 0..shapes {
        let contours = if i % 8 == 0 {
            vec![outline(&mut rng, Scale::Tiny, 20)]
        } else {
            random_polygon(&mut rng, Scale::ALL[i % 4])
        };
        let window = window_for(&mut rng, &contours);
        let rule = rng.pick(&RULES);
        let wanted = twins::polygon(&contours, rule, window);
        let places: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
        let slots = polygon::edge_slots(&places, window);
        assert!(filled(&contours, rule, window, slots.least).is_ok(), "{slots:?}: {contours:?} in {window:?}");
        let fewer = slots.least.checked_sub(1).map(|fewer| filled(&contours, rule, window, fewer));
        assert!(
            fewer.is_none_or(|got| got.is_err()) && slots.least <= slots.whole,
            "{slots:?}: {contours:?} in {window:?}"
        );
        for capacity in 0..=count(&contours) + 1 {
            let rows = || (window.y0..window.y1).map(|row| (row, twins::sides_on_row(&contours, window, row)));
            let overflow = rows().find(|&(_, needed)| needed > capacity);
            let enough = rows().map(|(_, needed)| needed).max().unwrap_or_default();
            let got = filled(&contours, rule, window, capacity);
            if let Some((row, needed)) = overflow {
                assert_eq!(got, Err(EdgeTableFull { capacity, needed, row, enough }), "{contours:?} in {window:?}");
                refused += 1;
            } else {
                let got = got.unwrap_or_else(|e| panic!("{e}: {contours:?} in {window:?}"));
                assert_runs(window, &got, &wanted, || format!("{rule:?} {contours:?} with {capacity} slots"));
                fitted += 1;
            }
        }
    }
    assert!(fitted.min(refused) >= shapes * 2 / 5, "{fitted} fitted, {refused} refused");
}

/// A shape whose crowded row is the last one: nothing of the rows above may be painted before the refusal.
#[test]
fn a_crowded_last_row_is_found_before_the_first_is_painted() {
    let mut contours = vec![vec![(0, 0), (40 * 256, 0), (40 * 256, 30 * 256), (0, 30 * 256)]];
    for tooth in 0..9 {
        let x = 1000 + tooth * 900;
        contours.push(vec![(x, 29 * 256), (x + 300, 29 * 256), (x + 200, 30 * 256)]);
    }
    let window = Rect::new(0, 0, 48, 40);
    let error = EdgeTableFull { capacity: 19, needed: 20, row: 29, enough: 20 };
    assert_eq!(filled(&contours, FillRule::EvenOdd, window, 19), Err(error));
    let wanted = twins::polygon(&contours, FillRule::EvenOdd, window);
    assert_eq!(filled(&contours, FillRule::EvenOdd, window, 20).as_ref(), Ok(&wanted));
    // What the window does not show needs no room.
    let above = Rect::new(0, 0, 48, 29);
    assert_eq!(filled(&contours, FillRule::EvenOdd, above, 2).as_ref(), Ok(&wanted[..29].to_vec()));
}

/// Sides right of the window change no pixel of it: they need no slot, whatever is missing at the end of a row then.
#[test]
fn sides_right_of_the_window_take_no_slot() {
    let window = Rect::new(0, 0, 40, 30);
    // Teeth as high as the window, each of them two sides, far right of it.
    let comb = |teeth: i32, at: i32| -> Vec<Vec<Units>> {
        let tooth = |i: i32| vec![(at + 9 * i, -500), (at + 9 * i + 5, -500), (at + 9 * i + 2, 9_000)];
        (0..teeth).map(tooth).collect()
    };
    for rule in RULES {
        for at in [39 * 256 + 129, 40 * 256, 100_000, i32::MAX - 9_000] {
            let teeth = comb(50, at);
            assert_eq!(filled(&teeth, rule, window, 0), Ok(vec![]), "{rule:?} at {at}");
            // One unit further left the first side stands on the centres of the last column.
            let refused = filled(&comb(1, 39 * 256 + 128), rule, window, 0);
            assert_eq!(refused, Err(EdgeTableFull { capacity: 0, needed: 1, row: 0, enough: 1 }));
        }
        // A shape whose right end is not seen: one slot, and rows that end at the window's side.
        let mut contours = comb(50, 41 * 256);
        contours.push(vec![(700, 300), (60_000, 300), (60_000, 7_000), (1_200, 7_000)]);
        let wanted = twins::polygon(&contours, rule, window);
        assert_eq!(filled(&contours, rule, window, 1).as_ref(), Ok(&wanted), "{rule:?}");
        // Two sides that go down, and both that go up are missing; in the middle of the rows the two cross.
        let bowls = vec![
            vec![(700, 300), (60_000, 300), (60_000, 7_000), (3_200, 7_000)],
            vec![(2_700, 500), (60_000, 500), (60_000, 6_800), (1_200, 6_800)],
        ];
        let wanted = twins::polygon(&bowls, rule, window);
        assert_eq!(filled(&bowls, rule, window, 2).as_ref(), Ok(&wanted), "{rule:?}");
    }
}

#[test]
fn tiles_of_every_size_show_the_same_polygon() {
    let mut rng = Rng::new(45);
    let whole = Rect::new(-9, -5, 39, 31);
    for _ in 0..100 {
        let n = 4 + rng.index(8);
        let contours = vec![(0..n).map(|_| (rng.int(-9_000, 16_000), rng.int(-9_000, 14_000))).collect::<Vec<_>>()];
        let rule = rng.pick(&RULES);
        let wanted = twins::polygon(&contours, rule, whole);
        for size in TILE_SIZES {
            let mut pieces = Hits::new(whole);
            for tile in tiles(whole, size) {
                pieces.add(&filled(&contours, rule, tile, n).expect("enough slots"));
            }
            assert_runs(whole, &pieces.runs(), &wanted, || format!("{contours:?} in tiles of {size:?}"));
        }
    }
}

/// Rectangles, by their own function, as polygons, and by the rule.
#[test]
fn rectangles() {
    let mut rng = Rng::new(46);
    for i in 0..cases(300_000) {
        let places = outline(&mut rng, Scale::ALL[i % 4], 2);
        let (a, b) = (places[0], places[1]);
        let around = vec![a, (b.0, a.1), b, (a.0, b.1)];
        let window = window_on(&mut rng, &around);
        let wanted = twins::rectangle(a, b, window);
        let pixels = rectangle::pixels(PointFx::from_bits(a.0, a.1), PointFx::from_bits(b.0, b.1));
        let got = runs_where(window, |x, y| pixels.contains(x, y));
        assert_runs(window, &got, &wanted, || format!("rectangle {a:?} {b:?}"));
        if i % 4 == 0 {
            let got = filled(&[around], FillRule::NonZero, window, 4).expect("enough slots");
            assert_runs(window, &got, &wanted, || format!("polygon {a:?} {b:?}"));
        }
    }
}

/// Outlines of boxes of pixels paint each pixel once, of every small size and up to the ends of the type.
#[test]
fn outlines_of_boxes() {
    let check = |area: Rect, window: Rect| {
        let mut hits = Hits::new(window);
        hits.draw_rectangle(area, BinaryColor::On);
        let wanted = runs_where(window, |x, y| twins::rectangle_outline_has(area, x, y));
        assert_runs(window, &hits.runs(), &wanted, || format!("outline of {area:?}"));
    };
    for (width, height) in (-2..9).flat_map(|w| (-2..9).map(move |h| (w, h))) {
        let area = Rect { x0: 2, y0: -1, x1: 2 + width, y1: -1 + height };
        check(area, Rect::new(0, -3, 12, 10));
        check(area, Rect::new(3, 0, 6, 4));
    }
    let mut rng = Rng::new(47);
    for _ in 0..cases(50_000) {
        let mut side = || rng.pick(&[i32::MIN, i32::MIN + 1, i32::MAX - 1, i32::MAX, -1, 0, 1]);
        let area = Rect { x0: side(), y0: side(), x1: side(), y1: side() };
        let near = |n: i32| (n.saturating_sub(3), n.saturating_add(3));
        let ((x0, x1), (y0, y1)) = (near(side()), near(side()));
        check(area, Rect::new(x0, y0, x1, y1));
    }
}

/// Closed lines are the lines between their corners.
#[test]
fn outlines_of_polygons() {
    let (window, mut rng) = (Rect::new(0, 0, 30, 24), Rng::new(48));
    for n in (0..6).cycle().take(600) {
        let corners: Vec<Point> = (0..n).map(|_| Point::new(rng.int(-9, 40), rng.int(-9, 30))).collect();
        let mut hits = Hits::new(window);
        hits.draw_polygon(corners.iter().copied(), BinaryColor::On);
        let lines = || (0..n).map(|i| (corners[i], corners[(i + 1) % n]));
        let line = |(a, b): (Point, Point)| twins::line((a.x, a.y), (b.x, b.y), window);
        let pixels: Vec<_> = lines().flat_map(line).collect();
        let got = runs_where(window, |x, y| hits.count(x, y) > 0);
        assert_runs(window, &got, &runs_where(window, |x, y| pixels.contains(&(x, y))), || format!("{corners:?}"));
    }
}

/// Rings may come as any iterator of vertices, by value or by reference.
#[test]
fn contours_are_any_iterators() {
    let ring = [(0, 0), (2_000, 100), (700, 1_900)];
    let window = Rect::new(0, 0, 9, 9);
    let wanted = twins::polygon(&[ring.to_vec()], FillRule::NonZero, window);
    let mut table = [EdgeSlot::EMPTY; 3];
    let by_value = collect(window, |emit| {
        let ring = ring.iter().map(|&(x, y)| PointFx::from_bits(x, y));
        polygon::fill(core::iter::once(ring), FillRule::NonZero, &mut table, window, emit).expect("enough slots");
    });
    assert_eq!(by_value, wanted);
    let list = vertices(&ring);
    let by_reference = collect(window, |emit| {
        polygon::fill([&list[..]], FillRule::NonZero, &mut table, window, emit).expect("enough slots");
    });
    assert_eq!(by_reference, wanted);
    let nothing: [&[PointFx]; 0] = [];
    assert_eq!(collect(window, |emit| polygon::fill(nothing, FillRule::NonZero, &mut [], window, emit).unwrap()), []);
}
