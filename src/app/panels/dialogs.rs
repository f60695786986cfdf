//! The windows over the window: palette, figure, guide, conventions, about.

use crate::app::msg::Msg;
use crate::app::panels::figure::figure_ui;
use crate::app::panels::guide::guide_ui;
use crate::app::panels::palette::palette_ui;
use crate::app::state::State;
use crate::app::state::notice::Dialog;
use crate::app::widgets::paint::rich_text_job;
use crate::figure::text::RichText;
use egui::{Id, Key, Modal};

/// Draws the open dialog, if any. `adapter` is the text on the graphics adapter.
pub fn dialog_ui(ctx: &egui::Context, state: &State, adapter: &str, out: &mut Vec<Msg>) {
    let Some(dialog) = state.dialog else { return };
    let frame = egui::Frame::popup(&ctx.global_style()).inner_margin(16.0);
    let response = Modal::new(Id::unique("dialog"))
        .frame(frame)
        .show(ctx, |ui| {
            match dialog {
                Dialog::Palette => palette_ui(ui, state, out),
                Dialog::OpenPath => open_path_ui(ui, state, out),
                Dialog::Figure => figure_ui(ui, state, out),
                Dialog::Guide(at) => guide_ui(ui, at, out),
                Dialog::Conventions => conventions_ui(ui),
                Dialog::About => about_ui(ui, adapter),
            }
            if dialog != Dialog::Palette {
                ui.add_space(8.0);
                if ui.button("Close").clicked() {
                    out.push(Msg::CloseDialog);
                }
            }
        });
    if response.should_close() {
        out.push(Msg::CloseDialog);
    }
}

/// For systems without a file dialog, and for those who know the path.
fn open_path_ui(ui: &mut egui::Ui, state: &State, out: &mut Vec<Msg>) {
    ui.set_width(460.0);
    ui.heading("Open path");
    ui.add_space(4.0);
    let mut text = state.typed.clone();
    let edit = egui::TextEdit::singleline(&mut text)
        .hint_text("Path of a MERL or fit file")
        .desired_width(f32::INFINITY);
    let edit = ui.add(edit);
    edit.request_focus();
    if edit.changed() {
        out.push(Msg::Typed(text.clone()));
    }
    ui.add_space(4.0);
    let path = text.trim();
    let chosen = ui
        .add_enabled(!path.is_empty(), egui::Button::new("Open"))
        .clicked()
        || ui.input(|input| input.key_pressed(Key::Enter));
    if chosen && !path.is_empty() {
        out.push(Msg::CloseDialog);
        out.push(Msg::OpenFiles(vec![path.into()]));
    }
}

/// Conventions behind every number and picture, a line each: symbols in the markup of formulas, and their meaning.
const CONVENTIONS: [(&str, &str); 11] = [
    ("n", "normal, z of the local frame"),
    (
        "ω_{i}, ω_{o}",
        "unit vectors to the light and to the viewer",
    ),
    ("ω_{r} = 2(ω_{i}·n)n − ω_{i}", "mirror direction"),
    ("ω_{h} = (ω_{i}+ω_{o})/|ω_{i}+ω_{o}|", "half vector"),
    (
        "θ_{i}, θ_{o}",
        "angles from the normal; light on the left, mirror direction on the right",
    ),
    (
        "θ_{h}, θ_{d}, φ_{d}",
        "half and difference angles; φ_{d} folded by +π into [0°, 180°)",
    ),
    ("f_{r}", "BRDF in sr^{-1}, without the cosine, linear RGB"),
    (
        "k_{s}",
        "specular amplitude; Phong: ρ_{s}(s+2)/(2π), Blinn-Phong: ρ_{s}(s+8)/(8π)",
    ),
    (
        "R_{F}(ω_{i}·ω_{h}, η)",
        "unpolarised dielectric Fresnel reflectance on the specular term",
    ),
    (
        "not measured",
        "a cell with a negative or non-finite channel: a gap or a hatch, never 0",
    ),
    (
        "0 stops",
        "a white diffuse surface facing a light of strength 1 is just white; sRGB, no tone map",
    ),
];

fn conventions_ui(ui: &mut egui::Ui) {
    ui.set_width(560.0);
    ui.heading("Conventions");
    ui.add_space(6.0);
    egui::Grid::new("conventions")
        .num_columns(2)
        .spacing([18.0, 7.0])
        .show(ui, |ui| {
            for (symbol, meaning) in CONVENTIONS {
                let (strong, plain) = (ui.visuals().strong_text_color(), ui.visuals().text_color());
                ui.label(rich_text_job(&RichText::parse(symbol), 14.0, strong));
                ui.label(rich_text_job(&RichText::parse(meaning), 13.0, plain));
                ui.end_row();
            }
        });
}

fn about_ui(ui: &mut egui::Ui, adapter: &str) {
    ui.set_width(440.0);
    ui.heading(format!("Grazing {}", env!("CARGO_PKG_VERSION")));
    ui.add_space(4.0);
    ui.label("A BRDF explorer for the angles at which Phong models go wrong.");
    ui.add_space(8.0);
    ui.label("Model and fit: J. B. Nielsen, J. R. Frisvad, K. Conradsen, H. Aanæs, Addressing Grazing Angle Reflections in Phong Models, SIGGRAPH Asia 2014.");
    ui.add_space(8.0);
    egui::Grid::new("about")
        .num_columns(2)
        .spacing([18.0, 5.0])
        .show(ui, |ui| {
            ui.weak("Graphics");
            ui.label(adapter);
            ui.end_row();
            ui.weak("Licence");
            ui.label(env!("CARGO_PKG_LICENSE"));
            ui.end_row();
        });
}
