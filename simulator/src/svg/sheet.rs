//! [`Sheet`]: what the `style` elements of a file say, by simple selectors: `path`, `.class`, `#id`, `path.class`, `*`.

use std::collections::BTreeSet;

use roxmltree::{Document, Node};

/// A name and what it is set to.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Declaration {
    pub(super) name: String,
    pub(super) value: String,
    pub(super) is_important: bool,
}

/// Declarations as they are written: `fill: none; stroke: red !important`.
pub(super) fn declarations(text: &str) -> Vec<Declaration> {
    let parts = text.split(';').filter_map(|part| part.split_once(':'));
    let all = parts.map(|(name, value)| {
        let value = value.trim();
        let important = value.rsplit_once('!').filter(|(_, word)| word.trim() == "important");
        let (value, is_important) = important.map_or((value, false), |(value, _)| (value.trim_end(), true));
        Declaration { name: name.trim().into(), value: value.into(), is_important }
    });
    all.collect()
}

/// Which elements a rule is about.
#[derive(Debug, Default)]
struct Selector {
    tag: Option<String>,
    classes: Vec<String>,
    ids: Vec<String>,
}

impl Selector {
    /// `None` if it is not a simple one.
    fn parse(text: &str) -> Option<Self> {
        let is_name =
            |name: &str| !name.is_empty() && name.chars().all(|c| c.is_alphanumeric() || c == '-' || c == '_');
        let mut selector = Self::default();
        let start = text.find(['.', '#']).unwrap_or(text.len());
        let (tag, mut rest) = text.split_at(start);
        match tag {
            "" if rest.is_empty() => return None,
            "" | "*" => {}
            tag => selector.tag = Some(is_name(tag).then(|| tag.to_owned())?),
        }
        while let Some(kind) = rest.chars().next() {
            let end = rest[1..].find(['.', '#']).map_or(rest.len(), |end| end + 1);
            let name = Some(&rest[1..end]).filter(|name| is_name(name))?.to_owned();
            if kind == '.' { &mut selector.classes } else { &mut selector.ids }.push(name);
            rest = &rest[end..];
        }
        Some(selector)
    }

    /// What is said of few says more.
    fn weight(&self) -> [usize; 3] {
        [self.ids.len(), self.classes.len(), usize::from(self.tag.is_some())]
    }

    fn is_about(&self, node: Node<'_, '_>) -> bool {
        let has_class =
            |class: &String| node.attribute("class").unwrap_or_default().split_whitespace().any(|one| one == class);
        self.tag.as_deref().is_none_or(|tag| tag == node.tag_name().name())
            && self.ids.iter().all(|id| node.attribute("id") == Some(id))
            && self.classes.iter().all(has_class)
    }
}

/// The rules of a file, those that count least first.
#[derive(Debug, Default)]
pub(super) struct Sheet {
    rules: Vec<(Selector, Vec<Declaration>)>,
}

impl Sheet {
    /// That of a document. Selectors that are not simple are named as unknown.
    pub(super) fn of(document: &Document<'_>, unknown: &mut BTreeSet<String>) -> Self {
        let mut rules = vec![];
        for sheet in document.descendants().filter(|node| node.tag_name().name() == "style") {
            let text: String = sheet.children().filter_map(|part| part.text().filter(|_| part.is_text())).collect();
            for rule in without_comments(&text).split('}') {
                let Some((selectors, body)) = rule.split_once('{') else { continue };
                for text in selectors.split(',').map(str::trim) {
                    match Selector::parse(text) {
                        Some(selector) => rules.push((selector, declarations(body))),
                        None => _ = unknown.insert(format!("the selector `{text}`")),
                    }
                }
            }
        }
        // Of rules that weigh the same, the last one counts.
        rules.sort_by_key(|(selector, _)| selector.weight());
        Self { rules }
    }

    /// What the rules say of an element, what counts most last.
    pub(super) fn about<'a>(&'a self, node: Node<'a, '_>) -> impl Iterator<Item = &'a Declaration> {
        self.rules.iter().filter(move |(selector, _)| selector.is_about(node)).flat_map(|(_, said)| said)
    }
}

fn without_comments(text: &str) -> String {
    let mut parts = text.split("/*");
    let mut rest = parts.next().unwrap_or_default().to_owned();
    rest.extend(parts.filter_map(|part| part.split_once("*/")).map(|(_, after)| after));
    rest
}
