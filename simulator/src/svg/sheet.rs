//! What the `style` elements of a file say, as the crate `simplecss` reads them.

use std::collections::BTreeSet;

use roxmltree::{Document, Node};
use simplecss::{AttributeOperator, Element, PseudoClass, StyleSheet};

/// The texts of all style sheets of a document.
pub(super) fn texts(document: &Document<'_>) -> Vec<String> {
    let sheets = document.descendants().filter(|node| node.tag_name().name() == "style");
    sheets.map(|sheet| sheet.children().filter_map(|part| part.text().filter(|_| part.is_text())).collect()).collect()
}

/// The rules of some texts, those that count least first.
pub(super) fn rules<'a>(texts: &'a [String], unknown: &mut BTreeSet<String>) -> StyleSheet<'a> {
    let mut rules = StyleSheet::new();
    for text in texts {
        let before = rules.rules.len();
        rules.parse_more(text);
        if text.contains('@') {
            unknown.insert("rules of style sheets that begin with `@`".into());
        } else if rules.rules.len() == before && !text.trim().is_empty() {
            unknown.insert(format!("the style sheet `{}`", text.trim()));
        }
    }
    rules
}

/// An element, as selectors look at it.
pub(super) struct Styled<'a, 'input>(pub(super) Node<'a, 'input>);

impl Element for Styled<'_, '_> {
    fn parent_element(&self) -> Option<Self> {
        self.0.parent_element().map(Self)
    }

    fn prev_sibling_element(&self) -> Option<Self> {
        self.0.prev_sibling_element().map(Self)
    }

    fn has_local_name(&self, name: &str) -> bool {
        self.0.tag_name().name() == name
    }

    fn attribute_matches(&self, local_name: &str, operator: AttributeOperator<'_>) -> bool {
        self.0.attribute(local_name).is_some_and(|value| operator.matches(value))
    }

    fn pseudo_class_matches(&self, class: PseudoClass<'_>) -> bool {
        class == PseudoClass::FirstChild && self.prev_sibling_element().is_none()
    }
}
