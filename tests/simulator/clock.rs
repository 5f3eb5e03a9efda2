//! The clock on all its screens: pictures in `tests/golden`, which `BLESS=1 cargo test --test simulator` writes anew.

use crate::pictures::compare;
use embedded_raster_simulator::clock::{clock, Screen};

#[test]
fn clocks_are_as_they_were() {
    let wrong = Screen::ALL.into_iter().filter_map(|(name, screen)| {
        let picture = clock(screen, 96, (10, 9, 36), 96).expect("enough memory");
        compare(&format!("clock-{name}"), &picture)
    });
    let wrong: Vec<String> = wrong.collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
