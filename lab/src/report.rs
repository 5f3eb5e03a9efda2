//! The report: tables in Markdown, to be read as they are and quoted elsewhere.

use std::{fmt::Write, process::Command};

use crate::{
    bench::{Cell, Results},
    judge::{per_million, Cover, Verdict},
};

/// Gaps and double hits: a row an engine, a column a mesh.
pub(crate) struct Covers {
    pub(crate) meshes: Vec<&'static str>,
    pub(crate) rows: Vec<(&'static str, Vec<Option<Cover>>)>,
}

/// Everything that was measured.
pub(crate) struct Report {
    pub(crate) lines: Results,
    pub(crate) triangles: Results,
    pub(crate) covers: Covers,
    pub(crate) polygons: Results,
    pub(crate) ellipses: Results,
    pub(crate) curves: Results,
    pub(crate) outlines: Results,
    pub(crate) paths: Results,
    pub(crate) strokes: Results,
    pub(crate) floods: Results,
    pub(crate) memory: Results,
    pub(crate) valgrind: Option<String>,
    pub(crate) quick: bool,
}

/// Three digits, as many as mean something.
pub(crate) fn digits(value: f64) -> String {
    match value {
        0.0 => "0".into(),
        v if v < 0.001 => format!("{v:.1e}"),
        v if v < 0.0995 => format!("{v:.3}"),
        v if v < 9.95 => format!("{v:.2}"),
        v if v < 99.5 => format!("{v:.1}"),
        v => thousands(v.round() as u64),
    }
}

/// 1234567 as 1,234,567.
fn thousands(value: u64) -> String {
    let digits = value.to_string();
    let groups: Vec<_> = digits.as_bytes().rchunks(3).rev().map(|g| String::from_utf8_lossy(g).into_owned()).collect();
    groups.join(",")
}

/// A table: names of the columns, then of each row with its cells. Columns are padded, so that the text reads well too.
pub(crate) fn table(first: &str, columns: &[&str], rows: &[(&str, Vec<String>)]) -> String {
    let mut lines: Vec<Vec<String>> =
        vec![std::iter::once(first).chain(columns.iter().copied()).map(String::from).collect()];
    lines.extend(rows.iter().map(|(name, cells)| std::iter::once((*name).to_owned()).chain(cells.clone()).collect()));
    let widths: Vec<_> =
        (0..=columns.len()).map(|i| lines.iter().map(|l| l[i].chars().count()).max().unwrap_or_default()).collect();
    let mut text = String::new();
    for (i, line) in lines.iter().enumerate() {
        for (j, (cell, &width)) in line.iter().zip(&widths).enumerate() {
            let padded = if j == 0 { format!("| {cell:<width$} ") } else { format!("| {cell:>width$} ") };
            text.push_str(&padded);
        }
        text.push_str("|\n");
        if i == 0 {
            let rule = |(j, &w): (usize, &usize)| if j == 0 { "-".repeat(w + 2) } else { "-".repeat(w + 1) + ":" };
            let _ = writeln!(text, "|{}|", widths.iter().enumerate().map(rule).collect::<Vec<_>>().join("|"));
        }
    }
    text
}

/// A table of a family with one thing in each cell.
pub(crate) fn family(results: &Results, show: impl Fn(&Cell) -> String) -> String {
    let cells = |row: &crate::bench::Row| row.cells.iter().map(|c| c.as_ref().map_or("-".into(), &show)).collect();
    let rows: Vec<_> = results.rows.iter().map(|row| (row.name, cells(row))).collect();
    table(results.title, &results.workloads, &rows)
}

pub(crate) fn per_pixel(cell: &Cell) -> String {
    let time = format!("{:.2} ns", cell.nanoseconds_per_pixel());
    cell.instructions_per_pixel().map_or(time.clone(), |n| format!("{} ({time})", digits(n)))
}

fn per_shape(cell: &Cell) -> String {
    cell.instructions_per_shape().map_or("-".into(), digits)
}

fn wrong_and_distance(v: Verdict) -> String {
    format!("{}; {:.3}", digits(v.wrong_per_million()), v.worst)
}

fn wrong_and_as_given(v: Verdict) -> String {
    format!("{}; {}", digits(v.wrong_per_million()), digits(per_million(v.wrong_as_given, v.pixels)))
}

impl Covers {
    fn table(&self) -> String {
        let cell = |c: &Option<Cover>| match c {
            Some(c) => {
                format!("{}; {}", digits(per_million(c.gaps, c.pixels)), digits(per_million(c.doubles, c.pixels)))
            }
            None => "-".into(),
        };
        let rows: Vec<_> = self.rows.iter().map(|(name, cells)| (*name, cells.iter().map(cell).collect())).collect();
        table("Meshes", &self.meshes, &rows)
    }
}

/// The first line that a command prints.
pub(crate) fn first_line(program: &str, arguments: &[&str]) -> Option<String> {
    let run = Command::new(program).args(arguments).output().ok().filter(|run| run.status.success())?;
    String::from_utf8_lossy(&run.stdout).lines().next().map(|line| line.trim().to_owned())
}

/// The version of a package in the workspace's lock file.
pub(crate) fn version(package: &str) -> &'static str {
    let lock = include_str!("../../Cargo.lock");
    let entry = lock.split("[[package]]").find(|e| e.contains(&format!("name = \"{package}\"\n")));
    entry.and_then(|e| e.split("version = \"").nth(1)?.split('"').next()).unwrap_or("?")
}

