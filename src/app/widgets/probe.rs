//! Moving and pinning the probe.

use crate::app::msg::Msg;
use crate::app::state::State;
use crate::app::state::probe::Probe;

/// Moves the probe to what is under the pointer; says nothing where that is the same as before.
pub fn hover(state: &State, probe: Option<Probe>, out: &mut Vec<Msg>) {
    if probe != state.hovered {
        out.push(Msg::Hover(probe));
    }
}

/// Pins the probe; a second click at the same place lets it go.
pub fn pin(state: &State, probe: Probe, out: &mut Vec<Msg>) {
    let near = |pinned: Probe| {
        (pinned.wi - probe.wi).length() < 0.02 && (pinned.wo - probe.wo).length() < 0.02
    };
    out.push(Msg::Pin(match state.pinned {
        Some(pinned) if near(pinned) => None,
        _ => Some(probe),
    }));
}
