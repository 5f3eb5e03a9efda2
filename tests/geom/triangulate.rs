//! Triangulations against the rule: every pixel inside by even-odd is painted by one triangle, no other by any; triangles
//! meet in whole sides; what crosses is refused by name; after refinement no side could be better.

#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "coordinates and counts of small shapes"
)]

use std::cmp::Ordering;

use embedded_raster::{
    geom::{
        delaunay,
        exact::{in_circle, turn},
        triangulate::{self, SideSlot},
    },
    raster::{polygon, triangle},
    EdgeSlot, FillRule, PointFx, Rect, TriangulateError,
};
use embedded_raster_simulator::world::{Map, Place, Projection, Screen, World};
use twins::{
    collect, corners,
    hits::Hits,
    meshes::{
        check, check_delaunay, check_mesh, determinant, first_crossing, flat, nodes, placed, triangulated, Contours,
        Wide,
    },
    rng::Rng,
    scenes::{outline, window_on, Scale},
    twice_area, vertices, Units,
};

/// Few vertices on a coarse grid: they touch, overlap, repeat and fold in every way there is.
#[test]
fn scribbles_on_a_grid() {
    let mut rng = Rng::new(600);
    let (mut cut, mut refused) = (0, 0);
    for _ in 0..80_000 {
        let (side, step) = (rng.int(1, 4), rng.pick(&[128, 256, 256, 300, 512]));
        let contours: Vec<Vec<Units>> = (0..rng.pick(&[1, 1, 1, 2, 2, 3]))
            .map(|_| (0..rng.index(8)).map(|_| (rng.int(0, side) * step, rng.int(0, side) * step)).collect())
            .collect();
        if check(&contours, Rect::new(-1, -1, 9, 9)) {
            cut += 1;
        } else {
            refused += 1;
        }
    }
    assert!(cut > 15_000 && refused > 15_000, "{cut} were cut, {refused} refused");
}

/// A few triangles and squares each, on a grid: islands, lakes, shared sides, chains.
#[test]
fn many_small_contours() {
    let mut rng = Rng::new(601);
    let mut cut = 0;
    for _ in 0..20_000 {
        let mut contours: Vec<Vec<Units>> = vec![];
        for _ in 0..rng.range(2, 9) {
            let mut contour: Vec<Units> =
                (0..rng.range(3, 4)).map(|_| (rng.int(0, 6) * 256, rng.int(0, 6) * 256)).collect();
            if rng.one_in(3) {
                let (x, y, w, h) = (rng.int(0, 5), rng.int(0, 5), rng.int(1, 5), rng.int(1, 5));
                contour = [(x, y), (x + w, y), (x + w, y + h), (x, y + h)].map(|(x, y)| (x * 256, y * 256)).to_vec();
            }
            contours.push(contour);
            if first_crossing(&contours).is_some() {
                contours.pop();
            }
        }
        cut += usize::from(check(&contours, Rect::new(-1, -1, 12, 12)));
    }
    assert_eq!(cut, 20_000, "none crosses");
}

/// Any set of the cells of a board, each as a contour of its own: sides cancel, corners touch, holes are everywhere.
#[test]
fn cells_of_a_board() {
    let mut rng = Rng::new(602);
    for _ in 0..1_500 {
        let (n, part, step) = (rng.int(1, 7), rng.range(1, 9) as u64, rng.pick(&[256, 200, 333]));
        let slant = rng.int(-60, 60);
        let mut contours = vec![];
        for (x, y) in (0..n).flat_map(|x| (0..n).map(move |y| (x, y))) {
            if rng.below(10) < part {
                let mut cell = [(x, y), (x + 1, y), (x + 1, y + 1), (x, y + 1)]
                    .map(|(x, y)| (x * step + y * slant, y * step - x * slant / 2))
                    .to_vec();
                if rng.one_in(2) {
                    cell.reverse();
                }
                cell.rotate_left(rng.index(4));
                contours.push(cell);
            }
        }
        rng.shuffle(&mut contours);
        assert!(check(&contours, Rect::new(-4, -4, 14, 14)), "cells do not cross");
    }
}