/// The commit, and whether the sources differ from it.
pub(crate) fn commit() -> String {
    let Some(commit) = first_line("git", &["rev-parse", "--short=10", "HEAD"]) else { return "not in git".into() };
    let clean = Command::new("git").args(["diff", "--quiet", "HEAD", "--", "src", "lab"]).status();
    format!("{commit}{}", if clean.is_ok_and(|s| s.success()) { "" } else { " with changes" })
}

/// The processor and its load, where Linux says them: times mean something on it only, and little while it is busy.
pub(crate) fn processor() -> String {
    let info = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    let name = info.lines().find_map(|line| line.strip_prefix("model name")?.split_once(": ").map(|(_, name)| name));
    let load = std::fs::read_to_string("/proc/loadavg").unwrap_or_default();
    let load = load.split(' ').next().filter(|l| !l.is_empty()).unwrap_or("unknown");
    format!("{}, {}, load average {load}", std::env::consts::ARCH, name.unwrap_or("unknown processor"))
}

impl Report {
    pub(crate) fn markdown(&self, plots: bool) -> String {
        let mut text = self.header();
        text.push_str(&self.lines_part(plots));
        text.push_str(&self.triangles_part(plots));
        text.push_str(&compared(&self.polygons, plots));
        text.push_str(&compared(&self.ellipses, plots));
        text.push_str(&self.curves_part(plots));
        text.push_str(&self.outlines_part(plots));
        text.push_str(&compared(&self.paths, plots));
        text.push_str(&compared(&self.strokes, plots));
        text.push_str(&compared(&self.floods, false));
        text.push_str(&self.memory_part());
        text.push_str(NOTES);
        text
    }

    fn header(&self) -> String {
        let counted = self.valgrind.as_deref().unwrap_or("no valgrind: time only");
        let rustc = first_line("rustc", &["--version"]).unwrap_or_else(|| "unknown rustc".into());
        let quick = if self.quick { " -- --quick" } else { "" };
        format!(
            "# Speed against error\n\n\
             Every algorithm that has a choice, beside the peers, in one run. Written by `cargo run --release -p lab{quick}`: \
             not to be edited.\n\n\
             - commit {}; {rustc}, opt-level 3\n- peers: embedded-graphics {}, tiny-skia {}\n\
             - instructions: {counted}; time: {}\n\n\
             {INTRODUCTION}\n",
            commit(),
            version("embedded-graphics"),
            version("tiny-skia"),
            processor(),
        )
    }

    fn lines_part(&self, plots: bool) -> String {
        format!(
            "## Lines\n\n{}Instructions per pixel (time per pixel):\n\n{}\n\
             Pixels that are not the nearest, per million; largest distance of a painted pixel from the line, in pixels, along \
             the shorter axis (0.5 is the best there is):\n\n{}\n",
            picture(&self.lines, plots),
            family(&self.lines, per_pixel),
            family(&self.lines, |c| wrong_and_distance(c.verdict)),
        )
    }

    fn triangles_part(&self, plots: bool) -> String {
        format!(
            "## Triangles\n\n{}Instructions per pixel (time per pixel):\n\n{}\n\
             Instructions per triangle:\n\n{}\n\
             Wrong pixels per million against the true triangle; against the triangle as the engine was given it, after \
             snapping:\n\n{}\n\
             How far snapping moves a corner at most, in pixels, which bounds the distance between the two shapes:\n\n{}\n\
             Shared sides: pixels per million of the screen that no triangle of a mesh paints; that more than one paints:\n\n{}\n",
            picture(&self.triangles, plots),
            family(&self.triangles, per_pixel),
            family(&self.triangles, per_shape),
            family(&self.triangles, |c| wrong_and_as_given(c.verdict)),
            family(&self.triangles, |c| digits(c.verdict.worst)),
            self.covers.table(),
        )
    }

    fn curves_part(&self, plots: bool) -> String {
        format!(
            "## Curves to lines\n\n{}Instructions per curve (time per curve):\n\n{}\n\
             Lines per curve:\n\n{}\n\
             Largest distance, in pixels, of a place on the lines from the curve, or on the curve from the lines:\n\n{}\n",
            picture(&self.curves, plots),
            family(&self.curves, |c| {
                let time = format!("{:.0} ns", c.nanoseconds_per_shape());
                c.instructions_per_shape().map_or(time.clone(), |n| format!("{} ({time})", digits(n)))
            }),
            family(&self.curves, |c| digits(c.verdict.lines as f64 / c.verdict.shapes as f64)),
            family(&self.curves, |c| digits(c.verdict.distance())),
        )
    }

