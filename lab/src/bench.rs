//! Families of engines on families of workloads, measured: what the report is made of.

use anyhow::Result;
use indicatif::ProgressBar;

use crate::{
    cost::{measured, nanoseconds, Counter},
    engine::{Entry, Origin},
    judge::{Judge, Verdict},
    workload::Workload,
};

/// One kind of shape.
pub(crate) struct Family<S> {
    pub(crate) key: &'static str,
    pub(crate) title: &'static str,
    pub(crate) entries: Vec<Entry<S>>,
    pub(crate) workloads: Vec<Workload<S>>,
}

/// One engine on one workload.
#[derive(Copy, Clone, Debug)]
pub(crate) struct Cell {
    pub(crate) instructions: Option<u64>,
    pub(crate) nanoseconds: f64,
    /// Shapes and pixels that were drawn for the cost.
    pub(crate) shapes: usize,
    pub(crate) pixels: usize,
    pub(crate) verdict: Verdict,
}

impl Cell {
    pub(crate) fn instructions_per_pixel(&self) -> Option<f64> {
        self.instructions.map(|n| n as f64 / self.pixels as f64)
    }

    pub(crate) fn instructions_per_shape(&self) -> Option<f64> {
        self.instructions.map(|n| n as f64 / self.shapes as f64)
    }

    pub(crate) fn nanoseconds_per_pixel(&self) -> f64 {
        self.nanoseconds / self.pixels as f64
    }
}

/// A row: an engine and a cell a workload, `None` where it sits it out.
pub(crate) struct Row {
    pub(crate) name: &'static str,
    pub(crate) origin: Origin,
    pub(crate) cells: Vec<Option<Cell>>,
}

/// A family, measured.
pub(crate) struct Results {
    pub(crate) key: &'static str,
    pub(crate) title: &'static str,
    pub(crate) workloads: Vec<&'static str>,
    pub(crate) rows: Vec<Row>,
}

impl<S: Judge> Family<S> {
    /// Engines times workloads.
    pub(crate) fn steps(&self) -> u64 {
        (self.entries.len() * self.workloads.len()) as u64
    }

    /// Draws one workload with one engine inside of `measured`, if `child` names one of this family.
    pub(crate) fn child(&mut self, child: &str) -> bool {
        let mut names = child.split('/');
        if names.next() != Some(self.key) {
            return false;
        }
        let (key, index) = (names.next(), names.next().and_then(|n| n.parse::<usize>().ok()));
        let entry = self.entries.iter_mut().find(|e| Some(e.key) == key);
        let workload = index.and_then(|i| self.workloads.get(i));
        let (Some(entry), Some(workload)) = (entry, workload) else { return false };
        // The first time costs more: pages are touched and buffers grow.
        entry.engine.draw(workload.measured());
        measured(entry.engine.as_mut(), workload.measured());
        true
    }

    pub(crate) fn run(mut self, counter: Option<&Counter>, quick: bool, bar: &ProgressBar) -> Result<Results> {
        let row = |e: &Entry<S>| Row { name: e.name, origin: e.origin, cells: Vec::new() };
        let mut rows: Vec<_> = self.entries.iter().map(row).collect();
        for (i, workload) in self.workloads.iter().enumerate() {
            let truths: Vec<_> = workload.shapes.iter().map(Judge::truth).collect();
            for (entry, row) in self.entries.iter_mut().zip(&mut rows) {
                bar.set_message(format!("{}: {}, {}", self.title, entry.name, workload.name));
                row.cells.push(if workload.far && !entry.goes_far {
                    None
                } else {
                    let child = format!("{}/{}/{i}", self.key, entry.key);
                    let instructions = counter.map(|c| c.instructions(&child)).transpose()?;
                    Some(cell(entry, workload, &truths, instructions, quick))
                });
                bar.inc(1);
            }
        }
        let workloads = self.workloads.iter().map(|w| w.name).collect();
        Ok(Results { key: self.key, title: self.title, workloads, rows })
    }
}

fn cell<S: Judge>(
    entry: &mut Entry<S>,
    workload: &Workload<S>,
    truths: &[S::Truth],
    instructions: Option<u64>,
    quick: bool,
) -> Cell {
    let engine = entry.engine.as_mut();
    let nanoseconds = nanoseconds(engine, workload.measured(), quick);
    let mut verdict = Verdict::default();
    for (shape, truth) in workload.shapes.iter().zip(truths) {
        engine.clear();
        engine.draw(std::slice::from_ref(shape));
        verdict.add(shape.verdict(truth, entry.key, &engine.painted()));
    }
    let pixels = truths[..workload.timed].iter().map(S::pixels).sum();
    Cell { instructions, nanoseconds, shapes: workload.timed, pixels, verdict }
}
