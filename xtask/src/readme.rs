//! The tables of the README and of the pages in `docs/`, made anew by the commands that stand above them.
//!
//! A table stands between two comments. The first says where it comes from: a command of this tool, or a heading of a file
//! whose first table it is.
//! ```text
//! <!-- cargo xtask table --target m4 -->        <!-- docs/speed-and-error.md: Lines -->
//! | ... |                                       | ... |
//! <!-- end -->                                  <!-- end -->
//! ```
//! The README also prints a firmware. It is the program of `firmware/readme`, letter by letter, and [`build_firmware`] builds that.

use std::env;
use std::fs;
use std::path::PathBuf;
use std::process::Command;

use anyhow::{bail, ensure, Context, Result};

use crate::firmware::{self, project, Opt};
use crate::Chip;

const END: &str = "<!-- end -->";

/// Writes all tables of some pages anew, or of all pages if none is named. Paths are those from the folder of the project.
pub fn update(wanted: &[PathBuf]) -> Result<()> {
    let (all, wanted) = (pages()?, wanted.iter().map(|page| project().join(page)).collect::<Vec<_>>());
    if let Some(unknown) = wanted.iter().find(|page| !all.contains(page)) {
        bail!("{} is not one of the pages with tables: README.md and docs/*.md", unknown.display());
    }
    let pages = if wanted.is_empty() { all } else { wanted };
    pages.iter().try_for_each(|page| {
        let old = fs::read_to_string(page).with_context(|| format!("reading {}", page.display()))?;
        let new = fill(&old, source).with_context(|| format!("in {}", page.display()))?;
        fs::write(page, new).with_context(|| format!("writing {}", page.display()))
    })
}

/// Draws the pictures of `src/tour.md`, of some modules and of the cookbook anew. Tests do it, as they have the programs that draw them.
pub fn draw_tour() -> Result<()> {
    for (package, test) in [("embedded-raster", "tour"), ("embedded-raster-simulator", "cookbook")] {
        let mut cargo = Command::new(env::var_os("CARGO").unwrap_or("cargo".into()));
        cargo.args(["test", "--package", package, "--test", test]).current_dir(project()).env("BLESS", "1");
        let status = cargo.status().with_context(|| format!("starting {cargo:?}"))?;
        ensure!(status.success(), "cargo ended with {status}");
    }
    Ok(())
}

/// Builds the firmware that the README prints, as it is printed, for a core without compare-and-swap.
pub fn build_firmware() -> Result<()> {
    let printed = fs::read_to_string(project().join("README.md")).context("reading README.md")?;
    let [built, manifest] = ["src/main.rs", "Cargo.toml"].map(|file| firmware::root().join("readme").join(file));
    let read = |path: &PathBuf| fs::read_to_string(path).with_context(|| format!("reading {}", path.display()));
    check_firmware(&printed, &read(&built)?, &read(&manifest)?)?;
    // The folder in which the budgets have built the core library for that already.
    firmware::build_with_frames("readme", &[Chip::M0], Opt::Small)?;
    println!("the firmware in README.md builds for {}", Chip::M0);
    Ok(())
}

/// Fails unless the program that a page prints is the one that is built, with the crates that its first line adds.
fn check_firmware(page: &str, built: &str, manifest: &str) -> Result<()> {
    let (_, rest) = page.split_once("```rust,ignore\n").context("README.md prints no firmware")?;
    let (printed, _) = rest.split_once("```\n").context("the firmware in README.md has no end")?;
    ensure!(printed == built, "README.md and firmware/readme/src/main.rs differ: copy the right one over the other");
    let adding = format!("// {}", adding(manifest)?);
    let first = printed.lines().next().unwrap_or_default();
    ensure!(first == adding, "the firmware in README.md begins with `{first}`, its manifest asks for `{adding}`");
    Ok(())
}

/// The command that adds the dependencies of a manifest, one a line, with their features.
fn adding(manifest: &str) -> Result<String> {
    let (_, dependencies) = manifest.split_once("[dependencies]\n").context("a manifest without dependencies")?;
    let (mut names, mut features) = (String::from("cargo add"), String::new());
    for (name, rest) in dependencies.lines().filter_map(|line| line.split_once(" = ")) {
        names.extend([" ", name]);
        let listed = rest.split_once("features = [").and_then(|(_, rest)| rest.split_once(']'));
        for feature in listed.into_iter().flat_map(|(listed, _)| listed.split(", ")) {
            features.extend([" -F ", name, "/", feature.trim_matches('"')]);
        }
    }
    Ok(names + &features)
}

