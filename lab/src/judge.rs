//! What an engine painted against the truth.

use std::convert::Infallible;

use embedded_graphics::{pixelcolor::BinaryColor, prelude::*};

use crate::{
    engine::{memory, triangles::given, Engine},
    frame::{Mask, HEIGHT, WIDTH, WINDOW},
    oracle::{polygon_has, sides_on_row, triangle_has, TrueLine},
    shape::{Job, Line, Polygon, Triangle, Units, ONE, SPRITE},
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
    /// Pixels: for a line the largest distance of a painted pixel from it, for a triangle how far snapping moves a corner.
    pub(crate) worst: f64,
}

impl Verdict {
    pub(crate) fn add(&mut self, other: Self) {
        self.pixels += other.pixels;
        self.wrong += other.wrong;
        self.wrong_as_given += other.wrong_as_given;
        self.worst = self.worst.max(other.worst);
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
    fn truth(&self) -> Self::Truth;
    /// Pixels that should be painted.
    fn pixels(truth: &Self::Truth) -> usize;
    /// `key` is the engine's.
    fn verdict(&self, truth: &Self::Truth, key: &str, painted: &Mask) -> Verdict;
}

impl Judge for Line {
    type Truth = Vec<(i32, i32)>;

    fn truth(&self) -> Self::Truth {
        TrueLine::new(self.a.into(), self.b.into()).pixels(WINDOW)
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
        Verdict { pixels: truth.len(), wrong: extra.max(missing), wrong_as_given: 0, worst }
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
        }
    }
}

impl Judge for Polygon {
    type Truth = Mask;

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
        let wrong = differences(truth, painted);
        Verdict { pixels: count(truth), wrong, wrong_as_given: wrong, worst: 0.0 }
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
        let wrong = differences(truth, painted);
        Verdict { pixels: count(truth), wrong, wrong_as_given: wrong, worst: 0.0 }
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
    fn errors<S: Judge>(entries: Vec<engine::Entry<S>>, workloads: &[workload::Workload<S>], key: &str) -> usize {
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
        for key in ["steps", "canvas"] {
            assert_eq!(errors(engine::lines::entries(), &workload::lines(true), key), 0, "lines by {key}");
        }
        for key in ["walk0", "walk4", "walk8", "fill", "canvas"] {
            assert_eq!(errors(engine::triangles::entries(), &workload::triangles(true), key), 0, "triangles by {key}");
        }
        assert_eq!(errors(engine::memory::entries(), &workload::memory(true), "canvas"), 0, "blits, text, one bit");
        for key in ["fill", "canvas"] {
            assert_eq!(errors(engine::polygons::entries(), &workload::polygons(true), key), 0, "polygons by {key}");
        }
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
