//! The fuzz targets that share their checks with tests, on random bytes: `cargo +nightly fuzz run pipeline` does the same with bytes
//! that learn.

use twins::{
    pictures,
    rng::{cases, Rng},
    targets, texts,
};

fn run(seed: u64, most: i64, target: fn(&[u8])) {
    let mut rng = Rng::new(seed);
    for _ in 0..cases(8_000) {
        let bytes: Vec<u8> = (0..rng.range(0, most)).flat_map(|_| rng.bits().to_le_bytes()).collect();
        target(&bytes);
    }
}

#[test]
fn shading() {
    run(1, 20, targets::shading);
}

#[test]
fn the_pipeline() {
    run(2, 20, targets::pipeline);
}

#[test]
fn textures() {
    run(3, 90, targets::texture);
}

#[test]
fn text() {
    run(4, 200, texts::target);
}

#[test]
fn soft_rims() {
    run(4, 60, targets::coverage);
}

#[test]
fn texts() {
    run(4, 12, targets::svg);
}

#[test]
fn packed_paths() {
    run(5, 12, targets::packed);
}

#[test]
fn pictures_in_every_way() {
    run(6, 30, pictures::blits);
}

#[test]
fn patterns() {
    run(7, 80, pictures::patterns);
}

#[test]
fn error_diffusion() {
    run(8, 40, pictures::diffusion);
}
