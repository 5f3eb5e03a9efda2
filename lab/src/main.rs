//! The lab: speed against error, for every algorithm that has a choice, beside the peers.
//!
//! `cargo run --release -p lab` writes `docs/speed-and-error.md` and its plots; `--help` tells the rest.
#![allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_precision_loss,
    clippy::cast_sign_loss,
    clippy::float_cmp,
    reason = "floats are what is studied here, and statistics are floats"
)]

mod bench;
mod cost;
mod coverage;
mod dither;
mod engine;
mod frame;
mod judge;
mod oracle;
mod pictures;
mod plain;
mod plot;
mod report;
mod shading;
mod shape;
mod workload;

use std::path::{Path, PathBuf};

use anyhow::{bail, Context, Result};
use indicatif::{ProgressBar, ProgressStyle};

use crate::{
    bench::{Family, Results},
    cost::Counter,
    plot::Axes,
    report::{Covers, Report},
    shape::{Blob, Curve, Job, Line, Oval, Polygon, Pool, Thick, Thin, Triangle},
};

const HELP: &str = "\
Measures speed against error and writes speed-and-error.md and plots into docs/.

cargo run --release -p lab -- [OPTIONS]
  --quick       few shapes, no plots, into a temporary folder: for continuous integration
  --plots       plots in a quick run too
  --out FOLDER  where to write
  --time-only   no callgrind
  --plain       only clears, rectangles and blits, beside `slice::fill` and `copy_from_slice`: printed
  --shading     colours, depths and textures over triangles: writes shading.md instead
  --coverage    soft rims: writes coverage.md instead
  --rims        only soft rims beside a loop of stores: printed
  --stores      only shaded triangles beside a loop of stores: printed
  --dither      what the eye sees of ordered dither: printed
  --pictures    pictures stretched and under maps: printed
  --samples     counts values that are not as promised, of tens of millions; fails when there is one

The peers that shade triangles take part in --shading and --stores with `--features peers-3d`, those that antialias in
--coverage and --rims with `--features peers-aa`, those that draw pictures in --pictures with `--features peers-pictures`.
";

/// What is measured.
#[derive(PartialEq, Eq)]
enum What {
    Report,
    Plain,
    Shading,
    Stores,
    Samples,
    Coverage,
    Rims,
    Dither,
    Pictures,
}

struct Options {
    quick: bool,
    plots: bool,
    count: bool,
    what: What,
    out: Option<PathBuf>,
    /// Draw one workload with one engine, for callgrind to count: `family/engine/workload`.
    child: Option<String>,
}

fn options() -> Result<Options> {
    use lexopt::prelude::*;
    let mut options = Options { quick: false, plots: false, count: true, what: What::Report, out: None, child: None };
    let mut parser = lexopt::Parser::from_env();
    while let Some(argument) = parser.next()? {
        match argument {
            Long("quick") => options.quick = true,
            Long("plots") => options.plots = true,
            Long("time-only") => options.count = false,
            Long("plain") => options.what = What::Plain,
            Long("shading") => options.what = What::Shading,
            Long("stores") => options.what = What::Stores,
            Long("coverage") => options.what = What::Coverage,
            Long("rims") => options.what = What::Rims,
            Long("dither") => options.what = What::Dither,
            Long("pictures") => options.what = What::Pictures,
            Long("samples") => options.what = What::Samples,
            Long("out") => options.out = Some(parser.value()?.into()),
            Long("child") => options.child = Some(parser.value()?.string()?),
            Long("help") | Short('h') => {
                print!("{HELP}");
                std::process::exit(0);
            }
            _ => return Err(argument.unexpected().into()),
        }
    }
    Ok(options)
}

fn lines(quick: bool) -> Family<Line> {
    Family { key: "lines", title: "Lines", entries: engine::lines::entries(), workloads: workload::lines(quick) }
}

fn triangles(quick: bool) -> Family<Triangle> {
    let (entries, workloads) = (engine::triangles::entries(), workload::triangles(quick));
    Family { key: "triangles", title: "Triangles", entries, workloads }
}

fn polygons(quick: bool) -> Family<Polygon> {
    let (entries, workloads) = (engine::polygons::entries(), workload::polygons(quick));
    Family { key: "polygons", title: "Polygons", entries, workloads }
}

