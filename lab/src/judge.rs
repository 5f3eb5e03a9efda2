//! What an engine painted against the truth.

use std::convert::Infallible;

use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};
use embedded_raster::raster::flood::Connectivity;
use twins::letters::Letters;

use crate::{
    engine::{memory, triangles::given, Engine},
    frame::{Mask, HEIGHT, WIDTH, WINDOW},
    oracle::{chords, distance_to, polygon_has, sides_on_row, stroke_has, triangle_has, Side, TrueLine},
    shape::{Blob, Curve, Job, Line, Oval, Polygon, Pool, Thick, Thin, Triangle, Units, ONE, SPRITE},
    workload::Mesh,
};

/// Errors, added up over shapes.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Verdict {
    /// Pixels that should be painted.
    pub(crate) pixels: usize,
    /// Pixels that are painted and should not be, and the other way round. A pixel of a line painted beside its place
    /// counts once.
    pub(crate) wrong: usize,
    /// The same against the shape as the engine was given it, after snapping.
    pub(crate) wrong_as_given: usize,
    /// Pixels: for a line or a curve the largest distance of a painted pixel from it, for a triangle how far snapping moves a
    /// corner. For what is shaded, how far the worst value is off.
    pub(crate) worst: f64,
    /// Pixels: the largest distance of a place on a curve from what was painted.
    pub(crate) left_out: f64,
    /// Lines that a curve became.
    pub(crate) lines: usize,
    /// Shapes that were judged.
    pub(crate) shapes: usize,
    /// Values of shaded pixels that were judged.
    pub(crate) values: usize,
    /// Those of them that are not the nearest ones.
    pub(crate) not_nearest: usize,
    /// How far values are off, in all.
    pub(crate) off: f64,
}

impl Verdict {
    pub(crate) fn add(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.wrong += other.wrong;
        self.wrong_as_given += other.wrong_as_given;
        self.worst = self.worst.max(other.worst);
        self.left_out = self.left_out.max(other.left_out);
        self.lines += other.lines;
        self.shapes += 1;
        self.values += other.values;
        self.not_nearest += other.not_nearest;
        self.off += other.off;
    }

    /// How far a value is off in the mean.
    pub(crate) fn mean(self) -> f64 {
        self.off / self.values.max(1) as f64
    }

    /// The larger of the two distances: none of two shapes has a place that is further from the other.
    pub(crate) fn distance(self) -> f64 {
        self.worst.max(self.left_out)
    }

    pub(crate) fn wrong_per_million(self) -> f64 {
        per_million(self.wrong, self.pixels)
    }
}

pub(crate) fn per_million(part: usize, whole: usize) -> f64 {
    part as f64 * 1e6 / whole.max(1) as f64
}

/// A shape that knows what it should look like.
pub(crate) trait Judge {
    type Truth;
    /// What its engines leave.
    type Drawn;
    fn truth(&self) -> Self::Truth;
    /// Pixels that should be painted.
    fn pixels(truth: &Self::Truth) -> usize;
    /// `key` is the engine's.
    fn verdict(&self, truth: &Self::Truth, key: &str, drawn: &Self::Drawn) -> Verdict;
}

impl Judge for Line {
    type Truth = Vec<(i32, i32)>;
    type Drawn = Mask;

    fn truth(&self) -> Self::Truth {
        twins::line(self.a.into(), self.b.into(), WINDOW)
    }

    fn pixels(truth: &Self::Truth) -> usize {
        truth.len()
    }

    fn verdict(&self, truth: &Self::Truth, _: &str, painted: &Mask) -> Verdict {
        let line = TrueLine::new(self.a.into(), self.b.into());
        let extra = painted.pixels().filter(|&(x, y)| !line.is_nearest(x, y)).count();
        // Where two pixels are equally near either will do.
        let nearest = |(x, y)| painted.has(x, y) && line.is_nearest(x, y);
        let missing = truth.iter().filter(|&&p| ![-1, 0, 1].iter().any(|&step| nearest(line.beside(p, step)))).count();
        let worst = painted.pixels().map(|(x, y)| line.distance(x, y)).fold(0.0, f64::max);
        Verdict { pixels: truth.len(), wrong: extra.max(missing), worst, ..Verdict::default() }
    }
}

