//! Flood fills against a breadth-first search: every picture of up to 4 x 5 pixels, mazes of a whole screen, with tables of
//! any length, none at all included.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    clippy::cast_precision_loss,
    clippy::cast_lossless,
    reason = "tests mix widths on purpose"
)]

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Rgb555, Rgb565},
};
use embedded_raster::{
    buffer_bytes,
    pixel::Lsb0,
    raster::flood::{fill, Connectivity, FloodSlot, FloodTarget},
    surface::{paged_bytes, Paged},
    Canvas, ClippedSpan, Framebuffer, Index1, Index2, Index4, Index8, PixelFormat, Rect, Surface,
};
use twins::{
    letters::Letters,
    rng::{cases, Rng},
};

const REACHES: [Connectivity; 2] = [Connectivity::Sides, Connectivity::Corners];

fn check(picture: &Letters, seed: (i32, i32), reach: Connectivity, capacity: usize) {
    let wanted = picture.flooded(seed, reach);
    let mut got = picture.clone();
    fill(&mut got, Point::new(seed.0, seed.1), reach, &mut vec![FloodSlot::EMPTY; capacity]);
    assert!(
        got == wanted,
        "{reach:?} from {seed:?} with {capacity} slots in\n{}got\n{}wanted\n{}",
        picture.text(),
        got.text(),
        wanted.text()
    );
}

/// All pictures of a size, or one in `step`, from every open pixel that is the first of its region for one reach, and by no
/// table and the shortest.
fn every_picture(width: i32, height: i32, step: usize) {
    for bits in (0..1_u32 << (width * height)).step_by(step) {
        let picture = Letters::new(width, height, |i| bits >> i & 1 != 0);
        for reach in REACHES {
            let mut rest = picture.clone();
            while let Some(first) = rest.pixels.iter().position(|&p| p == b'.') {
                let seed = (first as i32 % width, first as i32 / width);
                rest = rest.flooded(seed, reach);
                check(&picture, seed, reach, 0);
                check(&picture, seed, reach, 1);
            }
        }
    }
}

#[test]
fn every_small_picture() {
    for (width, height) in [(1, 1), (1, 5), (5, 1), (2, 2), (3, 3), (4, 3), (3, 5), (4, 4)] {
        every_picture(width, height, 1);
    }
}

#[test]
fn every_picture_of_4_x_5() {
    every_picture(4, 5, ((1 << 20) / cases(1 << 20)).max(1));
}

/// From every seed, open or not.
#[test]
fn every_seed_of_3_x_4() {
    for bits in 0..1_u32 << 12 {
        let picture = Letters::new(4, 3, |i| bits >> i & 1 != 0);
        for at in 0..12 {
            for capacity in 0..3 {
                for reach in REACHES {
                    check(&picture, (at % 4, at / 4), reach, capacity);
                }
            }
        }
    }
}

/// Noise of every density: regions with islands in islands, corridors that close on themselves.
#[test]
fn noise() {
    let mut rng = Rng::new(301);
    for _ in 0..cases(12_000) {
        let (width, height) = (rng.int(1, 24), rng.int(1, 18));
        let density = rng.range(20, 95) as u64;
        let mut picture = Letters::new(width, height, |_| rng.below(100) < density);
        let seed = (rng.int(0, width - 1), rng.int(0, height - 1));
        picture.pixels[(seed.1 * width + seed.0) as usize] = b'.';
        for reach in REACHES {
            for capacity in [0, 1, 2, 5, 40] {
                check(&picture, seed, reach, capacity);
            }
        }
    }
}

/// Corridors one pixel wide: a maze whose walls are taken away with some likelihood, so that there are loops.
fn maze(rng: &mut Rng, width: i32, height: i32, loops: u64) -> Letters {
    let mut maze = Letters::new(width, height, |_| false);
    let mut path = vec![(1, 1)];
    let at = |x: i32, y: i32| (y * width + x) as usize;
    maze.pixels[at(1, 1)] = b'.';
    while let Some(&(x, y)) = path.last() {
        let mut ways = [(2, 0), (-2, 0), (0, 2), (0, -2)];
        rng.shuffle(&mut ways);
        let inside = |x: i32, y: i32| x > 0 && y > 0 && x < width - 1 && y < height - 1;
        let way = ways.iter().find(|&&(dx, dy)| inside(x + dx, y + dy) && maze.pixels[at(x + dx, y + dy)] == b'#');
        match way {
            Some(&(dx, dy)) => {
                maze.pixels[at(x + dx / 2, y + dy / 2)] = b'.';
                maze.pixels[at(x + dx, y + dy)] = b'.';
                path.push((x + dx, y + dy));
            }
            None => _ = path.pop(),
        }
    }
    for y in 1..height - 1 {
        for x in 1..width - 1 {
            if (x + y) % 2 == 1 && rng.below(1_000) < loops {
                maze.pixels[at(x, y)] = b'.';
            }
        }
    }
    maze
}

