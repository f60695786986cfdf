//! The pages of `docs/` as they are built in: their text, their headings, and where their links lead.

pub mod markdown;

use markdown::{Block, Span};
use std::collections::BTreeMap;
use std::sync::LazyLock;

/// A page.
#[derive(Debug)]
pub struct GuidePage {
    /// Name of its file in `docs/`.
    pub file: &'static str,
    /// Name on screen.
    pub name: &'static str,
    /// Markdown of the page.
    pub text: &'static str,
}

/// The pages in the order offered; the first is the guide itself.
pub const PAGES: [GuidePage; 4] = [
    GuidePage {
        file: "guide.md",
        name: "Guide",
        text: include_str!("../../docs/guide.md"),
    },
    GuidePage {
        file: "figures.md",
        name: "Figures",
        text: include_str!("../../docs/figures.md"),
    },
    GuidePage {
        file: "formats.md",
        name: "Formats",
        text: include_str!("../../docs/formats.md"),
    },
    GuidePage {
        file: "theory.md",
        name: "Theory",
        text: include_str!("../../docs/theory.md"),
    },
];

macro_rules! pictures {
    ($($name:literal),* $(,)?) => {
        [$(($name, include_bytes!(concat!("../../assets/gallery/", $name)))),*]
    };
}

/// The pictures of the gallery as PNG, by the name of their file.
static PICTURES: [(&str, &[u8]); 11] = pictures![
    "albedo.png",
    "disc.png",
    "error-map.png",
    "image-slice.png",
    "landscape.png",
    "lobe3d.png",
    "lobes.png",
    "poster.png",
    "scatter.png",
    "slices.png",
    "sphere.png",
];

/// The PNG of a picture on a page, if it is built in.
pub fn picture(path: &str) -> Option<(&'static str, &'static [u8])> {
    let name = path.rsplit('/').next()?;
    PICTURES.iter().find(|(other, _)| *other == name).copied()
}

/// The blocks of each page of [`PAGES`].
pub static BLOCKS: LazyLock<[Vec<Block>; 4]> =
    LazyLock::new(|| PAGES.map(|page| markdown::parse(page.text)));

/// Place of a reader in the guide.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct GuideAt {
    /// Position in [`PAGES`].
    pub page: usize,
    /// Position among the headings of the page; its beginning without.
    pub heading: Option<usize>,
    /// Counts the jumps, so that one to the same heading is a new one.
    pub jump: u64,
}

/// Destination of a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinkTarget<'a> {
    /// Page, and a heading on it, each by position.
    Page(usize, Option<usize>),
    /// Address in the web.
    Web(&'a str),
}

/// Destination of a link on a page; `None` for one to a file that is not built in.
pub fn target(page: usize, link: &str) -> Option<LinkTarget<'_>> {
    if link.starts_with("https://") || link.starts_with("http://") {
        return Some(LinkTarget::Web(link));
    }
    let (file, anchor) = link.split_once('#').unwrap_or((link, ""));
    let page = match file {
        "" => page,
        file => PAGES.iter().position(|page| page.file == file)?,
    };
    let heading = match anchor {
        "" => None,
        anchor => Some(headings(&BLOCKS[page]).position(|heading| heading.anchor == anchor)?),
    };
    Some(LinkTarget::Page(page, heading))
}

/// A heading of a page.
#[derive(Clone, Copy, Debug)]
pub struct Heading<'a> {
    /// 1 for the page's own.
    pub level: u8,
    /// Name that a link to it has after `#`.
    pub anchor: &'a str,
    /// Words of the heading.
    pub spans: &'a [Span],
}

/// The headings among blocks, in order.
pub fn headings(blocks: &[Block]) -> impl Iterator<Item = Heading<'_>> {
    blocks.iter().filter_map(|block| match block {
        Block::Heading {
            level,
            anchor,
            spans,
        } => Some(Heading {
            level: *level,
            anchor,
            spans,
        }),
        _ => None,
    })
}

/// Makes the anchors of headings as GitHub does.
#[derive(Debug, Default)]
pub struct Anchors(BTreeMap<String, usize>);

impl Anchors {
    /// The anchor of the next heading with these words: small letters, digits, `-` and `_`, blanks as `-`; a number
    /// after it where it was there before.
    pub fn next(&mut self, words: &str) -> String {
        let mut anchor = String::new();
        for letter in words.trim().chars().flat_map(char::to_lowercase) {
            match letter {
                ' ' => anchor.push('-'),
                '-' | '_' => anchor.push(letter),
                letter if letter.is_alphanumeric() => anchor.push(letter),
                _ => {}
            }
        }
        let before = self.0.entry(anchor.clone()).or_default();
        *before += 1;
        match *before - 1 {
            0 => anchor,
            count => format!("{anchor}-{count}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn anchors_are_those_of_github() {
        let mut anchors = Anchors::default();
        for (words, anchor) in [
            ("The error E", "the-error-e"),
            ("The program's own folder", "the-programs-own-folder"),
            ("A & B", "a--b"),
            ("f_r over θo", "f_r-over-θo"),
            ("The error E", "the-error-e-1"),
            ("Keep a Changelog 1.1.0", "keep-a-changelog-110"),
        ] {
            assert_eq!(anchors.next(words), anchor);
        }
    }

    #[test]
    fn links_lead_to_pages_headings_and_the_web() {
        assert_eq!(target(0, "figures.md"), Some(LinkTarget::Page(1, None)));
        let Some(LinkTarget::Page(2, Some(merl))) = target(3, "formats.md#merl") else {
            panic!("no heading on MERL")
        };
        assert_eq!(headings(&BLOCKS[2]).nth(merl).map(|h| h.level), Some(2));
        assert_eq!(target(2, "#merl"), Some(LinkTarget::Page(2, Some(merl))));
        let web = "https://example.org/a#b";
        assert_eq!(target(0, web), Some(LinkTarget::Web(web)));
        for nowhere in ["figures.md#nothing", "../README.md", "#nothing"] {
            assert_eq!(target(0, nowhere), None);
        }
    }

    #[test]
    fn every_picture_of_the_pages_is_built_in() {
        let blocks = BLOCKS.iter().flatten();
        let paths: Vec<&str> = blocks
            .filter_map(|block| match block {
                Block::Picture { path, .. } => Some(path.as_str()),
                _ => None,
            })
            .collect();
        assert_eq!(paths.len(), PICTURES.len());
        for path in paths {
            assert!(picture(path).is_some(), "{path}");
        }
        assert!(picture("../assets/other.png").is_none());
    }
}
