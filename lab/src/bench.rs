//! Families of engines on families of workloads, measured: what the report is made of.

use indicatif::ProgressBar;

use crate::{
    cost::{measured, nanoseconds, Counts},
    engine::{Entry, Origin},
    judge::{Judge, Verdict},
    workload::Workload,
};

/// One kind of shape.
pub(crate) struct Family<S: Judge> {
    pub(crate) key: &'static str,
    pub(crate) title: &'static str,
    pub(crate) entries: Vec<Entry<S, S::Drawn>>,
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

    pub(crate) fn nanoseconds_per_shape(&self) -> f64 {
        self.nanoseconds / self.shapes as f64
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
    /// The names of the children: one for each engine and each workload that it can draw.
    pub(crate) fn children(&self) -> Vec<String> {
        let pairs = self.entries.iter().flat_map(|e| self.workloads.iter().enumerate().map(move |(i, w)| (e, i, w)));
        pairs.filter(|(e, _, w)| e.can(w)).map(|(e, i, _)| self.child_name(e, i)).collect()
    }

    fn child_name(&self, entry: &Entry<S, S::Drawn>, workload: usize) -> String {
        format!("{}/{}/{workload}", self.key, entry.key)
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

    pub(crate) fn run(mut self, counts: &Counts, quick: bool, bar: &ProgressBar) -> Results {
        let row = |e: &Entry<S, S::Drawn>| Row { name: e.name, origin: e.origin, cells: Vec::new() };
        let mut rows: Vec<_> = self.entries.iter().map(row).collect();
        for (i, workload) in self.workloads.iter().enumerate() {
            let truths: Vec<_> = workload.shapes.iter().map(Judge::truth).collect();
            let children: Vec<_> = self.entries.iter().map(|e| self.child_name(e, i)).collect();
            for ((entry, row), child) in self.entries.iter_mut().zip(&mut rows).zip(&children) {
                if !entry.can(workload) {
                    row.cells.push(None);
                    continue;
                }
                bar.set_message(format!("{}: {}, {}", self.title, entry.name, workload.name));
                let instructions = counts.get(child).copied();
                row.cells.push(Some(cell(entry, workload, &truths, instructions, quick)));
                bar.inc(1);
            }
        }
        let workloads = self.workloads.iter().map(|w| w.name).collect();
        Results { key: self.key, title: self.title, workloads, rows }
    }
}

fn cell<S: Judge>(
    entry: &mut Entry<S, S::Drawn>,
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
