//! Ordered dither: what the eye sees of thresholds of Bayer, of tables of blue noise, and of error diffusion.
//!
//! An eye is a blur: a bell with s of 2 pixels, which is a display of 100 pixels to the inch at arm's length, roughly, or of 1 pixel, which
//! is a close look. What is left of a pattern behind it is grain. A grain whose energy lies in a few waves is a texture, which is seen
//! where noise as strong is not.
//!
//! * **ramp**: root of the mean square of what a course from black to white is off, behind the blur, in levels of 255.
//! * **grain**: the same for flat areas, mean over all levels, and **worst** of them.
//! * **wave**: of the grain of flat areas, what the strongest wave alone has; mean over all levels, and worst.
//! * **lines**: waves that share nine tenths of the energy of a flat area, before the blur; mean over all levels.

mod blue_noise;

use std::{f64::consts::TAU, fmt::Write as _};

use self::blue_noise::ranks;
use embedded_graphics::geometry::Point;
use embedded_raster::{paint::Bayer, pixel::FloydSteinberg};

/// Columns and rows of a flat area: whole blocks of all tables.
const SIDE: usize = 32;
/// Columns and rows of a course.
const RAMP: (usize, usize) = (1024, 64);

/// A way to show levels of 0 to 255 by black and white.
trait Screen {
    /// The pixels of an area, row by row, that are white.
    fn shown(&mut self, width: usize, height: usize, level: &dyn Fn(usize, usize) -> u8) -> Vec<bool>;
}

/// By thresholds of a block.
struct Thresholds(usize, Vec<u16>);

impl Thresholds {
    fn bayer<const N: u32>() -> Self {
        let side = N as usize;
        let at = |n: usize| Point::new((n % side) as i32, (n / side) as i32);
        Self(side, (0..side * side).map(|n| Bayer::<N>::threshold(at(n)) as u16).collect())
    }
}

impl Screen for Thresholds {
    /// The rule of `Bayer::shade`, for as many thresholds as there are.
    fn shown(&mut self, width: usize, height: usize, level: &dyn Fn(usize, usize) -> u8) -> Vec<bool> {
        let Self(side, ranks) = self;
        let count = ranks.len();
        let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
        let is_white = |(x, y): (usize, usize)| {
            let rank = usize::from(ranks[y % *side * *side + x % *side]);
            usize::from(level(x, y)) * 2 * count + (2 * rank + 1) * 255 >= 510 * count
        };
        places.map(is_white).collect()
    }
}

/// By error diffusion.
struct Diffusion;

impl Screen for Diffusion {
    fn shown(&mut self, width: usize, height: usize, level: &dyn Fn(usize, usize) -> u8) -> Vec<bool> {
        // What is above has settled when the area begins.
        let (mut row, before) = (vec![[0; 1]; width], 64);
        let mut diffusion = FloydSteinberg::new(&mut row);
        let places = (0..height + before).flat_map(|y| (0..width).map(move |x| (x, y.saturating_sub(before))));
        let all: Vec<bool> = places
            .map(|(x, y)| diffusion.next([level(x, y)], |[n]| if n < 128 { (false, [0]) } else { (true, [255]) }))
            .collect();
        all[before * width..].to_vec()
    }
}

/// The share of each wave of a flat area: its energy, and the square of what the blur leaves of its height.
fn spectrum(white: &[bool], sigma: f64) -> Vec<(f64, f64)> {
    let mean = white.iter().filter(|&&white| white).count() as f64 / white.len() as f64;
    let value = |x: usize, y: usize| f64::from(u8::from(white[y * SIDE + x])) - mean;
    let wave = |n: usize| (TAU * n as f64 / SIDE as f64).sin_cos();
    // Rows first, then columns.
    let rows: Vec<(f64, f64)> = (0..SIDE * SIDE)
        .map(|n| {
            let (u, y) = (n % SIDE, n / SIDE);
            (0..SIDE).fold((0.0, 0.0), |(re, im), x| {
                let (sin, cos) = wave(u * x % SIDE);
                (re + value(x, y) * cos, im - value(x, y) * sin)
            })
        })
        .collect();
    let power = |u: usize, v: usize| {
        let (re, im) = (0..SIDE).fold((0.0, 0.0), |(re, im), y| {
            let ((sin, cos), (a, b)) = (wave(v * y % SIDE), rows[y * SIDE + u]);
            (re + a * cos + b * sin, im + b * cos - a * sin)
        });
        (re * re + im * im) / (SIDE as f64).powi(4)
    };
    let away = |n: usize| n.min(SIDE - n) as f64 / SIDE as f64;
    let kept = |u: usize, v: usize| (-(TAU * sigma).powi(2) * (away(u).powi(2) + away(v).powi(2))).exp();
    (1..SIDE * SIDE).map(|n| (n % SIDE, n / SIDE)).map(|(u, v)| (power(u, v), kept(u, v))).collect()
}

