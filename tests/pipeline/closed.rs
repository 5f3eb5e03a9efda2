//! Laws of closed meshes: seen from anywhere, through any lens, cut by the near plane, from inside.

use embedded_graphics_core::pixelcolor::Gray8;
use embedded_raster::{
    geom::space::Mat4,
    pipeline::{Facing, Pipeline},
    Angle, Vec3, Vec4,
};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

use crate::stages::{body, pipeline, plain, Hits, HEIGHT, WIDTH};

fn angle(rng: &mut Rng) -> Angle {
    Angle::from_bits(rng.bits() as u32)
}

fn turned(rng: &mut Rng) -> Mat4 {
    Mat4::rotate_x(angle(rng)) * Mat4::rotate_y(angle(rng)) * Mat4::rotate_z(angle(rng))
}

fn number(n: f64) -> I16F16 {
    I16F16::from_num(n)
}

/// A place in a box around (0, 0, 0).
fn place(rng: &mut Rng, reach: f64) -> Vec3 {
    let most = number(reach).to_bits();
    Vec3::from_bits([(); 3].map(|()| rng.int(-most, most)))
}

/// A ring with a hole, whose faces turn counter-clockwise as seen from outside.
fn ring(rng: &mut Rng) -> (Vec<Vec3>, Vec<[usize; 3]>) {
    let (around, across) = (rng.index(9) + 3, rng.index(7) + 3);
    let thick = 0.1 + 0.8 * rng.unit();
    let mut corners = vec![];
    for (i, j) in (0..around).flat_map(|i| (0..across).map(move |j| (i, j))) {
        let part = |i: usize, of: usize| i as f64 / of as f64 * std::f64::consts::TAU;
        let ((s, c), (t, d)) = (part(i, around).sin_cos(), part(j, across).sin_cos());
        let far = 1.0 + thick * d;
        corners.push(Vec3::new(number(c * far), number(s * far), number(thick * t)));
    }
    let at = |i: usize, j: usize| i % around * across + j % across;
    let squares = (0..around).flat_map(|i| (0..across).map(move |j| (i, j)));
    let triangles = squares.flat_map(|(i, j)| {
        let [a, b, c, d] = [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
        if (i + j) % 3 == 0 {
            [[a, b, c], [a, c, d]]
        } else {
            [[a, b, d], [b, c, d]]
        }
    });
    (corners, triangles.collect())
}

/// Fronts less backs of each pixel, and both together.
fn seen(mesh: impl Iterator<Item = [Vec4; 3]>) -> (Hits, Hits) {
    let (mut fronts, mut backs) = (Hits::new(), Hits::new());
    pipeline().triangles(mesh, plain, |t| if t.facing() == Facing::Front { &mut fronts } else { &mut backs }.add(t, 1));
    (fronts, backs)
}

/// Each pixel has as many fronts as backs, whatever the mesh: through lenses so long that the guard band cuts most of it, too.
#[test]
fn fronts_and_backs_are_as_many() {
    let (mut rng, mut pixels, mut cut) = (Rng::new(31), 0_i64, 0);
    for _ in 0..cases(6_000) {
        let (corners, triangles) = if rng.one_in(3) { body(&mut rng) } else { ring(&mut rng) };
        let away = rng.pick(&[4.0, 7.0, 30.0]);
        // From a lens that sees everything to one that sees a thousandth of it.
        let lens = 1.3 / rng.pick(&[1.0, 4.0, 60.0, 1_000.0]);
        let half = number(lens / away).max(I16F16::from_bits(1));
        let lens = Mat4::frustum([-half, half], [-half, half], I16F16::ONE, number(100.0));
        let eye = place(&mut rng, away / 4.0) + Vec3::new(I16F16::ZERO, I16F16::ZERO, number(away));
        let camera = lens * Mat4::look_at(eye, place(&mut rng, 1.0), Vec3::Y) * turned(&mut rng);
        let places: Vec<Vec4> = corners.iter().map(|&corner| camera.transform_point(corner)).collect();
        cut += u32::from(places.iter().any(|at| {
            let [x, _, _, w] = at.to_bits().map(i64::from);
            x.abs() * i64::from(WIDTH) > 6_140 * w
        }));
        let (fronts, backs) = seen(triangles.iter().map(|t| t.map(|i| places[i])));
        assert!(fronts.0 == backs.0, "{eye:?} {triangles:?} {places:?}");
        pixels += i64::from(fronts.0.iter().sum::<i32>());
    }
    assert!(pixels > cases(6_000) as i64 * 20 && cut as usize > cases(6_000) / 20, "{pixels} pixels, {cut} were cut");
}

/// From inside of a convex body, all around is back, and each pixel is covered exactly once: the near plane cuts nothing off that is
/// seen, and there are no cracks where it and the guard band cut.
#[test]
fn from_inside_each_pixel_is_covered_once() {
    let mut rng = Rng::new(32);
    for _ in 0..cases(6_000) {
        let (corners, triangles) = body(&mut rng);
        // The near plane, with its corners, lies within the body: its ball has a radius of at least 0.8.
        let near = rng.pick(&[0.001, 0.01, 0.1]);
        let lens = Mat4::perspective(Angle::degrees(rng.int(5, 120)), number(1.3), number(near), number(40.0));
        let eye = place(&mut rng, 0.3);
        let target = eye + place(&mut rng, 1.0);
        let camera =
            lens * Mat4::look_at(eye, target, Vec3::new(number(0.1), number(1.0), number(0.2))) * turned(&mut rng);
        if (target - eye).length() < number(0.05) {
            continue;
        }
        let scale = Mat4::scale(Vec3::new(number(3.0), number(3.0), number(3.0)));
        let camera = camera * scale;
        let (fronts, backs) = seen(triangles.iter().map(|t| t.map(|i| camera.transform_point(corners[i]))));
        assert!(fronts.0.iter().all(|&n| n == 0), "{eye:?} {target:?}: a front is seen from inside");
        assert!(backs.0.iter().all(|&n| n == 1), "{eye:?} {target:?}: {:?}", backs.0);
    }
}

/// The near plane cuts a convex body: a pixel may see a back without a front, where the cut is, but no front without a back, and
/// nothing twice. What is seen has no holes: each row is one run, and so is each column.
#[test]
fn a_cut_body_has_no_holes() {
    let (mut rng, mut open, mut whole) = (Rng::new(33), 0, 0);
    for _ in 0..cases(6_000) {
        let (corners, triangles) = body(&mut rng);
        let away = 0.6 + 1.2 * rng.unit();
        let near = rng.pick(&[0.05, 0.3, 0.9]);
        let lens = Mat4::perspective(Angle::degrees(rng.int(20, 110)), number(1.3), number(near), number(40.0));
        let eye = Vec3::new(I16F16::ZERO, I16F16::ZERO, number(away)) + place(&mut rng, 0.2);
        let camera = lens * Mat4::look_at(eye, place(&mut rng, 0.5), Vec3::Y) * turned(&mut rng);
        let (fronts, backs) = seen(triangles.iter().map(|t| t.map(|i| camera.transform_point(corners[i]))));
        for (&front, &back) in fronts.0.iter().zip(&backs.0) {
            assert!(front <= back && back <= 1, "{eye:?}: {front} fronts, {back} backs");
            open += i32::from(front < back);
            whole += front;
        }
        let one_run = |pixels: &mut dyn Iterator<Item = i32>| {
            let all: Vec<i32> = pixels.collect();
            all.windows(2).filter(|pair| pair[0] < pair[1]).count() + usize::from(all[0] == 1) <= 1
        };
        let (width, height) = (WIDTH as usize, HEIGHT as usize);
        assert!(
            (0..height).all(|y| one_run(&mut (0..width).map(|x| backs.0[y * width + x]))),
            "{eye:?}: a hole in a row"
        );
        assert!(
            (0..width).all(|x| one_run(&mut (0..height).map(|y| backs.0[y * width + x]))),
            "{eye:?}: a hole in a column"
        );
    }
    assert!(open > 10_000 && whole > 10_000, "{open} pixels in the cut, {whole} beside it");
}

/// A screen in two halves: two triangles with one side, which planes cut in any way, cover together what each covers alone, once.
#[test]
fn neighbours_share_what_is_cut() {
    let (mut rng, mut both) = (Rng::new(34), 0);
    for _ in 0..cases(20_000) {
        let corners = [(); 4].map(|()| crate::stages::corner(&mut rng));
        let [a, b, c, d] = corners;
        let mut hits = [Hits::new(), Hits::new(), Hits::new()];
        for (i, triangle) in [[a, b, c], [d, b, a]].into_iter().enumerate() {
            pipeline().triangles([triangle], plain, |t| {
                hits[i].add(t, 1);
                hits[2].add(t, 1);
            });
        }
        let is_single = |hits: &Hits| hits.0.iter().all(|&n| n <= 1);
        assert!(is_single(&hits[0]) && is_single(&hits[1]), "{corners:?}");
        // Before the eye, c and d lie on either side of the side from a to b if both triangles turn the same way.
        let is_before = corners.iter().all(|at| at.w > 0);
        if is_before && turn([a, b, c]) * turn([d, b, a]) > 0 {
            assert!(is_single(&hits[2]), "{corners:?}: a pixel is covered twice");
            both += i32::from(hits[0].0.contains(&1) && hits[1].0.contains(&1));
        }
    }
    assert!(both as usize > cases(20_000) / 100, "{both} pairs");
}

/// Corners of a needle: the third one close to the line through the others, between them or beyond.
fn needle(rng: &mut Rng) -> [Vec4; 3] {
    let [a, b] = [(); 2].map(|()| crate::stages::corner(rng).to_bits());
    let whole = rng.pick(&[256, 65_536, 1 << 20, 1 << 24]);
    let part = i64::from(rng.int(-2 * whole, 3 * whole));
    let wide = rng.pick(&[0, 1, 3, 20, 300, 5_000]);
    let c = core::array::from_fn(|i| {
        let (a, b) = (i64::from(a[i]), i64::from(b[i]));
        let on_line = a + (b - a) * part / i64::from(whole);
        (on_line + i64::from(rng.int(-wide, wide))).clamp(i32::MIN.into(), i32::MAX.into()) as i32
    });
    [a, b, c].map(Vec4::from_bits)
}

/// What is left of a needle is thinner than a place is rounded: its sides may cross, and still a pixel is painted once.
#[test]
fn needles_that_are_cut_are_painted_once() {
    let mut rng = Rng::new(36);
    let picked = [
        // Two sides cross, and the fan from the first one of four corners folds over a pixel.
        [
            [1_879_231, 311_609, 3_224_090, 3_257_918],
            [-12_023, 9_280, 212_421, 34_052],
            [-1_839_194_108, 376_119_246, 346_008_660, 673_747_395],
        ],
        [[7_103, 36_184, 6_020, 22_749], [-82_790, -1_830_595, 1_687_318, 1_883_452], [31, 23, 45_012, 55]],
        [[43_624, 49_305, 91_873, 103_483], [2_299, -2_422, 39_068, -5_427], [-49_938, 90_176, 55_573, 197_460]],
        // One of five corners.
        [
            [3_797_592, -207_440, 3_227_860, -267_626],
            [-1_058_653, -1_544_831, 195_241, 2_058_192],
            [-3_820_551, -2_305_146, -1_529_221, 3_380_922],
        ],
    ];
    let random = (0..cases(60_000)).map(|_| needle(&mut rng));
    let mut twice = 0;
    for corners in picked.map(|needle| needle.map(Vec4::from_bits)).into_iter().chain(random) {
        let (fronts, backs) = seen([corners].into_iter());
        let is_single = |hits: &Hits| hits.0.iter().all(|&n| n <= 1);
        assert!(is_single(&fronts) && is_single(&backs), "{corners:?}");
        twice += u32::from(fronts.0.iter().zip(&backs.0).any(|(front, back)| front + back > 1));
    }
    // One in millions has a pixel in the fold of every fan.
    assert!(twice as usize <= cases(60_000) / 500_000, "{twice} needles have a pixel twice");
}

/// Which way a triangle turns that lies before the eye: the sign of a determinant.
fn turn(corners: [Vec4; 3]) -> i128 {
    let [a, b, c] = corners.map(|at| {
        let [x, y, _, w] = at.to_bits().map(i128::from);
        [x, y, w]
    });
    let minor = |i: usize, j: usize| b[i] * c[j] - b[j] * c[i];
    (a[0] * minor(1, 2) + a[1] * minor(2, 0) + a[2] * minor(0, 1)).signum()
}

/// Pictures of any size, and nothing but the picture: no pixel outside, and none twice.
#[test]
fn a_screen_in_two_triangles_is_filled() {
    let mut rng = Rng::new(35);
    for _ in 0..cases(3_000) {
        let mut ram = vec![0; 64 * 64];
        let side = |rng: &mut Rng| rng.int(1, 64) as u16;
        let (width, height) = (side(&mut rng), side(&mut rng));
        let mut frame = embedded_raster::Framebuffer::<Gray8>::new(&mut ram, width, height).unwrap();
        // Larger than the screen by any factor, at any w.
        let far = rng.pick(&[1, 2, 100, 30_000]);
        let w = rng.int(1, 30_000 / i32::from(far)) as i16;
        let [a, b, c, d] =
            [(-far, -far), (far, -far), (far, far), (-far, far)].map(|(x, y)| Vec4::whole(x * w, y * w, w / 2, w));
        let mut count = 0;
        Pipeline::new(width, height).unwrap().triangles([[a, b, c], [a, c, d]], plain, |triangle| {
            triangle.fill(&mut frame, |_| {
                count += 1;
                Some(Gray8::new(1))
            });
        });
        assert_eq!(count, u32::from(width) * u32::from(height), "{width} x {height}, {far} times");
        assert!(frame.row_bytes(0..height).iter().all(|&byte| byte == 1));
    }
}
