//! The page: `docs/shading.md`.

use std::path::Path;

use anyhow::Result;
use indicatif::ProgressBar;

use super::{chips, chips::OnChip, depth16, depth32, gouraud, perspective, Shaded};
use crate::{
    bench::{Cell, Family, Results},
    cost::{Counter, Counts},
    judge::per_million,
    plot::{self, Axes},
    report::{commit, digits, family, first_line, per_pixel, processor, table, version},
};

/// Values that are not the nearest ones.
const VALUES: Axes = Axes {
    unit: "values per million that are not the nearest",
    error: |cell| per_million(cell.verdict.not_nearest, cell.verdict.values),
    ..plot::PIXELS
};

/// A family, measured on this computer, and what its ways are called on chips.
struct Part {
    results: Results,
    keys: Vec<(&'static str, &'static str)>,
}

/// All that is measured.
pub(crate) struct Page {
    parts: Vec<Part>,
    chips: Vec<OnChip>,
    valgrind: Option<String>,
    quick: bool,
}

fn families(quick: bool) -> [Family<Shaded>; 4] {
    [gouraud(quick), perspective(quick), depth16(quick), depth32(quick)]
}

/// Measures everything. Without a counter, time only.
pub(crate) fn measure(counter: Option<Counter>, quick: bool) -> Result<Page> {
    let children: Vec<_> = families(quick).iter().flat_map(Family::children).collect();
    let bar = ProgressBar::new((2 * children.len()) as u64);
    let counts: Counts = counter.as_ref().map(|c| c.count(&children, &bar)).transpose()?.unwrap_or_default();
    let part = |family: Family<Shaded>| {
        let keys = family.entries.iter().map(|entry| (entry.key, entry.name)).collect();
        Part { results: family.run(&counts, quick, &bar), keys }
    };
    let parts = families(quick).map(part).into();
    bar.finish_and_clear();
    let chips = if quick { Vec::new() } else { chips::measure() };
    Ok(Page { parts, chips, valgrind: counter.map(|c| c.version), quick })
}

impl Page {
    pub(crate) fn markdown(&self, plots: bool) -> String {
        let mut text = self.header();
        for part in &self.parts {
            text.push_str(&self.part(part, plots));
        }
        text.push_str(NOTES);
        text
    }

    pub(crate) fn draw(&self, folder: &Path) -> Result<()> {
        self.parts.iter().try_for_each(|part| {
            let file = folder.join(format!("shading-{}.svg", part.results.key));
            println!("{}", file.display());
            plot::draw(&part.results, &VALUES, &file)
        })
    }

    fn header(&self) -> String {
        let counted = self.valgrind.as_deref().unwrap_or("no valgrind: time only");
        let rustc = first_line("rustc", &["--version"]).unwrap_or_else(|| "unknown rustc".into());
        let peers = if cfg!(feature = "peers-3d") {
            let named = ["euc", "retrofire-core", "embedded-3dgfx"].map(|peer| format!("{peer} {}", version(peer)));
            named.join(", ")
        } else {
            "none: built without the feature `peers-3d`".into()
        };
        let quick = if self.quick { " --quick" } else { "" };
        let mut chips = String::new();
        self.chips.iter().for_each(|chip| chips.extend(["- ", &chip.heading, "\n"]));
        format!(
            "# Shading: speed against error\n\n\
             Colours, depths and textures over triangles: as textbooks do it, as this crate does, and as the peers do, in one \
             run. Written by `cargo run --release -p lab --features peers-3d -- --shading{quick}`: not to be edited.\n\n\
             - commit {}; {rustc}, opt-level 3\n- peers: {peers}\n- instructions: {counted}; time: {}\n{chips}\n\
             {INTRODUCTION}\n",
            commit(),
            processor(),
        )
    }

    fn part(&self, Part { results, keys }: &Part, plots: bool) -> String {
        let title = results.title;
        let picture = format!("![{title}: error against cost](shading-{}.svg)\n\n", results.key);
        let unit = if results.key == "perspective" { "texels" } else { "steps of the value" };
        format!(
            "## {title}\n\n{}{}Instructions per pixel on this computer (time per pixel):\n\n{}\n\
             Values per million that are not the nearest:\n\n{}\n\
             How far values are off at most; in the mean; in {unit}:\n\n{}\n\
             Pixels per million that are painted and should not be, or the other way round:\n\n{}\n",
            if plots { picture.as_str() } else { "" },
            self.on_chips(results.key, keys),
            family(results, per_pixel),
            family(results, |c| digits(per_million(c.verdict.not_nearest, c.verdict.values))),
            family(results, off),
            family(results, |c| digits(c.verdict.wrong_per_million())),
        )
    }