/// Around a middle, in the order of the angles.
fn star(rng: &mut Rng, middle: Units, radius: i32, n: usize) -> Vec<Units> {
    let mut ring: Vec<Units> =
        (0..n).map(|_| (rng.int(-radius, radius), rng.int(-radius, radius))).filter(|&p| p != (0, 0)).collect();
    ring.sort_by(|&p, &q| {
        let lower = |p: Units| (p.1, p.0) < (0, 0);
        lower(p).cmp(&lower(q)).then_with(|| twice_area((0, 0), q, p).cmp(&0))
    });
    ring.iter().map(|p| (middle.0 + p.0, middle.1 + p.1)).collect()
}

#[test]
fn stars_with_stars_in_them() {
    let mut rng = Rng::new(603);
    let mut cut = 0;
    for _ in 0..4_000 {
        let n = 3 + rng.index(30);
        let mut contours = vec![star(&mut rng, (2500, 2500), 3000, n)];
        for _ in 0..rng.index(6) {
            let (middle, n) = ((rng.int(800, 4200), rng.int(800, 4200)), 3 + rng.index(8));
            contours.push(star(&mut rng, middle, 500, n));
            if first_crossing(&contours).is_some() {
                contours.pop();
            }
        }
        rng.shuffle(&mut contours);
        cut += usize::from(check(&contours, Rect::new(-4, -4, 24, 24)));
    }
    assert!(cut > 2_000, "{cut} were cut");
}

/// A comb whose teeth reach into those of another; a spiral as a corridor; a saw with flat vertices.
#[test]
fn combs_and_spirals() {
    let mut rng = Rng::new(604);
    let comb = |n: i32, dx: i32, h: i32| -> Vec<Units> {
        let teeth = (0..n).flat_map(|i| [(2 * i * dx, h), ((2 * i + 1) * dx, 200)]);
        [(2 * n * dx, 0), (0, 0)].into_iter().chain(teeth).collect()
    };
    for n in 1..60 {
        let contour = comb(n, 100, rng.int(300, 4000));
        assert!(check(std::slice::from_ref(&contour), Rect::new(-1, -1, 50, 18)), "a comb of {n}");
        let (units, triangles) = triangulated(std::slice::from_ref(&contour)).expect("a comb");
        assert_eq!(triangles.len(), units.len() - 2, "a comb of {n}");
    }
    for n in 4..80_i32 {
        // Two walls, one step apart, round and round.
        let wall = |gap: i32| {
            (0..n).map(move |i| {
                let r = 60 * i + 300 + gap;
                [(r, 0), (0, r), (-r, 0), (0, -r)][i.unsigned_abs() as usize % 4]
            })
        };
        let contour: Vec<Units> = wall(0).chain(wall(100).rev()).collect();
        assert!(check(std::slice::from_ref(&contour), Rect::new(-20, -20, 20, 20)), "a spiral of {n}");
    }
    // Every side in four parts.
    for _ in 0..300 {
        let n = rng.range(3, 9) as usize;
        let corners = star(&mut rng, (600, 600), 300, n);
        let n = corners.len();
        let contour: Vec<Units> = (0..n)
            .flat_map(|i| {
                let (p, q) = (corners[i], corners[(i + 1) % n]);
                (0..4).map(move |k| (4 * p.0 + k * (q.0 - p.0), 4 * p.1 + k * (q.1 - p.1)))
            })
            .collect();
        check(&[contour], Rect::new(0, 0, 16, 16));
    }
}