#[test]
fn mazes_of_a_screen() {
    let mut rng = Rng::new(302);
    for _ in 0..2 {
        let maze = maze(&mut rng, 319, 239, 0);
        for capacity in [1, 4, 16, 64] {
            for reach in REACHES {
                check(&maze, (1, 1), reach, capacity);
            }
        }
    }
}

#[test]
fn small_mazes_with_many_loops() {
    let mut rng = Rng::new(303);
    for loops in [10, 30, 100, 300] {
        for _ in 0..10 {
            let maze = maze(&mut rng, 41, 31, loops);
            for capacity in [0, 1, 4, 16] {
                for reach in REACHES {
                    check(&maze, (1, 1), reach, capacity);
                }
            }
        }
    }
}

/// Spirals, combs, checkerboards, nested rings, by name.
#[test]
fn patterns() {
    let size = 61;
    let ring = |x: i32, y: i32| x.min(y).min(size - 1 - x).min(size - 1 - y);
    let patterns: [&dyn Fn(i32, i32) -> bool; 7] = [
        &|x, y| (x + y) % 2 == 0,
        &|x, y| x % 2 == 0 || y == 0,
        &|x, y| y % 2 == 0 || x == size - 1,
        &|x, y| y % 2 == 0 || x == if y % 4 == 1 { 0 } else { size - 1 },
        // Rings joined by gates that lie at the side away from one another.
        &|x, y| ring(x, y) % 2 == 0 || (x == size / 2 && if ring(x, y) % 4 == 1 { y < size / 2 } else { y > size / 2 }),
        &|x, y| x % 3 != 1 || y % 3 != 1,
        &|_, _| true,
    ];
    for pattern in patterns {
        let picture = Letters::new(size, size, |at| pattern(at % size, at / size));
        for reach in REACHES {
            for capacity in [0, 1, 2, 7, 64] {
                check(&picture, (0, 0), reach, capacity);
                check(&picture, (size - 1, 0), reach, capacity);
            }
        }
    }
    let spiral = Letters::parse(&[
        ".........",
        "########.",
        ".......#.",
        ".#####.#.",
        ".#...#.#.",
        ".#.###.#.",
        ".#.....#.",
        ".#######.",
        ".........",
    ]);
    for capacity in 0..4 {
        for reach in REACHES {
            check(&spiral, (3, 4), reach, capacity);
        }
    }
}

/// The same in memory: pictures of three colours, by colour and up to a boundary.
fn in_memory<F: PixelFormat>(seed: u64) {
    let mut rng = Rng::new(seed);
    let colors: Vec<F::Color> = [0, 1, 2, 3].map(|bits| F::unpack(bits & ((1 << F::BITS.min(31)) - 1))).to_vec();
    for round in 0..250 {
        let (width, height) = (rng.int(1, 40), rng.int(1, 20));
        let mut ram = vec![0; buffer_bytes::<F>(width as u16, height as u16)];
        let mut frame = Framebuffer::<F>::new(&mut ram, width as u16, height as u16).expect("enough bytes");
        let kinds = if F::BITS == 1 { 2 } else { rng.below(2) + 2 };
        for y in 0..height {
            for x in 0..width {
                let color = if rng.one_in(3) { rng.below(kinds) } else { 0 };
                frame.set(Point::new(x, y), colors[color as usize]);
            }
        }
        let mut window = Rect::new(0, 0, width, height);
        if rng.one_in(2) {
            window = window.intersection(Rect::new(rng.int(-2, 9), rng.int(-2, 5), rng.int(5, 40), rng.int(4, 20)));
        }
        let seed = Point::new(rng.int(-1, width), rng.int(-1, height));
        let new = colors[rng.below(kinds) as usize];
        let boundary = (round % 3 == 0).then(|| colors[rng.below(kinds) as usize]);
        let reach = rng.pick(&REACHES);
        let color = |frame: &Framebuffer<'_, F>, x: i32, y: i32| frame.get(Point::new(x, y)).map(F::pack);
        let old = color(&frame, seed.x, seed.y);
        // As letters: what is open in the window.
        let letters = Letters::new(width, height, |i| {
            let (x, y) = (i % width, i / width);
            let here = color(&frame, x, y);
            let open = match boundary {
                Some(boundary) => here != Some(F::pack(boundary)) && here != Some(F::pack(new)),
                None => here == old && here != Some(F::pack(new)),
            };
            open && window.contains(x, y)
        });
        let flooded = letters.flooded((seed.x, seed.y), reach);
        let wanted: Vec<_> = (0..width * height)
            .map(|i| {
                let painted = letters.pixels[i as usize] != flooded.pixels[i as usize];
                if painted {
                    Some(F::pack(new))
                } else {
                    color(&frame, i % width, i / width)
                }
            })
            .collect();
        let mut table = vec![FloodSlot::EMPTY; rng.index(6)];
        let mut clipped = frame.clipped(window);
        let wanted_slots = match boundary {
            Some(boundary) => clipped.flood_fill_to(seed, boundary, reach, &mut table, new),
            None => clipped.flood_fill(seed, reach, &mut table, new),
        };
        let used = table.iter().filter(|&&slot| slot != FloodSlot::EMPTY).count();
        assert!(used <= wanted_slots && (used == table.len() || used == wanted_slots), "slots that were wanted");
        let got: Vec<_> = (0..width * height).map(|i| color(&frame, i % width, i / width)).collect();
        assert!(got == wanted, "round {round}: {reach:?} from {seed:?} in\n{}", letters.text());
    }
}

