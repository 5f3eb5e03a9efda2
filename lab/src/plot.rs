//! Plots: error upwards, cost to the right, both in powers of ten; one panel a workload, one legend for all.

use std::path::Path;

use anyhow::{anyhow, Result};
use plotters::prelude::*;
use plotters::style::text_anchor::{HPos, Pos, VPos};

use crate::{
    bench::{Cell, Results},
    engine::Origin,
};

const PANEL: (u32, u32) = (400, 320);
const TITLE: u32 = 36;
const FONT: &str = "sans-serif";

/// What is to the right and upwards.
pub(crate) struct Axes {
    /// Whose cost it is, of a cell.
    pub(crate) per: &'static str,
    pub(crate) instructions: fn(&Cell) -> Option<f64>,
    pub(crate) nanoseconds: fn(&Cell) -> f64,
    pub(crate) unit: &'static str,
    pub(crate) error: fn(&Cell) -> f64,
    /// Errors below are drawn on this line, which is labelled 0.
    pub(crate) none: f64,
    pub(crate) most: f64,
}

/// Wrong pixels.
pub(crate) const PIXELS: Axes = Axes {
    per: "pixel",
    instructions: Cell::instructions_per_pixel,
    nanoseconds: Cell::nanoseconds_per_pixel,
    unit: "wrong pixels per million",
    error: |cell| cell.verdict.wrong_per_million(),
    none: 0.3,
    most: 3e7,
};

/// Distances of pixels.
pub(crate) const DISTANCES: Axes =
    Axes { unit: "largest distance, pixels", error: |cell| cell.verdict.distance(), none: 0.03, most: 300.0, ..PIXELS };

/// Distances of lines, which have no pixels.
pub(crate) const CURVES: Axes = Axes {
    per: "curve",
    instructions: Cell::instructions_per_shape,
    nanoseconds: Cell::nanoseconds_per_shape,
    none: 0.003,
    ..DISTANCES
};

impl Axes {
    /// Instructions, or nanoseconds where nothing was counted.
    fn cost(&self, cell: &Cell) -> f64 {
        (self.instructions)(cell).unwrap_or_else(|| (self.nanoseconds)(cell))
    }
}

/// A mark: its number in the legend, where it stands, and its colour.
struct Mark {
    number: usize,
    at: (f64, f64),
    origin: Origin,
}

fn color(origin: Origin) -> RGBColor {
    match origin {
        Origin::Textbook => RGBColor(0xc0, 0x5a, 0x1c),
        Origin::Crate => RGBColor(0x0b, 0x6e, 0x4f),
        Origin::Peer => RGBColor(0x3d, 0x4f, 0xa8),
    }
}

fn marks(results: &Results, axes: &Axes, workload: usize) -> Vec<Mark> {
    let mark = |(i, row): (usize, &crate::bench::Row)| {
        let cell = row.cells[workload]?;
        let error = (axes.error)(&cell).max(axes.none);
        Some(Mark { number: i + 1, at: (axes.cost(&cell), error), origin: row.origin })
    };
    results.rows.iter().enumerate().filter_map(mark).collect()
}

/// Writes the plot of a family.
pub(crate) fn draw(results: &Results, axes: &Axes, file: &Path) -> Result<()> {
    let panels = results.workloads.len() + 1;
    let columns = if panels == 4 { 2 } else { 3 };
    let rows = panels.div_ceil(columns);
    let size = (PANEL.0 * columns as u32, PANEL.1 * rows as u32 + TITLE);
    let root = SVGBackend::new(file, size).into_drawing_area();
    let failed = |e: &dyn std::fmt::Display| anyhow!("drawing {}: {e}", file.display());
    root.fill(&WHITE).map_err(|e| failed(&e))?;
    let title = format!("{}: error against cost (lower left is better)", results.title);
    let root = root.titled(&title, (FONT, 20)).map_err(|e| failed(&e))?;
    let areas = root.split_evenly((rows, columns));
    let counted = results.rows.iter().flat_map(|row| row.cells.iter().flatten()).all(|c| c.instructions.is_some());
    let unit = format!("{} per {}", if counted { "instructions" } else { "ns" }, axes.per);
    for (i, area) in areas.iter().enumerate().take(results.workloads.len()) {
        panel(area, results.workloads[i], &unit, axes, &marks(results, axes, i)).map_err(|e| failed(&e))?;
    }
    legend(&areas[results.workloads.len()], results).map_err(|e| failed(&e))?;
    root.present().map_err(|e| failed(&e))
}

