//! The gauge: pictures in `tests/golden`, which `BLESS=1 cargo test --test simulator` writes anew.

use embedded_raster_simulator::gauge::gauge;

use crate::pictures::compare;

#[test]
fn gauges_are_as_they_were() {
    let wrong = [0, 724, 1000].into_iter().filter_map(|value| {
        let picture = gauge(value).expect("enough memory").zoomed(2);
        compare(&format!("gauge-{value}"), &picture)
    });
    let wrong: Vec<String> = wrong.collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
