//! OBJ files: polygons of any number of corners become triangles.
//!
//! Source: "Object Files (.obj)", Wavefront Advanced Visualizer manual, appendix B1, 1992.

use std::str::FromStr;

use embedded_raster::{
    geom::triangulate::{self, SideSlot},
    PointFx, TriangulateError, Vec3,
};
use fixed::types::I24F8;

use super::{
    mesh::{cross, direction, number, Corner, Fit, Mesh},
    ParseError,
};

/// Squares of the chequerboard along a texture.
const SQUARES: f64 = 16.0;
/// How often a texture may lie side by side.
const REPEATS: f64 = 1_000.0;

/// What a file can say that is not shown here.
const IGNORED: [&str; 40] = [
    "g",
    "o",
    "s",
    "mg",
    "usemtl",
    "mtllib",
    "usemap",
    "maplib",
    "p",
    "l",
    "vp",
    "cstype",
    "deg",
    "bmat",
    "step",
    "curv",
    "curv2",
    "surf",
    "parm",
    "trim",
    "hole",
    "scrv",
    "sp",
    "end",
    "con",
    "bevel",
    "c_interp",
    "d_interp",
    "lod",
    "shadow_obj",
    "trace_obj",
    "ctech",
    "stech",
    "bsp",
    "bzp",
    "cdc",
    "cdp",
    "res",
    "call",
    "csh",
];

/// A corner of a face, by places in the lists of the file.
#[derive(Copy, Clone)]
struct Reference {
    place: usize,
    texel: Option<usize>,
    normal: Option<usize>,
}

/// What was read so far.
#[derive(Default)]
struct Lists {
    places: Vec<[f64; 3]>,
    texels: Vec<[f64; 2]>,
    normals: Vec<[f64; 3]>,
    corners: Vec<Reference>,
    /// How many of the corners each face has.
    faces: Vec<usize>,
}

impl Mesh {
    /// Reads an OBJ file: `v`, `vt`, `vn` and `f`. Materials, groups, lines, points and curves say nothing here.
    ///
    /// Faces may have any number of corners, convex or not, and count from the start of the file or, with negative numbers, back
    /// from the line where they stand. Corners without a normal get one: see [`Corner::normal`]. Without coordinates on the
    /// texture, it is projected along the z axis.
    ///
    /// # Errors
    /// The first line that is wrong, and a file without faces.
    /// ```
    /// use embedded_raster_simulator::teapot::Mesh;
    /// let mesh = Mesh::parse_obj(b"v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf -4 -3 -2 -1\n")?;
    /// assert_eq!(mesh.triangles.len(), 2);
    /// let error = Mesh::parse_obj(b"v 0 0 0\nv 1 0 0\nf 1 2 3\n").unwrap_err();
    /// assert_eq!(error.to_string(), "line 3: `3` is no vertex: the file has 2 so far");
    /// # Ok::<(), embedded_raster_simulator::teapot::ParseError>(())
    /// ```
    pub fn parse_obj(text: &[u8]) -> Result<Self, ParseError> {
        let mut lists = Lists::default();
        let text = String::from_utf8_lossy(text.strip_prefix(b"\xef\xbb\xbf").unwrap_or(text)).replace("\r\n", "\n");
        let mut end = 1;
        // Old files end their lines with a carriage return alone.
        let mut lines = (1..).zip(text.strip_suffix(['\n', '\r']).unwrap_or(&text).split(['\n', '\r']));
        while let Some((line, first)) = lines.next() {
            let mut whole = String::new();
            let (mut part, mut last) = (without_comment(first), line);
            // A line that ends with a backslash goes on in the next one.
            while let Some(start) = part.strip_suffix('\\') {
                whole.push_str(start);
                whole.push(' ');
                let Some((number, next)) = lines.next() else {
                    part = "";
                    break;
                };
                (part, last) = (without_comment(next), number);
            }
            whole.push_str(part);
            end = last;
            lists.read(&whole).map_err(|problem| ParseError { line, problem })?;
        }
        if lists.faces.is_empty() {
            return Err(ParseError { line: end, problem: "the file ends without a face".into() });
        }
        Ok(lists.mesh())
    }
}

fn without_comment(line: &str) -> &str {
    line.split('#').next().unwrap_or_default().trim_end()
}

impl Lists {
    fn read(&mut self, line: &str) -> Result<(), String> {
        let mut words = line.split_whitespace();
        let Some(statement) = words.next() else { return Ok(()) };
        match statement {
            // What follows, a weight or a colour, is not used.
            "v" => self.places.push(numbers(words, "a vertex is `v X Y Z`")?),
            "vn" => self.normals.push(numbers(words, "a normal is `vn X Y Z`")?),
            "vt" => {
                let mut words = words.peekable();
                let first: [f64; 1] = numbers(words.by_ref().take(1), "a place on the texture is `vt U V`")?;
                let second = words.next().map_or(Ok(0.0), real)?;
                self.texels.push([first[0], second]);
            }
            "f" | "fo" => self.face(words)?,
            _ if IGNORED.contains(&statement) => {}
            _ => return Err(format!("{} is no statement of an OBJ file", quoted(statement))),
        }
        Ok(())
    }