#[test]
fn packed_pixels() {
    in_memory::<Index1>(310);
    in_memory::<Lsb0<Index2>>(311);
    in_memory::<Index4>(312);
}

#[test]
fn whole_pixels() {
    in_memory::<Index8>(313);
    in_memory::<Rgb565>(314);
    in_memory::<Rgb555>(315);
    in_memory::<embedded_raster::pixel::Be<embedded_graphics_core::pixelcolor::Rgb888>>(316);
    in_memory::<embedded_raster::pixel::Xrgb8888>(317);
}

#[test]
fn pages() {
    let mut rng = Rng::new(318);
    for _ in 0..300 {
        let picture = Letters::new(23, 19, |_| !rng.one_in(3));
        let mut ram = vec![0; paged_bytes(23, 19)];
        let mut oled = Paged::<BinaryColor>::new(&mut ram, 23, 19).expect("enough bytes");
        let points = || (0..19).flat_map(|y| (0..23).map(move |x| (x, y)));
        for (x, y) in points() {
            oled.set(Point::new(x, y), BinaryColor::from(picture.at(x, y) == Some(b'#')));
        }
        let (seed, reach) = ((rng.int(0, 22), rng.int(0, 18)), rng.pick(&REACHES));
        oled.flood_fill(Point::new(seed.0, seed.1), reach, &mut [FloodSlot::EMPTY; 3], BinaryColor::On);
        let wanted = picture.flooded(seed, reach);
        for (x, y) in points() {
            let on = oled.get(Point::new(x, y)) == Some(BinaryColor::On);
            assert_eq!(on, wanted.at(x, y) == Some(b'#'), "({x}, {y}) of\n{}", picture.text());
        }
    }
}

/// Bits that no colour has do not make a pixel another colour.
#[test]
fn unused_bits() {
    let mut ram = [0, 0, 0, 0x80, 0, 0];
    let mut frame = Framebuffer::<Rgb555>::new(&mut ram, 3, 1).expect("enough bytes");
    let red = Rgb555::new(31, 0, 0);
    frame.flood_fill(Point::new(0, 0), Connectivity::Sides, &mut [FloodSlot::EMPTY], red);
    assert_eq!(frame.get(Point::new(2, 0)), Some(red));
}

/// Counts the pixels that are read.
struct Counted {
    picture: Letters,
    reads: std::cell::Cell<u64>,
}

impl FloodTarget for Counted {
    fn window(&self) -> Rect {
        self.picture.window()
    }

    fn is_open(&self, x: i32, y: i32) -> bool {
        self.reads.set(self.reads.get() + 1);
        self.picture.is_open(x, y)
    }

    fn paint(&mut self, span: ClippedSpan) {
        self.picture.paint(span);
    }
}

/// The slots that a fill wants, and the pixels that it reads with a table of some length.
fn reads(picture: &Letters, seed: (i32, i32), reach: Connectivity, capacity: usize) -> (usize, u64) {
    let mut counted = Counted { picture: picture.clone(), reads: 0.into() };
    let wanted = fill(&mut counted, Point::new(seed.0, seed.1), reach, &mut vec![FloodSlot::EMPTY; capacity]);
    assert!(counted.picture == picture.flooded(seed, reach), "{reach:?} with {capacity} slots");
    (wanted, counted.reads.get())
}