/// The pixels of a triangle.
fn triangle_mask(corners: [Units; 3]) -> Mask {
    let bounds = |values: [i64; 3]| {
        let pixel = |v: Option<i64>| v.unwrap_or_default().div_euclid(ONE) as i32;
        pixel(values.into_iter().min())..=pixel(values.into_iter().max())
    };
    let (columns, rows) = (bounds(corners.map(|u| u.0)), bounds(corners.map(|u| u.1)));
    let inside = |x: i32, y: i32| rows.contains(&y) && columns.contains(&x) && triangle_has(corners, x, y);
    Mask::from_pixels((0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| inside(x, y)))
}

fn count(mask: &Mask) -> usize {
    mask.bits().iter().filter(|&&bit| bit).count()
}

fn differences(a: &Mask, b: &Mask) -> usize {
    a.bits().iter().zip(b.bits()).filter(|(a, b)| a != b).count()
}

impl Judge for Triangle {
    type Truth = Mask;
    type Drawn = Mask;

    fn truth(&self) -> Mask {
        triangle_mask(self.units)
    }

    fn pixels(truth: &Mask) -> usize {
        count(truth)
    }

    fn verdict(&self, truth: &Mask, key: &str, painted: &Mask) -> Verdict {
        let given = given(key, self);
        let moved = |(a, b): (&Units, &Units)| ((a.0 - b.0) as f64).hypot((a.1 - b.1) as f64) / ONE as f64;
        Verdict {
            pixels: count(truth),
            wrong: differences(truth, painted),
            wrong_as_given: differences(&triangle_mask(given), painted),
            worst: given.iter().zip(&self.units).map(moved).fold(0.0, f64::max),
            ..Verdict::default()
        }
    }
}

impl Judge for Polygon {
    type Truth = Mask;
    type Drawn = Mask;

    fn truth(&self) -> Mask {
        let row = |y| {
            let sides = sides_on_row(&self.units, y);
            (0..WIDTH).map(move |x| polygon_has(&sides, x, y))
        };
        Mask::from_pixels((0..HEIGHT).flat_map(row))
    }

    fn pixels(truth: &Mask) -> usize {
        count(truth)
    }

    fn verdict(&self, truth: &Mask, _: &str, painted: &Mask) -> Verdict {
        compared(truth, painted)
    }
}

/// What was painted against what should be.
fn compared(truth: &Mask, painted: &Mask) -> Verdict {
    let wrong = differences(truth, painted);
    Verdict { pixels: count(truth), wrong, wrong_as_given: wrong, ..Verdict::default() }
}

impl Judge for Oval {
    type Truth = Mask;
    type Drawn = Mask;

    /// The centres inside of the curve or on it.
    fn truth(&self) -> Mask {
        let inside = |x: i32, y: i32| twins::box_ellipse_has(self.area, x, y);
        Mask::from_pixels((0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| inside(x, y)))
    }

    fn pixels(truth: &Mask) -> usize {
        count(truth)
    }

    fn verdict(&self, truth: &Mask, _: &str, painted: &Mask) -> Verdict {
        compared(truth, painted)
    }
}

impl Judge for Pool {
    type Truth = Mask;
    type Drawn = Mask;

    /// Breadth first.
    fn truth(&self) -> Mask {
        let picture = Letters::new(WIDTH, HEIGHT, |i| !self.walls[i as usize]);
        let flooded = picture.flooded((self.seed.x, self.seed.y), Connectivity::Sides);
        Mask::from_pixels(flooded.pixels.iter().zip(&picture.pixels).map(|(now, before)| now != before))
    }

    fn pixels(truth: &Mask) -> usize {
        count(truth)
    }

    fn verdict(&self, truth: &Mask, _: &str, painted: &Mask) -> Verdict {
        compared(truth, painted)
    }
}

/// Lines that a curve became: the ends of each, in pixels.
pub(crate) type Polyline = Vec<(f64, f64)>;

impl Judge for Curve {
    type Truth = Polyline;
    type Drawn = Polyline;

    fn truth(&self) -> Polyline {
        chords(self.units)
    }

    fn pixels(truth: &Polyline) -> usize {
        steps(truth.windows(2))
    }

    fn verdict(&self, truth: &Polyline, _: &str, drawn: &Polyline) -> Verdict {
        // Seven places on every line beside its ends.
        let between = |line: &[(f64, f64)]| {
            let [a, b] = [line[0], line[1]];
            (1..=8).map(move |i| f64::from(i) / 8.0).map(move |t| (a.0 + (b.0 - a.0) * t, a.1 + (b.1 - a.1) * t))
        };
        let off = |p| distance_to(p, truth.windows(2));
        let worst = drawn.windows(2).flat_map(between).map(off).fold(off(drawn[0]), f64::max);
        let left_out = truth.iter().map(|&p| distance_to(p, drawn.windows(2))).fold(0.0, f64::max);
        Verdict { worst, left_out, lines: drawn.len() - 1, ..Verdict::default() }
    }
}

