//! Builds that prove something.

use std::collections::BTreeSet;
use std::iter;
use std::process::Command;

use anyhow::{anyhow, bail, ensure, Context, Result};

use crate::firmware::project;
use crate::toolchain::Toolchain;
use crate::Chip;

/// Checks that the crate compiles for a chip, warnings as errors. No machine code is made: what a chip may lack is a type or a function
/// of the core library, such as atomic accesses.
pub fn cross(chip: Chip) -> Result<()> {
    let mut cargo = Toolchain::find(chip)?.cargo_check(chip);
    cargo.args(["--quiet", "--release", "--package", "embedded-raster", "--lib"]).current_dir(project());
    cargo.env("RUSTFLAGS", "--deny warnings").arg("--target-dir").arg(project().join("target/cross"));
    // The core library is compiled as a whole, though nothing is linked: it need not be optimised.
    cargo.env("CARGO_PROFILE_RELEASE_OPT_LEVEL", "0");
    let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
    ensure!(status.success(), "the crate does not build for {chip}: cargo ended with {status}");
    println!("builds for {chip}");
    Ok(())
}

/// How much is proved.
#[derive(Copy, Clone, Debug, PartialEq, Eq)]
pub enum Proofs {
    /// Speed without overflow checks, as most ship it, on layouts whose pixels are bytes; size with them, on layouts whose pixels
    /// are bits. What is not generic is in both.
    Some,
    /// Both with and without, on ten layouts.
    All,
}

/// Links every drawing call with a panic handler that does not exist, in two configurations or four; and once a call that does
/// panic, which must not link.
pub fn probe(proofs: Proofs) -> Result<()> {
    ensure!(cfg!(target_os = "linux"), "the probe needs a linker that takes `-z defs`: run it on Linux");
    let host = host()?;
    println!("linking every call of the list for this computer, again and again: some minutes");
    // Each of them is one unit of code, so two at a time: those for size take as long as those for speed.
    std::thread::scope(|scope| {
        let opts = [("3", "false", "words"), ("s", "true", "bits")].map(|(opt, first, some)| {
            let host = &host;
            let layouts = if proofs == Proofs::All { "bits,words,others" } else { some };
            scope.spawn(move || {
                if opt == "s" {
                    ensure!(
                        !link(host, opt, "true", "panics")?,
                        "the probe links although it panics: it proves nothing"
                    );
                }
                let others = ["true", "false"].into_iter().filter(|&checks| checks != first && proofs == Proofs::All);
                for checks in iter::once(first).chain(others) {
                    if !link(host, opt, checks, layouts)? {
                        let names = culprits(host, opt, checks, layouts)?;
                        bail!("a panic can be reached at opt-level {opt}, overflow checks {checks}, from\n{names}");
                    }
                    println!("no panic can be reached at opt-level {opt}, overflow checks {checks}");
                }
                Ok(())
            })
        });
        opts.into_iter().try_for_each(|opt| opt.join().map_err(|_| anyhow!("a build ended badly"))?)
    })
}

