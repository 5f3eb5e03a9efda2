//! The page: `docs/coverage.md`.

use std::{fmt::Write as _, path::Path};

use anyhow::Result;
use indicatif::ProgressBar;
use xtask::{heading, rims, Build, Chip, Opt};

use super::{
    angles::{self, Bright},
    coverage, stores,
};
use crate::{
    bench::{Cell, Results},
    cost::{Counter, Counts},
    judge::per_million,
    plot::{self, Axes},
    report::{commit, digits, family, first_line, per_pixel, processor, table, version},
};

/// How far levels are off in the mean.
const LEVELS: Axes =
    Axes { unit: "mean error, 255ths", error: |cell| cell.verdict.mean(), none: 0.1, most: 100.0, ..plot::PIXELS };

/// All that is measured.
pub(crate) struct Page {
    results: Results,
    bright: Vec<Bright>,
    stores: String,
    chips: Vec<(String, String)>,
    valgrind: Option<String>,
    quick: bool,
}

/// Measures everything. Without a counter, time only.
pub(crate) fn measure(counter: Option<Counter>, quick: bool) -> Result<Page> {
    let shapes = coverage(quick);
    let children = shapes.children();
    let bar = ProgressBar::new((2 * children.len()) as u64);
    let counts: Counts = counter.as_ref().map(|c| c.count(&children, &bar)).transpose()?.unwrap_or_default();
    let results = shapes.run(&counts, quick, &bar);
    bar.finish_and_clear();
    let chips = if quick { Vec::new() } else { [Chip::M4, Chip::M0].into_iter().filter_map(on_chip).collect() };
    let (bright, stores) = (angles::measure(quick), stores::report(quick));
    Ok(Page { results, bright, stores, chips, valgrind: counter.map(|c| c.version), quick })
}

/// The table of a chip. One for which that cannot be done is left out, with a hint.
fn on_chip(chip: Chip) -> Option<(String, String)> {
    let build = Build::new(chip, Opt::Three);
    match (heading(build), rims::measure(build)) {
        (Ok(heading), Ok(shapes)) => Some((heading, rims::markdown(&shapes))),
        (Err(error), _) | (_, Err(error)) => {
            eprintln!("{chip} is left out: {error:#}");
            None
        }
    }
}

impl Page {
    pub(crate) fn markdown(&self, plots: bool) -> String {
        let Self { results, .. } = self;
        let picture =
            |alt: &str, name: &str| if plots { format!("![{alt}](coverage-{name}.svg)\n\n") } else { String::new() };
        let share = |cell: &Cell| 100.0 * cell.verdict.not_nearest as f64 / cell.verdict.values.max(1) as f64;
        let bright = |bright: &Bright| {
            let [low, high, mean] = bright.all();
            vec![
                format!("{low:.4}"),
                format!("{high:.4}"),
                format!("{mean:.4}"),
                format!("{:.2} %", 100.0 * (high - low)),
            ]
        };
        let bright: Vec<_> = self.bright.iter().map(|b| (b.name, bright(b))).collect();
        let mut text = format!(
            "{}{}## Error\n\nHow far levels are off at most; in the mean; in 255ths, of the pixels that are covered in part:\n\n{}\n\
             Per cent of them that are not the nearest level:\n\n{}\n\
             Pixels per million that are tinted and should be empty or full:\n\n{}\n\
             ## Cost\n\nInstructions per pixel that is touched (time per pixel):\n\n{}\n\
             Time, in multiples of a loop that stores a byte for each of these pixels:\n\n{}\n\
             ## Brightness of thin lines\n\n{}Levels of a line one pixel wide and 100 pixels long, summed up, by its length, at 360 \
             angles:\n\n{}\n",
            self.header(),
            picture("Coverage: error against cost", "error"),
            family(results, |c| format!("{}; {}", digits(c.verdict.worst), digits(c.verdict.mean()))),
            family(results, |c| digits(share(c))),
            family(results, |c| digits(per_million(c.verdict.wrong, c.verdict.pixels))),
            family(results, per_pixel),
            self.stores,
            picture("Brightness over the angle", "brightness"),
            table("Lines", &["least", "most", "mean", "apart"], &bright),
        );
        for (heading, table) in &self.chips {
            let _ = write!(text, "## {heading}\n\nModelled cycles; `cargo xtask rims`:\n\n{table}\n");
        }
        text.push_str(NOTES);
        text
    }

    pub(crate) fn draw(&self, folder: &Path) -> Result<()> {
        let (error, bright) = (folder.join("coverage-error.svg"), folder.join("coverage-brightness.svg"));
        println!("{}\n{}", error.display(), bright.display());
        plot::draw(&self.results, &LEVELS, &error)?;
        angles::draw(&self.bright, &bright)
    }

    fn header(&self) -> String {
        let counted = self.valgrind.as_deref().unwrap_or("no valgrind: time only");
        let rustc = first_line("rustc", &["--version"]).unwrap_or_else(|| "unknown rustc".into());
        let peers: &[&str] = if cfg!(feature = "peers-aa") {
            &["tiny-skia", "zeno", "ab_glyph_rasterizer", "raqote"]
        } else {
            &["tiny-skia"]
        };
        let peers: Vec<_> = peers.iter().map(|peer| format!("{peer} {}", version(peer))).collect();
        let quick = if self.quick { " --quick" } else { "" };
        format!(
            "# Coverage: speed against error\n\n\
             Soft rims, as this crate draws them and as the peers do, in one run. Written by `cargo run --release -p lab --features \
             peers-aa -- --coverage{quick}`: not to be edited.\n\n\
             - commit {}; {rustc}, opt-level 3\n- peers: {}\n- instructions: {counted}; time: {}\n\n{INTRODUCTION}\n",
            commit(),
            peers.join(", "),
            processor(),
        )
    }
}

const INTRODUCTION: &str = "\
Everything is drawn on 320 x 240 pixels, in white on black, and the level of a pixel is judged against its exact area: a ratio of \
128-bit integers for polygons, a sum in double precision for all else. Random shapes, the same in every run. The nearest level is \
off by 1/2 at most and 1/4 in the mean. Paths are built beforehand; curves are cut into lines as they are drawn.\n\n\
- *20,000 px*, *100 px*, *slivers*: triangles; one, 120, and twelve of at most a pixel and a half in width for cost; for error many \
of each kind.\n\
- *circles*: of 1 to 55 pixels; *8 curves*: closed paths of cubic curves.\n\
- *lines*: one pixel wide, their ends cut off at right angles.\n\
- *crossings*: polygons of seven corners in six pixels, by the non-zero rule: sides cross in most of the pixels.\n";

const NOTES: &str = "\
## Notes\n\n\
- This crate draws on a `Framebuffer` of 8-bit grey, by the paint `Cover`; *true area*: by `fill_true` and `path_true`. tiny-skia and zeno fill masks, zeno of the size of the \
screen; ab_glyph_rasterizer sums up a box around the shape, and what it finds is copied to the screen; raqote, and tiny-skia \
for lines, draw on pixels of 32 bits.\n\
- Circles are four cubic curves for zeno, ab_glyph_rasterizer and raqote: within 1/3700 of the radius.\n\
- Where sides cross inside of a pixel, sums of areas are not the area. That concerns this crate, zeno and ab_glyph_rasterizer; \
samples have no such error, nor has the true area.\n\
- To count without the lab: `valgrind --tool=callgrind --toggle-collect='*measured*' target/release/lab --child coverage/own/0`.\n";
