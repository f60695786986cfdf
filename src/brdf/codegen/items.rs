//! The top-level functions and structs of WGSL texts, and the dependencies between them.

use std::collections::BTreeSet;

/// The top-level functions and structs of texts in which each begins and ends at the left margin.
pub struct WgslItems {
    all: Vec<WgslItem>,
}

struct WgslItem {
    name: String,
    /// Source text with the comment right above it.
    text: String,
}

impl WgslItems {
    /// Splits the texts into items.
    pub fn new(texts: &[&str]) -> Self {
        let mut all = Vec::new();
        for text in texts {
            let mut item = String::new();
            let mut name = None;
            for line in text.lines() {
                if line.is_empty() && name.is_none() {
                    // A comment that stands alone belongs to the file.
                    item.clear();
                    continue;
                }
                item.push_str(line);
                item.push('\n');
                if name.is_none() && !line.starts_with("//") {
                    name = words(line).nth(1).map(str::to_owned);
                }
                if line == "}" {
                    let text = std::mem::take(&mut item);
                    all.extend(name.take().map(|name| WgslItem { name, text }));
                }
            }
        }
        Self { all }
    }

    /// Text of an item and all items that it depends on, each after its own dependencies. Names of all but the item get
    /// a prefix, so that they collide with no others: `brdf_` for functions, `Brdf` for structs.
    pub fn needed_by(&self, name: &str) -> String {
        let mut order = Vec::new();
        self.visit(name, &mut BTreeSet::new(), &mut order);
        let mut text = String::new();
        for item in order {
            if !text.is_empty() {
                text.push('\n');
            }
            for token in tokens(&item.text) {
                let is_item = self.all.iter().any(|item| item.name == token);
                if is_item && token != name {
                    let is_struct = token.starts_with(char::is_uppercase);
                    text.push_str(if is_struct { "Brdf" } else { "brdf_" });
                }
                text.push_str(token);
            }
        }
        text
    }

    fn visit<'a>(
        &'a self,
        name: &str,
        seen: &mut BTreeSet<&'a str>,
        order: &mut Vec<&'a WgslItem>,
    ) {
        let Some(item) = self.all.iter().find(|item| item.name == name) else {
            return;
        };
        if seen.insert(&item.name) {
            for word in words(&item.text) {
                self.visit(word, seen, order);
            }
            order.push(item);
        }
    }
}

/// Words of a text, comments left out.
fn words(text: &str) -> impl Iterator<Item = &str> {
    tokens(text).filter(|token| token.starts_with(is_word))
}

/// Tokens of a text: words and numbers, runs of white space, comments, single signs. Concatenated they are the text.
pub fn tokens(text: &str) -> impl Iterator<Item = &str> {
    let mut rest = text;
    std::iter::from_fn(move || {
        let first = rest.chars().next()?;
        let run = |inside: fn(char) -> bool| rest.find(|c| !inside(c)).unwrap_or(rest.len());
        let length = if is_word(first) {
            run(is_word)
        } else if first.is_whitespace() {
            run(char::is_whitespace)
        } else if rest.starts_with("//") {
            run(|c| c != '\n')
        } else {
            first.len_utf8()
        };
        let (token, after) = rest.split_at(length);
        rest = after;
        Some(token)
    })
}

/// Whether a character is part of a word: an ASCII letter or digit, or `_`.
pub fn is_word(c: char) -> bool {
    c.is_ascii_alphanumeric() || c == '_'
}
