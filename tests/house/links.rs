//! Every link in the papers leads somewhere, and the README stays short.

use grazing::app::guide::{headings, markdown};
use pulldown_cmark::{BrokenLink, CowStr, Event, LinkType, Options, Parser, Tag};
use std::cell::RefCell;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::Command;

/// The most lines that the README may have.
const README_LINES: usize = 150;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The Markdown files that are kept, from the root on; in a copy without git those at the root and in `docs`.
fn papers() -> Vec<PathBuf> {
    let listed = Command::new("git")
        .args(["ls-files", "*.md"])
        .current_dir(root())
        .output();
    if let Some(listed) = listed.ok().filter(|listed| listed.status.success()) {
        let text = String::from_utf8(listed.stdout).expect("names in UTF-8");
        return text.lines().map(PathBuf::from).collect();
    }
    let folders = ["", "docs"].into_iter();
    let entries = folders.flat_map(|folder| {
        let entries = fs::read_dir(root().join(folder)).expect("a folder");
        entries.map(move |entry| Path::new(folder).join(entry.expect("an entry").file_name()))
    });
    entries
        .filter(|path| path.extension().is_some_and(|extension| extension == "md"))
        .collect()
}

/// Where the links and pictures of a text lead, and the names that stand for a link and are nowhere said.
fn links(text: &str) -> (Vec<String>, Vec<String>) {
    let unsaid = RefCell::new(Vec::new());
    let ask = |link: BrokenLink<'_>| -> Option<(CowStr<'_>, CowStr<'_>)> {
        // `[words]` alone may be words; `[words][name]` is meant as a link.
        if matches!(link.link_type, LinkType::Reference | LinkType::Collapsed) {
            unsaid.borrow_mut().push(link.reference.to_string());
        }
        None
    };
    let options = Options::ENABLE_TABLES;
    let parser = Parser::new_with_broken_link_callback(text, options, Some(ask));
    let links = parser
        .filter_map(|event| match event {
            Event::Start(Tag::Link { dest_url, .. } | Tag::Image { dest_url, .. }) => {
                Some(dest_url.to_string())
            }
            _ => None,
        })
        .collect();
    (links, unsaid.into_inner())
}

/// What is wrong with the links of a paper at `path` from the root on, one line each.
fn complaints(path: &Path, text: &str) -> Vec<String> {
    let (links, unsaid) = links(text);
    let mut found: Vec<String> = unsaid
        .iter()
        .map(|name| format!("{}: [{name}] is nowhere said", path.display()))
        .collect();
    for link in links {
        if ["https://", "http://", "mailto:"]
            .iter()
            .any(|start| link.starts_with(start))
        {
            continue;
        }
        let (file, anchor) = link.split_once('#').unwrap_or((&link, ""));
        let folder = root().join(path.parent().unwrap_or(Path::new("")));
        let to = folder.join(file);
        if !file.is_empty() && !to.exists() {
            found.push(format!("{}: {link} leads to no file", path.display()));
        } else if !anchor.is_empty() {
            let other = (!file.is_empty()).then(|| fs::read_to_string(&to).unwrap_or_default());
            let blocks = markdown::parse(other.as_deref().unwrap_or(text));
            if !headings(&blocks).any(|heading| heading.anchor == anchor) {
                found.push(format!("{}: {link} leads to no heading", path.display()));
            }
        }
    }
    found
}

#[test]
fn every_link_leads_somewhere() {
    let papers = papers();
    for name in ["README.md", "ARCHITECTURE.md", "docs/guide.md"] {
        assert!(papers.contains(&PathBuf::from(name)), "{papers:?}");
    }
    let mut count = 0;
    let mut all = Vec::new();
    for path in papers {
        let text = fs::read_to_string(root().join(&path)).expect("a paper");
        count += links(&text).0.len();
        all.extend(complaints(&path, &text));
    }
    assert!(all.is_empty(), "\n{}", all.join("\n"));
    assert!(count > 50, "{count}");
}

#[test]
fn planted_links_that_lead_nowhere_are_caught() {
    let count = |text: &str| complaints(Path::new("docs/planted.md"), text).len();
    let good = "# Here\n\n[a](../README.md) [b](guide.md#views) [c](#here) [d](../src/brdf) [e](https://example.org/)\n\
                ![f](../assets/window.png) [g] [h][i]\n\n[i]: theory.md#sources\n\n```sh\n[j](nowhere.md)\n```\n";
    assert_eq!(complaints(Path::new("docs/planted.md"), good), [""; 0]);
    for bad in [
        "[a](README.md)",
        "[a](guide.md#view)",
        "[a](#here)",
        "[a](../src/brdf/none.rs)",
        "![a](../assets/windows.png)",
        "[a][b]",
        "| a |\n|---|\n| [a](nowhere.md) |",
        "- **a**: [`b`](nowhere.md)",
    ] {
        assert_eq!(count(bad), 1, "{bad}");
    }
    // The second heading of a name has a number.
    assert_eq!(count("# A\n\n## A\n\n[a](#a-1)"), 0);
    assert_eq!(count("# A\n\n## A\n\n[a](#a-2)"), 1);
}

#[test]
fn the_readme_is_short() {
    let text = fs::read_to_string(root().join("README.md")).expect("the README");
    let lines = text.lines().count();
    assert!(lines <= README_LINES, "{lines} lines: move some to docs");
}
