//! What drawing costs: instructions, counted by callgrind, and time.
//!
//! The lab counts by running itself: `valgrind --tool=callgrind --toggle-collect='*measured*' lab --child ...` draws one
//! workload with one engine, and only what happens inside of [`measured`] is counted.

use std::{
    collections::HashMap,
    hint::black_box,
    path::PathBuf,
    process::{Command, Stdio},
    sync::atomic::{AtomicUsize, Ordering},
    thread,
    time::{Duration, Instant},
};

use anyhow::{ensure, Context, Result};
use indicatif::ProgressBar;

use crate::engine::Engine;

/// Instructions by the name of the child.
pub(crate) type Counts = HashMap<String, u64>;

/// The function between whose entry and exit callgrind counts.
#[inline(never)]
pub(crate) fn measured<S, D>(engine: &mut dyn Engine<S, D>, shapes: &[S]) {
    engine.draw(black_box(shapes));
}

/// The same for work of any kind.
#[inline(never)]
pub(crate) fn measured_work(work: &mut dyn FnMut()) {
    work();
}

/// Nanoseconds to draw the shapes once: the median of many runs, each long enough for the clock and shorter than the slices
/// of a scheduler, so that most of them are left alone even on a busy machine.
pub(crate) fn nanoseconds<S, D>(engine: &mut dyn Engine<S, D>, shapes: &[S], quick: bool) -> f64 {
    let (runs, shortest) = if quick { (5, Duration::from_micros(100)) } else { (41, Duration::from_micros(200)) };
    let once = |engine: &mut dyn Engine<S, D>, times: u32| {
        let start = Instant::now();
        (0..times).for_each(|_| measured(engine, shapes));
        start.elapsed()
    };
    let warm = once(engine, 1).max(Duration::from_nanos(100));
    let times = (shortest.as_nanos() / warm.as_nanos() + 1) as u32;
    let mut samples: Vec<_> = (0..runs).map(|_| once(engine, times).as_nanos() as f64 / f64::from(times)).collect();
    samples.sort_unstable_by(f64::total_cmp);
    samples[samples.len() / 2]
}

/// Callgrind, if it is there.
pub(crate) struct Counter {
    program: PathBuf,
    quick: bool,
    pub(crate) version: String,
}

impl Counter {
    /// `None`, and a hint, without valgrind.
    pub(crate) fn find(quick: bool) -> Option<Self> {
        let version = Command::new("valgrind").arg("--version").output().ok().filter(|run| run.status.success());
        let Some(version) = version else {
            eprintln!("valgrind is missing: time only. To count instructions: apt-get install valgrind");
            return None;
        };
        let version = String::from_utf8_lossy(&version.stdout).trim().to_owned();
        Some(Self { program: std::env::current_exe().ok()?, quick, version })
    }

    /// Instructions of all children, by name. A count does not depend on what else runs: all processors take part.
    pub(crate) fn count(&self, children: &[String], bar: &ProgressBar) -> Result<Counts> {
        let next = AtomicUsize::new(0);
        let work = || -> Result<Counts> {
            let mut counts = Counts::new();
            while let Some(child) = children.get(next.fetch_add(1, Ordering::Relaxed)) {
                bar.set_message(format!("callgrind: {child}"));
                counts.insert(child.clone(), self.instructions(child)?);
                bar.inc(1);
            }
            Ok(counts)
        };
        thread::scope(|scope| {
            let threads = thread::available_parallelism().map_or(1, usize::from);
            let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
            let mut all = Counts::new();
            for worker in workers {
                all.extend(worker.join().expect("a worker does not panic")?);
            }
            Ok(all)
        })
    }

    fn instructions(&self, child: &str) -> Result<u64> {
        let name = format!("embedded-raster-lab-{}-{}", std::process::id(), child.replace('/', "-"));
        let output = std::env::temp_dir().join(name);
        let mut command = Command::new("valgrind");
        command.args(["--tool=callgrind", "--toggle-collect=*measured*"]);
        command.arg(format!("--callgrind-out-file={}", output.display()));
        command.arg(&self.program).args(["--child", child]).args(self.quick.then_some("--quick"));
        let run = command.stdin(Stdio::null()).output().context("running valgrind")?;
        ensure!(run.status.success(), "callgrind of {child}: {}", String::from_utf8_lossy(&run.stderr));
        let counts = std::fs::read_to_string(&output).context("reading what callgrind wrote")?;
        // Left behind in a temporary folder at worst.
        let _ = std::fs::remove_file(&output);
        total(&counts).with_context(|| format!("no total in what callgrind wrote for {child}"))
    }
}

/// The instructions in the file that callgrind writes.
fn total(counts: &str) -> Option<u64> {
    let line = counts.lines().find_map(|line| line.strip_prefix("totals: ").or(line.strip_prefix("summary: ")))?;
    line.split_whitespace().next()?.parse().ok().filter(|&count| count > 0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn totals_are_found() {
        assert_eq!(total("events: Ir\nfn=(1) x\n3 4\ntotals: 1234\n"), Some(1234));
        assert_eq!(total("summary: 56 7\n"), Some(56));
        assert_eq!(total("totals: 0\n"), None, "nothing was collected: the function was not found");
    }
}
