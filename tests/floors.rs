//! Who may import whom: the floors of the house, checked against every path in `src`, and what the crate depends on.
//!
//! A module imports from the floors below its own and from itself, never from the other wing of its floor: geometry knows
//! no pixels, pixels know no geometry.

use std::{
    fs,
    path::{Path, PathBuf},
};

/// The table of the floors, as in ARCHITECTURE.md. `lib.rs` stands above them all.
const FLOORS: [(&str, u32); 16] = [
    ("tune", 0),
    ("num", 0),
    ("span", 0),
    ("error", 0),
    ("geom", 1),
    ("pixel", 1),
    ("raster", 2),
    ("surface", 2),
    ("paint", 3),
    ("canvas", 4),
    ("pipeline", 5),
    ("present", 6),
    ("text", 6),
    ("eg", 6),
    // Not modules: what lib.rs passes on may be named by nobody but users.
    ("lib", 7),
    ("", 7),
];

/// Floor 0 has its own order, so that words do not refer to each other in circles.
const GROUND: [&str; 4] = ["tune", "num", "span", "error"];

fn floor(module: &str) -> u32 {
    let known = FLOORS.iter().find(|(name, _)| *name == module);
    known.unwrap_or_else(|| panic!("module `{module}` has no floor yet: add it to the table and to ARCHITECTURE.md")).1
}

fn may_import(from: &str, to: &str) -> bool {
    let place = |module| GROUND.iter().position(|m| *m == module);
    match (place(from), place(to)) {
        (Some(from), Some(to)) => to <= from,
        _ => from == to || floor(to) < floor(from),
    }
}

fn sources(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).expect("src is readable") {
        let path = entry.expect("src is readable").path();
        if path.is_dir() {
            sources(&path, found);
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
}

/// The code of a file, without comments, without texts (links of documentation), and without what only tests see.
fn code(text: &str) -> String {
    let text = text.split("\nmod tests {").next().unwrap_or_default();
    let code = text.lines().map(|line| line.split("//").next().unwrap_or_default()).collect::<Vec<_>>().join("\n");
    code.split('"').step_by(2).collect::<Vec<_>>().join("\"\"")
}

/// The first names of everything imported by paths that start with `prefix`, as `crate::a::b` or `crate::{a::b, c}`.
fn first_names(code: &str, prefix: &str) -> Vec<String> {
    let mut names = vec![];
    for (at, _) in code.match_indices(prefix) {
        let before = code[..at].chars().next_back();
        if before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '$' || c == ':') {
            continue;
        }
        let rest = &code[at + prefix.len()..];
        if let Some(group) = rest.strip_prefix('{') {
            names.extend(group_names(group));
        } else {
            names.push(rest.chars().take_while(|c| c.is_alphanumeric() || *c == '_').collect());
        }
    }
    names
}

/// The first name of each entry of a group, up to the brace that closes it.
fn group_names(group: &str) -> Vec<String> {
    let (mut names, mut name, mut depth, mut at_start) = (vec![], String::new(), 0, true);
    for c in group.chars() {
        match c {
            '{' => depth += 1,
            '}' if depth == 0 => break,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                names.push(std::mem::take(&mut name));
                at_start = true;
            }
            ':' => at_start = false,
            c if depth == 0 && at_start && (c.is_alphanumeric() || c == '_') => name.push(c),
            _ => {}
        }
    }
    names.push(name);
    names.retain(|n| !n.is_empty());
    names
}

#[test]
fn every_import_goes_down() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = vec![];
    sources(&root, &mut files);
    assert!(files.len() > 20, "only {} files in src", files.len());
    let mut wrong = vec![];
    let mut imports = 0;
    for file in files {
        let inside = file.strip_prefix(&root).expect("it was found there");
        let module = inside.components().next().expect("a name").as_os_str().to_string_lossy().replace(".rs", "");
        floor(&module);
        if module == "lib" {
            continue;
        }
        let code = code(&fs::read_to_string(&file).expect("a readable file"));
        let mut names = first_names(&code, "crate::");
        // `super` of a file that is directly in src, or of a mod.rs, is the crate itself.
        let top = inside.components().count() == 1 || (inside.ends_with("mod.rs") && inside.components().count() == 2);
        if top {
            names.extend(first_names(&code, "super::"));
        }
        names.extend(first_names(&code, "super::super::").into_iter().filter(|_| inside.components().count() == 2));
        imports += names.len();
        for name in names {
            if !may_import(&module, &name) {
                wrong.push(format!("{} (floor {}) imports {name}", inside.display(), floor(&module)));
            }
        }
    }
    assert!(imports > 40, "only {imports} imports were found");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The paths in a piece of code that start with `crate`, `self` or `super`, groups written out, as lists of names. What a
