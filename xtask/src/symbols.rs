//! What must not be linked, read from the symbols of the firmwares in `size`.

use std::fs;
use std::path::Path;

use anyhow::{ensure, Context, Result};
use object::{Object, ObjectSymbol};

use crate::firmware::{self, Opt};
use crate::{size, Chip};

/// A firmware, and parts of names that it must not have.
struct Rule {
    program: &'static str,
    forbidden: &'static [&'static str],
    reason: &'static str,
}

/// A 64-bit division, by any of its names: the routines of the ABI, those of libgcc, and what the compiler's own call.
const DIVISION: &[&str] =
    &["ldivmod", "__udivdi3", "__umoddi3", "__divdi3", "__moddi3", "divmoddi4", "u64_div_rem", "i64_div_rem"];
/// Modules of the crate, as they stand in mangled names.
const LINE: &str = "6raster4line";
const TRIANGLE: &str = "6raster8triangle";
const POLYGON: &str = "6raster7polygon";
const ROUND: &str = "6raster5round";
/// Those of the third dimension, and of what changes over a triangle.
const PIPELINE: &str = "15embedded_raster8pipeline";
const CLIPPER: &str = "15embedded_raster8pipeline4clip3cut";
const SPACE: &str = "4geom5space";
const FACET: &str = "4geom5facet";
const VARYING: &str = "4geom7varying";
const SHADE: &str = "5paint5shade";
const DEPTH: &str = "5paint5depth";
const SPATIAL: [&str; 6] = [PIPELINE, SPACE, FACET, VARYING, SHADE, DEPTH];

/// The firmwares that have some of that. All others are flat, and have none of it.
const SPATIAL_PROGRAMS: [&str; 12] = [
    "depth",
    "depth_id",
    "depth_shade",
    "light",
    "matrices",
    "pipeline",
    "pipeline_depth",
    "pipeline_depth_whole",
    "pipeline_whole",
    "shade",
    "shade_value_1",
    "shade_value_3",
];

/// What a scene does not use must not be linked.
const RULES: &[Rule] = &[
    Rule { program: "line", forbidden: &[TRIANGLE, POLYGON, ROUND], reason: "a line needs no fills" },
    Rule { program: "line", forbidden: DIVISION, reason: "a line needs no 64-bit division" },
    Rule { program: "line_index4", forbidden: &[TRIANGLE, POLYGON, ROUND], reason: "a line needs no fills" },
    Rule { program: "line_index4", forbidden: DIVISION, reason: "a line needs no 64-bit division" },
    Rule { program: "clear", forbidden: &[LINE, TRIANGLE, POLYGON, ROUND], reason: "clearing needs no shapes" },
    Rule { program: "clear", forbidden: DIVISION, reason: "clearing needs no division" },
    Rule { program: "triangle", forbidden: &[LINE, POLYGON, ROUND], reason: "a triangle needs no other shape" },
    Rule { program: "polygon", forbidden: &[LINE, TRIANGLE, ROUND], reason: "a polygon needs no other shape" },
    Rule { program: "shade", forbidden: &[PIPELINE, SPACE, DEPTH], reason: "colours need neither depth nor space" },
    Rule { program: "shade_value_1", forbidden: &[PIPELINE, SPACE, DEPTH], reason: "nor do numbers" },
    Rule { program: "shade_value_3", forbidden: &[PIPELINE, SPACE, DEPTH], reason: "nor do numbers" },
    Rule { program: "depth", forbidden: &[PIPELINE, SPACE, SHADE], reason: "depth needs no space" },
    Rule { program: "depth_id", forbidden: &[PIPELINE, SPACE, SHADE], reason: "depth needs no space" },
    Rule { program: "depth_shade", forbidden: &[PIPELINE, SPACE], reason: "depth needs no space" },
    Rule { program: "pipeline", forbidden: &[DEPTH], reason: "it has no depths" },
    Rule { program: "pipeline_whole", forbidden: &[DEPTH, CLIPPER], reason: "nothing is cut" },
    Rule { program: "pipeline_depth_whole", forbidden: &[CLIPPER], reason: "nothing is cut" },
    Rule { program: "matrices", forbidden: &[PIPELINE, FACET, VARYING, TRIANGLE], reason: "nothing is drawn" },
    Rule { program: "light", forbidden: &[PIPELINE, FACET, VARYING, TRIANGLE], reason: "nothing is drawn" },
];

/// Checks the firmwares of some chips at some opt-levels.
pub fn check_all(chips: &[Chip], opts: &[Opt]) -> Result<()> {
    for &opt in opts {
        // The same build as that of the budgets.
        let folders = firmware::build_with_frames(size::PACKAGE, chips, opt)?;
        for (&chip, folder) in chips.iter().zip(&folders) {
            check(chip, folder)?;
            println!(
                "no unused shapes, nothing of space in flat scenes, and no floats on {chip} at opt-level {}",
                opt.name()
            );
        }
    }
    Ok(())
}

