//! Ellipses, arcs, sectors, rings and rounded rectangles against their equations, pixel by pixel.
#![no_main]

mod input;

use embedded_raster::{
    raster::{arc, ellipse, rounded},
    Angle, Ellipse, PointFx, Radii, Rect, Sector,
};
use fixed::types::I24F8;
use input::Input;
use libfuzzer_sys::fuzz_target;
use twins::{
    assert_runs, collect,
    rounds::{from_box, rounded_has, rounded_outline_has, sector_has},
    runs_where,
};

fuzz_target!(|data: &[u8]| {
    let mut input = Input(data);
    let window = input.window();
    match input.byte() & 3 {
        0 => boxes(&mut input, window),
        1 => places(&mut input, window),
        2 => arcs(&mut input, window),
        _ => corners(&mut input, window),
    }
});

fn boxes(input: &mut Input<'_>, window: Rect) {
    let area = input.area_near(window);
    let got = collect(window, |emit| ellipse::fill(Ellipse::in_box(area), window, emit));
    let wanted = runs_where(window, |x, y| twins::box_ellipse_has(area, x, y));
    assert_runs(window, &got, &wanted, || format!("filled {area:?}"));
    let got = collect(window, |emit| ellipse::outline(area, window, emit));
    let wanted = runs_where(window, |x, y| twins::outline_has(area, x, y));
    assert_runs(window, &got, &wanted, || format!("outline of {area:?}"));
    let got = collect(window, |emit| ellipse::enclosed(area, window, emit));
    let wanted = runs_where(window, |x, y| twins::enclosed_has(area, x, y));
    assert_runs(window, &got, &wanted, || format!("enclosed by {area:?}"));
}

fn places(input: &mut Input<'_>, window: Rect) {
    let (x, y) = input.place_near(window);
    let (rx, ry) = (input.near(0, 67), input.near(0, 67));
    let (at, wide) = (PointFx::from_bits(x, y), (i64::from(x), i64::from(y)));
    let shape = Ellipse::new(at, I24F8::from_bits(rx), I24F8::from_bits(ry));
    let got = collect(window, |emit| ellipse::fill(shape, window, emit));
    let wanted = runs_where(window, |x, y| twins::ellipse_has(wide, (rx.into(), ry.into()), 256, x, y));
    assert_runs(window, &got, &wanted, || format!("({x}, {y}) radii {rx}, {ry}"));
    let splat = Ellipse::splat(at, I24F8::from_bits(rx));
    let got = collect(window, |emit| ellipse::fill(splat, window, emit));
    let wanted =
        runs_where(window, |x, y| twins::ellipse_has((2 * wide.0, 2 * wide.1), (rx.into(), rx.into()), 512, x, y));
    assert_runs(window, &got, &wanted, || format!("a point at ({x}, {y}) of {rx}"));
}

fn arcs(input: &mut Input<'_>, window: Rect) {
    let area = input.area_near(window);
    let inner = input.area_near(area);
    let mut angle = || Angle::from_bits(u32::from(input.byte()) << 24 | (input.int() as u32) >> 8);
    let (start, end) = (angle(), angle());
    let (sector, outer) = (Sector::new(start, end), Ellipse::in_box(area));
    let inside = |x: i32, y: i32| sector_has(start, end, from_box(area, x, y));
    let what = |name: &str| format!("{name} {area:?} {inner:?} from {start:?} to {end:?}");

    let got = collect(window, |emit| arc::outline(area, sector, window, emit));
    let wanted = runs_where(window, |x, y| twins::outline_has(area, x, y) && inside(x, y));
    assert_runs(window, &got, &wanted, || what("arc"));
    let got = collect(window, |emit| arc::fill(outer, sector, window, emit));
    let wanted = runs_where(window, |x, y| twins::box_ellipse_has(area, x, y) && inside(x, y));
    assert_runs(window, &got, &wanted, || what("sector"));
    let got = collect(window, |emit| arc::ring_sector(outer, Ellipse::in_box(inner), sector, window, emit));
    let ring = |x, y| twins::box_ellipse_has(area, x, y) && !twins::box_ellipse_has(inner, x, y);
    let wanted = runs_where(window, |x, y| ring(x, y) && inside(x, y));
    assert_runs(window, &got, &wanted, || what("sector of a ring"));
}

fn corners(input: &mut Input<'_>, window: Rect) {
    let area = input.area_near(window);
    let mut radius = || input.near(64, 1) as u32;
    let radii = Radii { top_left: radius(), top_right: radius(), bottom_right: radius(), bottom_left: radius() };
    let got = collect(window, |emit| rounded::fill(area, radii, window, emit));
    let wanted = runs_where(window, |x, y| rounded_has(area, radii, x, y));
    assert_runs(window, &got, &wanted, || format!("filled {area:?} {radii:?}"));
    let got = collect(window, |emit| rounded::outline(area, radii, window, emit));
    let wanted = runs_where(window, |x, y| rounded_outline_has(area, radii, x, y));
    assert_runs(window, &got, &wanted, || format!("outline of {area:?} {radii:?}"));
}
