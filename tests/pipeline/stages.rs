use embedded_graphics_core::{
    geometry::Point,
    pixelcolor::{Gray8, GrayColor, Rgb565, RgbColor},
};
use embedded_raster::{
    geom::space::Mat4,
    paint::depth,
    pipeline::{shade_vertices, Facing, IndexOutOfRange, Pipeline, TooManyVertices, Topology, Triangle, Vertex},
    pixel::{Depth16, Depth32, Id16},
    surface::DepthBuffer,
    Angle, Error, Framebuffer, PictureTooLarge, Rect, Surface, Vec3, Vec4,
};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

pub(crate) const WIDTH: i32 = 48;
pub(crate) const HEIGHT: i32 = 36;

/// A surface that counts how often each pixel is painted.
pub(crate) struct Hits(pub(crate) Vec<i32>, Rect);

impl Hits {
    pub(crate) fn new() -> Self {
        Self(vec![0; (WIDTH * HEIGHT) as usize], Rect::new(0, 0, WIDTH, HEIGHT))
    }

    pub(crate) fn add(&mut self, triangle: &Triangle<()>, by: i32) {
        struct Add<'a>(&'a mut Hits, i32);
        impl Surface for Add<'_> {
            type Color = Gray8;
            fn window(&self) -> Rect {
                self.0 .1
            }
            fn fill_span(&mut self, span: embedded_raster::ClippedSpan, _: Gray8) {
                for x in span.x0()..span.x1() {
                    self.0 .0[(span.y() * WIDTH + x) as usize] += self.1;
                }
            }
        }
        triangle.fill(&mut Add(self, by), |_| Some(Gray8::new(0)));
    }
}

pub(crate) fn pipeline() -> Pipeline {
    Pipeline::new(WIDTH as u16, HEIGHT as u16).unwrap()
}

pub(crate) fn plain(place: Vec4) -> Vertex<()> {
    Vertex::new(place, ())
}

/// The triangle of the textbook.
#[test]
fn a_blue_triangle() {
    let mut ram = [0; 64 * 64 * 2];
    let mut frame = Framebuffer::<Rgb565>::new(&mut ram, 64, 64).unwrap();
    let corners = [(-1, 0), (0, -1), (-1, -1)].map(|(x, y)| Vec4::whole(x, y, 0, 1));
    let count =
        Pipeline::new(64, 64).unwrap().triangles([corners], plain, |t| t.fill(&mut frame, |_| Some(Rgb565::BLUE)));
    assert_eq!(count, 1);
    let pixels = (0..64).flat_map(|y| (0..64).map(move |x| Point::new(x, y)));
    let blue = |at: Point| at.y >= 32 && at.x < at.y - 32;
    let mut sum = 0;
    for at in pixels {
        let color = if blue(at) { Rgb565::BLUE } else { Rgb565::BLACK };
        assert_eq!(frame.get(at), Some(color), "{at}");
        sum += u32::from(blue(at));
    }
    assert_eq!(sum, 496);
    // Its corners turn clockwise, as seen.
    for (side, count) in [(Facing::Front, 1), (Facing::Back, 0)] {
        assert_eq!(Pipeline::new(64, 64).unwrap().cull(side).triangles([corners], plain, |_| ()), count);
        assert_eq!(
            Pipeline::new(64, 64).unwrap().front_is_clockwise().cull(side).triangles([corners], plain, |_| ()),
            1 - count
        );
    }
}

/// Whether a triangle in clip coordinates has a place of NDC: by homogeneous edge functions, and its z and w there.
fn has(corners: [[f64; 4]; 3], x: f64, y: f64) -> Option<f64> {
    let cross = |a: [f64; 4], b: [f64; 4]| {
        // The determinant of a, b and the place (x, y, 1).
        (a[1] * b[3] - a[3] * b[1]) * x + (a[3] * b[0] - a[0] * b[3]) * y + (a[0] * b[1] - a[1] * b[0])
    };
    let [a, b, c] = corners;
    let weights = [cross(b, c), cross(c, a), cross(a, b)];
    let sum = |i: usize| weights[0] * a[i] + weights[1] * b[i] + weights[2] * c[i];
    // All weights have one sign, and w is positive there: the place is weights times corners over their w.
    let sign = if sum(3) < 0.0 { -1.0 } else { 1.0 };
    if weights.iter().any(|w| w * sign <= 0.0) {
        return None;
    }
    let depth = sum(2) / sum(3);
    (0.0..=1.0).contains(&depth).then_some(depth)
}

