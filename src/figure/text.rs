//! Text with sub- and superscripts: `ω_{r}`, `sr^{-1}`.

/// Where a run stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// On the line.
    Base,
    /// Below it and smaller.
    Sub,
    /// Above it and smaller.
    Sup,
}

/// A stretch of text on one level.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The letters.
    pub text: String,
    /// Where they stand.
    pub level: Level,
}

/// A line of text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct RichText {
    /// From left to right; none is empty.
    pub runs: Vec<Run>,
}

impl RichText {
    /// Reads the markup `_{…}` and `^{…}`. What is no markup is text: nothing fails.
    pub fn parse(markup: &str) -> Self {
        let mut runs = Vec::new();
        let mut push = |text: &str, level| {
            if !text.is_empty() {
                runs.push(Run {
                    text: text.to_string(),
                    level,
                });
            }
        };
        let mut rest = markup;
        while let Some((at, level)) = next_opening(rest) {
            let inside = &rest[at + 2..];
            let Some(end) = inside.find('}') else { break };
            push(&rest[..at], Level::Base);
            push(&inside[..end], level);
            rest = &inside[end + 1..];
        }
        push(rest, Level::Base);
        Self { runs }
    }

    /// The letters alone, for file names, screen readers and widths.
    pub fn plain(&self) -> String {
        self.runs.iter().map(|run| run.text.as_str()).collect()
    }

    /// Rough width at a font size, for placing labels: true widths are known to painters only.
    pub fn estimated_width(&self, font_size: f32) -> f32 {
        let width = |run: &Run| {
            let size = if run.level == Level::Base { 1.0 } else { SMALL };
            0.54 * size * run.text.chars().count() as f32
        };
        font_size * self.runs.iter().map(width).sum::<f32>()
    }
}

/// Size of sub- and superscripts per size of the line.
pub const SMALL: f32 = 0.72;

fn next_opening(text: &str) -> Option<(usize, Level)> {
    let sub = text.find("_{").map(|at| (at, Level::Sub));
    let sup = text.find("^{").map(|at| (at, Level::Sup));
    sub.into_iter().chain(sup).min_by_key(|(at, _)| *at)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn levels(markup: &str) -> String {
        let show = |run: &Run| match run.level {
            Level::Base => run.text.clone(),
            Level::Sub => format!("[{}]", run.text),
            Level::Sup => format!("<{}>", run.text),
        };
        RichText::parse(markup).runs.iter().map(show).collect()
    }

    #[test]
    fn markup_becomes_runs() {
        assert_eq!(levels("ω_{r}·ω_{o}"), "ω[r]·ω[o]");
        assert_eq!(levels("(ω_{h}·n)^{4}"), "(ω[h]·n)<4>");
        assert_eq!(RichText::parse("f_{r} [sr^{-1}]").plain(), "fr [sr-1]");
    }

    #[test]
    fn what_is_no_markup_is_text() {
        for plain in [
            "",
            "a_b",
            "2^3",
            "open _{",
            "}{",
            "a_{}b".replace("_{}", "").as_str(),
        ] {
            assert_eq!(levels(plain), plain);
        }
    }
}
