//! Letters that no font of the window has.

use crate::common::folder::Folder;
use crate::common::records::write_merl;
use crate::common::window::{Window, settle, window_with_boxes, with_answers};
use egui::FontId;
use grazing::app::msg::Msg;

fn has(window: &Window, letter: char) -> bool {
    let font = FontId::proportional(14.0);
    window.ctx.fonts_mut(|fonts| fonts.has_glyph(&font, letter))
}

#[test]
#[cfg_attr(skip_gpu, ignore = "SKIP_GPU=1")]
fn a_name_in_another_script_brings_its_font_and_one_without_is_said_once() {
    let folder = Folder::new();
    // A window that needs none looks for none.
    let plain = folder.path("wood.binary");
    write_merl(&plain);
    let mut window = window_with_boxes(with_answers(&[&plain], None, None));
    assert!(!has(&window, '木'));
    assert!(window.state().state().letters.asked.is_empty());

    let wood = folder.path("木.binary");
    write_merl(&wood);
    let open = |window: &mut Window, file: &std::path::Path| {
        let ctx = window.ctx.clone();
        window
            .state_mut()
            .handle(&ctx, Msg::OpenFiles(vec![file.to_owned()]));
        settle(window, |state| {
            state.jobs.is_empty() && !state.scene.opened.is_empty()
        });
    };
    open(&mut window, &wood);
    settle(&mut window, |state| state.letters.asked.contains(&'木'));
    crate::common::wait::settle(|| {
        window.step();
        has(&window, '木')
            .then_some(())
            .ok_or_else(|| "no font".into())
    });
    assert_eq!(window.state().state().notices, []);

    // Nothing has these: said once, though they come one after the other.
    for (name, letter) in [("ꀀ.binary", 'ꀀ'), ("ሀ.binary", 'ሀ')] {
        let file = folder.path(name);
        write_merl(&file);
        open(&mut window, &file);
        settle(&mut window, |state| state.letters.asked.contains(&letter));
        settle(&mut window, |state| !state.notices.is_empty());
    }
    window.run_steps(5);
    let [notice] = &window.state().state().notices[..] else {
        panic!("{:?}", window.state().state().notices)
    };
    assert!(
        notice.text.contains("no font") && notice.text.contains("U+A000"),
        "{}",
        notice.text
    );
}
