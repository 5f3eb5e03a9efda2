//! Pictures stretched and under maps, as this crate draws them and as the peers do: what a pixel costs, and how many pixels have another
//! texel than the one under their centre, of exact ratios.
//!
//! `cargo run --release -p lab --features peers-pictures -- --pictures` prints it.

mod own;
mod peers;

use std::{fmt::Write, hint::black_box, time::Instant};

use anyhow::Result;
use embedded_raster::{fixed::types::I16F16, Affine, Angle, Rect};
use indicatif::ProgressBar;
use twins::{pictures::texel, rng::Rng};

use crate::{
    cost::{measured_work, Counter},
    frame::{HEIGHT, WIDTH},
};

/// Columns and rows of the picture.
const SIDE: u16 = 64;

/// Runs of each; the best one counts, as what disturbs a run only makes it longer.
const RUNS: usize = 201;

/// Pictures that are judged.
const JUDGED: usize = 300;

/// Column and row of the texel that a pixel shows; `None` where nothing was drawn.
type Texel = Option<(i32, i32)>;

/// How the picture is drawn.
#[derive(Copy, Clone, Debug)]
enum Job {
    /// Stretched to a box.
    Stretched(Rect),
    /// Under a map.
    Mapped(Affine),
}

impl Job {
    /// What each pixel of the screen should show.
    fn truth(&self) -> Vec<Texel> {
        let side = i32::from(SIDE);
        let along = |at: i32, low: i32, high: i32| (2 * (at - low) + 1) * side / (2 * (high - low));
        let at = |x: i32, y: i32| match self {
            Self::Stretched(to) => to.contains(x, y).then(|| (along(x, to.x0, to.x1), along(y, to.y0, to.y1))),
            Self::Mapped(map) => texel(map, (SIDE.into(), SIDE.into()), (x, y)),
        };
        (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y))).map(|(x, y)| at(x, y)).collect()
    }

    /// The map of floats that peers are given: `[xx, yx, xy, yy, dx, dy]`.
    #[cfg(feature = "peers-pictures")]
    fn floats(&self) -> [f32; 6] {
        match self {
            Self::Stretched(to) => {
                let by = |low: i32, high: i32| (high - low) as f32 / f32::from(SIDE);
                [by(to.x0, to.x1), 0.0, 0.0, by(to.y0, to.y1), to.x0 as f32, to.y0 as f32]
            }
            Self::Mapped(map) => [map.xx, map.yx, map.xy, map.yy, map.dx, map.dy].map(I16F16::to_num),
        }
    }
}

/// A way to draw the picture on a screen of its own.
trait Way {
    fn name(&self) -> &'static str;
    /// Whether it has a call for that.
    fn can(&self, job: &Job) -> bool;
    fn clear(&mut self);
    fn draw(&mut self, job: &Job);
    /// `None` if its colours do not say it.
    fn texels(&self) -> Option<Vec<Texel>>;
}

fn ways() -> Vec<Box<dyn Way>> {
    own::ways().into_iter().chain(peers::ways()).collect()
}

/// A picture turned and scaled about its middle, which is moved to a place.
fn turned(scale: f64, turns: f64, at: (f64, f64)) -> Affine {
    let number = |n: f64| I16F16::from_num(n);
    let middle = number(f64::from(SIDE) / -2.0);
    Affine::translate(middle, middle)
        .then(Affine::scale(number(scale), number(scale)))
        .then(Affine::rotate(Angle::from_bits((turns * 4_294_967_296.0) as u32)))
        .then(Affine::translate(number(at.0), number(at.1)))
}

