//! Lines and points through the pipeline: their pixels, values and depths against the rules, whole and in bands.

use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{BinaryColor, Gray8, GrayColor},
};
use embedded_raster::{
    geom::space::Mat4,
    paint::depth,
    pipeline::{assemble_lines, Dot, Facing, IndexOutOfRange, LineTopology, Pipeline, Vertex},
    pixel::{Depth16, Depth32},
    surface::DepthBuffer,
    Angle, Canvas, Framebuffer, PointFx, Rect, Vec3, Vec4,
};
use fixed::types::{I16F16, I24F8};
use twins::{
    clipping,
    hits::Hits,
    lines,
    rng::{cases, Rng},
};

use crate::stages::{body, compare_bands, corner, pipeline, HEIGHT, WIDTH};

const SIZE: (u16, u16) = (WIDTH as u16, HEIGHT as u16);

/// The nearest number to `most z / w`.
fn depth_of(at: Vec4, most: u32) -> i64 {
    let [_, _, z, w] = at.to_bits().map(i128::from);
    (2 * i128::from(most) * z + w).div_euclid(2 * w) as i64
}

fn units(place: PointFx) -> (i32, i32) {
    (place.x.to_bits(), place.y.to_bits())
}

/// Where something is, to the nearest 1/256 pixel.
fn place_of(at: Vec4) -> (i32, i32) {
    place_between([1], [at])
}

/// Where the mean of some positions is, which has not been rounded before.
fn place_between<const N: usize>(weights: [i128; N], positions: [Vec4; N]) -> (i32, i32) {
    let sum = |i: usize| (0..N).map(|k| weights[k] * i128::from(positions[k].to_bits()[i])).sum::<i128>();
    let (x, y, w) = (sum(0), -sum(1), sum(3));
    let nearest = |n: i128, size: i32| {
        let half = i128::from(size) * 128;
        ((2 * n * half + w).div_euclid(2 * w) + half) as i32
    };
    (nearest(x, WIDTH), nearest(y, HEIGHT))
}

/// Each pixel of a line has the value and the depth that the rule gives it. Of one that planes cut, depths are those of ends with
/// 29 bits.
#[test]
fn lines_are_those_of_the_rules() {
    let (mut rng, mut seen, mut cut) = (Rng::new(21), 0, 0);
    let window = Rect::new(0, 0, WIDTH, HEIGHT);
    let (mut ram, mut depth_ram) = (vec![0; 48 * 36], vec![0; 48 * 36 * 4]);
    for _ in 0..cases(20_000) {
        let ends = [(); 2].map(|()| Vertex::new(corner(&mut rng), (rng.bits() as u8, rng.bits() as i32)));
        let positions = ends.map(|end| end.position);
        let mut frame = Framebuffer::<Gray8>::new(&mut ram, SIZE.0, SIZE.1).unwrap();
        let mut buffer = DepthBuffer::<Depth32>::new(&mut depth_ram, SIZE.0, SIZE.1).unwrap();
        pipeline().lines(
            [ends],
            |vertex| vertex,
            |line| {
                let [a, b] = line.places().map(units);
                let [first, last] = *line.ends();
                let is_whole = [first, last] == ends;
                let left = clipping::line(positions.map(Vec4::to_bits), SIZE).expect("something is left");
                // Rounded from a number that is at most 2^-29 of itself away from the exact one.
                for ((x, y), weights) in [a, b].into_iter().zip(left) {
                    let (p, q) = place_between(weights, positions);
                    let off = x.abs_diff(p).max(y.abs_diff(q));
                    assert!(off <= u32::from(!is_whole), "{ends:?}: {x}, {y}, not {p}, {q}");
                    cut += off;
                }
                let depths = left.map(|weights| {
                    let sum =
                        |i: usize| (0..2).map(|k| weights[k] * i128::from(positions[k].to_bits()[i])).sum::<i128>();
                    let (z, w) = (sum(2), sum(3));
                    ((2 * i128::from(u32::MAX) * z + w).div_euclid(2 * w)) as i64
                });
                let mut wanted: Vec<_> = lines::line_fx(a, b, window)
                    .into_iter()
                    .map(|pixel| {
                        let number = |values: [i64; 2]| lines::nearest_along(a, b, values, pixel);
                        let values = [
                            number([first, last].map(|end| end.values.0.into())),
                            number([first, last].map(|end| end.values.1.into())),
                        ];
                        (pixel.1, pixel.0, values, number(depths))
                    })
                    .collect();
                wanted.sort_unstable();
                let (mut plain, mut deep) = (vec![], vec![]);
                line.draw(&mut frame, |fragment| {
                    assert_eq!((fragment.facing, fragment.number), (Facing::Front, 1));
                    let values = [fragment.values.0.into(), fragment.values.1.into()];
                    plain.push((fragment.at.y, fragment.at.x, values));
                    None
                });
                line.draw_depth(&mut frame, &mut buffer, depth::always, |fragment| {
                    let values = [fragment.values.0.into(), fragment.values.1.into()];
                    deep.push((fragment.at.y, fragment.at.x, values, i128::from(fragment.depth)));
                    Some(Gray8::new(7))
                });
                plain.sort_unstable();
                deep.sort_unstable();
                seen += wanted.len();
                if is_whole {
                    assert_eq!(deep, wanted, "{ends:?}");
                }
                let far = deep.iter().zip(&wanted).map(|(got, wanted)| (got.3 - wanted.3).abs()).max().unwrap_or(0);
                assert!(far <= 16, "{ends:?}: depths are {far} off");
                let without = |all: Vec<(i32, i32, [i128; 2], i128)>| -> Vec<_> {
                    all.into_iter().map(|(y, x, values, _)| (y, x, values)).collect()
                };
                assert_eq!(without(deep), plain);
                assert_eq!(without(wanted), plain);
            },
        );
    }
    assert!(seen > cases(20_000) && cut as usize <= cases(10).max(5), "{seen} pixels, {cut} places one off");
}