fn ellipses(quick: bool) -> Family<Oval> {
    let (entries, workloads) = (engine::ellipses::entries(), workload::ellipses(quick));
    Family { key: "ellipses", title: "Ellipses", entries, workloads }
}

fn curves(quick: bool) -> Family<Curve> {
    let (entries, workloads) = (engine::curves::entries(), workload::curves(quick));
    Family { key: "curves", title: "Curves to lines", entries, workloads }
}

fn outlines(quick: bool) -> Family<Thin> {
    let (entries, workloads) = (engine::outlines::entries(), workload::outlines(quick));
    Family { key: "outlines", title: "Curves one pixel wide", entries, workloads }
}

fn paths(quick: bool) -> Family<Blob> {
    Family { key: "paths", title: "Filled paths", entries: engine::paths::entries(), workloads: workload::paths(quick) }
}

fn strokes(quick: bool) -> Family<Thick> {
    let (entries, workloads) = (engine::strokes::entries(), workload::strokes(quick));
    Family { key: "strokes", title: "Strokes", entries, workloads }
}

fn floods(quick: bool) -> Family<Pool> {
    let (entries, workloads) = (engine::floods::entries(), workload::floods(quick));
    Family { key: "floods", title: "Flood fills", entries, workloads }
}

fn memory(quick: bool) -> Family<Job> {
    Family { key: "memory", title: "Memory", entries: engine::memory::entries(), workloads: workload::memory(quick) }
}

/// Draws what callgrind is to count.
fn child(name: &str, quick: bool) -> Result<()> {
    let known = match name.split('/').next() {
        Some("lines") => lines(quick).child(name),
        Some("triangles") => triangles(quick).child(name),
        Some("polygons") => polygons(quick).child(name),
        Some("ellipses") => ellipses(quick).child(name),
        Some("curves") => curves(quick).child(name),
        Some("outlines") => outlines(quick).child(name),
        Some("paths") => paths(quick).child(name),
        Some("strokes") => strokes(quick).child(name),
        Some("floods") => floods(quick).child(name),
        Some("memory") => memory(quick).child(name),
        Some("plain") => plain::child(name),
        Some("pictures") => pictures::child(name),
        Some("gouraud") => shading::gouraud(quick).child(name),
        Some("depth16") => shading::depth16(quick).child(name),
        Some("depth32") => shading::depth32(quick).child(name),
        Some("coverage") => coverage::coverage(quick).child(name),
        Some("perspective") => shading::perspective(quick).child(name),
        _ => false,
    };
    if !known {
        bail!("no engine and workload of the name {name}");
    }
    Ok(())
}

/// All triangle engines on all meshes.
fn covers(quick: bool, bar: &ProgressBar) -> Covers {
    let meshes = workload::meshes(quick);
    let mut rows = Vec::new();
    for mut entry in engine::triangles::entries() {
        let mut cells = Vec::new();
        for mesh in &meshes {
            bar.set_message(format!("Meshes: {}, {}", entry.name, mesh.name));
            let goes = entry.can_hard || !mesh.far;
            cells.push(goes.then(|| judge::cover(entry.engine.as_mut(), mesh)));
            bar.inc(1);
        }
        rows.push((entry.name, cells));
    }
    Covers { meshes: meshes.iter().map(|m| m.name).collect(), rows }
}