    /// Cycles of the ways of a family, a column for each chip and workload.
    fn on_chips(&self, key: &str, keys: &[(&'static str, &'static str)]) -> String {
        let mut workloads: Vec<&str> = Vec::new();
        for way in self.chips.iter().flat_map(|chip| &chip.ways).filter(|way| way.family == key) {
            if !workloads.contains(&way.workload.as_str()) {
                workloads.push(&way.workload);
            }
        }
        if workloads.is_empty() {
            return String::new();
        }
        let columns: Vec<_> = self.chips.iter().flat_map(|c| workloads.iter().map(move |w| (c, *w))).collect();
        let names: Vec<_> = columns.iter().map(|(chip, workload)| format!("{}, {workload}", chip.name)).collect();
        let names: Vec<_> = names.iter().map(String::as_str).collect();
        let cell = |way: &str, (chip, workload): &(&OnChip, &str)| {
            let cost = chip.cost(key, workload, way);
            cost.map_or("-".into(), |(cycles, instructions)| format!("{} ({})", digits(cycles), digits(instructions)))
        };
        let row = |&(way, name): &(&str, &'static str)| {
            let cells: Vec<_> = columns.iter().map(|column| cell(way, column)).collect();
            cells.iter().any(|cell| cell != "-").then_some((name, cells))
        };
        let rows: Vec<_> = keys.iter().filter_map(row).collect();
        format!("Modelled cycles per pixel (instructions); `cargo xtask ways`:\n\n{}\n", table("Chips", &names, &rows))
    }
}

/// The worst value, and the mean.
fn off(cell: &Cell) -> String {
    format!("{}; {}", digits(cell.verdict.worst), digits(cell.verdict.mean()))
}

const INTRODUCTION: &str = "\
Everything is drawn on 320 x 240 pixels of RGB565, the mesh on chips on 130 x 120. Cost is that of drawing, with all that has to \
be done for a triangle: corners are converted as they are drawn. Error is judged pixel by pixel against ratios of 128-bit \
integers, at the pixels that the true triangle has and the engine painted; random triangles, the same in every run. The nearest \
colour, of 5 and 6 bits, and the nearest depth is off by 1/2 at most and 1/4 in the mean; the right texel by 0.\n\n\
- *20,000 px*: one triangle for cost; for error also 60 of a quarter of the screen and more.\n\
- *100 px*, *mesh of 50 px*: 120 triangles; 3,200 in four layers that pass through each other, the depths cleared first. For error \
also thousands of that size.\n\
- *slivers*: from anywhere to anywhere on the screen, and at most 1.5 pixels wide.\n\
- *off-screen*: corners up to 3,000 pixels away.\n";

const NOTES: &str = "\
## Notes\n\n\
- The ways of textbooks are in the folder `textbook`, without a line that knows this crate: chips and this computer run the same \
code. *Barycentric*: all pixels of the box are tested, and values are weighted at each. *Sides and rows*: values go down the \
sides and along the rows by additions; that of the left side stands for that of the first pixel. *Plane*: gradients are found \
once, and values are taken at centres. Levels that an error takes out of their range are clamped.\n\
- Cortex-M4 has a unit for `f32`, Cortex-M0+ does it by function calls. The model takes 14 cycles for a division of floats, 3 for a \
product and a sum in one, 1 for the rest; it leaves out that a result costs a cycle more when the next instruction asks for it.\n\
- euc multiplies and adds in one step, which without `-C target-cpu` is a call of a function. It takes all pixels of the box.\n\
- retrofire-core is called behind its clipping, so what leaves the screen is not for it. Its depths are `f32`, the nearest the \
largest: here 2^16 or 2^32 less the depth.\n\
- embedded-3dgfx joins whole pixels: its corners are moved by up to a pixel, and its values with them, and it paints the sides \
too. What its depths gain from pixel to pixel has 16 bits, so it sits out those of 32.\n\
- A depth in `f32` has 24 bits.\n\
- Places in a texture are rounded to 1/65,536 texel in this crate: so one that lies just before a texel may be taken for its \
beginning. Runs are cut in halves where w changes much along them, here those of 32 pixels to 16.\n\
- To count without the lab: `valgrind --tool=callgrind --toggle-collect='*measured*' target/release/lab --child gouraud/exact/0`.\n";
