//! The card of a lesson: its text, and the way back and on.

use crate::app::lessons::rows::LESSONS;
use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::lesson::LessonAt;
use crate::app::widgets::paint::{rich_text_job, role_color};
use crate::figure::palette::Role;
use crate::figure::text::RichText;
use egui::{Align2, Id, Rect, Stroke, StrokeKind, vec2};

/// Width of the text in points.
const WIDTH: f32 = 380.0;

/// Draws the card over the left of the window, if a lesson is under way.
pub fn lesson_ui(ctx: &egui::Context, state: &State, out: &mut Vec<Msg>) {
    let Some((at, step)) = state.lesson.and_then(|at| Some((at, at.step()?))) else {
        return;
    };
    let lesson = &LESSONS[at.lesson];
    egui::Window::new(lesson.title)
        .id(Id::unique("lesson"))
        .title_bar(false)
        .resizable(false)
        .anchor(Align2::LEFT_BOTTOM, vec2(12.0, -40.0))
        .show(ctx, |ui| {
            ui.set_width(WIDTH);
            ui.horizontal(|ui| {
                ui.strong(lesson.title);
                ui.weak(format!("{} of {}", at.step + 1, lesson.steps.len()));
            });
            ui.add_space(4.0);
            let mut job =
                rich_text_job(&RichText::parse(step.text), 14.0, ui.visuals().text_color());
            job.wrap.max_width = WIDTH;
            ui.label(job);
            if at.waits {
                ui.weak("The material is being made…");
            }
            ui.add_space(6.0);
            ui.horizontal(|ui| buttons_ui(ui, at, out));
        });
}

fn buttons_ui(ui: &mut egui::Ui, at: LessonAt, out: &mut Vec<Msg>) {
    let last = at.step + 1 == LESSONS[at.lesson].steps.len();
    let go = |step| Msg::Lesson {
        lesson: at.lesson,
        step,
    };
    if ui
        .add_enabled(at.step > 0, egui::Button::new("Back"))
        .clicked()
    {
        out.push(go(at.step - 1));
    }
    if !last && ui.button("Next").clicked() {
        out.push(go(at.step + 1));
    }
    if ui
        .button("Again")
        .on_hover_text("Set the scene of this step once more")
        .clicked()
    {
        out.push(go(at.step));
    }
    let end = if last { "Done" } else { "End lesson" };
    if ui.button(end).clicked() {
        out.push(Msg::EndLesson);
    }
}

/// Frames what a step speaks of.
pub fn frame(ui: &egui::Ui, rect: Rect) {
    let color = role_color(ui.visuals().dark_mode, Role::Accent);
    ui.painter()
        .rect_stroke(rect, 6.0, Stroke::new(2.0, color), StrokeKind::Inside);
}
