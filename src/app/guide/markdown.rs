//! Markdown as blocks of spans: what the pages of the guide are made of, and no more.

use super::Anchors;
use pulldown_cmark::{CodeBlockKind, Event, Options, Parser, Tag, TagEnd};
use std::iter::Peekable;

/// A run of letters that look the same.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Span {
    /// The letters.
    pub text: String,
    /// Whether they are strong.
    pub strong: bool,
    /// Whether they are slanted.
    pub emphasis: bool,
    /// Whether they are code.
    pub code: bool,
    /// Destination of the link that they are.
    pub link: Option<String>,
}

impl Span {
    fn looks_like(&self, other: &Self) -> bool {
        let look = |span: &Self| (span.strong, span.emphasis, span.code);
        look(self) == look(other) && self.link == other.link
    }
}

/// A part of a page.
#[derive(Clone, Debug, PartialEq, Eq)]
#[expect(missing_docs, reason = "the line over each says it")]
pub enum Block {
    /// A heading, 1 being the largest, with what a link to it says after `#`.
    Heading {
        level: u8,
        anchor: String,
        spans: Vec<Span>,
    },
    /// Running text.
    Paragraph(Vec<Span>),
    /// Lines of code.
    Code(String),
    /// Items, numbered from `first` on where there is one.
    List {
        first: Option<u64>,
        items: Vec<Vec<Block>>,
    },
    /// A head and rows with as many cells each.
    Table {
        head: Vec<Vec<Span>>,
        rows: Vec<Vec<Vec<Span>>>,
    },
    /// A picture with what it shows in words.
    Picture { path: String, words: String },
}

/// The parts of a text in Markdown with tables.
pub fn parse(text: &str) -> Vec<Block> {
    let mut events = Parser::new_ext(text, Options::ENABLE_TABLES).peekable();
    blocks(&mut events, &mut Anchors::default())
}

/// The letters of spans.
pub fn words(spans: &[Span]) -> String {
    spans.iter().map(|span| span.text.as_str()).collect()
}

type Events<'a> = Peekable<Parser<'a>>;

/// Blocks until the end of what they are in.
fn blocks(events: &mut Events, anchors: &mut Anchors) -> Vec<Block> {
    let mut blocks = Vec::new();
    while let Some(event) = events.peek() {
        match event {
            Event::Start(Tag::Heading { level, .. }) => {
                let level = *level as u8;
                events.next();
                let spans = spans(events);
                let anchor = anchors.next(&words(&spans));
                blocks.push(Block::Heading {
                    level,
                    anchor,
                    spans,
                });
            }
            Event::Start(Tag::Paragraph) => {
                events.next();
                if let Some(Event::Start(Tag::Image { dest_url, .. })) = events.peek() {
                    let path = dest_url.to_string();
                    let words = words(&spans(events));
                    blocks.push(Block::Picture { path, words });
                } else {
                    blocks.push(Block::Paragraph(spans(events)));
                }
            }
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_) | CodeBlockKind::Indented)) => {
                events.next();
                let code = words(&spans(events)).trim_end().to_string();
                blocks.push(Block::Code(code));
            }
            Event::Start(Tag::List(first)) => {
                let first = *first;
                events.next();
                let mut items = Vec::new();
                while let Some(Event::Start(Tag::Item)) = events.next() {
                    items.push(self::blocks(events, anchors));
                }
                blocks.push(Block::List { first, items });
            }
            Event::Start(Tag::Table(_)) => {
                events.next();
                blocks.push(table(events));
            }
            // The text of an item without blank lines.
            event if is_inline(event) => blocks.push(Block::Paragraph(line(events))),
            // What a page has no look for: its content counts.
            Event::Start(_) => {
                events.next();
                blocks.extend(self::blocks(events, anchors));
            }
            Event::End(_) => {
                events.next();
                break;
            }
            _ => {
                events.next();
            }
        }
    }
    blocks
}

fn table(events: &mut Events) -> Block {
    let (mut head, mut rows) = (Vec::new(), Vec::new());
    while let Some(event) = events.next() {
        let in_head = matches!(event, Event::Start(Tag::TableHead));
        if !in_head && !matches!(event, Event::Start(Tag::TableRow)) {
            break;
        }
        let mut cells = Vec::new();
        while let Some(Event::Start(Tag::TableCell)) = events.next() {
            cells.push(spans(events));
        }
        if in_head {
            head = cells;
        } else {
            rows.push(cells);
        }
    }
    Block::Table { head, rows }
}

