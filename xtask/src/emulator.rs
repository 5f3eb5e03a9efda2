//! Running an ELF in QEMU, with one instruction to a nanosecond of virtual time.

use std::io::{ErrorKind, Read};
use std::path::Path;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::thread;
use std::time::{Duration, Instant};

use anyhow::{anyhow, bail, Context, Result};

use crate::{plugin, Chip};

/// A program that hangs is stopped after this; the longest one takes some seconds.
const TIME_LIMIT: Duration = Duration::from_secs(120);

/// Runs a program to its end and returns what it printed, with its cycles. Fails when its exit code is not 0.
pub fn run(chip: Chip, elf: &Path) -> Result<String> {
    let mut child = command(chip, elf)?.spawn().map_err(|error| explain(chip, error))?;
    // A thread, because a full pipe would stop the program while its end is waited for.
    let mut stdout = child.stdout.take().context("output of the emulator")?;
    let reader = thread::spawn(move || {
        let mut output = String::new();
        stdout.read_to_string(&mut output).map(|_| output)
    });
    let status = wait(&mut child)?;
    let output = reader.join().map_err(|_| anyhow!("reading the output failed"))??;
    if !status.success() {
        bail!("{} on {chip} ended with {status} after printing:\n{output}", elf.display());
    }
    plugin::together(&output)
}

fn command(chip: Chip, elf: &Path) -> Result<Command> {
    let mut qemu = Command::new(chip.emulator().0);
    qemu.args(chip.machine());
    qemu.args(["-display", "none", "-serial", "none", "-monitor", "none"]);
    qemu.args(["-semihosting-config", "enable=on,target=native", "-icount", "shift=0"]);
    if let Some(argument) = plugin::argument(chip, elf)? {
        qemu.arg("-plugin").arg(argument);
    }
    qemu.arg("-kernel").arg(elf).stdin(Stdio::null()).stdout(Stdio::piped());
    Ok(qemu)
}

fn explain(chip: Chip, error: std::io::Error) -> anyhow::Error {
    let (program, package) = chip.emulator();
    if error.kind() == ErrorKind::NotFound {
        return anyhow!("{program} is not installed; on Debian:\n    apt-get install {package}");
    }
    anyhow!(error).context(format!("starting {program}"))
}

/// Waits for the end, or kills the emulator at the time limit.
fn wait(child: &mut Child) -> Result<ExitStatus> {
    let start = Instant::now();
    while start.elapsed() < TIME_LIMIT {
        if let Some(status) = child.try_wait()? {
            return Ok(status);
        }
        thread::sleep(Duration::from_millis(10));
    }
    child.kill()?;
    child.wait()?;
    bail!("no end after {} s", TIME_LIMIT.as_secs())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_missing_emulator_says_what_to_install() {
        let text = explain(Chip::Riscv, ErrorKind::NotFound.into()).to_string();
        assert!(text.contains("apt-get install qemu-system-misc"), "{text}");
    }
}
