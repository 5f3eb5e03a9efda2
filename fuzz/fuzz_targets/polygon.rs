//! Polygons of any contours, through edge tables of any capacity, against a count of crossings per pixel.
#![no_main]

mod input;

use embedded_raster::{raster::polygon, EdgeSlot, EdgeTableFull, FillRule};
use libfuzzer_sys::fuzz_target;
use twins::{assert_runs, collect, vertices, Units};

fuzz_target!(|data: &[u8]| {
    let mut input = input::Input(data);
    let window = input.window();
    let (capacity, choice) = (usize::from(input.byte()), input.byte());
    let rule = if choice & 1 == 0 { FillRule::NonZero } else { FillRule::EvenOdd };
    let mut contours: Vec<Vec<Units>> = vec![vec![]];
    while input.goes_on() {
        let place = (input.int(), input.int());
        contours.last_mut().expect("there is one").push(place);
        // A place whose bits say so ends its contour.
        if place.0 & 7 == 5 {
            contours.push(vec![]);
        }
    }
    let outlines: Vec<_> = contours.iter().map(|c| vertices(c)).collect();
    let mut table = vec![EdgeSlot::EMPTY; capacity];
    let mut result = Ok(());
    let runs = collect(window, |emit| {
        result = polygon::fill(outlines.iter(), rule, &mut table, window, emit);
    });
    // A window without columns has no rows to paint either.
    let rows = if window.is_empty() { 0..0 } else { window.y0..window.y1 };
    let sides = rows.map(|row| (row, twins::sides_on_row(&contours, window, row)));
    let enough = sides.clone().map(|(_, sides)| sides).max().unwrap_or(0);
    let overflow = sides.clone().find(|&(_, needed)| needed > capacity);
    if let Some((row, needed)) = overflow {
        assert_eq!(result, Err(EdgeTableFull { capacity, needed, row, enough }), "{contours:?} in {window:?}");
        assert!(runs.is_empty(), "{runs:?} before {result:?}");
    } else {
        assert_eq!(result, Ok(()), "{contours:?} in {window:?}");
        let wanted = twins::polygon(&contours, rule, window);
        assert_runs(window, &runs, &wanted, || format!("{rule:?} {contours:?}"));
    }
});