/// A corner in clip coordinates: anywhere, behind the eye, far outside, at the ends of the type.
pub(crate) fn corner(rng: &mut Rng) -> Vec4 {
    let scale = rng.pick(&[1 << 16, 1 << 18, 1 << 22, i32::MAX]);
    let w = rng.int(-scale / 4, scale);
    let part = |rng: &mut Rng| rng.int(-scale, scale);
    let [x, y, z] = [part(rng), part(rng), part(rng)];
    let near = |n: i32, w: i32, rng: &mut Rng| {
        if rng.one_in(3) {
            n
        } else {
            (i64::from(n) * i64::from(w) / i64::from(scale)) as i32
        }
    };
    Vec4::from_bits([near(x, w, rng), near(y, w, rng), near(z, w, rng).wrapping_abs(), w])
}

#[test]
fn clipped_triangles_cover_what_they_should() {
    let mut rng = Rng::new(1);
    let (mut inside, mut outside, mut cut) = (0, 0, 0);
    for _ in 0..cases(4_000) {
        let corners = [corner(&mut rng), corner(&mut rng), corner(&mut rng)];
        let mut hits = Hits::new();
        cut += u32::from(pipeline().triangles([corners], plain, |t| hits.add(t, 1)) > 1);
        let real = corners.map(|c| c.to_bits().map(f64::from));
        for (i, &count) in hits.0.iter().enumerate() {
            let (x, y) = ((i as i32 % WIDTH) as f64 + 0.5, (i as i32 / WIDTH) as f64 + 0.5);
            // A sixteenth of a pixel around the centre.
            let around = [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(|(dx, dy)| {
                let (x, y) = (x + dx / 16.0, y + dy / 16.0);
                has(real, 2.0 * x / f64::from(WIDTH) - 1.0, 1.0 - 2.0 * y / f64::from(HEIGHT)).is_some()
            });
            assert!((0..=1).contains(&count), "{corners:?}: painted {count} times");
            if around == [true; 4] {
                assert_eq!(count, 1, "{corners:?}: {x}, {y} is missing");
                inside += 1;
            }
            // A sliver may pass between the four places.
            let at = has(real, 2.0 * x / f64::from(WIDTH) - 1.0, 1.0 - 2.0 * y / f64::from(HEIGHT)).is_some();
            if around == [false; 4] && !at && count == 1 {
                outside += 1;
            }
        }
    }
    assert!(cut > 100 && inside > 10_000, "{cut} were cut, {inside} pixels inside");
    assert!(outside * 1_000 < inside, "{outside} pixels too many, {inside} inside");
}

/// A cube, or a body with more faces: corners and triangles that turn counter-clockwise as seen from outside.
pub(crate) fn body(rng: &mut Rng) -> (Vec<Vec3>, Vec<[usize; 3]>) {
    if rng.one_in(2) {
        let corners =
            (0..8).map(|i| Vec3::whole(i & 1, i >> 1 & 1, i >> 2) * I16F16::from_num(2) - Vec3::whole(1, 1, 1));
        let faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
        let triangles = faces.iter().flat_map(|&[a, b, c, d]| [[a, b, c], [a, c, d]]);
        return (corners.collect(), triangles.collect());
    }
    // An octahedron whose faces are halved: 32 triangles on a ball.
    let mut corners: Vec<[f64; 3]> =
        vec![[1.0, 0.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, -1.0, 0.0], [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]];
    let mut triangles = vec![];
    let faces = [[0, 2, 4], [2, 1, 4], [1, 3, 4], [3, 0, 4], [2, 0, 5], [1, 2, 5], [3, 1, 5], [0, 3, 5]];
    for [a, b, c] in faces {
        let mut middle = |a: usize, b: usize| {
            let sum: Vec<f64> = (0..3).map(|i| corners[a][i] + corners[b][i]).collect();
            let length = sum.iter().map(|n| n * n).sum::<f64>().sqrt();
            let at = [sum[0] / length, sum[1] / length, sum[2] / length];
            corners.iter().position(|&c| c == at).unwrap_or_else(|| {
                corners.push(at);
                corners.len() - 1
            })
        };
        let (d, e, f) = (middle(a, b), middle(b, c), middle(c, a));
        triangles.extend([[a, d, f], [d, b, e], [f, e, c], [d, e, f]]);
    }
    let fixed = |n: f64| (n * 65_536.0).round() as i32;
    (corners.iter().map(|c| Vec3::from_bits(c.map(fixed))).collect(), triangles)
}

/// From every angle a closed mesh covers each pixel as often by front faces as by back faces; without its back faces, a convex
/// one covers the pixels that it has exactly once.
#[test]
fn closed_meshes_are_closed_from_every_angle() {
    let (mut rng, mut seen) = (Rng::new(2), 0);
    for _ in 0..cases(1_500) {
        let (corners, triangles) = body(&mut rng);
        let angle = |rng: &mut Rng| Angle::from_bits(rng.bits() as u32);
        let turn = Mat4::rotate_x(angle(&mut rng)) * Mat4::rotate_y(angle(&mut rng)) * Mat4::rotate_z(angle(&mut rng));
        let [near, far] = [I16F16::from_num(0.25), I16F16::from_num(40)];
        let eye = Vec3::new(
            I16F16::from_bits(rng.int(-60_000, 60_000)),
            I16F16::from_bits(rng.int(-60_000, 60_000)),
            I16F16::from_num(5),
        );
        let camera = Mat4::perspective(Angle::degrees(rng.int(10, 80)), I16F16::from_num(1.3), near, far)
            * Mat4::look_at(eye, Vec3::ZERO, Vec3::Y)
            * turn;
        let mesh = || triangles.iter().map(|t| t.map(|i| camera.transform_point(corners[i])));
        let mut sum = Hits::new();
        pipeline().triangles(mesh(), plain, |t| sum.add(t, if t.facing() == Facing::Front { 1 } else { -1 }));
        assert!(sum.0.iter().all(|&n| n == 0), "fronts and backs differ");
        let (mut front, mut back) = (Hits::new(), Hits::new());
        pipeline().cull(Facing::Back).triangles(mesh(), plain, |t| front.add(t, 1));
        pipeline().cull(Facing::Front).triangles(mesh(), plain, |t| back.add(t, 1));
        assert!(front.0.iter().all(|&n| n == 0 || n == 1), "a pixel is covered twice");
        assert!(front.0 == back.0, "fronts cover what backs do not");
        seen += front.0.iter().sum::<i32>();
    }
    assert!(seen > 10_000, "{seen} pixels");
}

/// A floor under the eye, up to the horizon, in many triangles: no cracks and no holes where the near plane and the guard band cut
/// it.
#[test]
fn a_floor_that_is_cut_has_no_cracks() {
    let (mut rng, mut seen) = (Rng::new(3), 0);
    for _ in 0..cases(400) {
        let [near, far] = [I16F16::from_num(1), I16F16::from_num(2_000)];
        let eye = Vec3::new(
            I16F16::from_bits(rng.int(-900_000, 900_000)),
            I16F16::from_bits(rng.int(2_000, 300_000)),
            I16F16::ZERO,
        );
        let ahead = Vec3::whole(0, 0, -rng.int(5, 90) as i16);
        let camera = Mat4::perspective(Angle::degrees(rng.int(20, 100)), I16F16::from_num(1.3), near, far)
            * Mat4::look_at(eye, ahead, Vec3::Y);
        let step = rng.int(3, 900) as i16;
        let place = |i: i16, j: i16| camera.transform_point(Vec3::whole(i * step, 0, j * step));
        let squares = (-8..8).flat_map(|i| (-8..8).map(move |j| (i, j)));
        let mesh = squares.flat_map(|(i, j)| {
            let [a, b, c, d] = [place(i, j), place(i + 1, j), place(i + 1, j + 1), place(i, j + 1)];
            if (i + j) % 2 == 0 {
                [[a, b, c], [a, c, d]]
            } else {
                [[a, b, d], [b, c, d]]
            }
        });
        let mut hits = Hits::new();
        pipeline().triangles(mesh, plain, |t| hits.add(t, 1));
        assert!(hits.0.iter().all(|&n| n == 0 || n == 1), "a pixel is covered twice");
        // What is seen of a square is convex: each row is one run, and so is each column.
        for row in hits.0.chunks(WIDTH as usize) {
            let edges = row.windows(2).filter(|pair| pair[0] != pair[1]).count();
            assert!(edges <= 2, "a hole in {row:?}");
        }
        seen += hits.0.iter().sum::<i32>();
    }
    assert!(seen > 10_000, "{seen} pixels");
}

/// Draws the whole and bands of it: colours and depths are the same.
pub(crate) fn compare_bands(
    draw: impl Fn(&mut Framebuffer<'_, Gray8>, &mut DepthBuffer<'_, Depth16>),
    what: &dyn Fn() -> String,
) {
    let size = (WIDTH as u16, HEIGHT as u16);
    let (mut ram, mut depth_ram) = (vec![0; 48 * 36], vec![0; 48 * 36 * 2]);
    let mut frame = Framebuffer::<Gray8>::new(&mut ram, size.0, size.1).unwrap();
    let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, size.0, size.1).unwrap();
    draw(&mut frame, &mut buffer);
    for rows in [1, 5, 16] {
        for start in (0..size.1).step_by(rows.into()) {
            let band = start..(start + rows).min(size.1);
            let (mut ram, mut depth_ram) = (vec![0; 48 * 16], vec![0; 48 * 16 * 2]);
            let mut part = Framebuffer::<Gray8>::band(&mut ram, size.0, size.1, band.clone()).unwrap();
            let mut part_buffer = DepthBuffer::<Depth16>::band(&mut depth_ram, size.0, size.1, band.clone()).unwrap();
            draw(&mut part, &mut part_buffer);
            for at in band.flat_map(|y| (0..WIDTH).map(move |x| Point::new(x, y.into()))) {
                assert_eq!(part.get(at), frame.get(at), "{} at {at}", what());
                assert_eq!(part_buffer.get(at), buffer.get(at), "{} at {at}", what());
            }
        }
    }
}

