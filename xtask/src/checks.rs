//! All checks in one command: [`check`] is what continuous integration runs, [`full`] what takes too long for every change.

use std::process::Command;
use std::thread;
use std::time::Instant;

use anyhow::{anyhow, ensure, Context, Result};

use crate::budget::{self, Columns};
use crate::firmware::{project, Build, Opt};
use crate::proofs::{self, Proofs};
use crate::steps::step;
use crate::{bands, cube, moving, playground, readme, scene, symbols, Chip};

/// A variable that `build.rs` reads, and its value.
type Switch = (&'static str, &'static str);

/// What a build may be switched by. A build that is given none takes the ways of this computer. Not flags of the compiler: by
/// those cargo would compile everything that the tests depend on anew, windows of three systems among it.
const SWITCHES: [Switch; 2] = [("EMBEDDED_RASTER_TUNE", "size"), ("EMBEDDED_RASTER_CORE", "small")];

/// What [`check`] tests in each build that switches make: arguments of `cargo test`, of one call in each line. Filters go
/// behind `--` and hold for all tests of their line. Here every shape is compared with its twin; [`full`] takes all tests.
const SWITCHED_TESTS: &[&[&str]] = &[&["--test=raster"]];

/// How many of the random cases of a test each build that is switched takes, in per cent.
const SWITCHED_CASES: u32 = 10;

/// How many of the random cases of a test [`check`] takes, in per cent; whoever calls `cargo test` takes all.
const CASES: u32 = 20;

/// All that a change must pass, in some minutes.
pub fn check() -> Result<()> {
    let start = Instant::now();
    quick(CASES, SWITCHED_TESTS, SWITCHED_CASES, Columns::Usual, Proofs::Some)?;
    passed(start);
    Ok(())
}

/// [`check`], with all cases of all tests in every build, flash on Cortex-M4 too, the probe with overflow checks and without, and all proofs and frames on every chip at
/// every opt-level; the budgets of builds for a processor; the lab, which also counts shaded values that are not as promised.
pub fn full() -> Result<()> {
    let start = Instant::now();
    quick(100, &[&[]], 100, Columns::All, Proofs::All)?;
    cargo_step(
        "calls on every layout",
        &[
            "test",
            "--workspace",
            "--features",
            "embedded-raster-twins/all-layouts",
            "--test=sequences",
            "--test=no_panic",
            "--test=present",
        ],
    )?;
    step("modelled cycles: every chip", || budget::check_models(&Chip::ALL))?;
    step("cross: every chip", || Chip::ALL.into_iter().try_for_each(proofs::cross))?;
    step("panics: every chip", || Chip::ALL.into_iter().try_for_each(proofs::panics))?;
    step("symbols: every chip and opt-level", || symbols::check_all(&Chip::ALL, &Opt::ALL))?;
    for opt in Opt::ALL {
        step(&format!("scene: every chip, opt-level {}", opt.name()), || {
            let builds = Chip::ALL.map(|chip| Build::new(chip, opt));
            scene::check_all(&builds)?;
            cube::check_all(&builds)?;
            moving::check_all(&builds)?;
            bands::check_all(&builds)?;
            playground::check_chips(&builds)
        })?;
    }
    cargo_step(
        "layers of embassy-stm32",
        &["test", "--manifest-path=displays/embassy/Cargo.toml", "--target-dir=target"],
    )?;
    step("the playground in a browser", playground::check)?;
    cargo_step("lab", &["run", "--release", "--package", "lab", "--", "--quick"])?;
    cargo_step("shaded values", &["run", "--release", "--package", "lab", "--", "--samples"])?;
    passed(start);
    Ok(())
}

/// * `cases`, `switched_cases`: how many of the random cases, in per cent.
fn quick(cases: u32, switched_tests: &[&[&str]], switched_cases: u32, columns: Columns, proofs: Proofs) -> Result<()> {
    cargo_step("format", &["fmt", "--all", "--check"])?;
    // Side by side, in folders of their own: much of either is a single crate or a single test, which leaves a core idle.
    thread::scope(|scope| {
        let firmware = scope.spawn(|| on_chips(columns, proofs));
        let tests = on_this_computer(cases, switched_tests, switched_cases);
        let firmware = firmware.join().map_err(|_| anyhow!("a step ended badly"))?;
        tests.and(firmware)
    })
}

