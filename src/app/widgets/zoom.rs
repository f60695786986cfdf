//! The gestures of a plot on straight axes: the wheel zooms, a drag pans, a double click resets.

use crate::figure::plot::PlotFrame;
use crate::figure::scale::Axis;
use egui::{PointerButton, Pos2};

/// Change of the axes by a gesture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Zoom {
    /// New ends of x.
    X([f64; 2]),
    /// New ends of y.
    Y([f64; 2]),
    /// Reset of both axes to what they were.
    Reset,
}

/// Points of the wheel that make something e times larger.
const WHEEL: f64 = 240.0;

/// The gesture on a plot, if there is one. y where the pointer is left of the frame or Ctrl is held, else x.
pub fn gesture(ui: &egui::Ui, response: &egui::Response, frame: &PlotFrame) -> Option<Zoom> {
    if response.double_clicked() {
        return Some(Zoom::Reset);
    }
    let place = |at: Pos2| -> [f32; 2] { (at - response.rect.min).into() };
    let [width, height] = frame.size().map(|length| f64::from(length.max(1.0)));
    let beside = |at: Pos2| place(at)[0] < frame.min[0];
    if response.dragged_by(PointerButton::Primary) {
        let (pressed, ctrl) =
            ui.input(|input| (input.pointer.press_origin(), input.modifiers.command));
        let by = response.drag_delta();
        if by == egui::Vec2::ZERO {
            return None;
        }
        return Some(if ctrl || pressed.is_some_and(beside) {
            Zoom::Y(frame.y.moved(f64::from(by.y) / height))
        } else {
            Zoom::X(frame.x.moved(-f64::from(by.x) / width))
        });
    }
    let at = response.hover_pos()?;
    let (wheel, ctrl_wheel) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let [x, y] = frame.shares(place(at)).map(|share| share.clamp(0.0, 1.0));
    if ctrl_wheel != 1.0 {
        Some(Zoom::Y(frame.y.zoomed(y, f64::from(ctrl_wheel))))
    } else if wheel == 0.0 {
        None
    } else {
        let factor = (f64::from(wheel) / WHEEL).exp();
        Some(if beside(at) {
            Zoom::Y(frame.y.zoomed(y, factor))
        } else {
            Zoom::X(frame.x.zoomed(x, factor))
        })
    }
}

/// Change of both axes of a plot by a gesture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlaneZoom {
    /// New ends of x and of y; `None` for an axis that stays.
    Ends([Option<[f64; 2]>; 2]),
    /// Reset of both axes to what they were.
    Reset,
}

/// The gesture on a plot whose axes are alike, if there is one: inside the frame the wheel zooms both about the pointer and a
/// drag pans; left of it y alone, below it x alone.
pub fn plane_gesture(
    ui: &egui::Ui,
    response: &egui::Response,
    frame: &PlotFrame,
) -> Option<PlaneZoom> {
    if response.double_clicked() {
        return Some(PlaneZoom::Reset);
    }
    let place = |at: Pos2| -> [f32; 2] { (at - response.rect.min).into() };
    let meant = |at: Pos2| {
        let [x, y] = place(at);
        // In the corner, where both would be left out, both are meant.
        let (left, below) = (x < frame.min[0], y > frame.max[1]);
        [!left || below, !below || left]
    };
    if response.dragged_by(PointerButton::Primary) {
        let by = response.drag_delta();
        if by == egui::Vec2::ZERO {
            return None;
        }
        let pressed = ui.input(|input| input.pointer.press_origin());
        let [x, y] = pressed.map_or([true; 2], meant);
        let [width, height] = frame.size().map(|length| f64::from(length.max(1.0)));
        return Some(PlaneZoom::Ends([
            x.then(|| frame.x.moved(-f64::from(by.x) / width)),
            y.then(|| frame.y.moved(f64::from(by.y) / height)),
        ]));
    }
    let at = response.hover_pos()?;
    let factor = wheel(ui)?;
    let [x, y] = meant(at);
    let [across, up] = frame.shares(place(at)).map(|share| share.clamp(0.0, 1.0));
    Some(PlaneZoom::Ends([
        x.then(|| frame.x.zoomed(across, factor)),
        y.then(|| frame.y.zoomed(up, factor)),
    ]))
}

impl Zoom {
    /// Moves the part in sight of a plot whose x is an angle in radians within `range` and whose y is `axis`.
    pub fn apply(
        self,
        axis: &Axis,
        range: [f64; 2],
        window: &mut Option<[f64; 2]>,
        limits: &mut Option<[f64; 2]>,
    ) {
        match self {
            Self::X(ends) => *window = held(ends.map(f64::to_radians), range),
            Self::Y(ends) => {
                if let Some(ends) = not_negative(axis, ends) {
                    *limits = Some(ends);
                }
            }
            Self::Reset => (*window, *limits) = (None, None),
        }
    }
}

/// Factor by which the wheel enlarges what it is turned over, with Ctrl or without.
pub fn wheel(ui: &egui::Ui) -> Option<f64> {
    let (wheel, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
    let factor = (f64::from(wheel) / WHEEL).exp() * f64::from(pinch);
    (factor != 1.0).then_some(factor)
}

/// Whether a drag that pans is under way, so that it is no search for values.
pub fn is_panning(response: &egui::Response) -> bool {
    response.dragged_by(PointerButton::Primary)
}

/// Ends moved inside a range; `None` where that is all of it.
fn held([low, high]: [f64; 2], [first, last]: [f64; 2]) -> Option<[f64; 2]> {
    let width = (high - low).max(1e-3 * (last - first) / 90.0);
    if !(width.is_finite() && low.is_finite()) || width >= (last - first) * (1.0 - 1e-6) {
        return None;
    }
    let low = low.clamp(first, last - width);
    Some([low, low + width])
}

/// Ends of an axis of values that has no negative ones.
pub fn not_negative(axis: &Axis, [low, high]: [f64; 2]) -> Option<[f64; 2]> {
    let low = low.max(0.0);
    // Nothing is as far off as this, and closer a difference would be rounding.
    let sane = low.is_finite() && (1e-12..1e12).contains(&high);
    let apart = axis.share(high) - axis.share(low.max(1e-30));
    (sane && high - low > 1e-6 * high && apart > 0.0).then_some([low, high])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ends_stay_inside() {
        let range = [-90.0, 90.0];
        assert_eq!(held([-120.0, -60.0], range), Some([-90.0, -30.0]));
        assert_eq!(held([10.0, 20.0], range), Some([10.0, 20.0]));
        assert_eq!(held([-100.0, 100.0], range), None);
        assert_eq!(held([f64::NAN, 100.0], range), None);
        let [low, high] = held([5.0, 5.0], range).expect("a part");
        assert!(high > low);
    }
}