/// How many pixels a line one pixel wide has along these, as far as they are on the screen: steps along the longer axis.
fn steps<'a>(lines: impl Iterator<Item = &'a [(f64, f64)]>) -> usize {
    let on_screen = |p: (f64, f64)| WINDOW.contains(p.0.floor() as i32, p.1.floor() as i32);
    let step = |l: &[(f64, f64)]| (l[1].0 - l[0].0).abs().max((l[1].1 - l[0].1).abs());
    lines.filter(|line| on_screen(line[0])).map(step).sum::<f64>().round() as usize
}

impl Judge for Thin {
    /// Only what lies near the screen.
    type Truth = Vec<[(f64, f64); 2]>;
    type Drawn = Mask;

    fn truth(&self) -> Self::Truth {
        let chords = chords(self.curve.units);
        let near = |v: f64, size: i32| (-4.0..f64::from(size) + 4.0).contains(&v);
        let near = |line: &&[(f64, f64)]| line.iter().any(|p| near(p.0, WIDTH) && near(p.1, HEIGHT));
        chords.windows(2).filter(near).map(|line| [line[0], line[1]]).collect()
    }

    fn pixels(truth: &Self::Truth) -> usize {
        steps(truth.iter().map(|line| &line[..]))
    }

    fn verdict(&self, truth: &Self::Truth, _: &str, painted: &Mask) -> Verdict {
        let centre = |(x, y): (i32, i32)| (f64::from(x) + 0.5, f64::from(y) + 0.5);
        let off = |p| distance_to(p, truth.iter().map(|line| &line[..]));
        let worst = painted.pixels().map(|p| off(centre(p))).fold(0.0, f64::max);
        // Places on the screen, not so near its border that their pixel may lie beyond.
        let inside = |p: &(f64, f64)| {
            (1.0..f64::from(WIDTH) - 1.0).contains(&p.0) && (1.0..f64::from(HEIGHT) - 1.0).contains(&p.1)
        };
        let nearest = |p: (f64, f64)| {
            let away = |q: (i32, i32)| (centre(q).0 - p.0).hypot(centre(q).1 - p.1);
            let (x, y) = (p.0.floor() as i32, p.1.floor() as i32);
            let near = (y - 3..=y + 3).flat_map(|y| (x - 3..=x + 3).map(move |x| (x, y)));
            near.filter(|&(x, y)| painted.has(x, y)).map(away).fold(f64::INFINITY, f64::min)
        };
        let left_out =
            truth.iter().map(|line| line[0]).filter(inside).map(|p| nearest(p).min(MOST)).fold(0.0, f64::max);
        Verdict { pixels: Self::pixels(truth), worst, left_out, ..Verdict::default() }
    }
}

/// What is further away than this counts as this far.
const MOST: f64 = 4.0;

impl Judge for Blob {
    type Truth = Mask;
    type Drawn = Mask;

    /// The centres inside of the chords by the even-odd rule.
    fn truth(&self) -> Mask {
        let unit = |v: f64| (v * ONE as f64).round() as i64;
        let units = |curve: &Curve| chords(curve.units).into_iter().skip(1).map(move |(x, y)| (unit(x), unit(y)));
        let outline: Vec<Units> = self.curves.iter().flat_map(units).collect();
        Mask::from_pixels((0..HEIGHT).flat_map(|y| {
            let sides = sides_on_row(&outline, y);
            (0..WIDTH).map(move |x| polygon_has(&sides, x, y))
        }))
    }

    fn pixels(truth: &Mask) -> usize {
        count(truth)
    }

    fn verdict(&self, truth: &Mask, _: &str, painted: &Mask) -> Verdict {
        compared(truth, painted)
    }
}

impl Judge for Thick {
    /// Pixels inside, and pixels inside or exactly on the border, which may be painted or not.
    type Truth = [Mask; 2];
    type Drawn = Mask;

    fn truth(&self) -> [Mask; 2] {
        let side = |x: i32, y: i32| {
            let has = |l: &[Point]| stroke_has(l[0].into(), l[1].into(), self.width, self.round, x, y);
            self.pixels.windows(2).map(has).max().unwrap_or(Side::Outside)
        };
        let sides: Vec<_> =
            (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| side(x, y)).collect();
        [Side::Inside, Side::Border].map(|least| Mask::from_pixels(sides.iter().map(|&side| side >= least)))
    }

