//! Icons beside another renderer, resvg, at 48 pixels: what is in the middle of each pixel, and what most of it is.

use std::{fs, path::Path};

use embedded_graphics_core::pixelcolor::{Rgb888, RgbColor};
use embedded_raster_simulator::svg::{draw, File, Screen};
use fixed::types::I24F8;
use resvg::{tiny_skia, usvg};

const SIZE: u16 = 48;
/// The other renderer's picture has so many pixels for one.
const FINE: usize = 16;
/// The square of twice 0.14 pixel, and half of one of its pixels.
const REACH: usize = 30;

/// All icons in the folder: name and text.
fn icons() -> Vec<(String, String)> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/icons");
    let files = fs::read_dir(folder).expect("the folder of icons").map(|entry| entry.expect("a file").path());
    let mut all: Vec<_> = files
        .map(|path| {
            let name = path.file_stem().expect("a name").to_string_lossy().into_owned();
            (name, fs::read_to_string(path).expect("a text"))
        })
        .collect();
    all.sort();
    all
}

/// Which pixels are dark, and what was left out.
fn ours(text: &str) -> (Vec<bool>, Vec<String>) {
    let mut file = File::parse(text).expect("an SVG file");
    let shapes = file.shapes((SIZE, SIZE), [1.0, 0.0, 0.0, 1.0, 0.0, 0.0], I24F8::ZERO);
    assert_eq!(file.errors, [""; 0], "path data");
    let screen = Screen { width: SIZE, height: SIZE, bits: 24, band: SIZE, slots: 9_999, paper: Rgb888::WHITE };
    let picture = draw(&shapes, &screen).expect("enough slots").picture;
    let dark = picture.colors().map(|color| color.g() < 128).collect();
    (dark, file.unknown.into_iter().collect())
}

/// Which of its pixels are dark.
fn theirs(text: &str) -> Vec<bool> {
    let tree = usvg::Tree::from_str(text, &usvg::Options::default()).expect("an SVG file");
    let side = u32::from(SIZE) * 16;
    let mut picture = tiny_skia::Pixmap::new(side, side).expect("a size");
    picture.fill(tiny_skia::Color::WHITE);
    // As large as it fits, in the middle.
    let (width, height) = (tree.size().width(), tree.size().height());
    let whole = f32::from(SIZE) * 16.0;
    let scale = (whole / width).min(whole / height);
    let map = tiny_skia::Transform::from_row(
        scale,
        0.0,
        0.0,
        scale,
        (whole - width * scale) / 2.0,
        (whole - height * scale) / 2.0,
    );
    resvg::render(&tree, map, &mut picture.as_mut());
    picture.pixels().iter().map(|pixel| pixel.green() < 128).collect()
}

#[test]
fn icons_are_those_of_another_renderer() {
    let (mut dark, mut count, mut bad) = (0, 0, vec![]);
    for (name, text) in icons() {
        let ((got, unknown), fine) = (ours(&text), theirs(&text));
        assert_eq!(unknown, [""; 0], "{name}: what was left out");
        let side = usize::from(SIZE);
        let is_dark = |x: usize, y: usize| fine[y * side * FINE + x];
        for (i, &is_drawn) in got.iter().enumerate() {
            let (x, y) = (i % side * FINE, i / side * FINE);
            let all = (0..FINE * FINE).map(|j| (j % FINE, j / FINE));
            let share = all.clone().filter(|&(p, q)| is_dark(x + p, y + q)).count();
            // Whether it is as ours somewhere near the middle: distances are doubled, as the middle is between two pixels.
            let square = |n: usize| (2 * n + 1).abs_diff(FINE).pow(2);
            let is_near =
                all.filter(|&(p, q)| square(p) + square(q) <= REACH).any(|(p, q)| is_dark(x + p, y + q) == is_drawn);
            if !is_near {
                bad.push(format!("{name}: ({}, {}) is {is_drawn}, and {share}/256 of it is dark", i % side, i / side));
            }
            count += usize::from(is_drawn != (share >= 128));
            dark += usize::from(is_drawn);
        }
    }
    assert!(bad.is_empty(), "{}", bad.join("\n"));
    // Pixels of which the middle and the larger part differ are few.
    assert!(dark > 10_000 && count * 60 < dark, "{count} of {dark}");
}