/// Tours of random places, untangled: while two sides cross, the way between them is turned round.
#[test]
fn tours_of_random_places() {
    let mut rng = Rng::new(605);
    let mut cut = 0;
    for i in 0..600 {
        let n = 3 + rng.index(40);
        let mut contour: Vec<Units> = (0..n).map(|_| (rng.int(-500, 5000), rng.int(-500, 5000))).collect();
        if i % 3 == 0 {
            contour = contour.iter().map(|p| (p.0 & !255, p.1 & !255)).collect();
        }
        for _ in 0..3000 {
            let Some((first, second)) = first_crossing(std::slice::from_ref(&contour)) else { break };
            contour[first + 1..=second].reverse();
        }
        cut += usize::from(check(&[contour], Rect::new(-3, -3, 21, 21)));
    }
    assert!(cut > 550, "{cut} were cut");
}

/// Shapes of every scale up to the ends of the type.
#[test]
fn any_coordinates() {
    let mut rng = Rng::new(606);
    let mut cut = 0;
    for i in 0..50_000 {
        let n = rng.index(9);
        let all = outline(&mut rng, Scale::ALL[i % 4], n);
        let contours = if n > 5 { vec![all[..3].to_vec(), all[3..].to_vec()] } else { vec![all] };
        let window =
            if n == 0 { Rect::new(0, 0, 2, 2) } else { window_on(&mut rng, contours.last().expect("one or two")) };
        cut += usize::from(check(&contours, window));
    }
    assert!(cut > 15_000, "{cut} were cut");
}

#[test]
fn crossings_are_named() {
    let each = |units: &[Units], starts: &[u16]| {
        let mut nodes = vec![SideSlot::EMPTY; 50];
        triangulate::each(&vertices(units), starts, &mut nodes, |t| panic!("{t:?} was emitted"))
    };
    let bow_tie = [(0, 0), (9, 9), (9, 0), (0, 9)];
    assert_eq!(each(&bow_tie, &[]), Err(TriangulateError::SidesCross { first: 0, second: 2 }));
    let pentagram = [(0, -20), (12, 17), (-19, -6), (19, -6), (-12, 17)];
    assert_eq!(each(&pentagram, &[]), Err(TriangulateError::SidesCross { first: 0, second: 2 }));
    let hole_over_the_side = [(0, 0), (9, 0), (9, 9), (0, 9), (4, 4), (12, 4), (6, 6)];
    assert_eq!(each(&hole_over_the_side, &[4]), Err(TriangulateError::SidesCross { first: 1, second: 4 }));
    // At the ends of the type, by one unit.
    let (low, high) = (i32::MIN, i32::MAX);
    let thin = [(low, low), (high, high), (high - 1, low), (high, high - 1), (low, high)];
    let wanted = first_crossing(&[thin.to_vec()]).map(|(first, second)| TriangulateError::SidesCross { first, second });
    assert_eq!(each(&thin, &[]).err(), wanted);
    let text = TriangulateError::SidesCross { first: 3, second: 8 }.to_string();
    assert!(text.contains('3') && text.contains('8'), "{text}");
}

