//! [`Patches`]: surfaces of Bézier patches.

use std::str::FromStr;

use embedded_raster::{
    geom::space::patch::{self, Part, Tessellation},
    Patch,
};
use fixed::types::I16F16;

use super::{
    mesh::{units, Corner, Fit, Mesh},
    obj::{quoted, real},
    ParseError,
};

/// Squares of the chequerboard along a patch.
const SQUARES: i32 = 4;

/// Into how many parts sides are cut to see how large a patch is.
const SAMPLES: u8 = 8;

/// Some patches, as large as a [`Mesh`] is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Patches {
    patches: Vec<Patch>,
}

impl Patches {
    /// Reads `v X Y Z`, a control point, and `p` with sixteen numbers of control points, row by row: a patch. Numbers count from 1
    /// on, z is up, and what follows a `#` is a comment.
    ///
    /// # Errors
    /// The first line that is none of these, and a text without patches.
    pub fn parse(text: &str) -> Result<Self, ParseError> {
        let (mut places, mut patches, mut end) = (vec![], vec![], 0);
        for (line, words) in (1..).zip(text.lines()) {
            end = line;
            read(words, &mut places, &mut patches).map_err(|problem| ParseError { line, problem })?;
        }
        if patches.is_empty() {
            return Err(ParseError { line: end, problem: "the text ends without a patch".into() });
        }
        let fit = Fit::new(&places);
        let patch = |numbers: [[usize; 4]; 4]| Patch { points: numbers.map(|row| row.map(|at| fit.place(places[at]))) };
        let patches: Vec<Patch> = patches.into_iter().map(patch).collect();
        // Once more, by the surface: it does not reach as far as the control points.
        let parts = || (0..=SAMPLES).map(|k| Part::new(k, SAMPLES));
        let places = |patch: &Patch| {
            parts()
                .flat_map(|u| parts().map(move |v| (u, v)))
                .map(|(u, v)| units(patch.position(u, v)))
                .collect::<Vec<_>>()
        };
        let fit = Fit::new(&patches.iter().flat_map(places).collect::<Vec<_>>());
        let fitted = |patch: Patch| Patch { points: patch.points.map(|row| row.map(|at| fit.place(units(at)))) };
        Ok(Self { patches: patches.into_iter().map(fitted).collect() })
    }

    /// Triangles of which no side is further from the surface than `tolerance`. Patches that share a side have the same corners
    /// there.
    pub fn mesh(&self, tolerance: I16F16) -> Mesh {
        let mut triangles = vec![];
        for patch in &self.patches {
            let levels = [0, 1, 2, 3].map(|side| patch::level(patch.side(side), tolerance));
            let mesh = Tessellation::new(patch, levels);
            let mut corners = vec![];
            mesh.each_vertex(|vertex| {
                let texel = [vertex.u, vertex.v].map(Part::to_fixed).map(|n| n * SQUARES);
                corners.push(Corner { place: vertex.position, normal: vertex.normal, texel });
            });
            mesh.each_triangle(|numbers| triangles.push(numbers.map(|number| corners[usize::from(number)])));
        }
        // Where a side is a single point, as at the knob, triangles have no area.
        triangles.retain(|[a, b, c]| a.place != b.place && b.place != c.place && c.place != a.place);
        let mut mesh = Mesh { triangles };
        mesh.smooth();
        mesh
    }
}

fn read(line: &str, places: &mut Vec<[f64; 3]>, patches: &mut Vec<[[usize; 4]; 4]>) -> Result<(), String> {
    let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
    match words.next() {
        None => {}
        Some("v") => {
            let all: Vec<f64> = words.map(real).collect::<Result<_, _>>()?;
            let [x, y, z] = all[..] else { return Err("a control point is `v X Y Z`".into()) };
            places.push([x, z, -y]);
        }
        Some("p") => {
            let number = |word| usize::from_str(word).ok()?.checked_sub(1).filter(|&at| at < places.len());
            let known = |word| {
                number(word).ok_or_else(|| format!("{} is no control point: there are {}", quoted(word), places.len()))
            };
            let all: Vec<usize> = words.map(known).collect::<Result<_, _>>()?;
            let numbers = <[usize; 16]>::try_from(all).map_err(|_| "a patch is `p` and sixteen numbers")?;
            patches.push([0, 4, 8, 12].map(|row| [0, 1, 2, 3].map(|column| numbers[row + column])));
        }
        Some(word) => return Err(format!("{} is neither `v` nor `p`", quoted(word))),
    }
    Ok(())
}
