//! Text of others in messages, such as names, keys and values of files and of the command line: in one line, of bounded
//! length, with control characters escaped.

use std::fmt::Display;
use std::path::Path;
use unicode_width::UnicodeWidthChar as _;

/// Columns that a text of others takes at most in a message.
pub const MOST: usize = 120;

/// A text of others, ready for a message.
pub fn shown(text: &str) -> String {
    within(text, MOST)
}

/// A text of others in quotation marks.
pub fn quoted(text: &str) -> String {
    format!("\"{}\"", shown(text))
}

/// A path in a message. It is text to read: bytes that are none are replaced.
pub fn path(path: &Path) -> String {
    shown(&path.to_string_lossy())
}

/// A text of at most `most` columns: the middle of a longer one is left out, as names differ at both ends.
pub fn within(text: &str, most: usize) -> String {
    let escaped = || text.chars().flat_map(escaped);
    // No further than it takes to know: a text may have millions of characters.
    let mut room = most;
    let fits = escaped().all(|c| {
        let width = width(c);
        let fits = width <= room;
        room = room.saturating_sub(width);
        fits
    });
    if fits {
        return escaped().collect();
    }
    let behind = most.saturating_sub(1) / 2;
    let before = most.saturating_sub(1) - behind;
    let mut end: Vec<String> = Vec::new();
    let mut room = behind;
    for c in text.chars().rev() {
        let piece: String = self::escaped(c).collect();
        let columns: usize = piece.chars().map(width).sum();
        if columns > room {
            break;
        }
        room -= columns;
        end.push(piece);
    }
    let mut room = before;
    let mut begin: String = escaped()
        .take_while(|c| {
            let fits = width(*c) <= room;
            room = room.saturating_sub(width(*c));
            fits
        })
        .collect();
    begin.push('…');
    begin.extend(end.into_iter().rev());
    begin
}

/// The message of a library about a text of others: what it quotes of that is bounded, and so is the whole.
pub fn said(error: &impl Display) -> String {
    let text = error.to_string();
    let begin = text.find(['"', '`']).map(|at| at + 1);
    // What is expected follows the quotation. The last such place is the library's own, whatever is quoted.
    let end = ["\", expected", "`, expected"]
        .iter()
        .filter_map(|end| text.rfind(end))
        .max();
    match (begin, end) {
        (Some(begin), Some(end)) if begin <= end => {
            let (before, after) = (&text[..begin], &text[end..]);
            format!("{before}{}{after}", shown(&text[begin..end]))
        }
        _ => within(&text, 2 * MOST),
    }
}

/// A text in one line, of any length: for messages that are made of bounded parts.
pub fn one_line(text: &str) -> String {
    text.chars().flat_map(escaped).collect()
}

/// Columns of a character; a mark that is put on another one counts too, as there may be any number of them.
fn width(c: char) -> usize {
    c.width().unwrap_or(1).max(1)
}

/// A character as it is, or its escape where it would steer the terminal, break the line or turn its direction.
fn escaped(c: char) -> impl Iterator<Item = char> {
    let steers = c.is_control() || matches!(c, '\u{2028}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    let (escape, plain) = if steers {
        (Some(c.escape_default()), None)
    } else {
        (None, Some(c))
    };
    escape.into_iter().flatten().chain(plain)
}

#[cfg(test)]
mod tests {
    use super::*;
    use unicode_width::UnicodeWidthStr as _;

    #[test]
    fn a_short_text_stays_and_a_long_one_is_cut_in_the_middle() {
        let just = "x".repeat(MOST);
        assert_eq!(shown(&just), just);
        assert_eq!(quoted("a \"b\""), "\"a \"b\"\"");
        for middle in ["x", "木", "\u{301}", "\n", "\u{202e}", "\u{10ffff}"] {
            let long = format!("begin{}end", middle.repeat(70_000));
            let cut = shown(&long);
            assert!(cut.width() <= MOST && cut.chars().count() <= MOST, "{cut}");
            assert!(cut.starts_with("begin") && cut.ends_with("end"), "{cut}");
            assert!(
                cut.contains('…') && !cut.contains(char::is_control),
                "{cut}"
            );
        }
        for most in 0..4 {
            assert!(within("abcdef", most).chars().count() <= most.max(1));
        }
    }

    #[test]
    fn what_steers_a_terminal_is_escaped() {
        let found = shown("a\u{1b}[31m\r\nb\u{202e}c\u{9b}");
        assert_eq!(found, "a\\u{1b}[31m\\r\\nb\\u{202e}c\\u{9b}");
        assert_eq!(one_line(&found), found);
    }

    #[test]
    fn a_library_quotes_no_more_than_others_do() {
        #[derive(Debug, serde::Deserialize)]
        #[serde(deny_unknown_fields)]
        struct Known {
            #[allow(dead_code)]
            number: f64,
        }
        let long = "\\u001b`, expected ".repeat(7000);
        for text in [
            format!("{{\"number\": \"{long}\"}}"),
            format!("{{\"{long}\": 1}}"),
        ] {
            let error = serde_json::from_str::<Known>(&text).expect_err("is bad");
            assert!(error.to_string().len() > 70_000);
            let said = said(&error);
            assert!(said.len() < 2 * MOST + 100, "{said}");
            assert!(said.contains(", expected `number`") || said.contains(", expected f64"));
            assert!(!said.contains(char::is_control), "{said}");
        }
        let short = serde_json::from_str::<Known>("{\"numbr\": 1}").expect_err("is bad");
        assert_eq!(said(&short), short.to_string());
    }
}
