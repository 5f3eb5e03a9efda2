//! Steps that take minutes: each says its name when it starts and its time when it ends, and is never silent for long.

use std::sync::mpsc::{self, RecvTimeoutError};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{Context, Result};

/// How long a step may be silent.
const SILENCE: Duration = Duration::from_secs(30);

/// Runs a step. What it prints itself is not held back.
pub fn step(name: &str, work: impl FnOnce() -> Result<()>) -> Result<()> {
    let start = Instant::now();
    println!("\n== {name}");
    let result = telling(SILENCE, |time| println!("still running: {name}, {} s", time.as_secs()), work);
    println!("== {name}: {} after {} s", if result.is_ok() { "passed" } else { "failed" }, start.elapsed().as_secs());
    result.with_context(|| format!("the step `{name}`"))
}

/// Calls `tell` with the time since the start, again and again, until the work is done.
fn telling<T>(interval: Duration, tell: impl Fn(Duration) + Send, work: impl FnOnce() -> T) -> T {
    let start = Instant::now();
    // Nothing is ever sent: that the sender is gone, also by a panic, says that the work is done.
    let (working, done) = mpsc::channel::<()>();
    thread::scope(|scope| {
        scope.spawn(move || {
            while done.recv_timeout(interval) == Err(RecvTimeoutError::Timeout) {
                tell(start.elapsed());
            }
        });
        let result = work();
        drop(working);
        result
    })
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicU32, Ordering};

    use super::*;

    #[test]
    fn long_work_is_not_silent() {
        let told = AtomicU32::new(0);
        let tell = |_| _ = told.fetch_add(1, Ordering::Relaxed);
        assert_eq!(telling(Duration::from_secs(60), tell, || 7), 7, "the result of the work");
        assert_eq!(told.load(Ordering::Relaxed), 0, "short work is");
        let until_told = || while told.load(Ordering::Relaxed) < 3 {};
        telling(Duration::from_millis(1), tell, until_told);
        assert!(told.load(Ordering::Relaxed) >= 3, "told again and again");
    }

    #[test]
    fn a_failure_names_its_step() {
        let error = step("the impossible", || anyhow::bail!("it is")).expect_err("it failed");
        assert_eq!(format!("{error:#}"), "the step `the impossible`: it is");
    }
}
