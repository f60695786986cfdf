//! Searching the commands: fuzzy, the best first.

use crate::app::command::Entry;
use nucleo_matcher::pattern::{CaseMatching, Normalization, Pattern};
use nucleo_matcher::{Config, Matcher, Utf32Str};

/// A command that was found.
#[derive(Clone, Debug)]
pub struct Hit<'a> {
    /// The command.
    pub entry: &'a Entry,
    /// Positions of the characters of its title that match, ascending; none where only its menu or its sentence does.
    pub matched: Vec<u32>,
}

/// The commands that match all words of `text`, each as letters in order, which need not be neighbours. Those whose own
/// name matches come first, the best of them before the others; then those whose title does, which is the name with its
/// submenu; then those whose sentence has the words as they are. Equals, and all where there is no word, stay in menu order.
pub fn search<'a>(entries: impl IntoIterator<Item = &'a Entry>, text: &str) -> Vec<Hit<'a>> {
    let pattern = Pattern::parse(&escaped(text), CaseMatching::Ignore, Normalization::Smart);
    let mut matcher = Matcher::new(Config::DEFAULT);
    let words: Vec<String> = text.split_whitespace().map(str::to_lowercase).collect();
    let mut letters = |haystack: &str| {
        let (mut buffer, mut matched) = (Vec::new(), Vec::new());
        let score = pattern.indices(
            Utf32Str::new(haystack, &mut buffer),
            &mut matcher,
            &mut matched,
        )?;
        matched.sort_unstable();
        matched.dedup();
        // Letters that happen to be somewhere in a long title are not what anybody meant.
        is_meant(haystack, &matched).then_some((score, matched))
    };
    let mut hits = Vec::new();
    for entry in entries {
        let title = entry.title();
        let before_name = (title.chars().count() - entry.name.chars().count()) as u32;
        let (rank, matched) = if let Some((score, matched)) = letters(&entry.name) {
            let matched = matched.into_iter().map(|at| at + before_name).collect();
            (Rank::Name(score), matched)
        } else if let Some((score, matched)) = letters(&title) {
            (Rank::Title(score), matched)
        } else {
            let said = format!("{} {title} {}", entry.menu, entry.help).to_lowercase();
            if !words.iter().all(|word| said.contains(word)) {
                continue;
            }
            (Rank::Sentence, Vec::new())
        };
        hits.push((rank, Hit { entry, matched }));
    }
    // Stable: equals stay in menu order.
    hits.sort_by_key(|(rank, _)| std::cmp::Reverse(*rank));
    hits.into_iter().map(|(_, hit)| hit).collect()
}

/// How well a command matches; the better the larger.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Rank {
    Sentence,
    Title(u32),
    Name(u32),
}

/// The text without the marks that the matcher reads as operators.
fn escaped(text: &str) -> String {
    let plain = |c: char| {
        if matches!(c, '^' | '$' | '!' | '\'' | '\\') {
            ' '
        } else {
            c
        }
    };
    text.chars().map(plain).collect()
}

/// Whether matched letters are what somebody meant: in a few runs, as in an abbreviation (at least two letters to a run on
/// average), or the beginnings of words.
fn is_meant(haystack: &str, matched: &[u32]) -> bool {
    let letters: Vec<char> = haystack.chars().collect();
    let before = |at: u32| (at as usize).checked_sub(1).map(|at| letters[at]);
    let begins_word = |at: u32| before(at).is_none_or(|c| !c.is_alphanumeric());
    let starts = matched
        .iter()
        .enumerate()
        .filter(|(k, at)| *k == 0 || matched[k - 1] + 1 != **at);
    let starts: Vec<u32> = starts.map(|(_, at)| *at).collect();
    matched.len() <= 1 || matched.len() >= 2 * starts.len() || starts.into_iter().all(begins_word)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::command::{Command, ENTRIES};
    use crate::app::state::prefs::Theme;

    fn found(text: &str) -> Vec<Command> {
        let hits = search(ENTRIES.iter(), text).into_iter();
        hits.map(|hit| hit.entry.command).collect()
    }

    #[test]
    fn a_name_comes_before_a_sentence() {
        let light = found("light");
        let theme = light
            .iter()
            .position(|c| *c == Command::UseTheme(Theme::Light));
        let sample = light
            .iter()
            .position(|c| matches!(c, Command::OpenSample(_)));
        assert!(sample.is_some(), "{light:?}");
        // Before the submenu "Lights" too.
        assert_eq!(theme, Some(0), "{light:?}");
    }

    #[test]
    fn letters_in_order_are_enough() {
        assert_eq!(found("expfig")[0], Command::ExportFigure);
        assert_eq!(found("ef")[0], Command::ExportFigure);
        assert_eq!(found("compa")[0], Command::Compare);
        assert_eq!(found("THEME DARK")[0], Command::UseTheme(Theme::Dark));
        assert_eq!(found("dark theme")[0], Command::UseTheme(Theme::Dark));
        assert_eq!(found("keep ρd")[0], Command::ToggleKeepOptimal);
        assert_eq!(found("session as")[0], Command::SaveSessionAs);
    }

    #[test]
    fn a_sentence_is_found_by_its_words() {
        assert!(found("spreadsheet").contains(&Command::CopyNumbers));
        assert!(found("clipboard xyz").is_empty());
        assert!(found("qqqq").is_empty());
    }

    #[test]
    fn without_a_word_all_stay_in_menu_order() {
        let all: Vec<Command> = ENTRIES.iter().map(|entry| entry.command).collect();
        assert_eq!(found(""), all);
        assert_eq!(found("  \t"), all);
        // An operator of the matcher is no word.
        assert_eq!(found("!"), all);
    }

    #[test]
    fn matched_letters_are_told() {
        let hits = search(ENTRIES.iter(), "expfig");
        assert_eq!(hits[0].matched, [0, 1, 2, 7, 8, 9]);
        let by_sentence = search(ENTRIES.iter(), "spreadsheet");
        assert!(by_sentence.iter().all(|hit| hit.matched.is_empty()));
    }
}