    fn face<'a>(&mut self, words: impl Iterator<Item = &'a str>) -> Result<(), String> {
        let before = self.corners.len();
        for word in words {
            let corner = self.reference(word)?;
            self.corners.push(corner);
        }
        let count = self.corners.len() - before;
        if count < 3 {
            return Err(format!("a face of {count} corners: it has three or more"));
        }
        self.faces.push(count);
        Ok(())
    }

    /// `v`, `v/vt`, `v//vn` or `v/vt/vn`.
    fn reference(&self, word: &str) -> Result<Reference, String> {
        let mut parts = word.split('/');
        let (place, texel, normal) = (parts.next().unwrap_or_default(), parts.next(), parts.next());
        if parts.next().is_some() || place.is_empty() || normal == Some("") || texel == Some("") && normal.is_none() {
            return Err(format!("{} is no corner: that is V, V/VT, V//VN or V/VT/VN", quoted(word)));
        }
        let optional = |part: Option<&str>, len, what| {
            part.filter(|part| !part.is_empty()).map(|part| entry(part, len, what)).transpose()
        };
        Ok(Reference {
            place: entry(place, self.places.len(), "vertex")?,
            texel: optional(texel, self.texels.len(), "place on the texture")?,
            normal: optional(normal, self.normals.len(), "normal")?,
        })
    }

    fn mesh(&self) -> Mesh {
        // Only what faces use: a vertex that nobody sees has no say in the size.
        let used: Vec<[f64; 3]> = self.corners.iter().map(|corner| self.places[corner.place]).collect();
        let fit = Fit::new(&used);
        let corner = |reference: &Reference| {
            let place = fit.place(self.places[reference.place]);
            let normal = reference.normal.map_or(Vec3::ZERO, |at| direction(self.normals[at]));
            let texel = match reference.texel {
                Some(at) => self.texels[at].map(|n| number(n.clamp(-REPEATS, REPEATS) * SQUARES)),
                // The body is 32 units wide: 16 squares.
                None => [place.x, place.y].map(|n| n / 2),
            };
            Corner { place, normal, texel }
        };
        let corners: Vec<Corner> = self.corners.iter().map(corner).collect();
        let (mut mesh, mut rest) = (Mesh { triangles: vec![] }, &corners[..]);
        for &count in &self.faces {
            let (face, others) = rest.split_at(count);
            triangles(face, &mut mesh.triangles);
            rest = others;
        }
        mesh.face_outwards();
        mesh.smooth();
        mesh
    }
}

/// Cuts a face into triangles that turn as it does.
fn triangles(face: &[Corner], out: &mut Vec<[Corner; 3]>) {
    let fan = || face[1..].windows(2).map(|pair| [face[0], pair[0], pair[1]]);
    if face.len() == 3 {
        out.extend(fan());
        return;
    }
    // Newell: the sum of the triangles around any place is the normal of the best plane.
    let mut normal = [0.0; 3];
    for [_, b, c] in fan() {
        let area = cross(face[0].place, b.place, c.place);
        normal = [0, 1, 2].map(|i| normal[i] + area[i]);
    }
    // As it is seen along the axis that is closest to the normal. What turns like x to y there, turns clockwise on a screen.
    let axis = (0..3).max_by(|&i, &j| normal[i].abs().total_cmp(&normal[j].abs())).unwrap_or(0);
    let flat = |corner: &Corner| {
        let at = corner.place.to_bits();
        PointFx::new(I24F8::from_bits(at[(axis + 1) % 3]), I24F8::from_bits(at[(axis + 2) % 3]))
    };
    let outline: Vec<PointFx> = face.iter().map(flat).collect();
    match cut(&outline) {
        Some(cut) if !cut.is_empty() => out.extend(cut.into_iter().map(|places| {
            let [a, b, c] = places.map(|place| face[usize::from(place)]);
            if normal[axis] < 0.0 {
                [a, c, b]
            } else {
                [a, b, c]
            }
        })),
        // It crosses itself, or has no area: any triangles are as good.
        _ => out.extend(fan()),
    }
}

/// Triangles of a polygon, as numbers of its corners; none if its sides cross.
fn cut(outline: &[PointFx]) -> Option<Vec<[u16; 3]>> {
    let mut slots = vec![SideSlot::EMPTY; outline.len()];
    loop {
        let mut cut = vec![];
        match triangulate::each(outline, &[], &mut slots, |triangle| cut.push(triangle)) {
            Ok(()) => return Some(cut),
            Err(TriangulateError::SideTableFull { needed, capacity })
                if needed > slots.len() && capacity == slots.len() =>
            {
                slots.resize(needed, SideSlot::EMPTY);
            }
            Err(_) => return None,
        }
    }
}

/// The number of an entry of a list of `len`, from 0 on: the file counts from 1, or back from the end.
fn entry(word: &str, len: usize, what: &str) -> Result<usize, String> {
    let number = i64::from_str(word).map_err(|_| format!("{} is no number of a {what}", quoted(word)))?;
    let from_start = usize::try_from(number).ok().and_then(|number| number.checked_sub(1));
    let from_end = usize::try_from(number.unsigned_abs()).ok().and_then(|number| len.checked_sub(number));
    let at = if number < 0 { from_end } else { from_start };
    at.filter(|&at| at < len).ok_or_else(|| format!("{} is no {what}: the file has {len} so far", quoted(word)))
}

/// The first numbers of a line.
fn numbers<'a, const N: usize>(words: impl Iterator<Item = &'a str>, rule: &str) -> Result<[f64; N], String> {
    let all: Vec<f64> = words.take(N).map(real).collect::<Result<_, _>>()?;
    <[f64; N]>::try_from(all).map_err(|all| format!("{rule}: it has {} of {N} numbers", all.len()))
}

/// A number that is not infinite.
pub(super) fn real(word: &str) -> Result<f64, String> {
    f64::from_str(word).ok().filter(|n| n.is_finite()).ok_or_else(|| format!("{} is not a number", quoted(word)))
}

/// The start of a word, on one line whatever is in it.
pub(super) fn quoted(word: &str) -> String {
    const MOST: usize = 24;
    let start: String = word.chars().take(MOST).flat_map(char::escape_debug).collect();
    let rest = if word.chars().nth(MOST).is_some() { "..." } else { "" };
    format!("`{start}{rest}`")
}