type Area<'a> = DrawingArea<SVGBackend<'a>, plotters::coord::Shift>;

/// Powers of ten around the values.
fn decades(values: impl Iterator<Item = f64> + Clone) -> std::ops::Range<f64> {
    let low = values.clone().fold(f64::MAX, f64::min).log10().floor();
    let high = values.fold(0.0, f64::max).log10().ceil();
    10_f64.powf(low) * 0.8..10_f64.powf(high.max(low + 1.0)) * 1.25
}

fn plain_number(value: f64) -> String {
    match value {
        v if v >= 1e6 => format!("{}M", v / 1e6),
        v if v >= 1e3 => format!("{}k", v / 1e3),
        v => format!("{v}"),
    }
}

fn panel(
    area: &Area<'_>,
    title: &str,
    unit: &str,
    axes: &Axes,
    marks: &[Mark],
) -> Result<(), Box<dyn std::error::Error>> {
    let costs = decades(marks.iter().map(|m| m.at.0));
    let mut chart = ChartBuilder::on(area)
        .caption(title, (FONT, 16))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(62)
        .build_cartesian_2d(costs.log_scale(), (axes.none * 0.6..axes.most).log_scale())?;
    chart
        .configure_mesh()
        .x_desc(unit)
        .y_desc(axes.unit)
        .axis_desc_style((FONT, 13))
        .label_style((FONT, 12))
        .light_line_style(RGBColor(0xf1, 0xf1, 0xf1))
        .bold_line_style(RGBColor(0xdd, 0xdd, 0xdd))
        .x_labels(5)
        .y_labels(7)
        .x_label_formatter(&|v| plain_number(*v))
        .y_label_formatter(&|v| plain_number(*v))
        .draw()?;
    // The line of those that make no error.
    let (left, right) = (chart.as_coord_spec().get_x_range().start, chart.as_coord_spec().get_x_range().end);
    chart.draw_series([PathElement::new(
        vec![(left, axes.none), (right, axes.none)],
        RGBColor(0x0b, 0x6e, 0x4f).mix(0.5),
    )])?;
    let (x0, y0) = chart.as_coord_spec().translate(&(left, axes.none));
    let style = TextStyle::from((FONT, 12).into_font()).pos(Pos::new(HPos::Right, VPos::Center));
    let (base_x, base_y) = area.get_base_pixel();
    area.draw(&Text::new("0", (x0 - base_x - 8, y0 - base_y), style))?;
    let places: Vec<_> = marks.iter().map(|m| chart.as_coord_spec().translate(&m.at)).collect();
    let places: Vec<_> = places.into_iter().map(|(x, y)| (x - base_x, y - base_y)).collect();
    draw_marks(area, marks, &places)
}

/// Dots at their places, numbers above them; a number that would hide another moves up.
fn draw_marks(area: &Area<'_>, marks: &[Mark], places: &[(i32, i32)]) -> Result<(), Box<dyn std::error::Error>> {
    let mut taken: Vec<(i32, i32)> = Vec::new();
    for (mark, &(x, y)) in marks.iter().zip(places) {
        let color = color(mark.origin);
        area.draw(&Circle::new((x, y), 4, color.filled()))?;
        let mut label = (x, y - 12);
        while taken.iter().any(|t| (t.0 - label.0).abs() < 15 && (t.1 - label.1).abs() < 13) {
            label.1 -= 13;
        }
        taken.push(label);
        let style = TextStyle::from((FONT, 13).into_font()).color(&color).pos(Pos::new(HPos::Center, VPos::Center));
        area.draw(&Text::new(mark.number.to_string(), label, style))?;
    }
    Ok(())
}

fn legend(area: &Area<'_>, results: &Results) -> Result<(), Box<dyn std::error::Error>> {
    let mut y = 44;
    for (i, row) in results.rows.iter().enumerate() {
        let color = color(row.origin);
        let style = |pos| TextStyle::from((FONT, 14).into_font()).color(&color).pos(Pos::new(pos, VPos::Center));
        area.draw(&Circle::new((30, y), 4, color.filled()))?;
        area.draw(&Text::new((i + 1).to_string(), (60, y), style(HPos::Right)))?;
        area.draw(&Text::new(row.name.replace('`', ""), (70, y), style(HPos::Left)))?;
        y += 24;
    }
    Ok(())
}