/// The README and the pages in `docs/`.
fn pages() -> Result<Vec<PathBuf>> {
    let mut pages = vec![project().join("README.md")];
    for entry in project().join("docs").read_dir().context("reading docs/")? {
        pages.extend(Some(entry?.path()).filter(|path| path.extension().is_some_and(|e| e == "md")));
    }
    pages.sort();
    Ok(pages)
}

/// The text with every table replaced by what `source` makes of its first comment.
fn fill(text: &str, mut source: impl FnMut(&str) -> Result<String>) -> Result<String> {
    let mut new = String::new();
    let mut lines = text.lines();
    while let Some(line) = lines.next() {
        new += line;
        new.push('\n');
        let Some(name) = line.strip_prefix("<!-- ").and_then(|line| line.strip_suffix(" -->")) else { continue };
        let table = source(name).with_context(|| format!("the table of `{name}`"))?;
        ensure!(lines.any(|line| line == END), "no `{END}` after `{name}`");
        new.extend(["\n", table.trim(), "\n\n", END, "\n"]);
    }
    Ok(new)
}

fn source(name: &str) -> Result<String> {
    if let Some(arguments) = name.strip_prefix("cargo xtask ") {
        eprintln!("{name}");
        let output = Command::new(env::current_exe()?).args(arguments.split(' ')).output()?;
        ensure!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        return Ok(String::from_utf8(output.stdout)?);
    }
    let (file, heading) = name.split_once(": ").context("neither a command nor a file and a heading")?;
    first_table(&fs::read_to_string(project().join(file)).with_context(|| format!("reading {file}"))?, heading)
}

/// The first table below a heading.
fn first_table(text: &str, heading: &str) -> Result<String> {
    let below = text.lines().skip_while(|line| line.trim_start_matches('#').trim() != heading);
    let table: Vec<&str> =
        below.skip_while(|line| !line.starts_with('|')).take_while(|line| line.starts_with('|')).collect();
    ensure!(!table.is_empty(), "no table below `{heading}`");
    Ok(table.join("\n"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn tables_are_replaced_and_the_rest_stays() {
        let text = "# a\n<!-- one -->\n| old |\n<!-- end -->\nb\n";
        let new = fill(text, |name| Ok(format!("| {name} |\n"))).expect("well-formed");
        assert_eq!(new, "# a\n<!-- one -->\n\n| one |\n\n<!-- end -->\nb\n");
        assert_eq!(fill(&new, |name| Ok(format!("| {name} |\n"))).expect("well-formed"), new);
    }

    /// Without running them: their commands are known, and their tables have ends.
    #[test]
    fn tables_of_all_pages_have_a_source() {
        let mut tables = 0;
        for page in pages().expect("the folder") {
            let text = fs::read_to_string(&page).expect("pages are readable");
            let filled = fill(&text, |name| {
                tables += 1;
                if !name.starts_with("cargo xtask ") {
                    source(name)?;
                }
                Ok(String::new())
            });
            assert!(filled.is_ok(), "{}: {filled:?}", page.display());
        }
        assert!(tables > 0, "there are some");
    }

    #[test]
    fn the_firmware_that_is_printed_is_built() {
        let read = |file: &str| fs::read_to_string(project().join(file)).expect(file);
        let [page, program, manifest] =
            ["README.md", "firmware/readme/src/main.rs", "firmware/readme/Cargo.toml"].map(read);
        check_firmware(&page, &program, &manifest).expect("the same");
        let refused = |page: &str, manifest: &str| check_firmware(page, &program, manifest).is_err();
        assert!(refused(&page.replace("loop {", "loop  {"), &manifest), "one blank more");
        assert!(refused(&page, &manifest.replace("panic-halt = \"1\"\n", "")), "a crate less");
        assert!(refused(&page, &format!("{manifest}static_cell = \"2\"\n")), "a crate more");
        let feature =
            manifest.replace("cortex-m-rt = \"0.7\"", "cortex-m-rt = { version = \"0.7\", features = [\"device\"] }");
        assert!(refused(&page, &feature), "another feature");
        assert!(refused("no program", &manifest), "none");
    }

    #[test]
    fn only_pages_with_tables_are_written() {
        let error = update(&["src/tour.md".into()]).expect_err("it has no tables").to_string();
        assert!(error.contains("tour.md is not one of the pages"), "{error}");
    }

    #[test]
    fn a_table_without_an_end_is_an_error() {
        assert!(fill("<!-- one -->\n| old |\n", |_| Ok(String::new())).is_err(), "nothing would be left of the text");
    }

    #[test]
    fn the_table_below_a_heading() {
        let text = "# x\n| no |\n## y\nwords\n| a |\n| b |\n\n| c |\n";
        assert_eq!(first_table(text, "y").expect("there is one"), "| a |\n| b |");
        assert!(first_table(text, "z").is_err(), "no such heading");
    }
}
