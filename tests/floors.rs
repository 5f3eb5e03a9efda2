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

/// All paths of the `use` statements of a file, one for each name: `use a::{b, c::d}` has `a::b` and `a::c::d`.
fn imported_paths(code: &str) -> Vec<String> {
    let mut paths = vec![];
    for statement in code.split(';') {
        let Some(at) = statement.rfind("use ") else { continue };
        let is_word = statement[..at].chars().next_back().is_none_or(char::is_whitespace);
        if is_word {
            let tree: String = statement[at + 4..].chars().filter(|c| !c.is_whitespace()).collect();
            expand(&tree, "", &mut paths);
        }
    }
    paths
}

/// Writes out the groups in braces.
fn expand(tree: &str, prefix: &str, paths: &mut Vec<String>) {
    let (mut depth, mut start) = (0, 0);
    for (at, c) in tree.char_indices().chain([(tree.len(), ',')]) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let entry = &tree[start..at];
                start = at + 1;
                match entry.split_once('{') {
                    Some((head, group)) => {
                        expand(group.strip_suffix('}').unwrap_or(group), &format!("{prefix}{head}"), paths);
                    }
                    None if !entry.is_empty() => paths.push(format!("{prefix}{entry}")),
                    None => {}
                }
            }
            _ => {}
        }
    }
}

/// The file that a path names something of, seen from another file: the innermost module on it that is a file.
fn file_of(path: &str, from: &Path, root: &Path) -> Option<PathBuf> {
    let is_root = from.file_name().is_some_and(|name| name == "mod.rs");
    let mut module = if is_root { from.parent()?.to_path_buf() } else { from.with_extension("") };
    let mut names = path.split("::").peekable();
    while let Some(name) = names.next_if(|name| ["crate", "self", "super"].contains(name)) {
        module = match name {
            "crate" => root.to_path_buf(),
            "super" => module.parent()?.to_path_buf(),
            _ => module,
        };
    }
    let file =
        |module: &Path| [module.with_extension("rs"), module.join("mod.rs")].into_iter().find(|file| file.is_file());
    let mut found = if module == root { None } else { file(&module) };
    for name in names {
        module.push(name);
        match file(&module) {
            Some(inner) => found = Some(inner),
            None => break,
        }
    }
    found
}

/// One file explains what the next one builds on; no two explain each other.
#[test]
fn no_two_files_import_each_other() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut files = vec![];
    sources(&root, &mut files);
    let mut imports = vec![];
    for from in files {
        let paths = imported_paths(&code(&fs::read_to_string(&from).expect("a readable file")));
        for to in paths.iter().filter_map(|path| file_of(path, &from, &root)).filter(|to| *to != from) {
            imports.push((from.clone(), to));
        }
    }
    assert!(imports.len() > 150, "only {} imports were found", imports.len());
    let mutual: Vec<_> = imports.iter().filter(|(from, to)| imports.contains(&(to.clone(), from.clone()))).collect();
    assert!(mutual.is_empty(), "{mutual:#?}");
}

#[test]
fn paths_are_found_in_files() {
    let code = "pub use self::a::B;\nuse crate::{\n    c::{d, e::F as G},\n    h,\n};\nfn because() { reuse (i); }";
    assert_eq!(imported_paths(code), ["self::a::B", "crate::c::d", "crate::c::e::FasG", "crate::h"]);
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let file = |path, from: &str| {
        let file = file_of(path, &root.join(from), &root)?;
        Some(file.strip_prefix(&root).expect("it lies there").to_string_lossy().replace('\\', "/"))
    };
    let exact = Some("geom/exact.rs".to_owned());
    assert_eq!(file("super::exact::turn", "geom/clip.rs"), exact);
    assert_eq!(file("crate::geom::exact::turn", "geom/triangulate/ears.rs"), exact);
    assert_eq!(file("exact::turn", "geom/mod.rs"), exact);
    assert_eq!(file("super::PointFx", "geom/clip.rs"), Some("geom/mod.rs".to_owned()));
    assert_eq!(file("core::cmp::Ordering", "geom/clip.rs"), Some("geom/clip.rs".to_owned()));
}

/// What a firmware takes over with this crate is four small crates, and `defmt` if it asks for it; each has its reason in
/// Cargo.toml.
#[test]
fn the_dependencies_are_the_four() {
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
    assert_eq!(names, ["bytemuck", "defmt", "embedded-graphics-core", "fixed", "heapless"]);
    assert!(!manifest.contains("\ndefault = "), "optional is what nobody gets without asking");
    assert!(!manifest.contains("[build-dependencies]"), "nothing is built for the build");
    assert!(!manifest.contains("[target."), "no chip has dependencies of its own");
    // No default features: they are where alloc, std and serde come in. (embedded-graphics-core has none by default.)
    for line in section.lines().filter(|l| l.contains('=') && !l.starts_with('#')) {
        assert_eq!(line.contains("optional = true"), line.starts_with("defmt"), "{line}");
        let plain = line.starts_with("embedded-graphics-core");
        assert!(plain || line.contains("default-features = false"), "{line}");
    }
}
