//! Undo as a stack of old states, one per gesture.

/// Number of steps that are kept.
const STEPS: usize = 200;

/// The states before and after the present one.
#[derive(Debug)]
pub struct History<T> {
    past: Vec<T>,
    future: Vec<T>,
    /// A gesture is under way: what changes now belongs to the step already begun.
    in_gesture: bool,
}

impl<T> Default for History<T> {
    fn default() -> Self {
        Self {
            past: Vec::new(),
            future: Vec::new(),
            in_gesture: false,
        }
    }
}

impl<T: Clone + PartialEq> History<T> {
    /// Keeps `present`, unless the gesture under way has done so. To be called before a change.
    pub fn before_change(&mut self, present: &T) {
        if self.in_gesture {
            return;
        }
        self.past.push(present.clone());
        if self.past.len() > STEPS {
            self.past.remove(0);
        }
        self.future.clear();
        self.in_gesture = true;
    }

    /// Ends the gesture: the next change begins a step of its own. A gesture that changed nothing leaves no step.
    pub fn settle(&mut self, present: &T) {
        if self.in_gesture && self.past.last() == Some(present) {
            self.past.pop();
        }
        self.in_gesture = false;
    }

    /// Takes the last step back.
    pub fn undo(&mut self, present: &mut T) {
        self.settle(present);
        if let Some(before) = self.past.pop() {
            self.future.push(std::mem::replace(present, before));
        }
    }

    /// Takes the last undo back.
    pub fn redo(&mut self, present: &mut T) {
        self.settle(present);
        if let Some(after) = self.future.pop() {
            self.past.push(std::mem::replace(present, after));
        }
    }

    /// Whether there is something to undo.
    pub fn can_undo(&self) -> bool {
        !self.past.is_empty()
    }

    /// Whether there is something to redo.
    pub fn can_redo(&self) -> bool {
        !self.future.is_empty()
    }

    /// All states that can be reached by undo and redo, for what changes the past too.
    pub fn states_mut(&mut self) -> impl Iterator<Item = &mut T> {
        self.past.iter_mut().chain(&mut self.future)
    }

    /// All states that can be reached by undo and redo.
    pub fn states(&self) -> impl Iterator<Item = &T> {
        self.past.iter().chain(&self.future)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_gesture_is_one_step() {
        let (mut history, mut x) = (History::default(), 0);
        for value in [1, 2, 3] {
            history.before_change(&x);
            x = value;
        }
        history.settle(&x);
        history.before_change(&x);
        x = 4;
        history.settle(&x);
        history.undo(&mut x);
        assert_eq!(x, 3);
        history.undo(&mut x);
        assert_eq!(x, 0);
        assert!(!history.can_undo());
        history.redo(&mut x);
        history.redo(&mut x);
        assert_eq!(x, 4);
        assert!(!history.can_redo());
    }

    #[test]
    fn a_gesture_that_comes_back_leaves_no_step() {
        let (mut history, mut x) = (History::default(), 0);
        history.before_change(&x);
        x = 1;
        history.before_change(&x);
        x = 0;
        history.settle(&x);
        assert!(!history.can_undo());
        history.undo(&mut x);
        assert_eq!(x, 0);
    }

    #[test]
    fn a_new_change_forgets_what_was_undone() {
        let (mut history, mut x) = (History::default(), 0);
        history.before_change(&x);
        x = 1;
        history.settle(&x);
        history.undo(&mut x);
        history.before_change(&x);
        x = 2;
        history.settle(&x);
        assert!(!history.can_redo());
        history.redo(&mut x);
        assert_eq!(x, 2);
    }
}
