//! The command line: see `HELP`.

use std::path::PathBuf;
use std::process::ExitCode;

use anyhow::{bail, Result};
use pico_args::Arguments;
use xtask::budget::{self, Columns};
use xtask::proofs::{self, Proofs};
use xtask::table::{self, Cell};
use xtask::{
    bands, checks, cube, heading, moving, playground, readme, rims, run, scene, size, symbols, ways, Build, Chip, Opt,
    Program,
};

const HELP: &str = "\
Checks:

    check
        all that a change must pass, as continuous integration runs it: less than a quarter of an hour
    full
        the same with all tests in every build, on every chip at every opt-level, and all budgets: more than an hour
    printed
        build the firmware that README.md prints, as it is printed, for Cortex-M0+
    cross [--target CHIP]...
        build the crate for the chips
    probe
        prove by the linker that no drawing call can panic: opt-level 3 and s, overflow checks on and off
    panics [--target CHIP]...
        the same on the chips
    symbols [--target CHIP]... [--opt 3|s]
        fail when a firmware in size/ links what it does not use, or floats, at both opt-levels unless told

The firmware on emulated chips. Cycles are modelled, from the tables of Cortex-M4, Cortex-M0+ and Hazard3 (RISC-V): see cycles/.

    run <bin> [--package bench] [--target CHIP]... [--opt 3|s] [--cpu]
        build a program, run it and print what it prints
    table [--target CHIP]... [--opt 3|s] [--cpu] [--format FORMAT] [--per pixel|call|stack] [--rows NAME,NAME...]
        run `table` and print it as Markdown: cycles, and instructions beside them
    ways [--target CHIP]... [--opt 3|s] [--cpu]
        run `ways`, which shades triangles as textbooks do and as this crate does, and print it as Markdown
    rims [--target CHIP]... [--opt 3|s] [--cpu]
        run `rims`, which draws shapes with soft rims and without, and print it as Markdown
    size [--target CHIP]... [--opt 3|s] [--rows NAME,NAME...]
        bytes of flash, static RAM and stack of the programs in size/, at `s` unless told
    scene [--target CHIP]... [--opt 3|s] [--cpu]
        draw the map of the world, a scene of all shapes, a cube in little RAM, and scenes that move; fail when a frame differs from
        this computer's
    cube [--target CHIP]... [--opt 3|s] [--cpu]
        the cube alone: whole and in bands, in 96, 48 and 16 kB of RAM
    moving [--target CHIP]... [--opt 3|s] [--cpu]
        the scenes that move, frame after frame: a plasma whose palette turns, and an oscilloscope with two buffers
    bands [--target CHIP]... [--opt 3|s] [--cpu]
        the map, a page of text and the teapot in bands: RAM against cycles, and how even a split between cores is
    budget [--bless]
        fail when cycles, instructions, flash or stack grew by more than 2 % over firmware/budgets.txt; or write that anew

The playground in the browser:

    playground [--check|--serve|--chips] [--target CHIP]... [--opt 3|s] [--cpu]
        build the page into target/playground, which any file server may serve, or open its index.html; with --check, compare its pictures
        with this computer's in a browser without a window; with --serve, serve it until stopped; with --chips, compare what chips play