/// Bands show what the whole shows: lines and points, colours and depths alike.
#[test]
fn bands_show_the_whole() {
    let mut rng = Rng::new(22);
    for _ in 0..cases(300) {
        let lines: Vec<[Vec4; 2]> = (0..9).map(|_| [corner(&mut rng), corner(&mut rng)]).collect();
        let points: Vec<Vec4> = (0..9).map(|_| corner(&mut rng)).collect();
        let size = I24F8::from_bits(rng.int(0, 6_000));
        let draw = |frame: &mut Framebuffer<'_, Gray8>, depth: &mut DepthBuffer<'_, Depth16>| {
            depth.clear(Depth16::MAX);
            let levels = |place: Vec4| Vertex::new(place, (place.x.to_bits() >> 8) as u8);
            pipeline().lines(lines.iter().copied(), levels, |line| {
                line.draw_depth(frame, depth, depth::less, |fragment| Some(Gray8::new(fragment.values)));
            });
            pipeline().points(points.iter().copied(), levels, |point| {
                let dot = if point.number() % 2 == 0 { Dot::Round(size) } else { Dot::Square(size) };
                point.draw_depth(dot, frame, depth, depth::less, |fragment| Some(Gray8::new(fragment.values)));
            });
        };
        compare_bands(draw, &|| format!("{lines:?} {points:?}"));
    }
}

/// A point has the pixels of the square or the round point around its place, those that pass its depth.
#[test]
fn points_are_those_of_the_canvas() {
    let (mut rng, mut seen) = (Rng::new(23), 0);
    for _ in 0..cases(20_000) {
        let vertex = Vertex::new(corner(&mut rng), rng.bits() as u8);
        let any = rng.int(-300, 30_000);
        let size = I24F8::from_bits(rng.pick(&[0, 1, 255, 256, 257, 512, any, any, i32::MIN, i32::MAX]));
        pipeline().points(
            [vertex],
            |vertex| vertex,
            |point| {
                assert_eq!(units(point.place()), place_of(vertex.position));
                assert_eq!((point.number(), *point.vertex()), (1, vertex));
                for dot in [Dot::Square(size), Dot::Round(size)] {
                    let mut wanted = Hits::new(Rect::new(0, 0, WIDTH, HEIGHT));
                    match dot {
                        Dot::Square(size) => wanted.fill_square_point_fx(point.place(), size, BinaryColor::On),
                        Dot::Round(size) => wanted.fill_round_point_fx(point.place(), size, BinaryColor::On),
                    }
                    let (mut ram, mut depth_ram) = (vec![0; 48 * 36], vec![0; 48 * 36 * 2]);
                    let mut frame = Framebuffer::<Gray8>::new(&mut ram, SIZE.0, SIZE.1).unwrap();
                    let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, SIZE.0, SIZE.1).unwrap();
                    let depth = depth_of(vertex.position, 0xffff) as u16;
                    // Left of the middle, the buffer is as near as the point.
                    buffer.clear(Depth16::MAX);
                    buffer.fill_rectangle(Rect::new(0, 0, WIDTH / 2, HEIGHT), Depth16(depth));
                    let mut all = 0;
                    point.draw(dot, &mut frame, |fragment| {
                        assert_eq!((fragment.values, fragment.number), (vertex.values, 1));
                        all += wanted.count(fragment.at.x, fragment.at.y);
                        None
                    });
                    assert_eq!(all as i32, wanted.runs().iter().map(|run| run.2 - run.1).sum::<i32>());
                    point.draw_depth(dot, &mut frame, &mut buffer, depth::less, |fragment| {
                        assert_eq!(fragment.depth, depth);
                        (fragment.at.y % 3 > 0).then_some(Gray8::new(1))
                    });
                    for at in (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| Point::new(x, y))) {
                        let is_painted =
                            wanted.count(at.x, at.y) == 1 && at.x >= WIDTH / 2 && at.y % 3 > 0 && depth < 0xffff;
                        assert_eq!(frame.get(at).unwrap().luma(), u8::from(is_painted), "{vertex:?} {dot:?} at {at}");
                        let kept = if is_painted || at.x < WIDTH / 2 { Depth16(depth) } else { Depth16::MAX };
                        assert_eq!(buffer.get(at), Some(kept));
                        seen += u32::from(is_painted);
                    }
                }
            },
        );
    }
    assert!(seen as usize > cases(20_000), "{seen} pixels");
}