/// Bands show what the whole shows, colours and depths alike.
#[test]
fn bands_show_the_whole() {
    let mut rng = Rng::new(4);
    for _ in 0..cases(200) {
        let mesh: Vec<[Vec4; 3]> = (0..6).map(|_| [corner(&mut rng), corner(&mut rng), corner(&mut rng)]).collect();
        let draw = |frame: &mut Framebuffer<'_, Gray8>, depth: &mut DepthBuffer<'_, Depth16>| {
            depth.clear(Depth16::MAX);
            let levels = |place: Vec4| Vertex::new(place, (place.x.to_bits() >> 8) as u8);
            pipeline().triangles(mesh.iter().copied(), levels, |triangle| {
                triangle.fill_depth(frame, depth, depth::less, |fragment| Some(Gray8::new(fragment.values)));
            });
        };
        compare_bands(draw, &|| format!("{mesh:?}"));
    }
}

/// What the fragment stage sees: the pixel, the values, the depth, the side and the number; and what it leaves out is left.
#[test]
fn fragments_have_what_they_should() {
    let (mut ram, mut depth_ram) = ([0; 48 * 36 * 2], [0xff; 48 * 36 * 4]);
    let mut ids = Framebuffer::<Id16>::new(&mut ram, 48, 36).unwrap();
    let mut buffer = DepthBuffer::<Depth32>::new(&mut depth_ram, 48, 36).unwrap();
    let square = |z: I16F16| {
        [(-1, -1), (1, -1), (-1, 1)]
            .map(|(x, y)| Vec3::new(I16F16::from_num(x), I16F16::from_num(y), z).with_w(I16F16::ONE))
    };
    let mut fragments = vec![];
    // The first one is left out by the near plane and counts all the same.
    let mesh = [square(I16F16::NEG_ONE), square(I16F16::from_num(0.25)), square(I16F16::from_num(0.5))];
    pipeline().triangles(
        mesh,
        |place| Vertex::new(place, 7_u8),
        |triangle| {
            triangle.fill_depth(&mut ids, &mut buffer, depth::less, |fragment| {
                fragments.push(fragment);
                (fragment.at.x % 2 == 0).then_some(Id16(fragment.number as u16))
            });
        },
    );
    for fragment in &fragments {
        assert_eq!((fragment.values, fragment.facing), (7, Facing::Front));
        let share = if fragment.number == 2 { 4 } else { 2 };
        assert_eq!(fragment.depth, ((u64::from(u32::MAX) * 2 + share) / (2 * share)) as u32);
        let id = if fragment.at.x % 2 == 0 { 2 } else { 0 };
        assert_eq!(ids.get(fragment.at), Some(Id16(id)), "{fragment:?}");
    }
    // Of the third triangle, only the columns that the second one left out are seen.
    assert!(fragments.iter().all(|f| f.number == 2 || f.number == 3 && f.at.x % 2 == 1));
    assert!(fragments.iter().any(|f| f.number == 3));
}

