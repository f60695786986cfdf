//! Help ▸ Guide: the pages inside the window.

use crate::common::window::{Window, click, press, run, window};
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::Queryable;
use grazing::app::command::Command;
use grazing::app::guide::{GuideAt, PAGES};
use grazing::app::state::notice::Dialog;

fn at(window: &Window) -> GuideAt {
    match window.state().state().dialog {
        Some(Dialog::Guide(at)) => at,
        other => panic!("{other:?}"),
    }
}

/// How far from the top of the window a text of the page is.
fn top(window: &Window, words: &str) -> Option<f32> {
    let mut found: Vec<f32> = window
        .query_all_by_role_and_label(Role::Label, words)
        .map(|node| node.rect().top())
        .collect();
    found.sort_by(f32::total_cmp);
    found.pop()
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_menu_opens_the_guide_and_links_lead_on() {
    let mut window = window(vec![], vec![]);
    click(&mut window, "Help");
    click(&mut window, "Guide");
    assert_eq!(at(&window).page, 0);
    let first = top(&window, "Getting around").expect("the first heading");
    assert!(first < 300.0, "{first}");
    // A link to another page.
    window.get_by_role_and_label(Role::Link, "Theory").click();
    window.run_steps(4);
    assert_eq!(PAGES[at(&window).page].file, "theory.md");
    assert!(top(&window, "Directions").is_some_and(|top| top < 400.0));
    // A heading in the list comes to the top, though it was out of sight.
    assert_eq!(top(&window, "Synthetic samples"), None);
    click(&mut window, "Synthetic samples");
    window.run_steps(4);
    assert!(at(&window).heading.is_some());
    assert!(top(&window, "Synthetic samples").is_some_and(|top| top > 0.0));
    press(&mut window, Modifiers::NONE, Key::Escape);
    assert_eq!(window.state().state().dialog, None);
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_link_into_a_page_shows_its_heading_and_a_web_link_asks_for_a_browser() {
    let mut window = window(vec![], vec![]);
    run(&mut window, Command::Guide);
    click(&mut window, "Formats");
    window.run_steps(2);
    window.get_by_role_and_label(Role::Link, "MERL").click();
    window.run_steps(4);
    let heading = top(&window, "MERL").expect("the heading");
    assert!((0.0..300.0).contains(&heading), "{heading}");
    window
        .get_by_role_and_label(Role::Link, "Mitsubishi Electric Research Laboratories")
        .click();
    let before = at(&window);
    let mut asked = Vec::new();
    for _ in 0..3 {
        window.step();
        asked.extend(window.output().platform_output.commands.clone());
    }
    assert!(
        asked.iter().any(|command| matches!(command, egui::OutputCommand::OpenUrl(open) if open.url.starts_with("https://www.merl.com/"))),
        "{asked:?}"
    );
    assert_eq!(at(&window), before);
}

/// The letters of a text that the fonts of the window lack, running text's and code's.
fn lacking(window: &Window, text: &str) -> Vec<char> {
    let fonts = [
        egui::FontId::proportional(14.0),
        egui::FontId::monospace(12.0),
    ];
    let shown = |letter: char| {
        window.ctx.fonts_mut(|view| {
            let has = |font| view.has_glyph(font, letter);
            letter.is_control() || fonts.iter().all(has)
        })
    };
    let mut lacking: Vec<char> = text.chars().filter(|letter| !shown(*letter)).collect();
    lacking.sort_unstable();
    lacking.dedup();
    lacking
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn the_fonts_have_every_letter_of_the_pages() {
    let window = window(vec![], vec![]);
    let all: String = PAGES.iter().map(|page| page.text).collect();
    assert_eq!(lacking(&window, &all), Vec::<char>::new());
    assert_eq!(lacking(&window, "Help \u{2192} Guide"), ['\u{2192}']);
}
