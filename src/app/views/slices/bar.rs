//! The toolbar of the slices.

use crate::app::msg::Msg;
use crate::app::views::slices::settings::SliceSettings;
use crate::app::widgets::controls::sized_choice_ui;
use crate::app::widgets::toolbar::Groups;
use crate::app::widgets::{controls, toolbar};
use crate::figure::scale::{RADIAL_SCALES, RadialScale};
use crate::figure::slices::{OVERS, Over, RESIDUALS, Residual, SliceSpec};
use crate::figure::subject::CHANNELS;
use crate::geom::limits::MAX_THETA_I_DEG;

/// Largest number of slices over θo.
const MOST: usize = 5;

/// Draws it. `shown` is what the plot shows: the view's own slices, or those through the probe.
pub fn toolbar_ui(ui: &mut egui::Ui, view: &SliceSettings, shown: &SliceSpec, out: &mut Vec<Msg>) {
    let mut changed = view.clone();
    toolbar::row_ui(ui, |bar| {
        bar.group(|ui| {
            let spec = &mut changed.spec;
            for over in OVERS {
                let response = ui.selectable_label(spec.over == over, over.name());
                let hint = format!("Slices over {}", over.name());
                if response.on_hover_text(hint).clicked() {
                    // Another angle: neither the old window nor the old limits mean anything.
                    (spec.over, spec.window, spec.limits) = (over, None, None);
                }
            }
        });
        bar.section(|ui| {
            let before = changed.spec.clone();
            angles_ui(ui, &mut changed.spec, shown);
            if changed.spec != before {
                // An angle that is set by hand is not the probe's.
                changed.follow = false;
            }
        });
        bar.group(|ui| follow_ui(ui, &mut changed.follow));
        shown_ui(bar, &mut changed.spec);
    });
    if changed != *view {
        out.push(Msg::set_view(changed));
    }
}

fn follow_ui(ui: &mut egui::Ui, follow: &mut bool) {
    ui.toggle_value(follow, "Follow")
        .on_hover_text("Take the fixed angles from the probe of the other views");
}

/// The fixed angles.
fn angles_ui(ui: &mut egui::Ui, spec: &mut SliceSpec, shown: &SliceSpec) {
    let mut angle = |markup: &str, name: &str, at: f64, to: &mut f64, last: f64| {
        controls::symbol_ui(ui, markup);
        let help = "Fixed in this slice; drag to change";
        if let Some(angle) = controls::angle_ui(ui, name, help, at, 0.0..=last) {
            *to = angle;
        }
    };
    if spec.over != Over::ThetaH && spec.over != Over::ThetaO {
        angle("θ_{h}", "theta_h", shown.theta_h, &mut spec.theta_h, 90.0);
    }
    if spec.over != Over::ThetaD && spec.over != Over::ThetaO {
        angle("θ_{d}", "theta_d", shown.theta_d, &mut spec.theta_d, 90.0);
    }
    if spec.over != Over::PhiD && spec.over != Over::ThetaO {
        angle("φ_{d}", "phi_d", shown.phi_d, &mut spec.phi_d, 360.0);
    }
    if spec.over != Over::ThetaO {
        return;
    }
    controls::symbol_ui(ui, "θ_{i}");
    let angles = shown.theta_i.clone();
    for (index, theta_i) in angles.into_iter().enumerate() {
        let name = format!("theta_i {}", index + 1);
        let help = "Angle of incidence; drag to change";
        let range = 0.0..=MAX_THETA_I_DEG;
        if let Some(angle) = controls::angle_ui(ui, &name, help, theta_i, range)
            && let Some(to) = spec.theta_i.get_mut(index)
        {
            *to = angle;
            spec.active = index;
        }
    }
    let few = ui.add_enabled(spec.theta_i.len() < MOST, egui::Button::new("+").small());
    if few.on_hover_text("Add an angle").clicked() {
        // Half way to the horizon from the last one.
        let last = spec.theta_i.last().copied().unwrap_or(0.0).to_degrees();
        let next = if last < 80.0 {
            0.5 * (last + 90.0)
        } else {
            30.0
        };
        spec.theta_i.push(next.round().to_radians());
        spec.active = spec.theta_i.len() - 1;
    }
    let many = ui.add_enabled(spec.theta_i.len() > 1, egui::Button::new("−").small());
    if many.on_hover_text("Remove the active angle").clicked() {
        spec.theta_i.remove(spec.active.min(spec.theta_i.len() - 1));
        spec.active = spec.active.min(spec.theta_i.len() - 1);
    }
}

/// Scale, residual, channel, cosine.
fn shown_ui(bar: &mut Groups<'_>, spec: &mut SliceSpec) {
    bar.section(|ui| {
        let scales: Vec<(RadialScale, &str)> = RADIAL_SCALES.map(|s| (s, s.name())).to_vec();
        if let Some(scale) = sized_choice_ui(ui, "Scale", spec.scale, &scales, 66.0) {
            (spec.scale, spec.limits) = (scale, None);
        }
    });
    bar.group(|ui| {
        let residuals: Vec<(Residual, &str)> = RESIDUALS.map(|r| (r, r.name())).to_vec();
        if let Some(residual) = sized_choice_ui(ui, "Residual", spec.residual, &residuals, 84.0) {
            spec.residual = residual;
        }
    });
    bar.group(|ui| {
        let channels = CHANNELS.map(|channel| (channel, channel.name()));
        if let Some(channel) = sized_choice_ui(ui, "Channel", spec.channel, &channels, 80.0) {
            spec.channel = channel;
        }
    });
    bar.group(|ui| {
        if let Some(cosine) = controls::cosine_ui(ui, spec.cosine) {
            spec.cosine = cosine;
        }
    });
}