    fn outlines_part(&self, plots: bool) -> String {
        format!(
            "## Curves one pixel wide\n\n{}Instructions per pixel (time per pixel); as many pixels as the curve takes steps \
             along the longer axis:\n\n{}\n\
             Largest distance of the centre of a painted pixel from the curve; of a place on the curve from the centre of a \
             painted pixel, 4 at most:\n\n{}\n",
            picture(&self.outlines, plots),
            family(&self.outlines, per_pixel),
            family(&self.outlines, |c| format!("{:.3}; {:.3}", c.verdict.worst, c.verdict.left_out)),
        )
    }

    fn memory_part(&self) -> String {
        format!(
            "## Memory\n\nBlits and text at 16 bits per pixel, shapes at one. Instructions per pixel (time per pixel); of \
             pictures and text only what is not background counts as a pixel:\n\n{}\n\
             Wrong pixels per million:\n\n{}\n",
            family(&self.memory, per_pixel),
            family(&self.memory, |c| digits(c.verdict.wrong_per_million())),
        )
    }
}

/// Cost, and wrong pixels.
fn compared(results: &Results, plots: bool) -> String {
    format!(
        "## {}\n\n{}Instructions per pixel (time per pixel):\n\n{}\nWrong pixels per million:\n\n{}\n",
        results.title,
        picture(results, plots),
        family(results, per_pixel),
        family(results, |c| digits(c.verdict.wrong_per_million())),
    )
}

fn picture(results: &Results, plots: bool) -> String {
    if plots {
        format!("![{}: error against cost](speed-and-error-{}.svg)\n\n", results.title, results.key)
    } else {
        String::new()
    }
}

const INTRODUCTION: &str = "\
Everything is drawn on 320 x 240 pixels: RGB565, tiny-skia on its own 32-bit pixmap. The textbook algorithms and the rows \
that name a function of `raster` paint into a plain `Vec<u16>`; `Canvas` rows paint into this crate's `Framebuffer`. Cost is \
that of drawing: shapes are converted and paths are built beforehand. Pixels are those that the true shape has on the \
screen. Error is judged against 128-bit integers (`twins`, `lab/src/oracle.rs`); random shapes, the same in every run.\n";

const NOTES: &str = "\
## Notes\n\n\
- *Tested*: the whole line is walked and each pixel is tested. *Moved*: the ends are first moved to the border of the screen \
(Cohen and Sutherland) and rounded to pixels, which draws another line. At a tie both pixels count as nearest.\n\
- Far off the screen the square of a line's length overflows the 32 bits that embedded-graphics has for it. tiny-skia's lines \
reach half a pixel beyond the centres of their end pixels, so that it draws both.\n\
- True triangles have 15 sub-pixel bits, all of them exact in `f32` on the screen. embedded-graphics joins pixels, so its \
corners are the centres of the pixels that contain the true ones, and it paints the outline too.\n\
- Polygons are filled by the even-odd rule, with the same vertices, in 1/256 pixel, for every engine.\n\
- *100 x off-screen*: corners up to 31,000 pixels away. embedded-graphics would visit every pixel of such a triangle, on the \
screen or not: it sits them out. It has no polygons.\n\
- Ellipses are given by boxes of whole pixels. The textbook's midpoint algorithm has two regions and 32-bit products: it \
breaks where the curve is thin, and where the box is large. embedded-graphics' own rule is another one near the border.\n\
- The points of curves are those of this crate's grid, 1/256 pixel, for every engine; the true curve is made of chords within \
1/5000 pixel of it. *De Casteljau* halves a curve until its control points are so near to the chord that the curve is within \
34.6/256 pixel of it, which is what this crate promises. Points closer than pixels are 16 bits of time at most.\n\
- Lines with a width go from the centre of a pixel to that of another. A pixel whose centre lies exactly on the border may be \
painted or not. This crate rounds borders outwards to 1/256 pixel. embedded-graphics has no round ends: it sits them out.\n\
- A flood fill is charged with loading its picture. The stacks of the textbook are as long as they need to be.\n\
- To count without the lab: `valgrind --tool=callgrind --toggle-collect='*measured*' target/release/lab --child lines/canvas/1`.\n";

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_what_means_something() {
        let shown: Vec<_> = [0.0, 0.000_12, 0.05, 1.234, 12.34, 123.4, 1_234_567.0].map(digits).into();
        assert_eq!(shown, ["0", "1.2e-4", "0.050", "1.23", "12.3", "123", "1,234,567"]);
    }

    #[test]
    fn tables_are_markdown() {
        let text = table("a", &["b"], &[("long name", vec!["1".into()])]);
        assert_eq!(text, "| a         | b |\n|-----------|--:|\n| long name | 1 |\n");
    }
}