fn on_this_computer(cases: u32, switched_tests: &[&[&str]], switched_cases: u32) -> Result<()> {
    cargo_step("clippy", &["clippy", "--workspace", "--all-targets"])?;
    cargo_step("clippy with defmt", &["clippy", "--package", "embedded-raster", "--features", "defmt"])?;
    // In the folder of the others: it depends on much that they do. Nothing is linked, so the library of the fuzzer in C++, which
    // would take longer than all else, is said to be there.
    let mut fuzz = cargo(&["check", "--manifest-path", "fuzz/Cargo.toml", "--target-dir", "target"]);
    fuzz.env("CUSTOM_LIBFUZZER_PATH", project().join("target/libFuzzer.a"));
    step("fuzz targets", || run(fuzz))?;
    cargo_step("documentation", &["doc", "--workspace", "--no-deps"])?;
    let mut tests = cargo(&["test", "--workspace"]);
    tests.env("EMBEDDED_RASTER_CASES", cases.to_string());
    step("tests", || run(tests))?;
    for switches in switched() {
        for tests in switched_tests {
            // Of the whole workspace, although other members have no such tests: then what all depend on has the same features, and is
            // not compiled anew.
            let args = [&["test", "--workspace"], *tests].concat();
            let mut cargo = cargo(&args);
            cargo.envs(switches.iter().copied()).env("EMBEDDED_RASTER_CASES", switched_cases.to_string());
            let names: Vec<_> = switches.iter().map(|(variable, value)| format!("{variable}={value}")).collect();
            step(&format!("tests with {}", names.join(" and ")), || run(cargo))?;
        }
    }
    Ok(())
}

fn on_chips(columns: Columns, proofs: Proofs) -> Result<()> {
    // All that the budgets measure at this level too: one call of cargo builds it.
    step("symbols: Cortex-M0+ at opt-level s", || symbols::check_all(&[Chip::M0], &[Opt::Small]))?;
    step("budget", || budget::check(columns))?;
    step("the firmware in README.md", readme::build_firmware)?;
    // A core without atomic accesses, which no other step builds for.
    step("cross: RV32IMC", || proofs::cross(Chip::Riscv))?;
    step("probe", || proofs::probe(proofs))
}

fn passed(start: Instant) {
    println!("\nall checks passed in {} s", start.elapsed().as_secs());
}

/// Every choice of switches but none of them.
fn switched() -> impl Iterator<Item = Vec<Switch>> {
    let chosen =
        |choice: u32| (0..).zip(SWITCHES).filter(move |&(i, _)| choice >> i & 1 == 1).map(|(_, switch)| switch);
    (1..1 << SWITCHES.len()).map(move |choice| chosen(choice).collect())
}

/// A command of cargo as a step.
fn cargo_step(name: &str, args: &[&str]) -> Result<()> {
    step(name, || run(cargo(args)))
}

/// A command of cargo. Warnings are errors.
fn cargo(args: &[&str]) -> Command {
    let flags = "--deny warnings";
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    cargo.args(args).current_dir(project());
    // Cargo keeps what it built by these flags beside what it built by others. Other steps set flags of their own.
    cargo.env("RUSTFLAGS", flags).env("RUSTDOCFLAGS", flags);
    for variable in ["CARGO_ENCODED_RUSTFLAGS", "EMBEDDED_RASTER_TUNE", "EMBEDDED_RASTER_CORE", "EMBEDDED_RASTER_CASES"]
    {
        cargo.env_remove(variable);
    }
    // Nobody debugs these builds.
    for variable in ["CARGO_INCREMENTAL", "CARGO_PROFILE_DEV_DEBUG", "CARGO_PROFILE_TEST_DEBUG"] {
        cargo.env(variable, "0");
    }
    // Most of the time goes into compiling tests. This saves a fifth of it, and slows those that compute down by less. Said of both
    // profiles, so that macros and build scripts are compiled once for both.
    cargo.env("CARGO_PROFILE_TEST_LTO", "off").env("CARGO_PROFILE_DEV_LTO", "off");
    cargo
}

/// Says what would do the same by hand, and does it.
fn run(mut cargo: Command) -> Result<()> {
    let variables =
        cargo.get_envs().filter(|(name, _)| *name == "RUSTFLAGS" || name.to_string_lossy().starts_with("EMBEDDED_"));
    let variables = variables.filter_map(|(name, value)| Some(format!("{}=\"{}\" ", name.display(), value?.display())));
    let args: Vec<_> = cargo.get_args().map(|arg| arg.to_string_lossy()).collect();
    println!("{}cargo {}", variables.collect::<String>(), args.join(" "));
    let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
    ensure!(status.success(), "cargo ended with {status}");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_choice_of_switches_is_tested() {
        let [a, b] = SWITCHES;
        assert_eq!(switched().collect::<Vec<_>>(), [vec![a], vec![b], vec![a, b]]);
    }

    #[test]
    fn the_switched_tests_exist() {
        let tests = SWITCHED_TESTS.concat().into_iter().filter_map(|arg| arg.strip_prefix("--test="));
        for test in tests {
            let folder = project().join("tests");
            let files = [folder.join(test).join("main.rs"), folder.join(test).with_extension("rs")];
            assert!(files.iter().any(|file| file.is_file()), "no test `{test}`");
        }
    }
}