#[test]
fn indices_of_each_topology() {
    let vertices: Vec<Vec4> = [(-1, -1), (1, -1), (1, 1), (-1, 1)].map(|(x, y)| Vec4::whole(x, y, 0, 1)).to_vec();
    let count = |topology, indices: &[u16]| {
        let mut seen = vec![];
        pipeline()
            .indexed(topology, &vertices, indices, |&place| plain(place), |t| seen.push((t.number(), t.facing())))
            .map(|count| {
                assert_eq!(count as usize, seen.len());
                seen
            })
    };
    let fronts = |n: u32| (1..=n).map(|i| (i, Facing::Front)).collect::<Vec<_>>();
    assert_eq!(count(Topology::List, &[0, 1, 2, 0, 2, 3]), Ok(fronts(2)));
    assert_eq!(count(Topology::List, &[0, 1, 2, 0, 2]), Ok(fronts(1)));
    assert_eq!(count(Topology::Strip, &[0, 1, 3, 2]), Ok(fronts(2)));
    assert_eq!(count(Topology::Fan, &[0, 1, 2, 3]), Ok(fronts(2)));
    for topology in [Topology::List, Topology::Strip, Topology::Fan] {
        assert_eq!(count(topology, &[]), Ok(vec![]));
        assert_eq!(count(topology, &[0, 1]), Ok(vec![]));
        let error = IndexOutOfRange { at: 4, index: 4, vertices: 4 };
        assert_eq!(count(topology, &[0, 1, 2, 3, 4]), Err(error));
        assert_eq!(error.to_string(), "index out of range: number 4 is 4, there are 4 vertices");
    }
    let byte = pipeline().indexed(Topology::List, &vertices, &[0_u8, 1, 2], |&place| plain(place), |_| ());
    let word = pipeline().indexed(Topology::List, &vertices, &[0_u32, 1, 2], |&place| plain(place), |_| ());
    assert_eq!((byte, word), (Ok(1), Ok(1)));
    assert!(pipeline().indexed(Topology::List, &vertices, &[u32::MAX], |&place| plain(place), |_| ()).is_err());
}

