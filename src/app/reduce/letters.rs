//! Reducer of letters that no font has: each is looked for once, and said once that there are some.

use crate::app::msg::Task;
use crate::app::reduce::notify;
use crate::app::state::State;
use crate::app::state::notice::Severity;
use crate::export::fonts::lacking_text;
use std::collections::BTreeSet;

/// Looks for fonts for the letters that were not asked for before.
pub(crate) fn look_for(state: &mut State, mut letters: BTreeSet<char>) -> Vec<Task> {
    letters.retain(|letter| state.letters.asked.insert(*letter));
    if letters.is_empty() {
        return Vec::new();
    }
    vec![Task::FindFonts(letters)]
}

/// Says that letters have no font, unless it has been said.
pub(crate) fn lacking(state: &mut State, letters: &BTreeSet<char>) {
    if let (Some(text), false) = (lacking_text(letters), state.letters.told) {
        state.letters.told = true;
        notify(state, Severity::Info, text);
    }
}
