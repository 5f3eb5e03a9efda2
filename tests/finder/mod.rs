//! [`Source`]: what is public in a source, found by its words and brackets.
//!
//! It need not follow modules and re-exports: the compiler warns of a `pub` that nobody can reach, so what is `pub` is public.

use std::{collections::BTreeSet, fs, path::Path};

/// What was found.
#[derive(Default)]
pub(crate) struct Source {
    functions: Vec<String>,
    implemented: Vec<Implemented>,
    /// Public structures and enumerations.
    types: BTreeSet<String>,
    /// All others: nobody can call what they implement.
    hidden: BTreeSet<String>,
    /// Traits, public or not.
    traits: BTreeSet<String>,
    /// What is re-exported from other crates: their functions cannot be seen here.
    pub(crate) foreign: Vec<String>,
}

/// A function that a type has because it implements a trait.
struct Implemented {
    of: String,
    owner: String,
    name: String,
}

/// Where items stand.
#[derive(Clone, Copy)]
enum Place<'a> {
    Module(&'a str),
    /// Everything in it is as public as the trait.
    Trait(&'a str),
    Type(&'a str),
    Implementation {
        of: &'a str,
        owner: &'a str,
    },
}

impl Source {
    /// Of all files in a folder.
    pub(crate) fn of_folder(folder: &Path) -> Self {
        let mut source = Self::default();
        source.add_folder(folder);
        source
    }

    fn add_folder(&mut self, folder: &Path) {
        for entry in fs::read_dir(folder).unwrap_or_else(|error| panic!("{}: {error}", folder.display())) {
            let path = entry.expect("an entry of a folder").path();
            if path.is_dir() {
                self.add_folder(&path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let stem = path.file_stem().and_then(|stem| stem.to_str()).expect("a name");
                let above = folder.file_name().and_then(|name| name.to_str()).expect("a name");
                let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
                self.add(&text, if stem == "mod" { above } else { stem });
            }
        }
    }

    /// Adds the text of a module.
    pub(crate) fn add(&mut self, text: &str, module: &str) {
        self.items(&tokens(text), Place::Module(module));
    }

    /// The names of what can be called from outside, as `owner::function`, sorted. Functions of the same name are there as often
    /// as they are in the source. The owner is a type, a trait or the last module. What a trait of this source asks of a type
    /// is named as the trait's; what other traits ask, as the type's.
    pub(crate) fn names(&self) -> Vec<String> {
        let public = |it: &&Implemented| !self.traits.contains(&it.of) && !self.hidden.contains(&it.owner);
        let implemented = self.implemented.iter().filter(public).map(|it| format!("{}::{}", it.owner, it.name));
        let mut names: Vec<String> = self.functions.iter().cloned().chain(implemented).collect();
        names.sort();
        names
    }

    fn items(&mut self, mut tokens: &[String], place: Place<'_>) {
        while !tokens.is_empty() {
            tokens = self.item(tokens, place);
        }
    }

    /// Looks at the first item; returns what comes after it.
    fn item<'a>(&mut self, mut tokens: &'a [String], place: Place<'_>) -> &'a [String] {
        let mut only_tests = false;
        while let ["#", ..] = words(tokens)[..] {
            let inner = usize::from(tokens.get(1).is_some_and(|token| token == "!"));
            let (attribute, rest) = group(&tokens[1 + inner..]);
            let has = |word| attribute.iter().any(|token| token == word);
            only_tests |= has("cfg") && has("test") && !has("not");
            tokens = rest;
        }
        let mut public = false;
        match words(tokens)[..] {
            ["pub", "(", ..] => tokens = group(&tokens[1..]).1,
            ["pub", ..] => (public, tokens) = (true, &tokens[1..]),
            ["$", "vis", ..] => (public, tokens) = (true, &tokens[2..]),
            _ => {}
        }
        let is_qualifier =
            |word: &str| ["const", "unsafe", "async", "extern", "safe", "default", "\"\""].contains(&word);
        let qualifiers = tokens.iter().take_while(|token| is_qualifier(token)).count();
        if tokens.get(qualifiers).is_some_and(|token| token == "fn") {
            let (name, rest) = name(&tokens[qualifiers + 1..]);
            if !only_tests {
                self.function(name, public, place);
            }
            return body(rest).1;
        }
        let Some(first) = tokens.first() else { return tokens };
        let (named, rest) = name(&tokens[1..]);
        match (first.as_str(), rest.first().map(String::as_str)) {
            ("mod", Some("{")) => {
                let (inside, rest) = group(rest);
                if !only_tests {
                    self.items(inside, Place::Module(&named));
                }
                rest
            }
            ("trait", _) => {
                let (_, inside, rest) = head_and_body(rest);
                self.traits.insert(named.clone());
                if public && !only_tests {
                    self.items(inside, Place::Trait(&named));
                }
                rest
            }
            ("impl", _) => {
                let (head, inside, rest) = head_and_body(&tokens[1..]);
                let (of, owner) = implementation(head);
                match of {
                    _ if only_tests => {}
                    Some(of) => self.items(inside, Place::Implementation { of: &of, owner: &owner }),
                    None => self.items(inside, Place::Type(&owner)),
                }
                rest
            }
            ("struct" | "enum" | "union", _) => {
                let known = if public { &mut self.types } else { &mut self.hidden };
                known.insert(named);
                body(rest).1
            }
            ("macro_rules", _) => {
                // A rule is a matcher, an arrow, and items.
                let (mut rules, rest) = group(&tokens[3..]);
                while !rules.is_empty() {
                    let (_, arrow) = group(rules);
                    let (made, next) = group(arrow.get(2..).unwrap_or_default());
                    self.items(made, place);
                    rules = next.strip_prefix(&[";".to_owned()]).unwrap_or(next);
                }
                rest
            }
            ("use", _) => {
                let end = tokens.iter().position(|token| token == ";").unwrap_or(tokens.len() - 1);
                let crates = ["embedded_graphics_core", "fixed", "bytemuck", "heapless", "core", "defmt"];
                if public && crates.contains(&named.as_str()) && rest.first().is_some_and(|token| token == ":") {
                    self.foreign.push(tokens[1..end].concat());
                }
                &tokens[end + 1..]
            }
            ("const" | "static" | "type", _) => {
                let mut rest = tokens;
                while let Some(token) = rest.first().filter(|&token| token != ";") {
                    rest = if is_open(token) { group(rest).1 } else { &rest[1..] };
                }
                rest.get(1..).unwrap_or_default()
            }
            (first, _) if is_open(first) => group(tokens).1,
            _ => &tokens[1..],
        }
    }

    fn function(&mut self, name: String, public: bool, place: Place<'_>) {
        match place {
            Place::Trait(owner) => self.functions.push(format!("{owner}::{name}")),
            Place::Module(owner) | Place::Type(owner) if public => self.functions.push(format!("{owner}::{name}")),
            Place::Implementation { of, owner } => {
                self.implemented.push(Implemented { of: of.to_owned(), owner: owner.to_owned(), name });
            }
            _ => {}
        }
    }
}

/// Words, lifetimes and single signs; literals of strings and characters are `""`, comments nothing.
fn tokens(text: &str) -> Vec<String> {
    let (letters, mut tokens, mut i) = (text.chars().collect::<Vec<_>>(), vec![], 0);
    let at = |i: usize| letters.get(i).copied().unwrap_or('\0');
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    while i < letters.len() {
        let start = i;
        match (at(i), at(i + 1)) {
            ('/', '/') => {
                while i < letters.len() && at(i) != '\n' {
                    i += 1;
                }
            }
            ('/', '*') => {
                let mut depth = 0;
                loop {
                    let step = match (at(i), at(i + 1)) {
                        ('/', '*') => 1,
                        ('*', '/') => -1,
                        _ => 0,
                    };
                    depth += step;
                    i += if step == 0 { 1 } else { 2 };
                    if depth == 0 || i >= letters.len() {
                        break;
                    }
                }
            }
            ('r', '"' | '#') if raw_string(&letters[i + 1..]).is_some() => {
                i += 1 + raw_string(&letters[i + 1..]).unwrap_or(0);
                tokens.push("\"\"".to_owned());
            }
            ('"', _) => {
                i += 1;
                while i < letters.len() && at(i) != '"' {
                    i += if at(i) == '\\' { 2 } else { 1 };
                }
                i += 1;
                tokens.push("\"\"".to_owned());
            }
            // A character, or a lifetime.
            ('\'', next) if next == '\\' || at(i + 2) == '\'' => {
                i += if next == '\\' { 3 } else { 2 };
                while i < letters.len() && at(i) != '\'' {
                    i += 1;
                }
                i += 1;
                tokens.push("\"\"".to_owned());
            }
            (c, _) if is_word(c) || c == '\'' => {
                i += 1;
                while is_word(at(i)) {
                    i += 1;
                }
                tokens.push(letters[start..i].iter().collect());
            }
            (c, _) => {
                i += 1;
                if !c.is_whitespace() {
                    tokens.push(c.to_string());
                }
            }
        }
    }
    tokens
}

/// How long a raw string is after its `r`, if it is one.
fn raw_string(letters: &[char]) -> Option<usize> {
    let hashes = letters.iter().take_while(|&&c| c == '#').count();
    let inside = letters.get(hashes..).filter(|rest| rest.first() == Some(&'"'))?;
    let end = |at: &usize| inside[*at] == '"' && inside[at + 1..].iter().take_while(|&&c| c == '#').count() >= hashes;
    (1..inside.len()).find(end).map(|at| hashes + at + 1 + hashes)
}

/// The first ones, to compare.
fn words(tokens: &[String]) -> Vec<&str> {
    tokens.iter().take(2).map(String::as_str).collect()
}

fn is_open(token: &str) -> bool {
    ["(", "[", "{"].contains(&token)
}

/// What is between the bracket that comes first and the one that closes it, and what comes after.
fn group(tokens: &[String]) -> (&[String], &[String]) {
    let mut depth = 0;
    for (i, token) in tokens.iter().enumerate() {
        match token.as_str() {
            "(" | "[" | "{" => depth += 1,
            ")" | "]" | "}" => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return (tokens.get(1..i).unwrap_or_default(), &tokens[i + 1..]);
        }
    }
    (&[], &[])
}

/// A name, which may be a macro's.
fn name(tokens: &[String]) -> (String, &[String]) {
    match words(tokens)[..] {
        ["$", name] => (format!("${name}"), &tokens[2..]),
        [name, ..] => (name.to_owned(), &tokens[1..]),
        _ => (String::new(), tokens),
    }
}

/// What comes before a body in braces, the body, and what comes after; or up to a semicolon.
fn head_and_body(tokens: &[String]) -> (&[String], &[String], &[String]) {
    let mut rest = tokens;
    while let Some(token) = rest.first() {
        let head = &tokens[..tokens.len() - rest.len()];
        match token.as_str() {
            "{" => {
                let (inside, rest) = group(rest);
                return (head, inside, rest);
            }
            ";" => return (head, &[], &rest[1..]),
            token if is_open(token) => rest = group(rest).1,
            _ => rest = &rest[1..],
        }
    }
    (tokens, &[], &[])
}

fn body(tokens: &[String]) -> (&[String], &[String]) {
    let (_, inside, rest) = head_and_body(tokens);
    (inside, rest)
}

/// The trait and the type of an `impl`, without what is generic in them.
fn implementation(head: &[String]) -> (Option<String>, String) {
    let mut parts = [String::new(), String::new()];
    let (mut depth, mut part) = (0, 0);
    for (i, token) in head.iter().enumerate() {
        let arrow = i > 0 && head[i - 1] == "-";
        match token.as_str() {
            "<" => depth += 1,
            ">" if !arrow => depth -= 1,
            "where" if depth == 0 => break,
            "for" if depth == 0 => part = 1,
            "mut" | "dyn" => {}
            // The last word of a path counts.
            word if depth == 0 && word.starts_with(|c: char| c.is_alphabetic() || c == '_') => {
                let sign = if i > 0 && head[i - 1] == "$" { "$" } else { "" };
                parts[part] = format!("{sign}{word}");
            }
            _ => {}
        }
    }
    match parts {
        [owner, other] if other.is_empty() => (None, owner),
        [of, owner] => (Some(of), owner),
    }
}