#[test]
fn scratch_of_every_size() {
    let mut rng = Rng::new(607);
    let (mut fitted, mut refused) = (0, 0);
    for _ in 0..5_000 {
        let contours: Vec<Vec<Units>> = (0..rng.range(1, 3))
            .map(|_| (0..rng.index(7)).map(|_| (rng.int(0, 4) * 256, rng.int(0, 4) * 256)).collect())
            .collect();
        if first_crossing(&contours).is_some() {
            continue;
        }
        let (units, starts) = flat(&contours);
        let (places, needed) = (vertices(&units), nodes(&contours));
        let mut wanted = vec![];
        triangulate::each(&places, &starts, &mut vec![SideSlot::EMPTY; needed], |t| wanted.push(t)).expect("enough");
        for capacity in 0..needed + 2 {
            let mut scratch = vec![SideSlot::EMPTY; capacity];
            let mut got = vec![];
            let result = triangulate::each(&places, &starts, &mut scratch, |t| got.push(t));
            if capacity < needed {
                // How often sides touch is found with a slot for every vertex, and two for every further contour.
                let least = units.len() + 2 * starts.len();
                let needed = if capacity < least { least } else { needed };
                assert_eq!(
                    (result, got.len()),
                    (Err(TriangulateError::SideTableFull { capacity, needed }), 0),
                    "{contours:?}"
                );
                refused += 1;
            } else {
                assert_eq!((result, &got), (Ok(()), &wanted), "{contours:?}");
                fitted += 1;
            }
        }
        for capacity in 0..needed.saturating_sub(2) {
            let (mut scratch, mut table) = (vec![SideSlot::EMPTY; needed], vec![[7; 3]; capacity]);
            let result = triangulate::list(&places, &starts, &mut scratch, &mut table);
            assert_eq!(
                result,
                Err(TriangulateError::TriangleTableFull { capacity, needed: needed - 2 }),
                "{contours:?}"
            );
            assert!(table.iter().all(|&t| t == [7; 3]), "something was written");
        }
        let mut triangles = wanted.clone();
        if let Some(less) = triangles.len().checked_sub(1) {
            let needed = triangles.len();
            let result = delaunay::refine(&places, &mut triangles, &mut vec![[0; 3]; less]);
            assert_eq!(result, Err(TriangulateError::TriangleTableFull { capacity: less, needed }));
            assert_eq!(triangles, wanted, "nothing changed");
        }
    }
    assert!(fitted > 1_000 && refused > 1_000, "{fitted} fitted, {refused} refused");
}

/// As many as there are, or the same errors as from a table of as many slots.
#[test]
fn vectors_hold_what_tables_hold() {
    let mut rng = Rng::new(609);
    let (mut full, mut refused) = (0, 0);
    for _ in 0..20_000 {
        let contours: Vec<Vec<Units>> = (0..rng.range(1, 3))
            .map(|_| (0..rng.index(8)).map(|_| (rng.int(0, 4) * 256, rng.int(0, 4) * 256)).collect())
            .collect();
        let (units, starts) = flat(&contours);
        let (places, mut slots, mut table) = (vertices(&units), [SideSlot::EMPTY; 20], [[0; 3]; 3]);
        let got = triangulate::to_vec::<3>(&places, &starts, &mut slots);
        let wanted = triangulate::list(&places, &starts, &mut slots, &mut table).map(|count| &table[..count]);
        assert_eq!(got.as_ref().map(|triangles| &triangles[..]), wanted.as_ref().copied(), "{contours:?}");
        full += usize::from(wanted.is_ok_and(|triangles| triangles.len() == 3));
        refused += usize::from(matches!(wanted, Err(TriangulateError::TriangleTableFull { .. })));
    }
    assert!(full > 100 && refused > 100, "{full} were full, {refused} refused");
}

/// Starts that do not ascend, or lie beyond the end, make empty contours.
#[test]
fn strange_starts() {
    let square = vertices(&[(0, 0), (900, 0), (900, 900), (0, 900)]);
    for starts in [&[0_u16][..], &[4], &[9], &[0, 0, 0], &[4, 1], &[65_535, 2]] {
        let mut nodes = vec![SideSlot::EMPTY; 20];
        let mut count = 0;
        triangulate::each(&square, starts, &mut nodes, |_| count += 1).expect("enough nodes");
        assert_eq!(count, 2, "{starts:?}");
    }
}