/// How many waves share nine tenths of the energy.
fn lines(spectrum: &[(f64, f64)]) -> f64 {
    let mut powers: Vec<f64> = spectrum.iter().map(|(power, _)| *power).collect();
    powers.sort_by(|a, b| b.total_cmp(a));
    let all: f64 = powers.iter().sum();
    let sums = powers.iter().scan(0.0, |sum, power| {
        *sum += power;
        Some(*sum)
    });
    sums.take_while(|sum| *sum < 0.9 * all).count() as f64 + 1.0
}

/// What a course is off behind the blur, in levels; the ends, where it has no neighbours, are left out.
fn ramp(screen: &mut dyn Screen, sigma: f64) -> f64 {
    let (width, height) = RAMP;
    let level = |x: usize, _: usize| (x * 256 / width) as u8;
    let white = screen.shown(width, height, &level);
    let reach = (4.0 * sigma) as usize;
    let bell: Vec<f64> =
        (0..=2 * reach).map(|n| (-(n as f64 - reach as f64).powi(2) / (2.0 * sigma * sigma)).exp()).collect();
    let whole: f64 = bell.iter().sum();
    let off = |x: usize, y: usize| f64::from(u8::from(white[y * width + x])) * 255.0 - x as f64 * 255.0 / width as f64;
    let across: Vec<f64> = (0..height * width)
        .map(|n| {
            let (x, y) = (n % width, n / width);
            let inside = x >= reach && x + reach < width;
            if inside {
                (0..=2 * reach).map(|i| bell[i] * off(x + i - reach, y)).sum::<f64>() / whole
            } else {
                0.0
            }
        })
        .collect();
    let (mut sum, mut count) = (0.0, 0.0);
    for y in reach..height - reach {
        for x in reach..width - reach {
            let error = (0..=2 * reach).map(|i| bell[i] * across[(y + i - reach) * width + x]).sum::<f64>() / whole;
            sum += error * error;
            count += 1.0;
        }
    }
    (sum / count).sqrt()
}

/// What is seen of one screen.
fn row(screen: &mut dyn Screen, sigma: f64) -> String {
    let (mut grains, mut waves, mut counts) = (vec![], vec![], vec![]);
    for level in 1..=254 {
        let white = screen.shown(SIDE, SIDE, &|_, _| level);
        if white.iter().all(|&pixel| pixel == white[0]) {
            continue;
        }
        let spectrum = spectrum(&white, sigma);
        let seen = || spectrum.iter().map(|(power, kept)| power * kept);
        grains.push(255.0 * seen().sum::<f64>().sqrt());
        // A wave and its mirror image are one.
        waves.push(255.0 * (2.0 * seen().fold(0.0, f64::max)).sqrt());
        counts.push(lines(&spectrum));
    }
    let mean = |values: &[f64]| values.iter().sum::<f64>() / values.len() as f64;
    let worst = |values: &[f64]| values.iter().copied().fold(0.0, f64::max);
    let (ramp, lines) = (ramp(screen, sigma), mean(&counts));
    let [grain, most, wave, strongest] = [mean(&grains), worst(&grains), mean(&waves), worst(&waves)];
    format!("{ramp:.1} | {grain:.1} | {most:.1} | {wave:.1} | {strongest:.1} | {lines:.0}")
}

/// A table, in Markdown.
pub(crate) fn report() -> String {
    let mut screens: Vec<(&str, Box<dyn Screen>)> = vec![
        ("Bayer, 2 x 2", Box::new(Thresholds::bayer::<2>())),
        ("Bayer, 4 x 4", Box::new(Thresholds::bayer::<4>())),
        ("Bayer, 8 x 8", Box::new(Thresholds::bayer::<8>())),
        ("blue noise, 8 x 8", Box::new(Thresholds(8, ranks(8, 1)))),
        ("blue noise, 16 x 16", Box::new(Thresholds(16, ranks(16, 1)))),
        ("blue noise, 32 x 32", Box::new(Thresholds(32, ranks(32, 1)))),
        ("Floyd-Steinberg", Box::new(Diffusion)),
    ];
    let mut table = String::from("| screen | s | ramp | grain | worst | wave | worst | lines |\n");
    table.push_str("|---|---:|---:|---:|---:|---:|---:|---:|\n");
    for sigma in [2.0, 1.0] {
        for (name, screen) in &mut screens {
            writeln!(table, "| {name} | {sigma} | {} |", row(screen.as_mut(), sigma)).expect("to a string");
        }
    }
    table
}
