//! The cube on chips with little RAM: it is drawn as on this computer, and all it takes is there.

use std::fmt::Write;

use anyhow::{ensure, Context, Result};

use crate::firmware::{self, Build, Program};
use crate::scene::{self, Frame};
use crate::size::Sections;
use crate::{emulator, frames, heading};

const PACKAGE: &str = "cube";
/// The programs, the bytes of RAM of their chips, and what the table calls them. `firmware/cube/build.rs` has the same bytes: for
/// the linker there are no more.
const WAYS: [(&str, u64, &str); 3] = [
    ("whole", 96 << 10, "whole, in 96 kB"),
    ("band32", 48 << 10, "bands of 32 rows, in 48 kB"),
    ("band16", 16 << 10, "bands of 16 rows, in 16 kB"),
];

/// What one way of drawing takes.
struct Taken {
    frames: Vec<Frame>,
    /// Bytes of static RAM.
    statics: u64,
    /// Bytes of stack, summed from the sizes of the frames, from the start of the program.
    summed: u64,
}

/// Draws the cube at all moments in all ways, in some builds for chips, and prints what they take. Fails where a frame is not that of
/// this computer, or where static RAM and the deepest stack together are more than there is.
pub fn check_all(builds: &[Build]) -> Result<()> {
    builds.iter().try_for_each(|build| {
        println!("{}\n", heading(*build)?);
        check(*build)
    })
}

fn check(build: Build) -> Result<()> {
    let host = scene::on_host("cube")?;
    let with_frames = firmware::build_with_frames(PACKAGE, &[build.chip], build.opt)?;
    let with_frames = with_frames.first().context("one chip has one folder")?;
    let mut rows = Vec::new();
    for (bin, ram, name) in WAYS {
        let elf = firmware::build_printing(&Program { package: PACKAGE, bin }, build)?;
        let drawn = scene::parse(&emulator::run(build.chip, &elf)?)?;
        scene::compare(&host, build.chip, &drawn)?;
        let elf = with_frames.join(bin);
        let taken = Taken { frames: drawn, statics: Sections::of(&elf)?.ram(), summed: frames::deepest(&elf)? };
        let (statics, summed) = (taken.statics, taken.summed);
        ensure!(
            statics + summed <= ram,
            "the cube, {name}: {statics} bytes of static RAM and {summed} of stack, but there are {ram}"
        );
        rows.push((name, taken));
    }
    println!(
        "The cube, 160 x 128 pixels in RGB565 with depths of 16 bits, on average over a turn:\n\n{}",
        markdown(&rows)?
    );
    Ok(())
}

/// A Markdown table: a row for each way.
fn markdown(rows: &[(&str, Taken)]) -> Result<String> {
    let mut text = String::from(
        "| cube | modelled cycles a frame | instructions | static RAM | stack, painted | stack, summed |\n|---|---:|---:|---:|---:|---:|\n",
    );
    for (name, Taken { frames, statics, summed }) in rows {
        let count = f64::from(u32::try_from(frames.len()).context("many frames")?);
        let cycles: Option<f64> = frames.iter().map(|frame| frame.cycles).sum();
        let cycles = cycles.map_or("–".into(), |sum| format!("{:.0}", sum / count));
        let instructions = frames.iter().map(|frame| frame.instructions).sum::<f64>() / count;
        let painted = frames.iter().map(|frame| frame.stack).max().context("no frames")?;
        // Writing to a string cannot fail.
        let _ = writeln!(text, "| {name} | {cycles} | {instructions:.0} | {statics} | {painted} | {summed} |");
    }
    if let Some((_, Taken { frames, .. })) = rows.first() {
        let sums: Vec<String> = frames.iter().map(|frame| format!("{:08x}", frame.crc32)).collect();
        let _ = writeln!(text, "\nCRC-32 in each way, of {} moments of a turn: {}.", sums.len(), sums.join(" "));
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::*;

    #[test]
    fn the_linker_has_the_same_ram() {
        let path = firmware::root().join(PACKAGE).join("build.rs");
        let text = fs::read_to_string(path).expect("a file");
        for (bin, ram, name) in WAYS {
            let kilobytes = ram >> 10;
            assert!(text.contains(&format!("(\"{bin}\", {kilobytes} << 10)")), "{bin}");
            assert!(name.ends_with(&format!("{kilobytes} kB")), "{name}");
        }
    }

    #[test]
    fn a_row_is_an_average() {
        let frames = scene::parse("cube-0;rgb565;100;50.0;8;0000000a\ncube-1;rgb565;201;61.0;12;0000000b\n");
        let taken = Taken { frames: frames.expect("well-formed"), statics: 7, summed: 16 };
        let text = markdown(&[("whole", taken)]).expect("frames");
        assert!(text.contains("| whole | 150 | 56 | 7 | 12 | 16 |"), "{text}");
        assert!(text.contains("0000000a 0000000b"), "{text}");
    }
}
