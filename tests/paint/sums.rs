//! Sums of shapes against whole numbers pixel by pixel, and shapes side by side, whose seams nobody sees.

use embedded_graphics_core::pixelcolor::{Gray4, Gray8, GrayColor, Rgb565, Rgb888, RgbColor};
use embedded_raster::{
    paint::{Add, Cover},
    pixel::Channels,
    raster::{coverage, triangle},
    surface::{Accumulator, Rows, Sum},
    Antialias, BufferError, Canvas, Frame, PointFx, Rect,
};
use twins::{
    coverage::Levels,
    rng::{cases, Rng},
};

/// What is added to a pixel: parts of colours, of 255ths.
#[derive(Clone, Default)]
struct Added(Vec<(Rgb888, u64)>);

impl Added {
    fn add(&mut self, color: Rgb888, level: u8) {
        let room = 255 - self.0.iter().map(|&(_, level)| level).sum::<u64>();
        self.0.push((color, room.min(level.into())));
    }

    /// By the rule: the mean of the parts, and of what was there before if there is room for more than a 255th.
    fn shown<C: Channels>(&self, old: C) -> C {
        let covered: u64 = self.0.iter().map(|&(_, level)| level).sum();
        let sum = |of: fn(&Rgb888) -> u8| self.0.iter().map(|(color, level)| u64::from(of(color)) * level).sum::<u64>();
        let sums = [sum(Rgb888::r), sum(Rgb888::g), sum(Rgb888::b)].map(|sum| sum as u32);
        if covered == 0 {
            return old;
        }
        old.mixed_with(sums, |d, most, sum| {
            let (d, most, sum) = (u64::from(d), u64::from(most), u64::from(sum));
            let (n, all) = match covered {
                254.. => (most * sum, 255 * covered),
                _ => (most * sum + 255 * (255 - covered) * d, 255 * 255),
            };
            ((2 * n + all) / (2 * all)) as u8
        })
    }
}

fn random<C: Channels + std::fmt::Debug>(rng: &mut Rng, color: impl Fn(u8) -> C) {
    let (x, y) = (rng.int(-5, 5), rng.int(-5, 5));
    let window = Rect::new(x, y, x + rng.int(1, 20), y + rng.int(1, 12));
    let pixels = || (window.y0..window.y1).flat_map(|y| (window.x0..window.x1).map(move |x| (x, y)));
    let (mut memory, mut added) = (vec![Sum::EMPTY; 20 * 12], vec![Added::default(); pixels().count()]);
    let mut sums = Accumulator::new(&mut memory, window).expect("enough memory");
    for _ in 0..rng.int(1, 5) {
        let corners = [(); 3].map(|()| PointFx::from_bits(rng.int(-2_000, 6_000), rng.int(-2_000, 4_000)));
        let color = Rgb888::new(rng.bits() as u8, rng.bits() as u8, rng.bits() as u8);
        let mut levels = Levels::new(window);
        if rng.one_in(3) {
            sums.fill_triangle_fx(corners, color);
            triangle::fill(corners, window, &mut levels);
        } else {
            sums.fill_triangle_aa(corners, &mut [], Add(color));
            coverage::triangle(corners, &mut [], window, &mut levels);
        }
        for ((x, y), sum) in pixels().zip(&mut added) {
            sum.add(color, levels.at(x, y));
        }
    }
    for ((x, y), added) in pixels().zip(&added) {
        let old = color(rng.bits() as u8);
        let sum = sums.at(x, y);
        assert!(sum.over(old) == added.shown(old), "({x}, {y}): {sum:?} over {old:?}");
        assert_eq!(u64::from(sum.covered()), added.0.iter().map(|part| part.1).sum::<u64>(), "covered at ({x}, {y})");
    }
    assert_eq!(sums.at(window.x1, window.y0), Sum::EMPTY, "outside");
}

#[test]
fn sums_are_those_of_their_parts() {
    let mut rng = Rng::new(1_760);
    for _ in 0..cases(300) {
        random(&mut rng, Gray8::new);
        random(&mut rng, Gray4::new);
        random(&mut rng, |n| Rgb565::new(n & 31, n & 63, n >> 3));
        random(&mut rng, |n| Rgb888::new(n, !n, n / 2));
    }
}

#[test]
fn too_little_memory_is_told() {
    let error = Accumulator::new(&mut [Sum::EMPTY; 11], Rect::new(2, 3, 6, 6)).expect_err("twelve are wanted");
    assert_eq!(error, BufferError::TooSmall { needed: 96, given: 88 });
    let everything = Rect::new(i32::MIN, i32::MIN, i32::MAX, i32::MAX);
    Accumulator::new(&mut [], everything).expect_err("more than there is");
    assert_eq!(size_of::<Sum>(), 8);
}

/// A fan of dark triangles around a place, on white: with sums nothing is lighter than the lightest of them, as far as the fan reaches.
#[test]
fn a_fan_has_no_seams() {
    let mut rng = Rng::new(1_770);
    let (mut seen, mut memory) = (0, vec![Sum::EMPTY; 40 * 40]);
    for _ in 0..cases(60) {
        let centre = (rng.int(15 * 256, 25 * 256), rng.int(15 * 256, 25 * 256));
        let place = |(x, y): (i32, i32)| PointFx::from_bits(x, y);
        let around: Vec<(i32, i32)> = (0..9)
            .map(|i| {
                let (sin, cos) = (f64::from(i) * std::f64::consts::TAU / 9.0 + 0.2).sin_cos();
                (centre.0 + (cos * 20_000.0) as i32, centre.1 + (sin * 20_000.0) as i32)
            })
            .collect();
        let white = || Frame::<_, Rows<Gray8>>::new(vec![255; 1600], 40, 40).expect("enough memory");
        let (mut painted, mut shown) = (white(), white());
        let mut sums = Accumulator::new(&mut memory, Rect::new(0, 0, 40, 40)).expect("enough memory");
        for i in 0..9 {
            let corners = [centre, around[i], around[(i + 1) % 9]].map(place);
            let grey = 40 + 8 * (i as u8 % 3);
            sums.fill_triangle_aa(corners, &mut [], Add(Rgb888::new(grey, grey, grey)));
            painted.fill_triangle_aa(corners, &mut [], Cover(Gray8::new(grey)));
        }
        sums.show(&mut shown, Sum::over);
        let lighter = |frame: &Frame<Vec<u8>, Rows<Gray8>>| {
            frame.colors(Rect::new(0, 0, 40, 40)).filter(|color| color.luma() > 56).count()
        };
        // Where all nine meet, each is rounded.
        let at = place(centre).pixel();
        let centre = usize::from(shown.get(at).is_some_and(|color| color.luma() > 56));
        assert_eq!(lighter(&shown) - centre, 0, "seams around {at}");
        seen += lighter(&painted);
    }
    assert!(seen > 1_000, "without sums there are seams: {seen} pixels");
}
