//! Triangulations by their rules: what crosses, how many nodes are enough, what triangles must not do.

use std::collections::{BTreeMap, BTreeSet};

use embedded_raster::{
    geom::{
        delaunay,
        triangulate::{self, SideSlot},
    },
    raster::triangle,
    FillRule, Rect, TriangulateError,
};

use super::{
    assert_runs, collect, corners,
    hits::Hits,
    shapes::{self, twice_area},
    vertices, wide, Units,
};

/// A polygon.
pub type Contours = [Vec<Units>];

/// The vertices of all contours, and where each contour but the first starts.
pub fn flat(contours: &Contours) -> (Vec<Units>, Vec<u16>) {
    let units = contours.concat();
    let mut starts = vec![];
    let mut end = 0;
    for contour in &contours[..contours.len().saturating_sub(1)] {
        end += contour.len();
        starts.push(u16::try_from(end).expect("a small polygon"));
    }
    (units, starts)
}

/// Do two sides cross at a place inside of both? By the parameters of the place, as fractions.
fn cross((a, b): (Units, Units), (c, d): (Units, Units)) -> bool {
    let ((ax, ay), (bx, by), (cx, cy), (dx, dy)) = (wide(a), wide(b), wide(c), wide(d));
    let (rx, ry, sx, sy) = (bx - ax, by - ay, dx - cx, dy - cy);
    let det = rx * sy - ry * sx;
    let (t, u) = ((cx - ax) * sy - (cy - ay) * sx, (cx - ax) * ry - (cy - ay) * rx);
    let inside = |n: i128| if det > 0 { 0 < n && n < det } else { det < n && n < 0 };
    det != 0 && inside(t) && inside(u)
}

/// The first side that crosses one before it, and the first one that it crosses, which comes first here.
pub fn first_crossing(contours: &Contours) -> Option<(usize, usize)> {
    let sides: Vec<_> = shapes::sides(contours).collect();
    (0..sides.len()).find_map(|j| (0..j).find(|&i| cross(sides[i], sides[j])).map(|i| (i, j)))
}

fn lies_between((a, b): (Units, Units), p: Units) -> bool {
    let within = |a: i32, b: i32, p: i32| a.min(b) <= p && p <= a.max(b);
    p != a && p != b && within(a.0, b.0, p.0) && within(a.1, b.1, p.1) && twice_area(a, b, p) == 0
}

/// The nodes that the documentation says are enough.
pub fn nodes(contours: &Contours) -> usize {
    let places: BTreeSet<Units> = contours.concat().into_iter().collect();
    let touches: usize =
        shapes::sides(contours).map(|side| places.iter().filter(|&&p| lies_between(side, p)).count()).sum();
    contours.concat().len() + 2 * contours.len().saturating_sub(1) + touches
}

/// By the crate, with as many nodes as the documentation says: the vertices, and triangles of their numbers.
pub fn triangulated(contours: &Contours) -> Result<(Vec<Units>, Vec<[u16; 3]>), TriangulateError> {
    let (units, starts) = flat(contours);
    let places = vertices(&units);
    let needed = nodes(contours);
    let mut triangles = vec![[u16::MAX; 3]; needed.saturating_sub(2)];
    let mut scratch = vec![SideSlot::EMPTY; needed];
    let count = triangulate::list(&places, &starts, &mut scratch, &mut triangles)?;
    triangles.truncate(count);
    Ok((units, triangles))
}

/// The corners of a triangle of numbers.
pub fn placed(units: &[Units], triangle: [u16; 3]) -> [Units; 3] {
    triangle.map(|i| units[usize::from(i)])
}

/// Triangles turn clockwise and have each side once: those that share one go along it in opposite directions.
pub fn check_mesh(units: &[Units], triangles: &[[u16; 3]], what: &dyn Fn() -> String) -> BTreeMap<(u16, u16), u16> {
    let mut sides = BTreeMap::new();
    for &[a, b, c] in triangles {
        let [pa, pb, pc] = placed(units, [a, b, c]);
        assert!(twice_area(pa, pb, pc) > 0, "{:?} has no area or turns the other way: {}", [a, b, c], what());
        for (side, far) in [((a, b), c), ((b, c), a), ((c, a), b)] {
            assert_eq!(sides.insert(side, far), None, "{side:?} is a side of two triangles: {}", what());
        }
    }
    // A side of one triangle only is one of the polygon: no vertex lies on it.
    for &(a, b) in sides.keys() {
        if !sides.contains_key(&(b, a)) {
            let side = (units[usize::from(a)], units[usize::from(b)]);
            let on = triangles.iter().flatten().find(|&&i| lies_between(side, units[usize::from(i)]));
            assert_eq!(on, None, "a corner lies on {side:?}: {}", what());
        }
    }
    sides
}