/// Indexed triangles of vertices that were shaded once are those of vertices that are shaded for each corner.
#[test]
fn vertices_are_shaded_once() {
    let mut rng = Rng::new(6);
    for _ in 0..cases(300) {
        let vertices: Vec<Vec4> = (0..rng.int(1, 12)).map(|_| corner(&mut rng)).collect();
        let indices: Vec<u8> = (0..rng.int(0, 30)).map(|_| rng.index(vertices.len()) as u8).collect();
        let topology = rng.pick(&[Topology::List, Topology::Strip, Topology::Fan]);
        let stage = |&at: &Vec4| Vertex::new(at, at.x.to_bits());
        let seen =
            |triangle: &Triangle<i32>| (triangle.places(), *triangle.corners(), triangle.facing(), triangle.number());
        let (mut wanted, mut got, mut numbers) = (vec![], vec![], vec![]);
        pipeline().indexed(topology, &vertices, &indices, stage, |triangle| wanted.push(seen(triangle))).unwrap();
        // There may be more places than vertices.
        let mut places = vec![Vertex::default(); vertices.len() + rng.index(3)];
        let shaded = shade_vertices(&vertices, &mut places, |at, number| {
            numbers.push(number);
            stage(at)
        })
        .unwrap();
        pipeline().indexed(topology, shaded, &indices, |vertex| *vertex, |triangle| got.push(seen(triangle))).unwrap();
        assert!(numbers.iter().copied().eq(0..vertices.len()), "{numbers:?}");
        assert_eq!(got, wanted);
    }
    let mut runs = 0;
    let error = shade_vertices(&[(); 3], &mut [Vertex::new(Vec4::ZERO, ()); 2], |(), _| {
        runs += 1;
        Vertex::default()
    })
    .unwrap_err();
    assert_eq!((error, runs), (TooManyVertices { capacity: 2, needed: 3 }, 0));
    assert_eq!(error.to_string(), "too many vertices: 3 are shaded, there are places for 2");
}