/// module passes on to its users by `pub use` is not an import of its own.
fn paths(code: &str) -> Vec<Vec<String>> {
    /// Reads a path or a group from `at` on; returns where it ends.
    fn read(code: &[char], mut at: usize, before: &[String], found: &mut Vec<Vec<String>>) -> usize {
        let mut path = before.to_vec();
        loop {
            while code.get(at).is_some_and(|c| c.is_whitespace()) {
                at += 1;
            }
            if code.get(at) == Some(&'{') {
                at += 1;
                while code.get(at).is_some_and(|&c| c != '}') {
                    let next = read(code, at, &path, found);
                    at = if next == at { at + 1 } else { next };
                }
                return at + 1;
            }
            let name: String = code[at..].iter().take_while(|c| c.is_alphanumeric() || **c == '_').collect();
            at += name.chars().count();
            if name.is_empty() {
                return at;
            }
            path.push(name);
            if code.get(at..at + 2) != Some(&[':', ':']) {
                found.push(path);
                return at;
            }
            at += 2;
        }
    }
    let mut found = vec![];
    for statement in code.split(';') {
        let words = statement.trim_start();
        if words.starts_with("pub") && words.contains(" use ") && words.find(" use ") < words.find("::") {
            continue;
        }
        let letters: Vec<char> = statement.chars().collect();
        let mut at = 0;
        while at < letters.len() {
            let starts = |word: &str| letters[at..].starts_with(&word.chars().collect::<Vec<_>>());
            let fresh = at == 0 || !(letters[at - 1].is_alphanumeric() || "_$:".contains(letters[at - 1]));
            if fresh && ["crate::", "self::", "super::"].iter().any(|word| starts(word)) {
                at = read(&letters, at, &[], &mut found);
            } else {
                at += 1;
            }
        }
    }
    found
}

/// The names of the modules above a file and its own: `["raster", "polygon", "edge"]`.
fn module_of(inside: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        inside.with_extension("").components().map(|c| c.as_os_str().to_string_lossy().into_owned()).collect();
    if names.last().is_some_and(|name| name == "mod") {
        names.pop();
    }
    names
}

/// A file that imports from another one is not imported by it: each pair of files can be read in one order.
#[test]
fn no_two_files_import_each_other() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = vec![];
    sources(&root, &mut files);
    let modules: Vec<(Vec<String>, String)> = files
        .iter()
        .map(|file| (module_of(file.strip_prefix(&root).expect("it was found there")), file))
        .filter(|(module, _)| module != &["lib"])
        .map(|(module, file)| (module, code(&fs::read_to_string(file).expect("a readable file"))))
        .collect();
    let mut imports = std::collections::HashSet::new();
    for (module, code) in &modules {
        for path in paths(code) {
            let mut target = match path[0].as_str() {
                "crate" => vec![],
                _ => module.clone(),
            };
            for name in &path {
                match name.as_str() {
                    "crate" | "self" => {}
                    "super" => drop(target.pop()),
                    name => {
                        target.push(name.to_owned());
                        if !modules.iter().any(|(known, _)| *known == target) {
                            target.pop();
                            break;
                        }
                    }
                }
            }
            if target != *module && !target.is_empty() {
                imports.insert((module.join("::"), target.join("::")));
            }
        }
    }
    assert!(imports.len() > 150, "only {} imports were found", imports.len());
    let mut both: Vec<_> = imports.iter().filter(|(a, b)| a < b && imports.contains(&(b.clone(), a.clone()))).collect();
    both.sort();
    assert!(both.is_empty(), "these import each other: {both:?}");
}

#[test]
fn the_reader_of_imports_reads_imports() {
    let text = "use crate::{\n  a::{b, c}, // crate::x\n  d,\n  e::f as g,\n};\nlet x = crate::h::i(); \"crate::y\" $crate::j!(); my_crate::k;\n\
                #[cfg(test)]\nmod tests { use crate::l; }";
    assert_eq!(first_names(&code(text), "crate::"), ["a", "d", "e", "h"]);
    assert!(may_import("raster", "geom") && may_import("raster", "raster") && may_import("eg", "surface"));
    assert!(
        !may_import("raster", "surface")
            && !may_import("pixel", "geom")
            && !may_import("num", "span")
            && may_import("span", "num")
    );
}

/// What a firmware takes over with this crate is three small crates; each has its reason in Cargo.toml.
#[test]
fn the_dependencies_are_the_three() {
    let manifest = fs::read_to_string(Path::new(env!("CARGO_MANIFEST_DIR")).join("Cargo.toml")).expect("a manifest");
    let section = manifest.split("\n[dependencies]\n").nth(1).expect("a list of dependencies");
    let section = section.split("\n[").next().expect("at least its start");
    let mut names: Vec<&str> = section
        .lines()
        .filter(|l| !l.starts_with('#'))
        .filter_map(|l| l.split_once('='))
        .map(|(n, _)| n.trim())
        .collect();
    names.sort_unstable();
    assert_eq!(names, ["bytemuck", "embedded-graphics-core", "fixed"]);
    assert!(!manifest.contains("[build-dependencies]"), "nothing is built for the build");
    assert!(!manifest.contains("[target."), "no chip has dependencies of its own");
    // No default features: they are where alloc, std and serde come in. (embedded-graphics-core has none by default.)
    for line in section.lines().filter(|l| l.contains('=') && !l.starts_with('#')) {
        let plain = line.starts_with("embedded-graphics-core");
        assert!(plain || line.contains("default-features = false"), "{line}");
    }
}