/// Whether it links; any failure but the missing panic handler is an error.
fn link(host: &str, opt: &str, checks: &str, features: &str) -> Result<bool> {
    let mut cargo = cargo_build(host, opt, checks, "target/probe");
    cargo.args(["--no-default-features", "--features", features]);
    cargo.env("RUSTFLAGS", "-C link-arg=-Wl,-z,defs -C link-arg=-Wl,--gc-sections");
    let output = cargo.output().with_context(|| format!("starting {cargo:?}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    let refused = text.contains("a_panic_can_be_reached");
    ensure!(output.status.success() || refused, "the probe does not build:\n{text}");
    Ok(!refused)
}

/// The functions that call what panics, a line each: linked with the handler left open, and read from the code.
fn culprits(host: &str, opt: &str, checks: &str, features: &str) -> Result<String> {
    let folder = "target/probe/names";
    let mut cargo = cargo_build(host, opt, checks, folder);
    cargo.args(["--no-default-features", "--features", features]);
    cargo.env("RUSTFLAGS", "-C link-arg=-Wl,--gc-sections -C strip=none");
    ensure!(cargo.status()?.success(), "the probe does not build with the handler left open");
    let library = project().join(folder).join(opt).join(host).join("release/libprobe.so");
    let mut objdump = Command::new("objdump");
    objdump.args(["-d", "--no-show-raw-insn", "--demangle"]).arg(library);
    let output = objdump.output().with_context(|| format!("{objdump:?}, to name what panics"))?;
    Ok(callers_of_panics(&String::from_utf8_lossy(&output.stdout)))
}

/// Of a disassembly: the functions that call what panics. Those of the core library are among them, all but what panics itself: a
/// closure of ours may have become a part of one.
fn callers_of_panics(assembly: &str) -> String {
    let (mut names, mut function) = (BTreeSet::new(), "");
    for line in assembly.lines() {
        if let Some(name) = line.strip_suffix(">:").and_then(|line| line.split_once('<')) {
            function = name.1;
        }
        let panics = ["core::panicking::", "unwrap_failed", "expect_failed", "_fail>"];
        let is_one =
            function.contains("rust_begin_unwind") || panics.iter().any(|what| format!("{function}>").contains(what));
        if !is_one && !line.ends_with(">:") && panics.iter().any(|what| line.contains(what)) {
            names.insert(format!("    {function}\n"));
        }
    }
    names.into_iter().collect()
}

fn cargo_build(host: &str, opt: &str, checks: &str, target: &str) -> Command {
    let mut cargo = Command::new(std::env::var_os("CARGO").unwrap_or("cargo".into()));
    // With a target named, the flags are those of the library alone, not of build scripts as well.
    cargo.args(["build", "--quiet", "--release", "--target", host]).current_dir(project().join("firmware/probe"));
    cargo.args(["--config", &format!("profile.release.opt-level={}", if opt == "s" { "\"s\"" } else { opt })]);
    // What others wrote keeps its checks: then it is compiled once for both, and may panic in more ways.
    cargo.args(["--config", "profile.release.overflow-checks=true"]);
    for package in ["embedded-raster", "embedded-raster-calls", "probe"] {
        cargo.args(["--config", &format!("profile.release.package.{package}.overflow-checks={checks}")]);
    }
    cargo.arg("--target-dir").arg(project().join(target).join(opt));
    cargo.env_remove("EMBEDDED_RASTER_TUNE").env_remove("EMBEDDED_RASTER_CORE");
    cargo
}

/// The same on a chip: all calls as an image that is linked with nothing left out.
pub fn panics(chip: Chip) -> Result<()> {
    ensure!(!link_image(chip, "3", "true", true)?, "the probe links although it panics: it proves nothing");
    for opt in ["3", "s"] {
        for checks in ["true", "false"] {
            println!("linking every call of the list for {chip} at opt-level {opt}");
            let linked = link_image(chip, opt, checks, false)?;
            ensure!(
                linked,
                "a panic can be reached on {chip} at opt-level {opt}, overflow checks {checks}; `cargo xtask probe` may name it"
            );
            println!("no panic can be reached on {chip} at opt-level {opt}, overflow checks {checks}");
        }
    }
    Ok(())
}

/// Whether it links; any failure but the missing panic handler is an error.
fn link_image(chip: Chip, opt: &str, checks: &str, panics: bool) -> Result<bool> {
    let mut cargo = Toolchain::find(chip)?.cargo_build(&[chip]);
    cargo.args(["--quiet", "--release"]).current_dir(project().join("firmware/probe/chip"));
    cargo.args(["--config", &format!("profile.release.opt-level={}", if opt == "s" { "\"s\"" } else { opt })]);
    // For the crate and what it depends on, not for the core library: a toolchain's own comes without them.
    for package in
        ["embedded-raster", "embedded-graphics-core", "fixed", "bytemuck", "heapless", "embedded-raster-calls"]
    {
        cargo.args(["--config", &format!("profile.release.package.{package}.overflow-checks={checks}")]);
    }
    cargo.args(if panics { &["--features", "panics"][..] } else { &[] });
    cargo.arg("--target-dir").arg(project().join("target/probe").join(opt));
    // Nobody calls the calls, and they are to be linked all the same. This also replaces the linker scripts of the firmware.
    cargo.env("RUSTFLAGS", "-C link-arg=--no-gc-sections");
    let output = cargo.output().with_context(|| format!("starting {cargo:?}"))?;
    let text = String::from_utf8_lossy(&output.stderr);
    let refused = text.contains("a_panic_can_be_reached");
    ensure!(output.status.success() || refused, "the probe does not build:\n{text}");
    Ok(!refused)
}

/// The target that the compiler builds for by itself.
fn host() -> Result<String> {
    let output = Command::new(std::env::var_os("RUSTC").unwrap_or("rustc".into())).arg("-vV").output()?;
    let text = String::from_utf8(output.stdout)?;
    let line = text.lines().find_map(|line| line.strip_prefix("host: "));
    Ok(line.context("rustc -vV names no host")?.to_owned())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_disassembly_names_who_panics() {
        let assembly = "\
0000000000023340 <embedded_raster::scan::corridor::{{closure}}>:
   23375:\tcall   14b2b0 <core::panicking::panic_const::panic_const_mul_overflow>
0000000000023390 <draw4>:
   23395:\tcall   14b2b0 <embedded_raster::raster::line::draw>
0000000000023398 <core::array::<impl [T; N]>::map>:
   2339a:\tcall   14b2b0 <core::panicking::panic_const::panic_const_mul_overflow>
000000000014b290 <core::option::expect_failed>:
  14b294:\tcall   14b2a0 <core::panicking::panic_fmt>
000000000014b2b0 <core::panicking::panic_const::panic_const_mul_overflow>:
  14b2b4:\tcall   14b2a0 <core::panicking::panic_fmt>
";
        let named = ["core::array::<impl [T; N]>::map", "embedded_raster::scan::corridor::{{closure}}"];
        assert_eq!(callers_of_panics(assembly), named.map(|name| format!("    {name}\n")).concat());
    }
}