Documentation:

    readme [PAGE]...
        make the tables of README.md and docs/*.md anew, or of some of these pages, each by the command that stands above it
    tour
        draw the pictures of src/tour.md, the page of the crate, of some modules and of the cookbook anew: look at each that changed

CHIP is m0, m4 or riscv, all of them unless told. --rows names the rows of a table, all of them unless told. FORMAT is rgb565, gray8, gray4 or binary.
--cpu builds with -C target-cpu of the chip's processor.
";

fn main() -> ExitCode {
    match command(Arguments::from_env()) {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error:#}");
            ExitCode::FAILURE
        }
    }
}

fn command(mut args: Arguments) -> Result<()> {
    if args.contains(["-h", "--help"]) {
        print!("{HELP}");
        return Ok(());
    }
    let name = args.subcommand()?;
    match name.as_deref() {
        Some("run") => run_program(args),
        Some("table") => print_tables(args),
        Some("ways") => print_ways(args),
        Some("rims") => print_rims(args),
        Some("size") => print_sizes(args),
        Some("scene") => print_scene(args),
        Some("cube") => print_cube(args),
        Some("moving") => print_moving(args),
        Some("bands") => print_bands(args),
        Some("budget") => budget(args),
        Some("cross") => cross(args),
        Some("symbols") => check_symbols(args),
        Some("panics") => check_panics(args),
        Some("playground") => play(args),
        Some("printed") => alone(args, readme::build_firmware),
        Some("readme") => update_pages(args),
        Some("tour") => alone(args, readme::draw_tour),
        Some("check") => alone(args, checks::check),
        Some("full") => alone(args, checks::full),
        Some("probe") => alone(args, || proofs::probe(Proofs::All)),
        Some(other) => bail!("no command `{other}`\n\n{HELP}"),
        None => bail!("which command?\n\n{HELP}"),
    }
}

/// A command without options.
fn alone(args: Arguments, work: impl FnOnce() -> Result<()>) -> Result<()> {
    finish(args)?;
    work()
}

fn update_pages(args: Arguments) -> Result<()> {
    let pages = args.finish();
    readme::update(&pages.iter().map(PathBuf::from).collect::<Vec<_>>())
}

fn run_program(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    let package: String = args.opt_value_from_str("--package")?.unwrap_or("bench".into());
    let bin: String = args.free_from_str()?;
    finish(args)?;
    for build in builds {
        print!("{}", run(&Program { package: &package, bin: &bin }, build)?);
    }
    Ok(())
}

fn print_tables(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    let format: Option<String> = args.opt_value_from_str("--format")?;
    let cell = args.opt_value_from_str("--per")?.unwrap_or(Cell::PerPixel);
    let wanted = wanted_rows(&mut args)?;
    finish(args)?;
    for build in builds {
        let rows = table::parse(&run(&Program { package: "bench", bin: "table" }, build)?)?;
        let rows = table::select(rows, wanted.as_deref(), |row| &row.workload)?;
        println!("{}: {}\n", heading(build)?, cell.title(&rows));
        for name in table::formats(&rows) {
            if format.as_deref().is_none_or(|wanted| wanted == name) {
                println!("{}", table::markdown(&rows, name, cell));
            }
        }
    }
    Ok(())
}

fn print_ways(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    finish(args)?;
    for build in builds {
        println!("{}\n\n{}", heading(build)?, ways::markdown(&ways::measure(build)?));
    }
    Ok(())
}

fn print_rims(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    finish(args)?;
    for build in builds {
        println!("{}: modelled cycles\n\n{}", heading(build)?, rims::markdown(&rims::measure(build)?));
    }
    Ok(())
}

fn print_sizes(mut args: Arguments) -> Result<()> {
    let (chips, opt) = (chips(&mut args)?, opt(&mut args, Opt::Small)?);
    let wanted = wanted_rows(&mut args)?;
    finish(args)?;
    let programs = table::select(size::programs()?, wanted.as_deref(), |name| name)?;
    for chip in chips {
        let table = size::markdown(&size::features(&programs, chip, opt)?, &size::painted(&programs, chip, opt)?);
        println!("{}: bytes beyond `empty`\n\n{table}", heading(Build::new(chip, opt))?);
    }
    Ok(())
}

fn print_scene(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    finish(args)?;
    scene::check_all(&builds)?;
    cube::check_all(&builds)?;
    moving::check_all(&builds)
}

fn print_cube(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    finish(args)?;
    cube::check_all(&builds)
}

fn print_moving(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    finish(args)?;
    moving::check_all(&builds)
}

fn print_bands(mut args: Arguments) -> Result<()> {
    let builds = builds(&mut args)?;
    finish(args)?;
    bands::check_all(&builds)
}

fn play(mut args: Arguments) -> Result<()> {
    if args.contains("--chips") {
        let builds = builds(&mut args)?;
        finish(args)?;
        return playground::check_chips(&builds);
    }
    let (checks, serves) = (args.contains("--check"), args.contains("--serve"));
    finish(args)?;
    match (checks, serves) {
        (true, _) => playground::check(),
        (false, true) => playground::serve(),
        (false, false) => playground::build().map(|folder| println!("{}", folder.join("index.html").display())),
    }
}

fn budget(mut args: Arguments) -> Result<()> {
    let bless = args.contains("--bless");
    finish(args)?;
    if bless {
        return budget::bless(&budget::measure(Columns::All)?);
    }
    budget::check(Columns::All)
}

fn cross(mut args: Arguments) -> Result<()> {
    let chips = chips(&mut args)?;
    finish(args)?;
    chips.into_iter().try_for_each(proofs::cross)
}

fn check_symbols(mut args: Arguments) -> Result<()> {
    let chips = chips(&mut args)?;
    let opts = args.opt_value_from_str("--opt")?.map_or(Opt::ALL.to_vec(), |opt| vec![opt]);
    finish(args)?;
    symbols::check_all(&chips, &opts)
}

fn check_panics(mut args: Arguments) -> Result<()> {
    let chips = chips(&mut args)?;
    finish(args)?;
    chips.into_iter().try_for_each(proofs::panics)
}

fn chips(args: &mut Arguments) -> Result<Vec<Chip>> {
    let chosen: Vec<Chip> = args.values_from_str("--target")?;
    Ok(if chosen.is_empty() { Chip::ALL.to_vec() } else { chosen })
}

/// The chips, with the optimisation level and the processor.
fn builds(args: &mut Arguments) -> Result<Vec<Build>> {
    let (opt, cpu) = (opt(args, Opt::Three)?, args.contains("--cpu"));
    Ok(chips(args)?.into_iter().map(|chip| Build { chip, opt, cpu }).collect())
}

fn opt(args: &mut Arguments, default: Opt) -> Result<Opt> {
    Ok(args.opt_value_from_str("--opt")?.unwrap_or(default))
}

/// The names after `--rows`.
fn wanted_rows(args: &mut Arguments) -> Result<Option<Vec<String>>> {
    let names: Option<String> = args.opt_value_from_str("--rows")?;
    Ok(names.map(|names| names.split(',').map(str::to_owned).collect()))
}

fn finish(args: Arguments) -> Result<()> {
    let rest = args.finish();
    if !rest.is_empty() {
        bail!("not understood: {rest:?}\n\n{HELP}");
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_are_names_between_commas() {
        let rows = |args: &[&str]| wanted_rows(&mut Arguments::from_vec(args.iter().map(Into::into).collect()));
        assert_eq!(rows(&[]).expect("none are told"), None, "all of them");
        let names = ["clear", "lines-12"].map(str::to_owned);
        assert_eq!(rows(&["--rows", "clear,lines-12"]).expect("well-formed"), Some(names.to_vec()));
        assert!(rows(&["--rows"]).is_err(), "no names");
    }
}