/// Points are left out by the near plane, the far plane and the guard band, and nothing else; they keep their numbers.
#[test]
fn points_that_are_left_out() {
    let at = |x: i16, y: i16, z: i16, w: i16| Vec4::whole(x, y, z, w);
    let points = [
        at(0, 0, 0, 1),
        at(0, 0, 1, 1),
        at(0, 0, -1, 1),
        at(0, 0, 2, 1),
        at(0, 0, 0, 0),
        at(9, -9, 0, 1),
        at(300, 0, 0, 1),
    ];
    let mut numbers = vec![];
    let count = pipeline().points(points, |at| Vertex::new(at, ()), |point| numbers.push(point.number()));
    assert_eq!((count, numbers), (3, vec![1, 2, 6]));
}

/// Whole pixels give Bresenham's line: clip coordinates that fall on centres of pixels.
#[test]
fn between_centres_of_pixels_it_is_the_line_of_the_canvas() {
    let mut rng = Rng::new(24);
    for _ in 0..cases(5_000) {
        let ends = [(); 2].map(|()| Point::new(rng.int(-20, 80), rng.int(-20, 80)));
        // In a picture of 64 x 64 pixels, NDC of pixel centres are whole multiples of 1 / 64.
        let vertices = ends.map(|at| Vec4::from_bits([(2 * at.x - 63) << 10, (63 - 2 * at.y) << 10, 0, 1 << 16]));
        let (mut got, mut wanted) = (Hits::new(Rect::new(0, 0, 64, 64)), Hits::new(Rect::new(0, 0, 64, 64)));
        Pipeline::new(64, 64).unwrap().lines(
            [vertices],
            |at| Vertex::new(at, ()),
            |line| {
                assert_eq!(line.places(), ends.map(PointFx::from));
                line.draw(&mut got, |_| Some(BinaryColor::On));
            },
        );
        wanted.draw_line(ends[0], ends[1], BinaryColor::On);
        assert_eq!(got.runs(), wanted.runs(), "{ends:?}");
    }
}

#[test]
fn indices_of_each_kind_of_lines() {
    let names = ["a", "b", "c"];
    let lines = |topology, indices: &[u16]| {
        assemble_lines(topology, &names, indices).map(|lines| lines.map(|[a, b]| format!("{a}{b}")).collect::<Vec<_>>())
    };
    let found = |text: &str| Ok(text.split_whitespace().map(str::to_owned).collect::<Vec<_>>());
    assert_eq!(lines(LineTopology::List, &[0, 1, 2, 0, 1]), found("ab ca"));
    assert_eq!(lines(LineTopology::Strip, &[0, 1, 2, 0]), found("ab bc ca"));
    assert_eq!(lines(LineTopology::Loop, &[0, 1, 2]), found("ab bc ca"));
    assert_eq!(lines(LineTopology::Loop, &[0, 1]), found("ab"));
    for topology in [LineTopology::List, LineTopology::Strip, LineTopology::Loop] {
        assert_eq!(lines(topology, &[]), found(""));
        assert_eq!(lines(topology, &[2]), found(""));
        assert_eq!(lines(topology, &[0, 3]), Err(IndexOutOfRange { at: 1, index: 3, vertices: 3 }));
    }
}