    fn pixels([inside, _]: &[Mask; 2]) -> usize {
        count(inside)
    }

    fn verdict(&self, [inside, border]: &[Mask; 2], _: &str, painted: &Mask) -> Verdict {
        let missing = inside.pixels().filter(|&(x, y)| !painted.has(x, y)).count();
        let extra = painted.pixels().filter(|&(x, y)| !border.has(x, y)).count();
        let wrong = missing + extra;
        Verdict { pixels: count(inside), wrong, wrong_as_given: wrong, ..Verdict::default() }
    }
}

/// Keeps which pixels are painted, one by one: the truth of text is what its own library sets pixel by pixel.
struct Pixels(Vec<bool>);

impl OriginDimensions for Pixels {
    fn size(&self) -> Size {
        Size::new(WIDTH as u32, HEIGHT as u32)
    }
}

impl DrawTarget for Pixels {
    type Color = BinaryColor;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<BinaryColor>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(p, color) in pixels.into_iter().filter(|pixel| WINDOW.contains(pixel.0.x, pixel.0.y)) {
            self.0[(p.y * WIDTH + p.x) as usize] = color.is_on();
        }
        Ok(())
    }
}

impl Judge for Job {
    type Truth = Mask;
    type Drawn = Mask;

    fn truth(&self) -> Mask {
        let sprite = |at: Point, x: i32, y: i32| {
            let inside = (0..SPRITE).contains(&(x - at.x)) && (0..SPRITE).contains(&(y - at.y));
            inside && Self::sprite_has(x - at.x, y - at.y)
        };
        let all = |has: &dyn Fn(i32, i32) -> bool| {
            Mask::from_pixels((0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| has(x, y)))
        };
        match self {
            Self::BitLine(line) => {
                let pixels = line.truth();
                all(&|x, y| pixels.contains(&(x, y)))
            }
            Self::BitRectangle(area) => all(&|x, y| area.contains(x, y)),
            Self::BitTriangle(triangle) => triangle_mask(given("canvas", triangle)),
            Self::Blit(at) | Self::BlitKeyed(at) => all(&|x, y| sprite(*at, x, y)),
            Self::Text(at) | Self::Glyphs(at) => {
                let mut pixels = Pixels(vec![false; (WIDTH * HEIGHT) as usize]);
                memory::text(&mut pixels, *at, BinaryColor::On, BinaryColor::Off);
                Mask::from_pixels(pixels.0.into_iter())
            }
        }
    }

    fn pixels(truth: &Mask) -> usize {
        count(truth)
    }

    fn verdict(&self, truth: &Mask, key: &str, painted: &Mask) -> Verdict {
        if let Self::BitLine(line) = self {
            return line.verdict(&line.truth(), key, painted);
        }
        compared(truth, painted)
    }
}

/// Pixels of the screen that no triangle of a mesh painted, and pixels that several did.
#[derive(Copy, Clone, Debug, Default)]
pub(crate) struct Cover {
    pub(crate) pixels: usize,
    pub(crate) gaps: usize,
    pub(crate) doubles: usize,
}

