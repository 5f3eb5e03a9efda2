//! The teapot: OBJ files, good and bad ones; pictures of each view in `tests/golden`; bands; and a rasterizer in floats as a twin.
//! `BLESS=1 cargo test --test simulator` writes the pictures anew.

use std::{
    collections::{HashMap, HashSet},
    path::Path,
};

use crate::pictures::compare;
use embedded_graphics::pixelcolor::RgbColor;
use embedded_raster::{pixel::Xrgb8888, Angle, Vec3};
use embedded_raster_simulator::{
    teapot::{draw, draw_as, Camera, Corner, Mesh, ParseError, Patches, View},
    Picture,
};
use fixed::types::I16F16;
use twins::rng::{cases, Rng};

const WIDTH: u16 = 96;
const HEIGHT: u16 = 64;

fn camera() -> Camera {
    Camera { zoom: I16F16::from_num(1.25), ..Camera::new(WIDTH, HEIGHT) }
}

fn patches() -> Patches {
    Patches::parse(include_str!("../../assets/teapot-patches.txt")).expect("they are well-formed")
}

fn teapot(view: View) -> Mesh {
    patches().mesh(camera().tolerance(view))
}

fn obj(name: &str) -> Result<Mesh, ParseError> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/assets").join(name);
    Mesh::parse_obj(&std::fs::read(path).expect("it is there"))
}

