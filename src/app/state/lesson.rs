//! Place of a learner in the lessons.

/// Place of a learner in the lessons.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct LessonAt {
    /// Position in [`crate::app::lessons::rows::LESSONS`].
    pub lesson: usize,
    /// Position in its steps.
    pub step: usize,
    /// Whether the step's scene is still to be set, as its material is being made.
    pub waits: bool,
}
