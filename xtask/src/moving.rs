//! The scenes that move, on chips: each frame is that of this computer, and so are the bytes that a display is sent of it; and all they
//! take is there.

use std::fmt::Write;

use anyhow::{ensure, Context, Result};

use crate::firmware::{self, Build, Program};
use crate::scene::{self, Frame};
use crate::size::Sections;
use crate::{emulator, frames, heading};

const PACKAGE: &str = "moving";
/// The programs, and the bytes of RAM of their chips. `firmware/moving/build.rs` has the same bytes: for the linker there are no more.
const PROGRAMS: [(&str, u64); 2] = [("plasma", 96 << 10), ("scope", 96 << 10)];

/// What a scene takes.
struct Taken {
    frames: Vec<Frame>,
    /// Of the last frame, the checksum of all that the display was sent.
    wire: u32,
    /// Bytes of static RAM.
    statics: u64,
    /// Bytes of stack, summed from the sizes of the frames, from the start of the program.
    summed: u64,
}

/// Draws the scenes frame after frame, in some builds for chips, and prints what they take. Fails where a frame is not that of this
/// computer, or where static RAM and the deepest stack together are more than there is.
pub fn check_all(builds: &[Build]) -> Result<()> {
    let host = scene::on_host("moving")?;
    builds.iter().try_for_each(|build| {
        println!("{}\n", heading(*build)?);
        check(*build, &host)
    })
}

fn check(build: Build, host: &[Frame]) -> Result<()> {
    let with_frames = firmware::build_with_frames(PACKAGE, &[build.chip], build.opt)?;
    let with_frames = with_frames.first().context("one chip has one folder")?;
    let mut rows = Vec::new();
    for (bin, ram) in PROGRAMS {
        let expected: Vec<Frame> = host.iter().filter(|frame| is_of(frame, bin)).cloned().collect();
        let elf = firmware::build_printing(&Program { package: PACKAGE, bin }, build)?;
        let drawn = scene::parse(&emulator::run(build.chip, &elf)?)?;
        scene::compare(&expected, build.chip, &drawn)?;
        let (sent, frames): (Vec<_>, Vec<_>) = drawn.into_iter().partition(is_of_wire);
        let wire = sent.last().with_context(|| format!("{bin} sends nothing"))?.crc32;
        let elf = with_frames.join(bin);
        let taken = Taken { frames, wire, statics: Sections::of(&elf)?.ram(), summed: frames::deepest(&elf)? };
        let (statics, summed) = (taken.statics, taken.summed);
        ensure!(
            statics + summed <= ram,
            "{bin}: {statics} bytes of static RAM and {summed} of stack, but there are {ram}"
        );
        rows.push((bin, taken));
    }
    println!("Scenes that move, 320 x 240 pixels:\n\n{}", markdown(&rows)?);
    Ok(())
}

/// Whether a frame is one of a scene: `plasma-3` of `plasma`.
fn is_of(frame: &Frame, scene: &str) -> bool {
    frame.name.strip_prefix(scene).is_some_and(|number| number.starts_with('-'))
}

/// Whether it says what was sent, not what is shown: `plasma-wire-3`.
fn is_of_wire(frame: &Frame) -> bool {
    frame.name.contains("-wire-")
}

/// A Markdown table: a row for each scene. The first frame, which draws and sends everything, stands beside the average of the others.
fn markdown(rows: &[(&str, Taken)]) -> Result<String> {
    let mut text = String::from(
        "| scene | modelled cycles, first frame | each of the others | static RAM | stack, painted | stack, summed | CRC-32 of the last | as it is sent |\n\
         |---|---:|---:|---:|---:|---:|---|---|\n",
    );
    for (name, Taken { frames, wire, statics, summed }) in rows {
        let (first, others) = frames.split_first().context("no frames")?;
        let last = others.last().context("one frame")?;
        let count = f64::from(u32::try_from(others.len()).context("many frames")?);
        let cycles = |sum: Option<f64>| sum.map_or("–".into(), |sum| format!("{sum:.0}"));
        let average = others.iter().map(|frame| frame.cycles).sum::<Option<f64>>().map(|sum| sum / count);
        let painted = frames.iter().map(|frame| frame.stack).max().context("no frames")?;
        // Writing to a string cannot fail.
        let _ = writeln!(
            text,
            "| {name} | {} | {} | {statics} | {painted} | {summed} | {:08x} | {wire:08x} |",
            cycles(first.cycles),
            cycles(average),
            last.crc32
        );
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_linker_has_the_same_ram() {
        let text = fs::read_to_string(firmware::root().join(PACKAGE).join("build.rs")).expect("a file");
        for (bin, ram) in PROGRAMS {
            assert!(text.contains(&format!("(\"{bin}\", {} << 10)", ram >> 10)), "{bin}");
        }
    }

    #[test]
    fn the_first_frame_stands_alone() {
        let frames =
            scene::parse("scope-0;index4;900;0.0;8;0000000a\nscope-1;index4;100;0.0;12;0000000b\nscope-2;index4;201;0.0;8;0000000c\n");
        let taken = Taken { frames: frames.expect("well-formed"), wire: 13, statics: 7, summed: 16 };
        assert!(is_of(&taken.frames[0], "scope") && !is_of(&taken.frames[0], "sco"), "by its name");
        let text = markdown(&[("scope", taken)]).expect("frames");
        assert!(text.contains("| scope | 900 | 150 | 7 | 12 | 16 | 0000000c | 0000000d |"), "{text}");
    }
}