/// Fails when a firmware has what it must not have.
fn check(chip: Chip, folder: &Path) -> Result<()> {
    for program in size::programs()? {
        let names = names(&folder.join(&program))?;
        // Without symbols everything would pass.
        ensure!(names.iter().any(|name| name == "main"), "{program} on {chip} has no symbol `main`: was it stripped?");
        for rule in RULES.iter().filter(|rule| rule.program == program) {
            let found = names.iter().find(|name| rule.forbidden.iter().any(|part| name.contains(part)));
            ensure!(found.is_none(), "{program} on {chip} has `{}`, but {}", found.map_or("", |n| n), rule.reason);
        }
        if program == "everything" {
            // It has what there is.
        } else if SPATIAL_PROGRAMS.contains(&&*program) {
            let division = names.iter().find(|name| DIVISION.iter().any(|part| name.contains(part)));
            ensure!(division.is_none(), "{program} on {chip} divides 64 bits: `{}`", division.map_or("", |n| n));
        } else {
            let found = names.iter().find(|name| SPATIAL.iter().any(|part| name.contains(part)));
            ensure!(found.is_none(), "{program} on {chip} is flat, but has `{}`", found.map_or("", |n| n));
        }
        let float = names.iter().find(|name| software_floats(chip) && is_float(name));
        ensure!(float.is_none(), "{program} on {chip} computes with floats: `{}`", float.map_or("", |n| n));
    }
    Ok(())
}

/// On these chips every operation on floats is a call; the others have instructions for it.
fn software_floats(chip: Chip) -> bool {
    matches!(chip, Chip::M0 | Chip::Riscv)
}

/// Names of all functions and variables in the image.
fn names(elf: &Path) -> Result<Vec<String>> {
    let bytes = fs::read(elf).with_context(|| format!("reading {}", elf.display()))?;
    let file = object::File::parse(&*bytes)?;
    let symbols = file.symbols().filter(ObjectSymbol::is_definition);
    Ok(symbols.filter_map(|symbol| symbol.name().ok().map(str::to_owned)).collect())
}

/// A routine that computes with floats, as the ABI of Arm or libgcc names it.
fn is_float(name: &str) -> bool {
    const TO_FLOAT: [&str; 9] = ["i2f", "i2d", "ui2f", "ui2d", "l2f", "l2d", "ul2f", "ul2d", "h2f"];
    const LIBGCC: [&str; 16] = [
        "add", "sub", "mul", "div", "neg", "eq", "ne", "lt", "le", "gt", "ge", "unord", "float", "fix", "extend",
        "trunc",
    ];
    if let Some(routine) = name.strip_prefix("__aeabi_") {
        let compares = ["cf", "cd"].iter().any(|prefix| routine.starts_with(prefix));
        return routine.starts_with(['f', 'd']) || compares || TO_FLOAT.contains(&routine);
    }
    let known = |routine: &str| LIBGCC.iter().any(|prefix| routine.starts_with(prefix));
    let single_or_double = name.contains("sf") || name.contains("df");
    let libgcc = name.strip_prefix("__").is_some_and(known) && single_or_double;
    libgcc || name.contains("17compiler_builtins5float")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn floats_are_known_by_name() {
        for name in ["__aeabi_fadd", "__aeabi_dmul", "__aeabi_ui2f", "__aeabi_cdcmple", "__addsf3", "__fixdfsi"] {
            assert!(is_float(name), "{name}");
        }
        for name in ["__aeabi_uidiv", "__aeabi_lmul", "__aeabi_idivmod", "__muldi3", "main", "__udivsi3"] {
            assert!(!is_float(name), "{name}");
        }
    }

    /// A module that was moved would never be found.
    #[test]
    fn rules_are_about_modules_that_exist() {
        for mangled in [LINE, TRIANGLE, POLYGON, ROUND] {
            let name =
                mangled.strip_prefix("6raster").expect("a shape").trim_start_matches(|c: char| c.is_ascii_digit());
            let module = firmware::project().join("src/raster").join(name);
            assert!(module.with_extension("rs").is_file() || module.join("mod.rs").is_file(), "{mangled}");
        }
        for path in ["pipeline/clip", "geom/space/mod", "geom/facet", "geom/varying/mod", "paint/shade", "paint/depth"]
        {
            assert!(firmware::project().join("src").join(path).with_extension("rs").is_file(), "{path}");
            let parts: Vec<&str> = path.split('/').filter(|part| *part != "mod").collect();
            let mangled = parts.iter().map(|part| format!("{}{part}", part.len())).collect::<Vec<_>>().concat();
            let known = SPATIAL.iter().chain([&CLIPPER]).any(|name| name.contains(&mangled));
            assert!(known, "{mangled}");
        }
    }

    #[test]
    fn rules_are_about_programs_that_exist() {
        let programs = size::programs().expect("the folder");
        for rule in RULES {
            assert!(programs.iter().any(|name| name == rule.program), "{}", rule.program);
        }
        for program in SPATIAL_PROGRAMS {
            assert!(programs.iter().any(|name| name == program), "{program}");
        }
    }
}