/// What costs are measured of.
fn measured() -> [(&'static str, Job); 5] {
    let middle = (f64::from(WIDTH) / 2.0, f64::from(HEIGHT) / 2.0);
    [
        ("twice as large", Job::Stretched(Rect::new(77, 41, 77 + 128, 41 + 128))),
        ("192 x 150", Job::Stretched(Rect::new(61, 33, 61 + 192, 33 + 150))),
        ("40 x 30", Job::Stretched(Rect::new(101, 99, 101 + 40, 99 + 30))),
        ("turned by 30 degrees", Job::Mapped(turned(1.0, 1.0 / 12.0, middle))),
        ("turned, 2.3 times as large", Job::Mapped(turned(2.3, 1.0 / 12.0, middle))),
    ]
}

/// What is judged: boxes, or maps, of which some lie on whole pixels, as those of programs do.
fn judged(are_boxes: bool, quick: bool) -> Vec<Job> {
    let mut rng = Rng::new(16);
    let count = if quick { JUDGED / 10 } else { JUDGED };
    let jobs = (0..count).map(|i| {
        let (x, y) = (rng.int(-40, WIDTH - 20), rng.int(-40, HEIGHT - 20));
        if are_boxes {
            return Job::Stretched(Rect::new(x, y, x + rng.int(1, 300), y + rng.int(1, 220)));
        }
        let mut unit = || f64::from(rng.int(0, 1 << 20)) / f64::from(1 << 20);
        let (scale, turns) = (0.3 + 3.0 * unit(), unit());
        if i % 3 == 0 {
            // By whole numbers of degrees, at the middles of pixels.
            let degrees = (turns * 360.0).round();
            return Job::Mapped(turned((scale * 2.0).ceil() / 2.0, degrees / 360.0, (f64::from(x), f64::from(y))));
        }
        Job::Mapped(turned(scale, turns, (f64::from(x) + unit(), f64::from(y) + unit())))
    });
    jobs.collect()
}

fn child_name(way: &dyn Way, job: &str) -> String {
    format!("pictures/{}/{job}", way.name())
}

/// Draws what callgrind is to count, if there is something of this name.
pub(crate) fn child(name: &str) -> bool {
    for mut way in ways() {
        for (job_name, job) in measured() {
            if way.can(&job) && child_name(way.as_ref(), job_name) == name {
                // The first time costs more: pages are touched.
                way.draw(&job);
                measured_work(&mut || way.draw(black_box(&job)));
                return true;
            }
        }
    }
    false
}

fn nanoseconds(way: &mut dyn Way, job: &Job, quick: bool) -> f64 {
    let runs = if quick { 11 } else { RUNS };
    let once = |_| {
        let start = Instant::now();
        (0..4).for_each(|_| way.draw(black_box(job)));
        start.elapsed().as_nanos() as f64 / 4.0
    };
    (0..runs).map(once).fold(f64::INFINITY, f64::min)
}

/// Pixels that are drawn and should not be, or the other way round; pixels that show another texel; and all that should be drawn.
fn wrong(way: &mut dyn Way, jobs: &[Job]) -> Option<(usize, usize, usize)> {
    let (mut edges, mut others, mut all) = (0, 0, 0);
    for job in jobs {
        way.clear();
        way.draw(job);
        for (got, wanted) in way.texels()?.into_iter().zip(job.truth()) {
            all += usize::from(wanted.is_some());
            edges += usize::from(got.is_some() != wanted.is_some());
            others += usize::from(got.is_some() && wanted.is_some() && got != wanted);
        }
    }
    Some((edges, others, all))
}

/// Two tables: what a pixel costs, and what is wrong.
pub(crate) fn report(counter: Option<&Counter>, quick: bool) -> Result<String> {
    let (mut ways, jobs) = (ways(), measured());
    let pairs = || ways.iter().flat_map(|way| jobs.iter().map(move |job| (way, job)));
    let children: Vec<_> =
        pairs().filter(|(way, (_, job))| way.can(job)).map(|(way, (name, _))| child_name(way.as_ref(), name)).collect();
    let bar = ProgressBar::new(children.len() as u64);
    let counts = counter.map(|counter| counter.count(&children, &bar)).transpose()?.unwrap_or_default();
    bar.finish_and_clear();
    let mut text = String::from(
        "A picture of 64 x 64 pixels, stretched or under a map, with the nearest texel: nanoseconds a pixel (instructions a pixel).\n\n|  |",
    );
    for (name, _) in &jobs {
        let _ = write!(text, " {name} |");
    }
    let _ = write!(text, "\n|---|{}", "---:|".repeat(jobs.len()));
    for way in &mut ways {
        let _ = write!(text, "\n| {} |", way.name());
        for (name, job) in &jobs {
            if !way.can(job) {
                text += " |";
                continue;
            }
            let pixels = job.truth().iter().flatten().count() as f64;
            let counted = counts.get(&child_name(way.as_ref(), name));
            let instructions = counted.map_or(String::new(), |&n| format!(" ({:.1})", n as f64 / pixels));
            let _ = write!(text, " {:.2}{instructions} |", nanoseconds(way.as_mut(), job, quick) / pixels);
        }
    }
    text += "\n\nOf a million pixels: at the edge drawn and should not be, or not drawn and should be; with another texel than that under \
             the centre.\n\n|  | stretched: edge | texel | under a map: edge | texel |\n|---|---:|---:|---:|---:|";
    for way in &mut ways {
        let _ = write!(text, "\n| {} |", way.name());
        for jobs in [judged(true, quick), judged(false, quick)] {
            let found = if way.can(&jobs[0]) { wrong(way.as_mut(), &jobs) } else { None };
            let Some((edges, others, all)) = found else {
                text += " | |";
                continue;
            };
            let share = |n: usize| n as f64 * 1e6 / all as f64;
            let _ = write!(text, " {:.0} | {:.0} |", share(edges), share(others));
        }
    }
    Ok(text)
}
