//! Stages of the staged fit [Nielsen14], and a choice of them.

use crate::brdf::{Model, ParamId};
use std::ops::{Index, IndexMut};

/// Stage of the staged fit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Stage {
    /// Stage 1: ρ_d and k_s for a fixed shape; exact [Nielsen14].
    Amplitudes,
    /// Stage 2: the lobe's parameters and η for fixed ρ_d and k_s [Nielsen14].
    Shape,
    /// Stage 3: the lobe's parameters, η and k_s for fixed ρ_d [Nielsen14].
    ShapeAndSpecular,
    /// Stage 4: all parameters together, from several starts.
    Joint,
}

/// All stages in the order in which they are run.
pub const STAGES: [Stage; 4] = [
    Stage::Amplitudes,
    Stage::Shape,
    Stage::ShapeAndSpecular,
    Stage::Joint,
];

impl Stage {
    /// Number of the stage in files and on screen, 1 to 4: three as in [Nielsen14] and one more.
    pub fn number(self) -> usize {
        self as usize + 1
    }

    /// The stage with this number; `None` outside of 1 to 4.
    pub fn by_number(number: usize) -> Option<Self> {
        STAGES.into_iter().find(|stage| stage.number() == number)
    }

    /// Symbols of the parameters of a model that the stage moves, in the markup of [`crate::figure::text`].
    pub fn symbols(self, model: &Model) -> String {
        if self == Self::Joint {
            return "all".into();
        }
        // The shape first: what sets the stages apart.
        let rows = || model.rows().filter(|row| self.moves(row.id));
        let shape = rows().filter(|row| !row.id.is_color());
        let colors = rows().filter(|row| row.id.is_color());
        let symbols: Vec<&str> = shape.chain(colors).map(|row| row.symbol).collect();
        symbols.join(", ")
    }

    /// Whether the stage may move a parameter.
    pub fn moves(self, id: ParamId) -> bool {
        match self {
            Self::Amplitudes => id.is_color(),
            Self::Shape => !id.is_color(),
            Self::ShapeAndSpecular => id != ParamId::RHO_D,
            Self::Joint => true,
        }
    }
}

/// Choice of the stages that a fit runs, always in the order of [`STAGES`]; indexed by [`Stage`].
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct StageSet {
    /// Whether stage 1 is run: ρ_d and k_s.
    pub amplitudes: bool,
    /// Whether stage 2 is run: the lobe's parameters and η.
    pub shape: bool,
    /// Whether stage 3 is run: the lobe's parameters, η and k_s.
    pub shape_and_specular: bool,
    /// Whether stage 4 is run: all parameters together.
    pub joint: bool,
}

impl StageSet {
    /// No stage.
    pub const NONE: Self = Self {
        amplitudes: false,
        shape: false,
        shape_and_specular: false,
        joint: false,
    };
    /// Stages 1 to 3, the fit of [Nielsen14].
    pub const POSTER: Self = Self {
        amplitudes: true,
        shape: true,
        shape_and_specular: true,
        joint: false,
    };
    /// All four stages.
    pub const ALL: Self = Self {
        joint: true,
        ..Self::POSTER
    };

    /// Chosen stages, in the order in which they are run.
    pub fn iter(self) -> impl Iterator<Item = Stage> {
        STAGES.into_iter().filter(move |stage| self[*stage])
    }
}

impl FromIterator<Stage> for StageSet {
    fn from_iter<I: IntoIterator<Item = Stage>>(stages: I) -> Self {
        let mut set = Self::NONE;
        for stage in stages {
            set[stage] = true;
        }
        set
    }
}

impl Index<Stage> for StageSet {
    type Output = bool;

    fn index(&self, stage: Stage) -> &bool {
        match stage {
            Stage::Amplitudes => &self.amplitudes,
            Stage::Shape => &self.shape,
            Stage::ShapeAndSpecular => &self.shape_and_specular,
            Stage::Joint => &self.joint,
        }
    }
}

impl IndexMut<Stage> for StageSet {
    fn index_mut(&mut self, stage: Stage) -> &mut bool {
        match stage {
            Stage::Amplitudes => &mut self.amplitudes,
            Stage::Shape => &mut self.shape,
            Stage::ShapeAndSpecular => &mut self.shape_and_specular,
            Stage::Joint => &mut self.joint,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_set_has_the_stages_that_it_is_made_of() {
        for bits in 0..16 {
            let chosen = |stage: &Stage| bits >> (stage.number() - 1) & 1 == 1;
            let stages: Vec<Stage> = STAGES.into_iter().filter(chosen).collect();
            let set: StageSet = stages.iter().copied().rev().collect();
            assert_eq!(set.iter().collect::<Vec<_>>(), stages);
            assert!(STAGES.iter().all(|stage| set[*stage] == chosen(stage)));
            // A planted change is seen.
            let mut other = set;
            other[Stage::Shape] = !other[Stage::Shape];
            assert_ne!(other, set);
        }
        assert_eq!(STAGES.into_iter().collect::<StageSet>(), StageSet::ALL);
        assert_eq!(StageSet::default(), StageSet::NONE);
    }
}
