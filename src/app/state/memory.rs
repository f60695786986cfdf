//! Tables in memory and on the GPU: the least recently shown ones go where all take more than the limit.

use crate::app::state::State;
use crate::app::state::material::{MaterialId, Presence};
use crate::measured::{Grid, Table};
use std::sync::Arc;

/// A table in memory.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Held {
    /// Material whose table it is.
    pub id: MaterialId,
    /// Size in bytes.
    pub bytes: u64,
    /// Whether it must stay.
    pub shown: bool,
    /// Time at which it was shown last.
    pub last_shown: u64,
}

/// The tables to let go so that the rest and `coming` bytes more are within `limit`: those not shown for the longest
/// time first, never one that is shown.
pub fn to_evict(held: &[Held], coming: u64, limit: u64) -> Vec<MaterialId> {
    let mut total: u64 = coming + held.iter().map(|held| held.bytes).sum::<u64>();
    let mut others: Vec<&Held> = held.iter().filter(|held| !held.shown).collect();
    others.sort_by_key(|held| (held.last_shown, held.id));
    let mut gone = Vec::new();
    for held in others {
        if total <= limit {
            break;
        }
        total -= held.bytes;
        gone.push(held.id);
    }
    gone
}

/// Size of a table in bytes; 0 for the one that stands in where there are no data.
pub fn bytes(table: &Arc<Table>) -> u64 {
    if table.valid_count() == 0 {
        return 0;
    }
    cell_bytes(table.grid())
}

pub(crate) fn cell_bytes(grid: Grid) -> u64 {
    (grid.len() * size_of::<[f32; 3]>()) as u64
}

/// Size of a table as a texture, in bytes: four numbers a cell in place of three. Where the GPU has no memory of its own, it
/// takes that of the program.
pub fn texture_bytes(table: &Arc<Table>) -> u64 {
    bytes(table) / 3 * 4
}

/// Largest number of tables that stay on the GPU.
const MOST_TEXTURES: usize = 4;

/// The open materials whose tables stay on the GPU, those shown lately first: the shown one, and others as far as the limit
/// has room beside all tables.
pub fn on_gpu(state: &State) -> Vec<MaterialId> {
    let opened = state.scene.opened.iter();
    let mut held: Vec<(u64, MaterialId, u64)> = opened
        .filter_map(|opened| Some((opened.id, state.materials.get(&opened.id)?)))
        .filter(|(_, material)| material.presence == Presence::Loaded)
        .map(|(id, material)| (material.last_shown, id, texture_bytes(&material.table)))
        .filter(|(_, _, bytes)| *bytes > 0)
        .collect();
    held.sort_by_key(|(last_shown, id, _)| (std::cmp::Reverse(*last_shown), *id));
    let mut total = tables(state);
    let limit = state.prefs.memory.bytes();
    let fits = |(k, (_, id, bytes)): (usize, (u64, MaterialId, u64))| {
        total += bytes;
        (k == 0 || total <= limit).then_some(id)
    };
    let lately = held.into_iter().take(MOST_TEXTURES).enumerate();
    lately.map_while(fits).collect()
}

fn tables(state: &State) -> u64 {
    let tables = state.materials.values().map(|material| &material.table);
    tables.map(bytes).sum()
}

/// Size of all tables of the state in bytes, in memory and on the GPU.
pub fn total(state: &State) -> u64 {
    let on_gpu = on_gpu(state).into_iter();
    let textures = on_gpu.filter_map(|id| Some(texture_bytes(&state.materials.get(&id)?.table)));
    tables(state) + textures.sum::<u64>()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Materials of 10 bytes, number k shown last at time k.
    fn held(count: u64, shown: &[u64]) -> Vec<Held> {
        (0..count)
            .map(|k| Held {
                id: MaterialId(k),
                bytes: 10,
                shown: shown.contains(&k),
                last_shown: k,
            })
            .collect()
    }

    fn ids(ids: &[u64]) -> Vec<MaterialId> {
        ids.iter().map(|id| MaterialId(*id)).collect()
    }

    #[test]
    fn the_least_recently_shown_go_first_and_the_shown_stay() {
        assert_eq!(to_evict(&held(4, &[3]), 0, 40), ids(&[]));
        assert_eq!(to_evict(&held(4, &[3]), 0, 39), ids(&[0]));
        assert_eq!(to_evict(&held(4, &[3]), 10, 30), ids(&[0, 1]));
        assert_eq!(to_evict(&held(4, &[0, 3]), 0, 25), ids(&[1, 2]));
        assert_eq!(to_evict(&held(4, &[0, 1, 2, 3]), 0, 0), ids(&[]));
        let mut newer = held(3, &[]);
        newer[0].last_shown = 9;
        assert_eq!(to_evict(&newer, 0, 25), ids(&[1]));
    }

    /// The most bytes ever held while 50 materials are shown one after the other, with this way to choose.
    fn most_held(limit: u64, evict: impl Fn(&[Held], u64, u64) -> Vec<MaterialId>) -> u64 {
        let mut all: Vec<Held> = Vec::new();
        let mut most = 0;
        for k in 0..50 {
            for held in &mut all {
                held.shown = false;
            }
            let gone = evict(&all, 10, limit);
            all.retain(|held| !gone.contains(&held.id));
            all.push(Held {
                id: MaterialId(k),
                bytes: 10,
                shown: true,
                last_shown: k,
            });
            most = most.max(all.iter().map(|held| held.bytes).sum());
        }
        most
    }

    #[test]
    fn memory_never_passes_the_limit_but_for_the_shown_one() {
        for limit in [0, 5, 10, 35, 100, 1000] {
            let most = most_held(limit, to_evict);
            assert!(most <= limit.max(10), "{most} of {limit}");
            assert!(
                most + 10 > limit.min(500),
                "all room is used: {most} of {limit}"
            );
        }
        // Planted: what is coming is not counted.
        let forgetful = |held: &[Held], _: u64, limit: u64| to_evict(held, 0, limit);
        assert!(most_held(30, forgetful) > 30);
    }
}
