//! How bright thin lines are: what they cover, summed up, by their length, at each of 360 angles.

use std::path::Path;

use anyhow::{anyhow, Result};
use embedded_raster::FillRule;
use plotters::prelude::*;
use twins::rng::Rng;

use super::{entries, outline::Outline, shape::Soft};
use crate::engine::Origin;

/// Lines at each angle.
const LINES: usize = 8;
/// How long they are, in pixels.
const LENGTH: f64 = 100.0;

/// Of an engine, the least and the largest brightness, and the mean, at each angle.
pub(crate) struct Bright {
    pub(crate) name: &'static str,
    origin: Origin,
    pub(crate) degrees: Vec<[f64; 3]>,
}

impl Bright {
    /// Over all angles: least, largest, and the mean.
    pub(crate) fn all(&self) -> [f64; 3] {
        let low = self.degrees.iter().map(|d| d[0]).fold(f64::MAX, f64::min);
        let high = self.degrees.iter().map(|d| d[1]).fold(f64::MIN, f64::max);
        [low, high, self.degrees.iter().map(|d| d[2]).sum::<f64>() / self.degrees.len() as f64]
    }
}

/// Lines from places near the centre of the screen, in 1/256 pixel, and how long they are.
fn lines(degrees: usize) -> Vec<(Soft, f64)> {
    let mut rng = Rng::new(degrees as u64 + 1);
    let (sin, cos) = (degrees as f64).to_radians().sin_cos();
    let line = |_| {
        let a = (rng.int(159 * 256, 161 * 256), rng.int(119 * 256, 121 * 256));
        let away = |n: f64| (n * LENGTH * 256.0).round() as i32;
        let b = (a.0 + away(cos), a.1 + away(sin));
        let length = f64::from(b.0 - a.0).hypot(f64::from(b.1 - a.1)) / 256.0;
        (Soft::new(Outline::Line(a, b), FillRule::NonZero), length)
    };
    (0..LINES).map(line).collect()
}

pub(crate) fn measure(quick: bool) -> Vec<Bright> {
    let mut all = Vec::new();
    for mut entry in entries().into_iter().filter(|entry| entry.can_hard) {
        let mut at = |degrees: usize| {
            let mut sums = Vec::new();
            for (line, length) in lines(degrees) {
                entry.engine.clear();
                entry.engine.draw(std::slice::from_ref(&line));
                let sum: f64 = entry.engine.painted().iter().map(|&level| f64::from(level) / 255.0).sum();
                sums.push(sum / length);
            }
            let (low, high) = sums.iter().fold((f64::MAX, f64::MIN), |(l, h), &s| (l.min(s), h.max(s)));
            [low, high, sums.iter().sum::<f64>() / sums.len() as f64]
        };
        let degrees = (0..360).step_by(if quick { 30 } else { 1 }).map(&mut at).collect();
        all.push(Bright { name: entry.name, origin: entry.origin, degrees });
    }
    all
}

/// The mean brightness over the angle, a line for each engine.
pub(crate) fn draw(all: &[Bright], file: &Path) -> Result<()> {
    let failed = |e: &dyn std::fmt::Display| anyhow!("drawing {}: {e}", file.display());
    picture(all, file).map_err(|e| failed(&e))
}

fn picture(all: &[Bright], file: &Path) -> Result<(), Box<dyn std::error::Error>> {
    let root = SVGBackend::new(file, (900, 420)).into_drawing_area();
    root.fill(&WHITE)?;
    let means = all.iter().flat_map(|bright| bright.degrees.iter().map(|d| d[2]));
    let low = means.clone().fold(1.0, f64::min) - 0.02;
    let high = means.fold(1.0, f64::max) + 0.02;
    let mut chart = ChartBuilder::on(&root)
        .caption("Brightness of lines one pixel wide over their angle", ("sans-serif", 18))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(62)
        .build_cartesian_2d(0.0..360.0, low..high)?;
    chart
        .configure_mesh()
        .x_desc("degrees")
        .y_desc("pixels covered per pixel of length")
        .light_line_style(RGBColor(0xf1, 0xf1, 0xf1))
        .bold_line_style(RGBColor(0xdd, 0xdd, 0xdd))
        .draw()?;
    let peers = [
        RGBColor(0x3d, 0x4f, 0xa8),
        RGBColor(0xc0, 0x5a, 0x1c),
        RGBColor(0x8a, 0x3d, 0xa8),
        RGBColor(0x55, 0x55, 0x55),
    ];
    let mut colors = peers.into_iter().cycle();
    for bright in all {
        let own = bright.origin == Origin::Crate;
        let color = if own { RGBColor(0x0b, 0x6e, 0x4f) } else { colors.next().unwrap_or(BLACK) };
        let step = 360.0 / bright.degrees.len() as f64;
        let places: Vec<_> = bright.degrees.iter().enumerate().map(|(i, d)| (i as f64 * step, d[2])).collect();
        chart
            .draw_series([PathElement::new(places, color.stroke_width(if own { 3 } else { 1 }))])?
            .label(bright.name)
            .legend(move |(x, y)| PathElement::new(vec![(x, y), (x + 18, y)], color.stroke_width(2)));
    }
    chart.configure_series_labels().background_style(WHITE.mix(0.8)).border_style(BLACK.mix(0.2)).draw()?;
    root.present()?;
    Ok(())
}