#[test]
fn predicates_are_exact_up_to_the_ends_of_the_type() {
    let mut rng = Rng::new(608);
    let mut ties = 0;
    let mut compare = |places: [Units; 4]| {
        let [a, b, c, d] = places;
        let [va, vb, vc, vd] = places.map(|(x, y)| PointFx::from_bits(x, y));
        assert_eq!(turn(va, vb, vc), twice_area(a, b, c).cmp(&0), "{places:?}");
        let wanted = determinant(a, b, c, d).cmp(&Wide::ZERO);
        assert_eq!(in_circle(va, vb, vc, vd), wanted, "{places:?}");
        ties += usize::from(wanted == Ordering::Equal);
    };
    for i in 0..100_000 {
        let places = outline(&mut rng, Scale::ALL[i % 4], 4);
        compare([places[0], places[1], places[2], places[3]]);
        // Corners of a rectangle lie on a circle, and one unit beside it they do not.
        let [(x0, y0), (x1, y1)] = [places[0], places[1]];
        let (dx, dy) = (rng.int(-1, 1), rng.int(-1, 1));
        compare([(x0, y0), (x1, y0), (x1, y1), (x0.saturating_add(dx), y1.saturating_add(dy))]);
    }
    let ends = [i32::MIN, i32::MIN + 1, -1, 0, 1, i32::MAX - 1, i32::MAX];
    for _ in 0..50_000 {
        compare([(); 4].map(|()| (rng.pick(&ends), rng.pick(&ends))));
    }
    assert!(ties > 2_500, "only {ties} ties");
}

fn map() -> Map {
    Map::parse(include_bytes!("../../assets/world-110m.txt")).expect("the map is well-formed")
}

/// The countries, as they come: a pixel is 0.64 degrees.
fn countries() -> Vec<(String, Vec<Vec<Units>>)> {
    let ring = |ring: &Vec<Place>| ring.iter().map(|p| (p.lon * 4, -p.lat * 4)).collect();
    map().countries.iter().map(|c| (c.name.clone(), c.rings.iter().map(ring).collect())).collect()
}

fn bounds(contours: &Contours) -> Rect {
    let all = || contours.iter().flatten();
    let range =
        |of: fn(&Units) -> i32| (all().map(of).min().unwrap_or(0) >> 8, (all().map(of).max().unwrap_or(0) >> 8) + 1);
    let ((x0, x1), (y0, y1)) = (range(|p| p.0), range(|p| p.1));
    Rect::new(x0, y0, x1, y1)
}

#[test]
fn countries_of_the_world() {
    for (name, rings) in countries() {
        let refused = !check(&rings, bounds(&rings));
        // In this map the border of Sudan crosses itself, where its first side and one of its last meet.
        let wanted = (name == "Sudan").then_some(TriangulateError::SidesCross { first: 0, second: 78 });
        assert_eq!((triangulated(&rings).err(), refused), (wanted, wanted.is_some()), "{name}");
    }
}

/// All countries at once: their inner borders cancel, what is left are the continents. Where the border of Sudan crosses
/// itself it crosses that of the Central African Republic too, once on each side of the corner with South Sudan.
#[test]
fn the_whole_world() {
    let all = countries().into_iter().filter(|(name, _)| !name.ends_with("Sudan"));
    let rings: Vec<Vec<Units>> = all.flat_map(|(_, rings)| rings).collect();
    let (units, starts) = flat(&rings);
    let places = vertices(&units);
    let mut scratch = vec![SideSlot::EMPTY; 12_000];
    let mut triangles = vec![];
    triangulate::each(&places, &starts, &mut scratch, |t| triangles.push(t)).expect("borders do not cross");
    check_mesh(&units, &triangles, &|| "the world".into());
    let window = bounds(&rings);
    let mut table = vec![EdgeSlot::EMPTY; places.len()];
    let wanted = collect(window, |emit| {
        let contours = rings.iter().map(|ring| vertices(ring)).collect::<Vec<_>>();
        polygon::fill(&contours, FillRule::EvenOdd, &mut table, window, emit).expect("a slot for every side");
    });
    for refined in [false, true] {
        if refined {
            let mut neighbours = vec![[0; 3]; triangles.len()];
            delaunay::refine(&places, &mut triangles, &mut neighbours).expect("a slot for each");
            check_delaunay(&units, &triangles, &|| "the world".into());
        }
        let mut hits = Hits::new(window);
        for &triangle in &triangles {
            hits.add(&collect(window, |emit| triangle::fill(corners(placed(&units, triangle)), window, emit)));
        }
        assert_eq!(hits.runs(), wanted, "refined: {refined}");
    }
}