/// Each pixel of the window is painted once if it is inside, else never.
fn check_pixels(contours: &Contours, units: &[Units], triangles: &[[u16; 3]], window: Rect) {
    let mut hits = Hits::new(window);
    for &triangle in triangles {
        hits.add(&collect(window, |emit| triangle::fill(corners(placed(units, triangle)), window, emit)));
    }
    let wanted = shapes::polygon(contours, FillRule::EvenOdd, window);
    assert_runs(window, &hits.runs(), &wanted, || format!("{contours:?} as {triangles:?}"));
}

/// Every side between two triangles: the far corner of one is not in the circle of the other, unless the side cannot flip.
pub fn check_delaunay(units: &[Units], triangles: &[[u16; 3]], what: &dyn Fn() -> String) {
    let sides = check_mesh(units, triangles, what);
    for (&(a, b), &c) in &sides {
        if let Some(&d) = sides.get(&(b, a)) {
            let [a, b, c, d] = [a, b, c, d].map(|i| units[usize::from(i)]);
            assert!(determinant(a, b, c, d) <= Wide::ZERO, "{a:?} {b:?} should be {c:?} {d:?}: {}", what());
        }
    }
}

/// Everything at once; says whether there was a triangulation.
pub fn check(contours: &Contours, window: Rect) -> bool {
    let what = || format!("{contours:?}");
    let result = triangulated(contours);
    if let Some((first, second)) = first_crossing(contours) {
        assert_eq!(result, Err(TriangulateError::SidesCross { first, second }), "{}", what());
        return false;
    }
    let (units, mut triangles) = result.unwrap_or_else(|e| panic!("{e}: {}", what()));
    check_mesh(&units, &triangles, &what);
    check_pixels(contours, &units, &triangles, window);
    let area: i128 = triangles.iter().map(|&t| placed(&units, t)).map(|[a, b, c]| twice_area(a, b, c)).sum();
    delaunay::refine(&vertices(&units), &mut triangles, &mut vec![[0; 3]; units.len() * 3]).expect("it fits");
    check_delaunay(&units, &triangles, &what);
    check_pixels(contours, &units, &triangles, window);
    let refined: i128 = triangles.iter().map(|&t| placed(&units, t)).map(|[a, b, c]| twice_area(a, b, c)).sum();
    assert_eq!(area, refined, "the area: {}", what());
    true
}

/// 256-bit two's complement, high half first.
#[derive(Copy, Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Wide(i128, u128);

impl Wide {
    /// Nothing.
    pub const ZERO: Self = Self(0, 0);

    fn product(a: i128, b: i128) -> Self {
        let halves = |n: u128| (n >> 64, n & u128::from(u64::MAX));
        let ((ah, al), (bh, bl)) = (halves(a.unsigned_abs()), halves(b.unsigned_abs()));
        let (mut high, mut low) = (ah * bh, al * bl);
        for middle in [ah * bl, al * bh] {
            let (sum, carry) = low.overflowing_add(middle << 64);
            low = sum;
            high += (middle >> 64) + u128::from(carry);
        }
        let positive = Self(high as i128, low);
        if (a < 0) == (b < 0) {
            positive
        } else {
            Self(!positive.0, !positive.1).plus(Self(0, 1))
        }
    }

    fn plus(self, other: Self) -> Self {
        let (low, carry) = self.1.overflowing_add(other.1);
        Self(self.0.wrapping_add(other.0).wrapping_add(i128::from(carry)), low)
    }
}

/// The determinant of the rule, in 256 bits, expanded along another column than the crate does.
pub fn determinant(a: Units, b: Units, c: Units, d: Units) -> Wide {
    let rows = [a, b, c].map(|p| {
        let (x, y) = (wide(p).0 - wide(d).0, wide(p).1 - wide(d).1);
        (x, y, x * x + y * y)
    });
    let [a, b, c] = rows;
    // Along the first column; each minor y Q - Q y has up to 99 bits.
    let term = |x: i128, (p, q): ((i128, i128, i128), (i128, i128, i128))| Wide::product(x, p.1 * q.2 - p.2 * q.1);
    term(a.0, (b, c)).plus(term(b.0, (c, a))).plus(term(c.0, (a, b)))
}
