//! Scenes in bands: memory against cycles, and how even the parts are that cores draw at once. The lines of the program `bands`.

use std::fmt::Write;
use std::str::FromStr;

use anyhow::{bail, ensure, Context, Error, Result};

use crate::scene::{self, Frame};
use crate::{heading, run, table, Build, Chip, Program};

/// Rows of the screen.
const HEIGHT: u32 = 240;
/// Into how many parts a frame is split: a core for each.
const CORES: [usize; 3] = [2, 3, 4];

/// One line: a band.
#[derive(Clone, Debug)]
struct Line {
    scene: String,
    format: String,
    /// Of a band; the last one may have fewer.
    rows: u32,
    bytes: u32,
    cycles: Option<f64>,
    stack: u32,
    /// Of this band and those before.
    crc32: u32,
}

impl FromStr for Line {
    type Err = Error;

    fn from_str(line: &str) -> Result<Self, Error> {
        let fields: Vec<&str> = line.split(';').collect();
        let &[scene, format, rows, _, bytes, cycles, stack, crc32] = &fields[..] else {
            bail!("{} fields instead of 8 in the line `{line}`", fields.len());
        };
        Ok(Self {
            scene: scene.into(),
            format: format.into(),
            rows: rows.parse()?,
            bytes: bytes.parse()?,
            cycles: table::parse_cycles(cycles)?,
            stack: stack.parse()?,
            crc32: u32::from_str_radix(crc32, 16)?,
        })
    }
}

/// A scene in bands of some height.
#[derive(Clone, Debug, PartialEq)]
struct Drawn {
    scene: String,
    format: String,
    rows: u32,
    bytes: u32,
    /// Modelled cycles of each band, from the top down. None where nobody counts them.
    cycles: Vec<f64>,
    stack: u32,
    /// Of all bands together.
    crc32: u32,
}

impl Drawn {
    fn sum(&self) -> f64 {
        self.cycles.iter().sum()
    }

    fn slowest(&self) -> f64 {
        self.cycles.iter().copied().fold(0.0, f64::max)
    }
}

/// Draws the scenes in bands, in some builds for chips, and prints what they take. Fails where the bands of a scene together are not what this
/// computer draws at once.
pub fn check_all(builds: &[Build]) -> Result<()> {
    let host = scene::on_host("bands")?;
    builds.iter().try_for_each(|&build| {
        let drawn = parse(&run(&Program { package: "bench", bin: "bands" }, build)?)?;
        compare(&host, build.chip, &drawn)?;
        ensure!(
            drawn.iter().all(|drawn| !drawn.cycles.is_empty()),
            "nobody counts cycles here, which are all that is compared"
        );
        println!("{}\n\n{}\n{}", heading(build)?, memory(&drawn)?, balance(&drawn)?);
        Ok(())
    })
}

/// The lines of a scene that have the same height follow each other.
fn parse(output: &str) -> Result<Vec<Drawn>> {
    let mut all = Vec::<Drawn>::new();
    for line in output.lines().filter(|line| !line.starts_with('#')) {
        let Line { scene, format, rows, bytes, cycles, stack, crc32 } = line.parse()?;
        match all.last_mut() {
            Some(last) if (&last.scene, last.rows) == (&scene, rows) => {
                last.cycles.extend(cycles);
                (last.stack, last.crc32) = (last.stack.max(stack), crc32);
            }
            _ => all.push(Drawn { scene, format, rows, bytes, cycles: cycles.into_iter().collect(), stack, crc32 }),
        }
    }
    Ok(all)
}

/// Fails where bands are not the whole.
fn compare(host: &[Frame], chip: Chip, drawn: &[Drawn]) -> Result<()> {
    for Drawn { scene, format, rows, crc32, .. } in drawn {
        let whole = host.iter().find(|frame| (&frame.name, &frame.format) == (scene, format));
        let expected = whole.with_context(|| format!("this computer does not draw {scene}"))?.crc32;
        ensure!(
            expected == *crc32,
            "{scene} in bands of {rows} rows on {chip} has the checksum {crc32:08x}, as a whole on this computer {expected:08x}"
        );
    }
    let is_drawn = |frame: &Frame| drawn.iter().any(|drawn| drawn.scene == frame.name);
    ensure!(host.iter().all(is_drawn), "{chip} does not draw all scenes");
    Ok(())
}

