//! Calls one after the other, on memory of any layout and on a naive twin: the same pixels, the same answers, and no bit changed
//! outside of what a call may paint. The fuzz target `sequence` does the same with bytes that learn.

use twins::{
    rng::{cases, Rng},
    sequences::sequence,
};

fn sequences(seed: u64) {
    let mut rng = Rng::new(seed);
    for _ in 0..cases(1_000) {
        let bytes: Vec<u8> = (0..rng.range(500, 8_000)).flat_map(|_| rng.bits().to_le_bytes()).collect();
        sequence(&bytes);
    }
}

#[test]
fn sequences_are_the_same_on_a_naive_surface() {
    // Another seed for a longer run by hand.
    sequences(std::env::var("EMBEDDED_RASTER_SEED").map_or(970, |seed| seed.parse().expect("a seed is a number")));
}

#[test]
fn sequences_are_the_same_from_another_seed() {
    sequences(971);
}
