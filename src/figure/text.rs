//! Markup for labels and formulas: `ω_{r}` is a subscript, `x^{4}` a superscript, `sr^{−1}` a unit.
//!
//! A level ends at the next `}`; levels do not nest. Whatever is not markup is text, so parsing never fails.

/// Height of a run in its line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ScriptLevel {
    /// Text on the line.
    Base,
    /// Below it and smaller.
    Sub,
    /// Above it and smaller.
    Sup,
}

/// Size of a subscript or superscript, relative to the text around it.
pub const SCRIPT_SIZE: f32 = 0.72;

impl ScriptLevel {
    /// Size of its letters, relative to the base.
    pub fn relative_size(self) -> f32 {
        match self {
            Self::Base => 1.0,
            Self::Sub | Self::Sup => SCRIPT_SIZE,
        }
    }
}

/// A piece of text on one level; never empty.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct TextRun {
    /// Characters of the run.
    pub text: String,
    /// Height in the line.
    pub level: ScriptLevel,
}

/// One line of text with subscripts and superscripts.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RichText {
    /// Runs from left to right.
    pub runs: Vec<TextRun>,
}

impl RichText {
    /// Reads markup. A `_{` or `^{` without its `}` stays as it is.
    pub fn parse(markup: &str) -> Self {
        let mut text = Self::default();
        let mut rest = markup;
        let mut searched = 0;
        while let Some(found) = rest[searched..].find(['_', '^']) {
            let at = searched + found;
            let after = &rest[at + 1..];
            let inside = after
                .strip_prefix('{')
                .and_then(|inside| inside.split_once('}'));
            let Some((inside, behind)) = inside else {
                searched = at + 1;
                continue;
            };
            let level = if rest.as_bytes()[at] == b'_' {
                ScriptLevel::Sub
            } else {
                ScriptLevel::Sup
            };
            text.push(&rest[..at], ScriptLevel::Base);
            text.push(inside, level);
            (rest, searched) = (behind, 0);
        }
        text.push(rest, ScriptLevel::Base);
        text
    }

    /// Text without markup: names that people chose, where `_{` means itself.
    pub fn literal(text: &str) -> Self {
        let mut literal = Self::default();
        literal.push(text, ScriptLevel::Base);
        literal
    }

    /// Characters without levels: for screen readers and searching.
    pub fn plain(&self) -> String {
        self.runs.iter().map(|run| run.text.as_str()).collect()
    }

    /// Estimated width in units of the font size; within about 15 % for the fonts in use.
    pub fn width_em(&self) -> f32 {
        self.runs
            .iter()
            .map(|run| run.level.relative_size() * run.text.chars().map(char_em).sum::<f32>())
            .sum()
    }

    fn push(&mut self, text: &str, level: ScriptLevel) {
        if !text.is_empty() {
            self.runs.push(TextRun {
                text: text.to_owned(),
                level,
            });
        }
    }
}

/// A plain name, cut with an ellipsis where it is wider than `width_em`.
pub fn elided(name: &str, width_em: f32) -> RichText {
    let whole = RichText::literal(name);
    if whole.width_em() <= width_em {
        return whole;
    }
    let mut kept = String::new();
    let mut used = char_em('…');
    for letter in name.chars() {
        used += char_em(letter);
        if used > width_em {
            break;
        }
        kept.push(letter);
    }
    RichText::literal(&format!("{}…", kept.trim_end()))
}

fn char_em(letter: char) -> f32 {
    match letter {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '·' | '\'' | '|' | ' ' => 0.25,
        'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '-' | '/' | '°' => 0.37,
        'm' | 'w' | 'M' | 'W' | '@' | '…' | '—' => 0.85,
        letter if letter.is_uppercase() || letter == 'ω' => 0.66,
        // Scripts that are set in squares.
        '\u{1100}'..='\u{11ff}' | '\u{2e80}'.. => 1.0,
        _ => 0.55,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn runs(markup: &str) -> Vec<(String, ScriptLevel)> {
        RichText::parse(markup)
            .runs
            .into_iter()
            .map(|run| (run.text, run.level))
            .collect()
    }

    fn run(text: &str, level: ScriptLevel) -> (String, ScriptLevel) {
        (text.to_owned(), level)
    }

    #[test]
    fn levels_are_read() {
        use ScriptLevel::{Base, Sub, Sup};
        assert_eq!(runs("sr^{−1}"), [run("sr", Base), run("−1", Sup)]);
        assert_eq!(
            runs("(ω_{h}·n)^{4s}"),
            [
                run("(ω", Base),
                run("h", Sub),
                run("·n)", Base),
                run("4s", Sup)
            ]
        );
        assert_eq!(
            runs("k_{s}^{2}"),
            [run("k", Base), run("s", Sub), run("2", Sup)]
        );
        assert_ne!(runs("x^{4}"), runs("x_{4}"));
    }

    #[test]
    fn what_is_no_markup_is_text() {
        for text in [
            "a_b", "a^b", "x_{open", "}", "{a}", "_", "^", "5 ^ {3}", "ω_", "_^{",
        ] {
            assert_eq!(runs(text), [run(text, ScriptLevel::Base)], "{text}");
        }
        assert_eq!(runs(""), []);
        assert_eq!(runs("x_{}"), [run("x", ScriptLevel::Base)]);
        assert_eq!(
            runs("a_b_{c}"),
            [run("a_b", ScriptLevel::Base), run("c", ScriptLevel::Sub)]
        );
        assert_eq!(RichText::literal("a_{b}").plain(), "a_{b}");
        assert_eq!(RichText::parse("a_{b}").plain(), "ab");
    }

    #[test]
    fn long_names_are_cut() {
        assert_eq!(elided("nickel", 10.0).plain(), "nickel");
        let cut = elided("specular-orange-phenolic-remeasured", 6.0);
        assert!(cut.plain().ends_with('…') && cut.plain().starts_with("spec"));
        assert!(cut.width_em() <= 6.0);
    }

    #[test]
    fn formulas_of_all_models_read_without_braces() {
        for model in crate::brdf::MODELS {
            let mut texts = vec![model.formula];
            texts.extend(model.rows().map(|param| param.symbol));
            for text in texts {
                let plain = RichText::parse(text).plain();
                assert!(!plain.contains(['{', '}', '_', '^']), "{text}: {plain}");
            }
        }
    }
}