/// Spans until the end of what they are in, which is taken too.
fn spans(events: &mut Events) -> Vec<Span> {
    let spans = line(events);
    events.next();
    spans
}

/// Spans until a block begins or ends.
fn line(events: &mut Events) -> Vec<Span> {
    let mut spans: Vec<Span> = Vec::new();
    let mut look = Span::default();
    while let Some(event) = events.next_if(|event| is_inline(event)) {
        let mut add = |text: &str, code: bool| {
            let span = Span {
                text: text.into(),
                code,
                ..look.clone()
            };
            match spans.last_mut() {
                Some(last) if last.looks_like(&span) => last.text.push_str(text),
                _ => spans.push(span),
            }
        };
        match event {
            Event::Text(text) => add(&text, false),
            Event::Code(text) => add(&text, true),
            Event::SoftBreak | Event::HardBreak => add(" ", false),
            Event::Start(Tag::Strong) => look.strong = true,
            Event::End(TagEnd::Strong) => look.strong = false,
            Event::Start(Tag::Emphasis) => look.emphasis = true,
            Event::End(TagEnd::Emphasis) => look.emphasis = false,
            Event::Start(Tag::Link { dest_url, .. }) => look.link = Some(dest_url.to_string()),
            Event::End(TagEnd::Link) => look.link = None,
            _ => {}
        }
    }
    spans
}

fn is_inline(event: &Event) -> bool {
    match event {
        Event::Start(tag) => matches!(
            tag,
            Tag::Strong | Tag::Emphasis | Tag::Strikethrough | Tag::Link { .. } | Tag::Image { .. }
        ),
        Event::End(tag) => matches!(
            tag,
            TagEnd::Strong
                | TagEnd::Emphasis
                | TagEnd::Strikethrough
                | TagEnd::Link
                | TagEnd::Image
        ),
        Event::Rule => false,
        _ => true,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plain(text: &str) -> Vec<Span> {
        vec![Span {
            text: text.into(),
            ..Span::default()
        }]
    }

    #[test]
    fn a_page_becomes_blocks() {
        let text = "# One\n\nTwo **three** [four](a.md#b)\nfive.\n\n- **six**\n- seven\n\n  eight\n\n1. nine\n\n\
                    ```sh\nten [no](link)\n```\n\n![eleven](x.png)\n\n| a | b |\n|---|---|\n| `c` | d\\|e |\n\n## One\n";
        let blocks = parse(text);
        let [one, two, list, numbered, code, picture, table, again] = &blocks[..] else {
            panic!("{blocks:#?}")
        };
        let heading = |level, anchor: &str| Block::Heading {
            level,
            anchor: anchor.into(),
            spans: plain("One"),
        };
        assert_eq!((one, again), (&heading(1, "one"), &heading(2, "one-1")));
        let Block::Paragraph(spans) = two else {
            panic!("{two:?}")
        };
        assert_eq!(words(spans), "Two three four five.");
        assert!(spans[1].strong && spans[3].link.as_deref() == Some("a.md#b"));
        let item = |text| vec![Block::Paragraph(plain(text))];
        let Block::List { first: None, items } = list else {
            panic!("{list:?}")
        };
        assert!(matches!(&items[0][..], [Block::Paragraph(spans)] if spans[0].strong));
        assert_eq!(items[1], [item("seven"), item("eight")].concat());
        let expected = Block::List {
            first: Some(1),
            items: vec![item("nine")],
        };
        assert_eq!(*numbered, expected);
        assert_eq!(*code, Block::Code("ten [no](link)".into()));
        let expected = Block::Picture {
            path: "x.png".into(),
            words: "eleven".into(),
        };
        assert_eq!(*picture, expected);
        let Block::Table { head, rows } = table else {
            panic!("{table:?}")
        };
        assert_eq!(*head, [plain("a"), plain("b")]);
        assert!(rows[0][0][0].code && rows[0][1] == plain("d|e"));
    }
}