#[test]
fn pictures_that_are_too_large() {
    assert!(Pipeline::new(4_096, 4_096).is_ok() && Pipeline::new(0, 0).is_ok());
    for (width, height) in [(4_097, 1), (1, 4_097), (u16::MAX, u16::MAX)] {
        assert_eq!(Pipeline::new(width, height), Err(PictureTooLarge { width, height, most: 4_096 }));
    }
    let error = Error::from(Pipeline::new(5_000, 7).unwrap_err());
    assert_eq!(error.to_string(), "picture too large: 5000 x 7 pixels, the pipeline draws 4096 each way");
}

/// Any bits anywhere: no panic, and no pixel outside.
#[test]
fn any_bits_are_fine() {
    let mut rng = Rng::new(5);
    let (mut ram, mut depth_ram) = ([0; 20 * 10], [0; 20 * 10 * 2]);
    for _ in 0..cases(40_000) {
        let mut bits = || {
            let any = rng.bits() as i32;
            rng.pick(&[0, 1, -1, i32::MIN, i32::MAX, any, any, any >> 12])
        };
        let mut place = || Vec4::from_bits([bits(), bits(), bits(), bits()]);
        let rows = [place(), place(), place(), place()];
        let mesh = [[place(), place(), place()]];
        let matrix = Mat4 { rows };
        let size = |n: u64| (n % 4_097) as u16;
        let pipeline = Pipeline::new(size(rng.bits()), size(rng.bits())).unwrap();
        let mut frame = Framebuffer::<Gray8>::new(&mut ram, 20, 10).unwrap();
        let mut buffer = DepthBuffer::<Depth16>::new(&mut depth_ram, 20, 10).unwrap();
        pipeline.triangles(
            mesh,
            |at| Vertex::new(matrix.transform(at), (at.x, 7_u8)),
            |triangle| {
                triangle.fill_depth(&mut frame, &mut buffer, depth::less_equal, |f| Some(Gray8::new(f.values.1)));
            },
        );
        assert!((0..10).all(|y| (0..20).all(|x| [0, 7].contains(&frame.get(Point::new(x, y)).unwrap().luma()))));
    }
}