/// Rounded to 1/256 pixel on small screens, sides touch that did not; but none comes to cross.
#[test]
fn countries_on_screens() {
    let map = map();
    let mut refused = vec![];
    for (projection, width, height) in
        [(Projection::Equirectangular, 320, 240), (Projection::Robinson, 1001, 777), (Projection::Miller, 160, 120)]
    {
        let world = World::new(&map, Screen { projection, width, height });
        for (country, of) in world.countries().iter().zip(&map.countries) {
            let rings: Vec<Vec<Units>> =
                country.iter().map(|ring| ring.iter().map(|v| (v.x.to_bits(), v.y.to_bits())).collect()).collect();
            if !check(&rings, bounds(&rings)) {
                refused.push((width, of.name.as_str()));
            }
        }
    }
    assert_eq!(refused, [320, 1001, 160].map(|width| (width, "Sudan")), "countries whose sides cross");
}

/// A table that is surely too small is refused before sides are compared: 2,000,000,000,000 pairs here, or 800,000,000.
#[test]
fn sizes_come_first() {
    let refused = |count: usize, starts: &[u16], capacity: usize| {
        let places: Vec<PointFx> = (0..).take(count).map(|i: i32| PointFx::from_bits(i, i % 7 * 1_000)).collect();
        triangulate::each(&places, starts, &mut vec![SideSlot::EMPTY; capacity], |_| panic!("a triangle"))
    };
    for (count, starts, capacity) in [(2_000_000, &[][..], 10), (40_000, &[], 39_999), (40_000, &[9, 99], 40_003)] {
        let needed = count + 2 * starts.len();
        assert_eq!(refused(count, starts, capacity), Err(TriangulateError::SideTableFull { capacity, needed }));
    }
    // Then what crosses.
    assert_eq!(refused(40_000, &[], 40_000), Err(TriangulateError::SidesCross { first: 6, second: 39_999 }));
}

/// Vertices on one straight line: nearly each lies on nearly every side. `src/geom/triangulate/sweep.rs` counts the work.
#[test]
fn a_zigzag_on_a_line_is_counted() {
    let zigzag = |n: i32| -> Vec<PointFx> {
        (0..n).map(|i| PointFx::from_bits(if i % 2 == 0 { i } else { 9_000 + i }, 0)).collect()
    };
    // By the rule: each vertex with each side.
    let needed = |places: &[PointFx]| {
        let n = places.len();
        let x = |i: usize| places[i % n].x.to_bits();
        let between = |i: usize, p: i32| x(i).min(x(i + 1)) < p && p < x(i).max(x(i + 1));
        n + (0..n).map(|i| (0..n).filter(|&v| between(i, x(v))).count()).sum::<usize>()
    };
    for n in [40, 6_000] {
        let places = zigzag(n);
        let mut slots = vec![SideSlot::EMPTY; places.len() + 1];
        let result = triangulate::each(&places, &[], &mut slots, |_| {});
        let capacity = slots.len();
        assert_eq!(result, Err(TriangulateError::SideTableFull { capacity, needed: needed(&places) }));
    }
}

/// Two sides that cross are named by the second one: it is the first one to cross any before it.
#[test]
fn of_many_crossings_one_is_named() {
    // The last of four lines crosses the first three; the third crosses the second.
    let lines = [(0, 0), (9, 0), (20, 3), (0, 9), (0, 4), (9, 9), (9, -9), (1, 20)];
    let starts = [2, 4, 6];
    let mut slots = vec![SideSlot::EMPTY; 50];
    let result = triangulate::each(&vertices(&lines), &starts, &mut slots, |t| panic!("{t:?} was emitted"));
    assert_eq!(result, Err(TriangulateError::SidesCross { first: 2, second: 4 }));
}