/// Noise, pillars of one pixel, teeth of a comb, and corridors, with their names; to be filled from the corner or next to it.
fn hard_pictures(rng: &mut Rng) -> Vec<(String, Letters)> {
    let mut pictures = vec![];
    for size in [64, 128, 256] {
        for percent in if size == 256 { vec![5] } else { vec![1, 5, 10, 30] } {
            let mut noise = Letters::new(size, size, |_| rng.below(100) >= percent);
            noise.pixels[0] = b'.';
            pictures.push((format!("{percent} % noise, {size} x {size}"), noise));
        }
    }
    let picture = |open: &dyn Fn(i32, i32) -> bool| Letters::new(201, 201, |at| open(at % 201, at / 201));
    for step in [2, 3, 4] {
        pictures.push((format!("pillars, one in {step}"), picture(&|x, y| x % step != 1 || y % step != 1)));
    }
    pictures.push(("a chequerboard".into(), picture(&|x, y| (x + y) % 2 == 0)));
    pictures.push(("a comb".into(), picture(&|x, y| x % 2 == 0 || y == 0)));
    for loops in [0, 10, 100, 300] {
        let mut maze = maze(rng, 201, 201, loops);
        maze.pixels[0] = b'.';
        maze.pixels[1] = b'.';
        pictures.push((format!("a maze with {loops} loops in 1,000"), maze));
    }
    pictures
}

/// Work with a table that is too short, counted in pixels that are read: with 5 % noise, pillars and combs at most 8 times the
/// pixels painted times how many times too short it is. The worst of all pictures here is the one that the module names.
#[test]
fn few_slots_cost_no_more_than_they_are_too_few() {
    let (mut rng, mut choice) = (Rng::new(320), Rng::new(321));
    let mut worst = [0; 2];
    for (name, picture) in hard_pictures(&mut rng) {
        for reach in REACHES {
            let flooded = picture.flooded((0, 0), reach);
            let pixels = picture.pixels.iter().zip(&flooded.pixels).filter(|(old, new)| old != new).count() as u64;
            let (wanted, most) = reads(&picture, (0, 0), reach, 1 << 16);
            assert!(most <= 6 * pixels, "{name}: {most} reads for {pixels} pixels with enough slots");
            let is_bounded = name.starts_with("5 %") || name.starts_with("pillars") || name == "a comb";
            let part = if is_bounded { wanted * 9 / 10 } else { 700 };
            for capacity in [1, 3, 16, 64, 256, 1_000, wanted / 2, part] {
                if capacity >= 1 && capacity < wanted && choice.takes_case() {
                    let (_, reads) = reads(&picture, (0, 0), reach, capacity);
                    let bound = 8 * pixels * wanted.div_ceil(capacity) as u64;
                    assert!(
                        !is_bounded || reads <= bound,
                        "{name}, {reach:?}, {capacity} of {wanted} slots: {reads} reads for {pixels} pixels"
                    );
                    let worst = &mut worst[usize::from(capacity >= 16)];
                    *worst = reads.div_ceil(pixels).max(*worst);
                }
            }
        }
    }
    assert!(worst <= [7_700, 550], "the worst cases that the module names: {worst:?} reads a pixel");
}

/// Two large loops that a corridor joins, with a dead end in its middle: the walker eats the dead end, and then stands where both
/// walls are the same one.
#[test]
fn a_dead_end_between_two_loops() {
    let (width, height) = (83, 47);
    let in_loop = |x: i32, y: i32| {
        let ring = (x - 1).min(y - 1).min(31 - x).min(45 - y);
        ring == 0
    };
    let picture = Letters::new(width, height, |at| {
        let (x, y) = (at % width, at / width);
        in_loop(x, y)
            || in_loop(width - 1 - x, y)
            || (y == 23 && (31..=51).contains(&x))
            || (x == 41 && (23..40).contains(&y))
    });
    for turned in [false, true] {
        let picture = if turned {
            Letters::new(height, width, |at| picture.at(at / height, at % height) == Some(b'.'))
        } else {
            picture.clone()
        };
        for seed in [(41, 39), (41, 30), (1, 1), (36, 23), (47, 23), (81, 45)] {
            let seed = if turned { (seed.1, seed.0) } else { seed };
            for reach in REACHES {
                for capacity in 0..3 {
                    check(&picture, seed, reach, capacity);
                }
            }
        }
    }
}