fn measure(options: &Options) -> Result<Report> {
    let quick = options.quick;
    let counter = if options.count { Counter::find(quick) } else { None };
    let (lines, triangles, polygons, memory) = (lines(quick), triangles(quick), polygons(quick), memory(quick));
    let (ellipses, floods) = (ellipses(quick), floods(quick));
    let (curves, outlines, paths, strokes) = (curves(quick), outlines(quick), paths(quick), strokes(quick));
    let children = [
        lines.children(),
        triangles.children(),
        polygons.children(),
        ellipses.children(),
        curves.children(),
        outlines.children(),
        paths.children(),
        strokes.children(),
        floods.children(),
        memory.children(),
    ]
    .concat();
    let meshes = triangles.entries.len() * workload::meshes(true).len();
    let steps = children.len() * if counter.is_some() { 2 } else { 1 } + meshes;
    let bar = ProgressBar::new(steps as u64);
    bar.set_style(ProgressStyle::with_template("{bar:30} {pos}/{len} {elapsed} {msg}")?);
    let counts = counter.as_ref().map(|c| c.count(&children, &bar)).transpose()?.unwrap_or_default();
    let report = Report {
        lines: lines.run(&counts, quick, &bar),
        triangles: triangles.run(&counts, quick, &bar),
        covers: covers(quick, &bar),
        polygons: polygons.run(&counts, quick, &bar),
        ellipses: ellipses.run(&counts, quick, &bar),
        curves: curves.run(&counts, quick, &bar),
        outlines: outlines.run(&counts, quick, &bar),
        paths: paths.run(&counts, quick, &bar),
        strokes: strokes.run(&counts, quick, &bar),
        floods: floods.run(&counts, quick, &bar),
        memory: memory.run(&counts, quick, &bar),
        valgrind: counter.map(|c| c.version),
        quick,
    };
    bar.finish_and_clear();
    Ok(report)
}

fn write(report: &Report, folder: &Path, plots: bool) -> Result<()> {
    write_page(&folder.join("speed-and-error.md"), &report.markdown(plots))?;
    if plots {
        let plot = |(results, axes): (&Results, &Axes)| {
            let file = folder.join(format!("speed-and-error-{}.svg", results.key));
            println!("{}", file.display());
            plot::draw(results, axes, &file)
        };
        [
            (&report.lines, &plot::PIXELS),
            (&report.triangles, &plot::PIXELS),
            (&report.polygons, &plot::PIXELS),
            (&report.ellipses, &plot::PIXELS),
            (&report.curves, &plot::CURVES),
            (&report.outlines, &plot::DISTANCES),
            (&report.paths, &plot::PIXELS),
            (&report.strokes, &plot::PIXELS),
        ]
        .into_iter()
        .try_for_each(plot)?;
    }
    Ok(())
}

fn main() -> Result<()> {
    let options = options()?;
    if let Some(name) = &options.child {
        return child(name, options.quick);
    }
    let quick = options.quick;
    let counter = || if options.count { Counter::find(quick) } else { None };
    match options.what {
        What::Report => write(&measure(&options)?, &folder(&options), options.plots || !quick),
        What::Plain => {
            println!("{}", plain::report(counter().as_ref(), quick)?);
            Ok(())
        }
        What::Shading => {
            let (page, folder) = (shading::page::measure(counter(), quick)?, folder(&options));
            write_page(&folder.join("shading.md"), &page.markdown(options.plots || !quick))?;
            if options.plots || !quick {
                page.draw(&folder)?;
            }
            Ok(())
        }
        What::Stores => {
            println!("{}", shading::stores::report(quick));
            Ok(())
        }
        What::Coverage => {
            let (page, folder) = (coverage::page::measure(counter(), quick)?, folder(&options));
            write_page(&folder.join("coverage.md"), &page.markdown(options.plots || !quick))?;
            if options.plots || !quick {
                page.draw(&folder)?;
            }
            Ok(())
        }
        What::Rims => {
            println!("{}", coverage::stores::report(quick));
            Ok(())
        }
        What::Dither => {
            print!("{}", dither::report());
            Ok(())
        }
        What::Pictures => {
            println!("{}", pictures::report(counter().as_ref(), quick)?);
            Ok(())
        }
        What::Samples => shading::samples::run(quick),
    }
}

/// Where to write.
fn folder(options: &Options) -> PathBuf {
    match &options.out {
        Some(folder) => folder.clone(),
        None if options.quick => std::env::temp_dir().join("embedded-raster-lab"),
        None => Path::new(env!("CARGO_MANIFEST_DIR")).with_file_name("docs"),
    }
}

/// Writes a page, and says where.
fn write_page(page: &Path, text: &str) -> Result<()> {
    if let Some(folder) = page.parent() {
        std::fs::create_dir_all(folder).with_context(|| format!("making {}", folder.display()))?;
    }
    std::fs::write(page, text).with_context(|| format!("writing {}", page.display()))?;
    println!("{}", page.display());
    Ok(())
}