/// A convex body in lines: the edges of its fronts are seen, and no others.
#[test]
fn hidden_lines_are_hidden() {
    let mut rng = Rng::new(25);
    let (mut seen, mut lost, mut hidden, mut wrong) = (0, 0, 0, 0);
    // As many as the shares below are of, whatever part of the cases is taken.
    for _ in 0..400 {
        let (corners, triangles) = body(&mut rng);
        let mut angle = || Angle::from_bits(rng.bits() as u32);
        let turn = Mat4::rotate_x(angle()) * Mat4::rotate_y(angle()) * Mat4::rotate_z(angle());
        let [near, far] = [I16F16::from_num(1), I16F16::from_num(40)];
        let eye = Vec3::new(I16F16::ZERO, I16F16::ZERO, I16F16::from_num(5));
        let camera = Mat4::perspective(Angle::degrees(40), I16F16::from_num(1.3), near, far)
            * Mat4::look_at(eye, Vec3::ZERO, Vec3::Y)
            * turn;
        let places: Vec<Vec4> = corners.iter().map(|&corner| camera.transform_point(corner)).collect();
        let (mut ram, mut depth_ram) = (vec![0; 160 * 120], vec![0; 160 * 120 * 2]);
        let mut frame = Framebuffer::<Gray8>::new(&mut ram, 160, 120).unwrap();
        let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 160, 120).unwrap();
        buffer.clear(Depth16::MAX);
        let pipeline = Pipeline::new(160, 120).unwrap();
        let vertex = |i: usize| Vertex::new(places[i], ());
        let mut fronts = vec![false; triangles.len()];
        pipeline.triangles(triangles.iter().copied(), vertex, |triangle| {
            fronts[triangle.number() as usize - 1] = triangle.facing() == Facing::Front;
            let number = Gray8::new(triangle.number() as u8);
            triangle.fill_behind(&mut frame, &mut buffer, depth::less_equal, |_| Some(number));
        });
        for (number, triangle) in triangles.iter().enumerate() {
            for (i, j) in [(0, 1), (1, 2), (2, 0)] {
                let edge = [triangle[i], triangle[j]];
                let has = |t: &[usize; 3]| (0..3).any(|k| [t[(k + 1) % 3], t[k]] == edge);
                let other = triangles.iter().position(has).expect("it is closed");
                let (mut passed, mut all) = (vec![], vec![]);
                pipeline.lines([edge], vertex, |line| {
                    line.draw(&mut frame, |fragment| {
                        all.push(fragment.at);
                        None
                    });
                    line.draw_depth(&mut frame, &mut buffer, depth::less_equal, |fragment| {
                        passed.push(fragment.at);
                        None
                    });
                });
                if fronts[number] || fronts[other] {
                    seen += all.len();
                    for at in all.iter().filter(|at| !passed.contains(at)) {
                        lost += 1;
                        // Triangles never hide their own sides.
                        let over = usize::from(frame.get(*at).expect("on the screen").luma());
                        assert!(over != number + 1 && over != other + 1, "{at} of {edge:?} is hidden by {over}");
                    }
                } else {
                    (hidden, wrong) = (hidden + all.len(), wrong + passed.len());
                }
            }
        }
    }
    assert!(seen > 10_000 && hidden > 10_000, "{seen} pixels are seen, {hidden} hidden");
    // Beside a corner, a pixel of a line may belong to a triangle that the line is no side of.
    assert!(lost * 100 < seen, "{lost} of {seen} pixels are lost");
    // Triangles seen nearly edge-on, along the outline, are set back far.
    assert!(wrong * 25 < hidden, "{wrong} of {hidden} hidden pixels are seen");
}

/// Any bits anywhere: no panic, and no pixel outside.
#[test]
fn any_bits_are_fine() {
    let mut rng = Rng::new(26);
    let (mut ram, mut depth_ram) = ([0; 20 * 10], [0; 20 * 10 * 2]);
    for _ in 0..cases(40_000) {
        let mut bits = || {
            let any = rng.bits() as i32;
            rng.pick(&[0, 1, -1, i32::MIN, i32::MAX, any, any, any >> 12])
        };
        let mut place = || Vec4::from_bits([bits(), bits(), bits(), bits()]);
        let ends = [place(), place()];
        let size = |n: u64| (n % 4_097) as u16;
        let pipeline = Pipeline::new(size(rng.bits()), size(rng.bits())).unwrap();
        let mut frame = Framebuffer::<Gray8>::new(&mut ram, 20, 10).unwrap();
        let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 20, 10).unwrap();
        let dot = I24F8::from_bits(rng.bits() as i32);
        pipeline.lines(
            [ends],
            |at| Vertex::new(at, (at.x, 7_u8)),
            |line| {
                line.draw(&mut frame, |f| Some(Gray8::new(f.values.1)));
                line.draw_depth(&mut frame, &mut buffer, depth::less_equal, |f| Some(Gray8::new(f.values.1)));
            },
        );
        pipeline.points(
            ends,
            |at| Vertex::new(at, (at.x, 7_u8)),
            |point| {
                point.draw_depth(Dot::Round(dot), &mut frame, &mut buffer, depth::less_equal, |f| {
                    Some(Gray8::new(f.values.1))
                });
            },
        );
        assert!((0..10).all(|y| (0..20).all(|x| [0, 7].contains(&frame.get(Point::new(x, y)).unwrap().luma()))));
    }
}
