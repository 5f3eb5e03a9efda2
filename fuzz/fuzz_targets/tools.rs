//! Triangles of polygons, Delaunay's and others; convexity, areas, places inside; clipped segments; viewports: against their
//! rules in wide integers.
#![no_main]

mod input;

use embedded_raster::{
    geom::{clip, exact, polygon, Viewport},
    FillRule, PointFx, Rect,
};
use input::Input;
use libfuzzer_sys::fuzz_target;
use twins::{
    meshes::{check, determinant, Wide},
    polygon_contains,
    tools::{clip_twin, convex_twin, map_twin},
    vertices, wide, Units,
};

fuzz_target!(|data: &[u8]| {
    let mut input = Input(data);
    let window = input.window();
    match input.byte() & 3 {
        0 | 1 => polygons(&mut input, window),
        2 => segments(&mut input, window),
        _ => viewports(&mut input),
    }
});

fn polygons(input: &mut Input<'_>, window: Rect) {
    // On a coarse grid they touch and fold.
    let (coarse, at) = (input.byte(), input.place_near(window));
    let mut contours: Vec<Vec<Units>> = vec![vec![]];
    let mut count = 0;
    while input.goes_on() && count < 24 {
        let place = if coarse & 1 == 0 {
            let byte = input.byte();
            let grid = |from: i32, n: u8| from.saturating_add(i32::from(n & 7) * 256);
            (grid(at.0, byte), grid(at.1, byte >> 4))
        } else {
            input.place_near(window)
        };
        count += 1;
        contours.last_mut().expect("there is one").push(place);
        if input.byte() & 7 == 5 {
            contours.push(vec![]);
        }
    }
    check(&contours, window);
    let places: Vec<Vec<PointFx>> = contours.iter().map(|c| vertices(c)).collect();
    for (contour, vertices) in contours.iter().zip(&places) {
        assert_eq!(polygon::is_convex(vertices), convex_twin(contour), "{contour:?}");
        let area: i128 = twins::sides(std::slice::from_ref(contour))
            .map(|(a, b)| (wide(a).0 - wide(b).0) * (wide(a).1 + wide(b).1))
            .sum();
        assert_eq!(polygon::twice_area(vertices), area, "{contour:?}");
        assert_eq!(polygon::orientation(vertices), area.cmp(&0), "{contour:?}");
    }
    for rule in [FillRule::NonZero, FillRule::EvenOdd] {
        let got = polygon::contains(&places, rule, PointFx::from_bits(at.0, at.1));
        assert_eq!(got, polygon_contains(&contours, rule, at), "{at:?} {rule:?} {contours:?}");
    }
}

fn segments(input: &mut Input<'_>, window: Rect) {
    let places = [(); 4].map(|()| input.place_near(window));
    let [a, b, c, d] = places.map(|(x, y)| PointFx::from_bits(x, y));
    assert_eq!(exact::turn(a, b, c), twins::twice_area(places[0], places[1], places[2]).cmp(&0), "{places:?}");
    let wanted = determinant(places[0], places[1], places[2], places[3]).cmp(&Wide::ZERO);
    assert_eq!(exact::in_circle(a, b, c, d), wanted, "{places:?}");

    let (ends, area) = ([places[0], places[1]], [places[2], places[3]]);
    let (got, wanted) = (clip::segment(a, b, [c, d]), clip_twin(ends, area));
    assert_eq!(got.is_some(), wanted.is_some(), "{ends:?} in {area:?}");
    let (Some(got), Some(wanted)) = (got, wanted) else { return };
    for (k, t) in wanted.into_iter().enumerate() {
        let at = got.at[k];
        assert_eq!(i128::from(at.number) * t.1, t.0 * i128::from(at.of.get()), "{ends:?} in {area:?}: end {k}");
        let ((ax, ay), (bx, by)) = (wide(ends[0]), wide(ends[1]));
        let place = PointFx::from_bits(t.nearest(ax, bx), t.nearest(ay, by));
        assert_eq!(got.ends[k], place, "{ends:?} in {area:?}: end {k}");
    }
}

fn viewports(input: &mut Input<'_>) {
    let (low, high) = ([input.int(), input.int()], [input.int(), input.int()]);
    let area = Rect::new(input.int(), input.int(), input.int(), input.int());
    let (x, y) = (input.int(), input.int());
    let units = |v: PointFx| (v.x.to_bits(), v.y.to_bits());
    let (upper, lower) = (units(PointFx::px(area.x0, area.y0)), units(PointFx::px(area.x1, area.y1)));
    let (mut view, screen_x, mut screen_y) =
        (Viewport::from_bits(low, high, area), (upper.0, lower.0), (upper.1, lower.1));
    if input.byte() & 1 == 0 {
        (view, screen_y) = (view.with_y_up(), (screen_y.1, screen_y.0));
    }
    let (plane_x, plane_y) = ((low[0], high[0]), (low[1], high[1]));
    let wanted = (map_twin(x, plane_x, screen_x), map_twin(y, plane_y, screen_y));
    assert_eq!(units(view.bits_to_screen([x, y])), wanted, "({x}, {y}) in {view:?}");
    let wanted = [map_twin(x, screen_x, plane_x), map_twin(y, screen_y, plane_y)];
    assert_eq!(view.to_plane_bits(PointFx::from_bits(x, y)), wanted, "back from ({x}, {y}) in {view:?}");
}