pub(crate) fn cover(engine: &mut dyn Engine<Triangle>, mesh: &Mesh) -> Cover {
    let mut sum = Cover::default();
    for triangles in &mesh.covers {
        let mut hits = vec![0_u32; (WIDTH * HEIGHT) as usize];
        for triangle in triangles {
            engine.clear();
            engine.draw(std::slice::from_ref(triangle));
            hits.iter_mut().zip(engine.painted().bits()).for_each(|(hits, &bit)| *hits += u32::from(bit));
        }
        sum.pixels += hits.len();
        sum.gaps += hits.iter().filter(|&&n| n == 0).count();
        sum.doubles += hits.iter().filter(|&&n| n > 1).count();
    }
    sum
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{engine, workload};

    /// Draws the first shapes of every workload and adds up the errors of one engine.
    fn errors<S: Judge<Drawn = Mask>>(
        entries: Vec<engine::Entry<S>>,
        workloads: &[workload::Workload<S>],
        key: &str,
    ) -> usize {
        let mut entry = entries.into_iter().find(|e| e.key == key).expect("an engine of this name");
        let mut wrong = 0;
        for shape in workloads.iter().flat_map(|w| w.shapes.iter().take(6)) {
            entry.engine.clear();
            entry.engine.draw(std::slice::from_ref(shape));
            wrong += shape.verdict(&shape.truth(), key, &entry.engine.painted()).wrong_as_given;
        }
        wrong
    }

    #[test]
    fn the_crate_is_exact() {
        for key in ["spans", "canvas"] {
            assert_eq!(errors(engine::lines::entries(), &workload::lines(true), key), 0, "lines by {key}");
        }
        for key in ["walk0", "walk4", "walk8", "fill", "canvas"] {
            assert_eq!(errors(engine::triangles::entries(), &workload::triangles(true), key), 0, "triangles by {key}");
        }
        for key in ["fill", "canvas"] {
            assert_eq!(errors(engine::ellipses::entries(), &workload::ellipses(true), key), 0, "ellipses by {key}");
        }
        for key in ["stack", "runs", "canvas64", "canvas4", "canvas1"] {
            assert_eq!(errors(engine::floods::entries(), &workload::floods(true), key), 0, "floods by {key}");
        }
        assert_eq!(errors(engine::memory::entries(), &workload::memory(true), "canvas"), 0, "blits, text, one bit");
        for key in ["fill", "canvas"] {
            assert_eq!(errors(engine::polygons::entries(), &workload::polygons(true), key), 0, "polygons by {key}");
        }
    }

    /// Judges the first shapes of every workload that is not far away.
    fn verdict<S: Judge>(
        entries: Vec<engine::Entry<S, S::Drawn>>,
        workloads: &[workload::Workload<S>],
        key: &str,
    ) -> Verdict {
        let mut entry = entries.into_iter().find(|e| e.key == key).expect("an engine of this name");
        let mut all = Verdict::default();
        for shape in workloads.iter().flat_map(|w| w.shapes.iter().take(3)) {
            entry.engine.clear();
            entry.engine.draw(std::slice::from_ref(shape));
            all.add(shape.verdict(&shape.truth(), key, &entry.engine.painted()));
        }
        all
    }

    #[test]
    fn curves_and_strokes_keep_their_promises() {
        for key in ["crate", "halves"] {
            let lines = verdict(engine::curves::entries(), &workload::curves(true), key);
            assert!(lines.distance() < 34.5 / 256.0, "{key}: {lines:?}");
        }
        for key in ["draw", "canvas"] {
            let thin = verdict(engine::outlines::entries(), &workload::outlines(true), key);
            assert!(thin.worst < 0.75 && thin.left_out < 1.5, "outlines by {key}: {thin:?}");
        }
        for key in ["fill", "canvas"] {
            let paths = verdict(engine::paths::entries(), &workload::paths(true), key);
            assert!(paths.wrong_per_million() < 2_000.0, "paths by {key}: {paths:?}");
        }
        for key in ["pieces", "canvas"] {
            let strokes = verdict(engine::strokes::entries(), &workload::strokes(true), key);
            assert!(strokes.wrong_per_million() < 4_000.0, "strokes by {key}: {strokes:?}");
        }
        let strokes = verdict(engine::strokes::entries(), &workload::strokes(true), "distance");
        assert_eq!(strokes.wrong, 0, "distances in f32");
    }

    #[test]
    fn textbook_engines_draw_the_same_shapes_nearly() {
        assert_eq!(errors(engine::lines::entries(), &workload::lines(true)[..2], "bresenham"), 0);
        assert!(errors(engine::triangles::entries(), &workload::triangles(true)[..3], "float") < 9, "f32 barycentric");
        assert!(errors(engine::polygons::entries(), &workload::polygons(true)[..2], "float") < 9, "f32 crossings");
    }

    #[test]
    fn a_line_beside_its_place_is_wrong_once_a_pixel() {
        let line = Line::new((2, 5), (9, 5));
        let beside = Mask::from_pixels((0..WIDTH * HEIGHT).map(|i| i / WIDTH == 6 && (2..=9).contains(&(i % WIDTH))));
        let verdict = line.verdict(&line.truth(), "", &beside);
        assert_eq!((verdict.pixels, verdict.wrong), (8, 8));
        assert!((verdict.worst - 1.0).abs() < 1e-12, "a pixel away");
    }

    #[test]
    fn meshes_cover_the_screen_once() {
        let mut entries = engine::triangles::entries();
        let fill = entries.iter_mut().find(|e| e.key == "fill").expect("the span solver");
        for mesh in workload::meshes(true) {
            let cover = cover(fill.engine.as_mut(), &mesh);
            assert_eq!((cover.gaps, cover.doubles), (0, 0), "{}", mesh.name);
        }
    }
}