/// The scene drawn at once.
fn whole<'a>(drawn: &'a [Drawn], scene: &str) -> Result<&'a Drawn> {
    let whole = drawn.iter().find(|drawn| drawn.scene == scene && drawn.rows == HEIGHT);
    whole.with_context(|| format!("{scene} is not drawn at once"))
}

/// A Markdown table: a row for each scene and height.
fn memory(all: &[Drawn]) -> Result<String> {
    let mut text = String::from(
        "| scene | rows of a band | bands | bytes of a band | stack | modelled cycles a frame | times the whole |\n|---|---:|---:|---:|---:|---:|---:|\n",
    );
    for drawn in all {
        let (Drawn { scene, format, rows, bytes, stack, .. }, cycles) = (drawn, drawn.sum());
        let (bands, times) = (HEIGHT.div_ceil(*rows), cycles / whole(all, scene)?.sum());
        // Writing to a string cannot fail.
        let _ =
            writeln!(text, "| {scene}, {format} | {rows} | {bands} | {bytes} | {stack} | {cycles:.0} | {times:.2} |");
    }
    Ok(text)
}

/// A Markdown table: a row for each scene, with how many times as fast several cores draw it: the whole against the slowest part.
fn balance(all: &[Drawn]) -> Result<String> {
    let mut text = String::from("| scene | modelled cycles of one core |");
    for cores in CORES {
        let _ = write!(text, " the slowest of {cores} | times as fast |");
    }
    let _ = writeln!(text, "\n|---|---:|{}", "---:|---:|".repeat(CORES.len()));
    for whole in all.iter().filter(|drawn| drawn.rows == HEIGHT) {
        let Drawn { scene, format, .. } = whole;
        let _ = write!(text, "| {scene}, {format} | {:.0} |", whole.sum());
        for cores in CORES {
            let parts = all.iter().find(|drawn| drawn.scene == *scene && HEIGHT.div_ceil(drawn.rows) as usize == cores);
            let slowest = parts.with_context(|| format!("{scene} is not drawn in {cores} parts"))?.slowest();
            let _ = write!(text, " {slowest:.0} | {:.2} |", whole.sum() / slowest);
        }
        text.push('\n');
    }
    Ok(text)
}

#[cfg(test)]
mod tests {
    use super::*;

    const OUTPUT: &str = "# a remark\n\
        map;index4;240;0;38400;900;40;0000000a\n\
        map;index4;120;0;19200;300;48;00000001\nmap;index4;120;120;19200;700;40;0000000a\n\
        map;index4;80;0;12800;300;40;1\nmap;index4;80;80;12800;300;40;2\nmap;index4;80;160;12800;500;40;a\n\
        map;index4;60;0;9600;300;40;1\nmap;index4;60;60;9600;300;40;2\nmap;index4;60;120;9600;300;40;2\nmap;index4;60;180;9600;450;40;a\n";

    #[test]
    fn bands_of_a_height_are_one_frame() {
        let drawn = parse(OUTPUT).expect("well-formed");
        assert_eq!(drawn.len(), 4, "heights");
        assert_eq!((drawn[1].sum(), drawn[1].slowest(), drawn[1].stack, drawn[1].crc32), (1000.0, 700.0, 48, 10));
        let text = memory(&drawn).expect("there is a whole");
        assert!(text.contains("| map, index4 | 120 | 2 | 19200 | 48 | 1000 | 1.11 |"), "{text}");
        let text = balance(&drawn).expect("there are 2, 3 and 4 parts");
        assert!(text.contains("| map, index4 | 900 | 700 | 1.29 | 500 | 1.80 | 450 | 2.00 |"), "{text}");
        assert!(balance(&drawn[..3]).is_err(), "no quarters");
        assert!(memory(&drawn[1..]).is_err(), "nothing to compare with");
        assert!(parse("map;index4;240;0").is_err(), "half a line");
    }

    #[test]
    fn other_bands_are_an_error() {
        let drawn = parse(OUTPUT).expect("well-formed");
        let host = scene::parse("map;index4;-;0.0;0;0000000a\n").expect("well-formed");
        compare(&host, Chip::M4, &drawn).expect("the same");
        let other = scene::parse("map;index4;-;0.0;0;0000000b\n").expect("well-formed");
        let error = compare(&other, Chip::M4, &drawn).expect_err("not the same").to_string();
        assert!(error.starts_with("map in bands of 240 rows on Cortex-M4"), "{error}");
        assert!(compare(&host, Chip::M4, &[]).is_err(), "nothing is drawn");
    }
}