fn real(v: Vec3) -> [f64; 3] {
    v.to_bits().map(|n| f64::from(n) / 65_536.0)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Twice the area of a triangle, in the direction in which it looks.
fn area([a, b, c]: &[Corner; 3]) -> [f64; 3] {
    let [a, b, c] = [a, b, c].map(|corner| real(corner.place));
    let ([x, y, z], [p, q, r]) = ([0, 1, 2].map(|i| b[i] - a[i]), [0, 1, 2].map(|i| c[i] - a[i]));
    [y * r - z * q, z * p - x * r, x * q - y * p]
}

/// How far away the furthest corner is.
fn radius(mesh: &Mesh) -> f64 {
    let squares = mesh.triangles.iter().flatten().map(|corner| dot(real(corner.place), real(corner.place)));
    squares.fold(0.0, f64::max).sqrt()
}

fn assert_fits(mesh: &Mesh, what: &str) {
    let radius = radius(mesh);
    assert!((radius - 16.0).abs() < 0.001, "{what}: {radius}");
}

#[test]
fn corners_in_all_forms() {
    let mesh = obj("forms.obj").expect("it is well-formed");
    assert_eq!(mesh.triangles.len(), 5);
    assert_fits(&mesh, "forms");
    let whole = |texel: [I16F16; 2]| texel.map(|n| n.to_num::<i32>());
    let [_, second, third, fourth, last] = &mesh.triangles[..] else { panic!("five") };
    assert_eq!(
        second.map(|corner| whole(corner.texel)),
        [[0, 0], [16, 16], [16, 16]],
        "the last one counts from the end"
    );
    assert_eq!(fourth.map(|corner| whole(corner.texel)), [[0, 0], [16, 0], [16, 16]], "one number is enough");
    assert!(third.iter().chain(fourth).all(|corner| corner.normal == Vec3::Z), "of length 1");
    assert_eq!(
        [0, 1, 2].map(|i| (third[i].place.z > last[i].place.z, last[i].normal)),
        [(true, -Vec3::Z); 3],
        "behind"
    );
    // Without a place on the texture it is the place in front of it.
    assert!(third.iter().all(|corner| corner.texel == [corner.place.x, corner.place.y].map(|n| n / 2)), "projected");
}

#[test]
fn polygons_of_any_kind() {
    let mesh = obj("star.obj").expect("it is well-formed");
    assert_fits(&mesh, "star");
    // Eight corners are six triangles. Of the square, one corner is there twice.
    assert_eq!(mesh.triangles.len(), 6 + 2 + 2);
    let (star, rest) = mesh.triangles.split_at(6);
    let sum = |triangles: &[_], axis: usize| triangles.iter().map(|triangle| area(triangle)[axis]).sum::<f64>();
    assert!(star.iter().all(|triangle| area(triangle)[2] > 0.0), "all look the same way");
    // As seen from above, twice the areas are 8 x 10 x 3 and 2 x 2 x 2: nothing is missing, nothing is there twice.
    let ratio = sum(star, 2) / sum(&rest[..2], 1);
    assert!((ratio.abs() - 30.0).abs() < 0.01, "{ratio}");
    // Faces against the axes: whichever way they turn, triangles turn as they do.
    for (face, axis, sign) in [
        ("v 0 0 0\nv 2 1 0\nv 0 2 0\nv 1 1 0\n", 2, 1.0),
        ("v 0 0 0\nv 0 2 1\nv 0 0 2\nv 0 1 1\n", 0, 1.0),
        ("v 0 0 0\nv 1 0 2\nv 2 0 0\nv 1 0 1\n", 1, 1.0),
    ] {
        for (order, sign) in [("f 1 2 3 4\n", sign), ("f 4 3 2 1\n", -sign)] {
            let mesh = Mesh::parse_obj(&[face, order].concat().into_bytes()).expect("it is well-formed");
            let areas: Vec<f64> = mesh.triangles.iter().map(|triangle| area(triangle)[axis] * sign).collect();
            assert!(areas.len() == 2 && areas.iter().all(|&a| a > 0.0), "{face}{order}: {areas:?}");
        }
    }
}

/// Lines end as on any system.
#[test]
fn ends_of_lines() {
    let text = std::fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/assets/forms.obj"));
    let text = text.expect("it is there").replace("\r\n", "\n");
    let mesh = Mesh::parse_obj(text.as_bytes()).expect("it is well-formed");
    for end in ["\r\n", "\r"] {
        let (other, wrong) = (text.replace('\n', end), format!("v 0 0 0{end}{end}f 1 \\{end}1 2{end}"));
        assert_eq!(Mesh::parse_obj(other.as_bytes()), Ok(mesh.clone()), "{end:?}");
        let error = Mesh::parse_obj(wrong.as_bytes()).expect_err("there is no second vertex").to_string();
        assert_eq!(error, "line 3: `2` is no vertex: the file has 1 so far", "{end:?}");
    }
}

/// Some editors begin a file with a mark of its encoding.
#[test]
fn a_byte_order_mark_says_nothing() {
    let text = "v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nf -3 -2 -1\r\n";
    let mesh = Mesh::parse_obj(text.as_bytes()).expect("it is well-formed");
    for start in ["\u{feff}", "\u{feff}# a triangle\r\n"] {
        assert_eq!(Mesh::parse_obj(format!("{start}{text}").as_bytes()), Ok(mesh.clone()), "{start:?}");
    }
}

#[test]
fn normals_that_a_file_does_not_have() {
    let cube = obj("cube.obj").expect("it is well-formed");
    assert_eq!(cube.triangles.len(), 12);
    for triangle in &cube.triangles {
        let normal = Mesh::face_normal(triangle);
        assert!(triangle.iter().all(|corner| corner.normal == normal), "each square has its own");
        assert!(dot(area(triangle), real(triangle[0].place)) > 0.0, "outside is in front");
    }
    // Two triangles at right angles, one four times as large, with a place that is there twice: its normal is by their areas.
    let mesh =
        Mesh::parse_obj(b"v 0 0 0\nv 4 0 0\nv 0 4 0\nv 0 0 0\nv 0 1 0\nv 0 0 4\nf 1 2 3\nf 4 5 6\n").expect("a mesh");
    let [first, second] = &mesh.triangles[..] else { panic!("two") };
    let [x, y, z] = real(first[0].normal);
    assert!((x * 4.0 - z).abs() < 0.001 && y == 0.0 && (x * x + z * z - 1.0).abs() < 0.001, "{x} {y} {z}");
    assert_eq!((first[0].normal, first[1].normal), (second[0].normal, Vec3::Z), "one place, one normal");
    // Inside out by its numbers, but not by its normals: it is turned over.
    let mesh = Mesh::parse_obj(b"v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 -1\nf 1//1 2//1 3//1\n").expect("a mesh");
    assert!(area(&mesh.triangles[0])[2] < 0.0, "it looks where its normals point");
}

#[test]
fn bodies_of_any_size() {
    for scale in ["", "e300", "e-300", "e307", "e-320"] {
        let text: String = ["0 0 0", "9 0 0", "0 3 0", "0 0 1"]
            .map(|place| format!("v {}{scale}\n", place.replace(' ', &format!("{scale} "))))
            .concat();
        let mesh =
            Mesh::parse_obj(format!("{text}v 1e308 1e308 1e308\nf 1 2 3\nf 1 2 4\n").as_bytes()).expect("a mesh");
        assert_fits(&mesh, scale);
    }
    let mesh = Mesh::parse_obj(b"v -1.7e308 0 0\nv 1.7e308 0 0\nv 0 1e308 0\nf 1 2 3\n").expect("a mesh");
    assert_fits(&mesh, "from one end to the other");
    let mesh = Mesh::parse_obj(b"v 5 5 5\nv 5 5 5\nv 5 5 5\nvt 1e9 -1e9\nf 1/1 2/1 3/1\n").expect("a mesh");
    assert_eq!(mesh.triangles[0][0].place, Vec3::ZERO, "a single place");
    for view in View::ALL {
        draw(16, &mesh, view, &camera(), None).expect("a picture");
    }
}

#[test]
fn what_is_wrong_with_a_file() {
    let error = |name| obj(name).expect_err("it is wrong").to_string();
    assert_eq!(error("bad-corner.obj"), "line 7: `4` is no vertex: the file has 3 so far");
    assert_eq!(error("bad-number.obj"), "line 4: `1,5` is not a number");
    for (text, expected) in [
        ("", "line 1: the file ends without a face"),
        ("v 1 2 3\n\n# end\n", "line 3: the file ends without a face"),
        ("v 1 2\n", "line 1: a vertex is `v X Y Z`: it has 2 of 3 numbers"),
        ("v 1 2 nan\n", "line 1: `nan` is not a number"),
        ("v 1 2 1e999\n", "line 1: `1e999` is not a number"),
        ("\nvn 1\n", "line 2: a normal is `vn X Y Z`: it has 1 of 3 numbers"),
        ("vt\n", "line 1: a place on the texture is `vt U V`: it has 0 of 1 numbers"),
        ("vt 0 x\n", "line 1: `x` is not a number"),
        ("v 0 0 0\nf 1 1\n", "line 2: a face of 2 corners: it has three or more"),
        ("v 0 0 0\nf\n", "line 2: a face of 0 corners: it has three or more"),
        ("v 0 0 0\nf 1 1 0\n", "line 2: `0` is no vertex: the file has 1 so far"),
        ("v 0 0 0\nf 1 1 -2\n", "line 2: `-2` is no vertex: the file has 1 so far"),
        ("v 0 0 0\nf 1 1 -9223372036854775808\n", "line 2: `-9223372036854775808` is no vertex: the file has 1 so far"),
        ("v 0 0 0\nf 1 1 1.5\n", "line 2: `1.5` is no number of a vertex"),
        ("v 0 0 0\nf 1/1 1 1\n", "line 2: `1` is no place on the texture: the file has 0 so far"),
        ("v 0 0 0\nf 1//7 1 1\n", "line 2: `7` is no normal: the file has 0 so far"),
        ("v 0 0 0\nf 1/ 1 1\n", "line 2: `1/` is no corner: that is V, V/VT, V//VN or V/VT/VN"),
        ("v 0 0 0\nf /1 1 1\n", "line 2: `/1` is no corner: that is V, V/VT, V//VN or V/VT/VN"),
        ("v 0 0 0\nf 1/1/ 1 1\n", "line 2: `1/1/` is no corner: that is V, V/VT, V//VN or V/VT/VN"),
        ("v 0 0 0\nf 1/1/1/1 1 1\n", "line 2: `1/1/1/1` is no corner: that is V, V/VT, V//VN or V/VT/VN"),
        ("v 0 0 0\nf \\\n1 \\\n1 7\n", "line 2: `7` is no vertex: the file has 1 so far"),
        ("csh ls\ncall other.obj 1\n", "line 2: the file ends without a face"),
        ("v 0 0 0\nf 1 1 \\", "line 2: a face of 2 corners: it has three or more"),
        (
            "\u{7f}ELF\u{1}0123456789012345678901234567\n",
            "line 1: `\\u{7f}ELF\\u{1}0123456789012345678...` is no statement of an OBJ file",
        ),
    ] {
        let error = Mesh::parse_obj(text.as_bytes()).expect_err(text);
        assert_eq!(error.to_string(), expected, "{text:?}");
    }
    for (text, expected) in [
        ("", "line 0: the text ends without a patch"),
        ("v 1 2\n", "line 1: a control point is `v X Y Z`"),
        ("# none\nv 1 2 3\np 1 1 1\n", "line 3: a patch is `p` and sixteen numbers"),
        ("v 1 2 3\np 1 1 1 2\n", "line 2: `2` is no control point: there are 1"),
        ("f 1 2 3\n", "line 1: `f` is neither `v` nor `p`"),
    ] {
        assert_eq!(Patches::parse(text).expect_err(text).to_string(), expected, "{text:?}");
    }
}

/// Whatever stands in a file: a mesh or an error.
#[test]
fn any_file_is_fine() {
    let (mut rng, mut meshes) = (Rng::new(1), 0);
    for name in ["forms.obj", "star.obj", "cube.obj"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/assets").join(name);
        let text = std::fs::read(path).expect("it is there");
        for _ in 0..cases(1_000) {
            let mut text = text.clone();
            for _ in 0..rng.int(1, 4) {
                let at =
                    usize::try_from(rng.int(0, i32::try_from(text.len()).expect("short") - 1)).expect("not negative");
                let byte = rng.pick(b"0123456789-./ev\n\\ \xff");
                if rng.one_in(2) {
                    text[at] = byte;
                } else {
                    text.insert(at, byte);
                }
            }
            match Mesh::parse_obj(&text) {
                Ok(mesh) => {
                    assert!(radius(&mesh) < 16.001, "{}", String::from_utf8_lossy(&text));
                    meshes += 1;
                }
                Err(error) => assert!(error.to_string().lines().count() == 1, "{error}"),
            }
        }
    }
    assert!(meshes > cases(1_000) / 10, "{meshes} meshes");
}

/// Files that programs write differ in nothing that is seen here.
#[test]
fn the_teapot_of_triangles_is_that_of_patches() {
    let mesh = obj("teapot.obj").expect("it is well-formed");
    assert_eq!(mesh.triangles.len(), 992);
    assert_fits(&mesh, "triangles");
    // Of patches, the furthest place need not be a corner.
    assert!((15.95..16.001).contains(&radius(&teapot(View::Depth))), "{}", radius(&teapot(View::Depth)));
    // Of its 792 places 263 are there twice, at seams. Nobody sees them, as each place has one normal.
    let mut normals = HashMap::new();
    for corner in mesh.triangles.iter().flatten() {
        assert_eq!(*normals.entry(corner.place.to_bits()).or_insert(corner.normal), corner.normal, "a seam");
    }
    assert_eq!(normals.len(), 529);
}

/// What a view shows of the teapot.
fn picture(bits: u32, view: View) -> Picture {
    draw(bits, &teapot(view), view, &camera(), None).expect("it has pixels").picture
}

#[test]
fn each_view_at_several_depths() {
    let all = View::ALL.into_iter().flat_map(|view| [1, 4, 16].map(|bits| (view, bits)));
    let rest = [2, 8, 24, 32].map(|bits| (View::Textured, bits));
    let wrong: Vec<_> = all
        .chain(rest)
        .filter_map(|(view, bits)| compare(&format!("teapot-{}-{bits}", view.name()), &picture(bits, view)))
        .collect();
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

#[test]
fn bands_show_the_whole() {
    let mut choice = Rng::new(1);
    for view in View::ALL {
        let mesh = teapot(view);
        for bits in [1, 2, 4, 8, 16, 24, 32] {
            let whole = draw(bits, &mesh, view, &camera(), None).expect("it has pixels");
            // Depths of one kind differ in how they store a pixel: that has tests of its own.
            let all = [1, 7, 16, HEIGHT - 1, HEIGHT, u16::MAX];
            let some = if [1, 4, 16].contains(&bits) { &all[..] } else { &all[2..3] };
            for &rows in some.iter().filter(|_| choice.takes_case()) {
                let bands = draw(bits, &mesh, view, &camera(), Some(rows)).expect("it has pixels");
                assert!(bands.picture == whole.picture, "{view:?} at {bits} bits in bands of {rows} rows");
                assert_eq!(bands.fragments, whole.fragments, "{view:?} in bands of {rows} rows");
                let part = |bytes: usize| bytes / usize::from(HEIGHT) * usize::from(rows.min(HEIGHT));
                let memory = [whole.color, whole.depth, whole.scratch].map(part);
                assert_eq!([bands.color, bands.depth, bands.scratch], memory, "{view:?} in bands of {rows} rows");
            }
        }
    }
}

/// The pixels of a picture that do not show the background.
fn silhouette(picture: &Picture) -> Vec<bool> {
    let background = picture.color(0, 0);
    picture.colors().map(|color| Some(color) != background).collect()
}

/// A triangle of the twin: its corners on the screen, with depths; and its colour.
struct Twin {
    corners: [[f64; 3]; 3],
    color: [f64; 3],
}

/// The flat view in floats: from the places of a mesh to pixels and colours, by the words of the documentation alone.
fn floats(mesh: &Mesh, camera: &Camera) -> Vec<Twin> {
    let turns = |angle: Angle| f64::from(angle.to_bits()) / 4_294_967_296.0 * std::f64::consts::TAU;
    let ((sy, cy), (sp, cp)) = (turns(camera.yaw).sin_cos(), turns(camera.pitch).sin_cos());
    let turned = |[x, y, z]: [f64; 3]| {
        let (x, z) = (cy * x + sy * z, cy * z - sy * x);
        [x, cp * y - sp * z, sp * y + cp * z]
    };
    let [width, height] = [camera.width, camera.height].map(f64::from);
    let away = 16.0 * 3.25 / camera.zoom.to_num::<f64>();
    let focal = height / 2.0 / 18.5_f64.to_radians().tan();
    let seen = |corner: &Corner| {
        let [x, y, z] = turned(real(corner.place));
        let distance = away - z;
        [width / 2.0 + focal * x / distance, height / 2.0 - focal * y / distance, distance]
    };
    let unit = |v: [f64; 3]| v.map(|n| n / dot(v, v).sqrt());
    let light = unit([-4.0, 6.0, 7.0]);
    let half = unit([light[0], light[1], light[2] + 1.0]);
    let twin = |triangle: &[Corner; 3]| {
        let corners = [0, 1, 2].map(|i| seen(&triangle[i]));
        let [[ax, ay, _], [bx, by, _], [cx, cy, _]] = corners;
        let front = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax) < 0.0;
        let normal = unit(turned(area(triangle))).map(|n| if front { n } else { -n });
        let matt = dot(normal, light).max(0.0);
        let shine = if matt > 0.0 { dot(normal, half).max(0.0).powi(40) } else { 0.0 };
        let tone = 36.0 + 156.0 * matt + 63.0 * shine;
        let own = (tone / 192.0).min(1.0);
        let white = ((tone - 192.0) / 63.0).max(0.0);
        let color = [224.0, 140.0, 80.0].map(|c| c * own * (1.0 - white) + 255.0 * white);
        Twin { corners, color }
    };
    mesh.triangles.iter().map(twin).collect()
}

impl Twin {
    /// How far inside a place is, in pixels, and how far away the triangle is there.
    fn at(&self, x: f64, y: f64) -> (f64, f64) {
        let [a, b, c] = self.corners;
        let edge = |a: [f64; 3], b: [f64; 3]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        let whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let weights = [edge(b, c), edge(c, a), edge(a, b)].map(|w| w * whole.signum());
        let lengths = [(b, c), (c, a), (a, b)].map(|(a, b)| (b[0] - a[0]).hypot(b[1] - a[1]));
        let inside = (0..3).map(|i| weights[i] / lengths[i].max(1e-9)).fold(f64::INFINITY, f64::min);
        // 1 / distance is linear on the screen.
        let near = (0..3).map(|i| weights[i] / whole.abs() / self.corners[i][2]).sum::<f64>();
        (inside, 1.0 / near)
    }
}

impl Twin {
    /// Where a place is on the texture, if it lies inside: what is over the distance, over one over the distance.
    fn texel(&self, corners: &[Corner; 3], x: f64, y: f64) -> Option<[f64; 2]> {
        let (inside, distance) = self.at(x, y);
        let [a, b, c] = self.corners;
        let edge = |a: [f64; 3], b: [f64; 3]| (b[0] - a[0]) * (y - a[1]) - (b[1] - a[1]) * (x - a[0]);
        let whole = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
        let weights = [edge(b, c), edge(c, a), edge(a, b)].map(|w| w / whole);
        let sum = |axis: usize| {
            let parts = (0..3).map(|i| weights[i] * corners[i].texel[axis].to_num::<f64>() / self.corners[i][2]);
            parts.sum::<f64>() * distance
        };
        (inside > 0.02).then(|| [sum(0), sum(1)])
    }
}

/// Pixels that are surely inside of a triangle are painted, those surely outside of all are not, and where one triangle is surely the
/// nearest, the pixel has its colour.
#[test]
fn the_flat_view_is_that_of_floats() {
    let bodies = [
        teapot(View::Flat),
        obj("teapot.obj").expect("a mesh"),
        obj("cube.obj").expect("a mesh"),
        obj("star.obj").expect("a mesh"),
    ];
    let (mut inside, mut outside, mut colored) = (0, 0, 0);
    for mesh in &bodies {
        for (yaw, pitch, zoom) in [(-25, 22, 1.25), (0, 0, 1.0), (100, -40, 0.5), (211, 80, 1.75), (300, 10, 1.0)] {
            let zoom = I16F16::from_num(zoom);
            let camera = Camera { yaw: Angle::degrees(yaw), pitch: Angle::degrees(pitch), zoom, ..camera() };
            let picture = draw_as::<Xrgb8888>(mesh, View::Flat, &camera, None).expect("it has pixels").picture;
            let (painted, twins) = (silhouette(&picture), floats(mesh, &camera));
            for (at, &is_painted) in painted.iter().enumerate() {
                let (x, y) = (at % usize::from(WIDTH), at / usize::from(WIDTH));
                let (cx, cy) = (
                    f64::from(u16::try_from(x).expect("small")) + 0.5,
                    f64::from(u16::try_from(y).expect("small")) + 0.5,
                );
                // Corners are rounded to 1/256 pixel.
                let near: Vec<_> = twins
                    .iter()
                    .map(|twin| (twin.at(cx, cy), twin))
                    .filter(|((inside, _), _)| *inside > -0.02)
                    .collect();
                if near.is_empty() {
                    assert!(!is_painted, "{x}, {y} is painted at {yaw}, {pitch}");
                    outside += 1;
                }
                let Some(&((_, first), nearest)) = near
                    .iter()
                    .filter(|((inside, _), _)| *inside > 0.02)
                    .min_by(|((_, a), _), ((_, b), _)| a.total_cmp(b))
                else {
                    continue;
                };
                assert!(is_painted, "{x}, {y} is not painted at {yaw}, {pitch}");
                inside += 1;
                let rivals =
                    near.iter().filter(|((_, depth), twin)| *depth < first + 0.05 && !std::ptr::eq(*twin, nearest));
                if rivals.count() == 0 {
                    let color = picture.color(x, y).expect("inside");
                    let off = [color.r(), color.g(), color.b()]
                        .into_iter()
                        .zip(nearest.color)
                        .map(|(c, n)| (f64::from(c) - n).abs());
                    let off = off.fold(0.0, f64::max);
                    assert!(off < 4.0, "{x}, {y} is {color:?} at {yaw}, {pitch}, not {:?}", nearest.color);
                    colored += 1;
                }
            }
        }
    }
    assert!(
        inside > 15_000 && outside > 40_000 && colored > 12_000,
        "{inside} inside, {outside} outside, {colored} with a colour"
    );
}

/// Where no triangle ends near a pixel, its colour tells how many triangles it lies in: one colour for each number up to fifteen.
#[test]
fn overdraw_counts_triangles() {
    let bodies = [teapot(View::Overdraw), obj("teapot.obj").expect("a mesh"), obj("cube.obj").expect("a mesh")];
    let mut colors = HashMap::new();
    let mut pixels = 0;
    for mesh in &bodies {
        for (yaw, pitch) in [(-25, 22), (0, 0), (100, -40), (211, 80)] {
            let camera = Camera { yaw: Angle::degrees(yaw), pitch: Angle::degrees(pitch), ..camera() };
            let drawing = draw(24, mesh, View::Overdraw, &camera, None).expect("it has pixels");
            let twins = floats(mesh, &camera);
            let mut least = 0;
            for (at, color) in drawing.picture.colors().enumerate() {
                let (x, y) = (at % usize::from(WIDTH), at / usize::from(WIDTH));
                let centre = |n: usize| f64::from(u16::try_from(n).expect("small")) + 0.5;
                let inside: Vec<f64> = twins.iter().map(|twin| twin.at(centre(x), centre(y)).0).collect();
                let times = inside.iter().filter(|&&inside| inside > 0.0).count();
                least += inside.iter().filter(|&&inside| inside > 0.02).count() as u64;
                if inside.iter().all(|inside| inside.abs() > 0.02) {
                    let known = *colors.entry(times.min(15)).or_insert(color);
                    assert_eq!(color, known, "{x}, {y} lies in {times} triangles at {yaw}, {pitch}");
                    pixels += 1;
                }
            }
            assert!(drawing.fragments >= least && drawing.fragments < least + least / 5 + 50, "{least} are sure");
        }
    }
    let different: HashSet<_> = colors.values().map(|c| (c.r(), c.g(), c.b())).collect();
    assert!(different.len() == colors.len() && colors.len() >= 5 && pixels > 50_000, "{pixels} pixels, {colors:?}");
}

/// A square that leads into the distance: its chequers are where rays of the eye meet them, not where the middle of its sides is on
/// the screen.
#[test]
fn textures_are_seen_in_perspective() {
    // Two triangles, 16 squares of the chequerboard each way, tilted.
    let square = b"v -1 -1 0\nv 1 -1 0\nv 1 1 0\nv -1 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nf 1/1 2/2 3/3 4/4\n";
    let mesh = Mesh::parse_obj(square).expect("it is well-formed");
    let (mut checked, mut light) = (0, 0);
    for (yaw, pitch) in [(0, 0), (0, -70), (60, 20), (-50, 45), (30, 75)] {
        let camera = Camera { yaw: Angle::degrees(yaw), pitch: Angle::degrees(pitch), ..Camera::new(192, 144) };
        let picture = draw(24, &mesh, View::Textured, &camera, None).expect("it has pixels").picture;
        let twins = floats(&mesh, &camera);
        for (twin, corners) in twins.iter().zip(&mesh.triangles) {
            for (at, color) in picture.colors().enumerate() {
                let (x, y) = (at % 192, at / 192);
                let centre = |n: usize| f64::from(u16::try_from(n).expect("small")) + 0.5;
                let Some(texel) = twin.texel(corners, centre(x), centre(y)) else { continue };
                // Not beside a side of a square.
                if texel.iter().any(|n| (n - n.round()).abs() < 0.05) {
                    continue;
                }
                let is_light = (texel[0].floor() + texel[1].floor()).rem_euclid(2.0) < 0.5;
                assert_eq!(color.r() > color.b(), is_light, "{x}, {y} at {yaw}, {pitch}: {texel:?}, {color:?}");
                (checked, light) = (checked + 1, light + u32::from(is_light));
            }
        }
    }
    assert!(checked > 15_000 && (checked * 2 / 5..checked * 3 / 5).contains(&light), "{light} of {checked}");
}

/// All views show the same pixels of the same triangles.
#[test]
fn views_have_one_silhouette() {
    let mesh = teapot(View::Flat);
    let drawn = |view| draw(24, &mesh, view, &camera(), None).expect("it has pixels");
    let expected = silhouette(&drawn(View::Flat).picture);
    for view in View::ALL.into_iter().filter(|&view| view != View::Wire) {
        assert!(silhouette(&drawn(view).picture) == expected, "{view:?}");
    }
    // What is seen of a pixel is one fragment of those that its overdraw counts.
    let covered = expected.iter().filter(|&&is_painted| is_painted).count() as u64;
    let [flat, all] = [View::Flat, View::Overdraw].map(|view| drawn(view).fragments);
    assert!(covered < flat && flat < all, "{covered} pixels, {flat} and {all} fragments");
    // The lines are where the triangles are.
    let lines = silhouette(&drawn(View::Wire).picture);
    let around = |at: usize| {
        [0, 1, 2]
            .iter()
            .any(|dy| [0, 1, 2].iter().any(|dx| expected[at + dy * usize::from(WIDTH) + dx - usize::from(WIDTH) - 1]))
    };
    assert!((0..lines.len()).all(|at| !lines[at] || around(at)), "a line beside the body");
}

#[test]
fn numbers_and_shares_are_colours() {
    let mesh = teapot(View::Id);
    let ids = draw(24, &mesh, View::Id, &camera(), None).expect("it has pixels").picture;
    let colors: HashSet<_> = ids.colors().map(|c| (c.r(), c.g(), c.b())).collect();
    assert_eq!(colors.len(), 16, "fifteen, and the background");
    let shares = draw(24, &mesh, View::Barycentric, &camera(), None).expect("it has pixels").picture;
    let sums = shares.colors().zip(silhouette(&shares)).filter(|&(_, is_painted)| is_painted);
    for (c, _) in sums {
        let sum = [c.r(), c.g(), c.b()].map(i32::from).iter().sum::<i32>();
        assert!((254..=256).contains(&sum), "each share is rounded: {c:?}");
    }
    // Directions have length 1, if the corners of a triangle have nearly the same, and look to the viewer, who is not infinitely far
    // away.
    let fine = patches().mesh(I16F16::from_num(0.002));
    let normals = draw(24, &fine, View::Normal, &camera(), None).expect("it has pixels").picture;
    for (c, _) in normals.colors().zip(silhouette(&normals)).filter(|&(_, is_painted)| is_painted) {
        let v = [c.r(), c.g(), c.b()].map(|n| f64::from(n) / 127.5 - 1.0);
        assert!((dot(v, v).sqrt() - 1.0).abs() < 0.08 && v[2] > -0.4, "{c:?}");
    }
}

/// More triangles than numbers of 16 bits.
#[test]
fn many_triangles_have_longer_numbers() {
    let camera = camera();
    let few = teapot(View::Id);
    let mut many = few.clone();
    // Behind all others, and so small that nobody sees them.
    let hidden = few.triangles[0].map(|corner| Corner { place: Vec3::ZERO, ..corner });
    many.triangles.resize(70_000, hidden);
    let [few, many] = [few, many].map(|mesh| draw(8, &mesh, View::Id, &camera, None).expect("it has pixels"));
    assert_eq!(few.scratch * 2, many.scratch);
    assert!(few.picture == many.picture, "the same");
}

#[test]
fn any_camera_is_fine() {
    let mesh = obj("teapot.obj").expect("a mesh");
    for (width, height) in [(1, 1), (1, 300), (300, 1), (17, 4096)] {
        for (zoom, pitch) in [(I16F16::MIN, 3), (I16F16::ZERO, 90), (I16F16::from_num(3), -90), (I16F16::MAX, 200)] {
            let camera = Camera { zoom, pitch: Angle::degrees(pitch), ..Camera::new(width, height) };
            for view in View::ALL {
                let drawing = draw(4, &mesh, view, &camera, Some(100)).expect("it has pixels");
                assert_eq!((drawing.picture.width(), drawing.picture.height()), (width.into(), height.into()));
                assert!(patches().mesh(camera.tolerance(view)).triangles.len() < 100_000, "bounded");
            }
        }
    }
}
