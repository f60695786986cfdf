//! What views show and cannot compute within a frame: a slot per kind of result.
//!
//! A view wishes for a result each time it is drawn ([`want`]); nothing happens where the slot has it or makes it.
//! Otherwise a thread makes it, and the old result stays on screen, dimmed. A new kind is a type that is [`Wish`] and a
//! field of [`Derived`].

use super::jobs::Outbox;
use super::paper::PreviewWish;
use super::state::{CancelFlag, State};
use super::update::{Msg, Task};
use super::views::albedo::{MeasuredAlbedo, ModelAlbedo};
use super::views::error_map::ErrorWish;
use super::views::landscape::LandscapeWish;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

/// The slots of all kinds.
#[derive(Debug, Default)]
pub struct Derived {
    /// Albedos of measurements.
    pub measured_albedo: Slot<MeasuredAlbedo>,
    /// Albedos of models.
    pub model_albedo: Slot<ModelAlbedo>,
    /// Where the error of the shown model comes from.
    pub error_map: Slot<ErrorWish>,
    /// A figure on paper.
    pub preview: Slot<PreviewWish>,
    /// The best error over (s, α).
    pub landscape: Slot<LandscapeWish>,
}

/// A result that takes long, by what it is made from.
pub trait Wish: Clone + PartialEq + fmt::Debug + Send + 'static {
    /// The result.
    type Made: fmt::Debug + Send + Sync + 'static;

    /// Whether a newer wish lets this one end first: right for what takes no longer than a few frames, as a slider
    /// that is dragged would otherwise never see a result.
    const ENDS_FIRST: bool;

    /// Its slot.
    fn slot(derived: &mut Derived) -> &mut Slot<Self>;

    /// Makes it on a thread of its own. What `follow` is told is shown; where it breaks, nobody waits any more.
    fn make(
        &self,
        follow: &mut dyn FnMut(Step<Self::Made>) -> ControlFlow<()>,
    ) -> Option<Self::Made>;
}

/// A word of a job.
#[derive(Debug)]
pub enum Step<T> {
    /// How far it is, in [0, 1].
    Progress(f32),
    /// What there is so far.
    Part(T),
}

/// One result and the job that makes the next one.
#[derive(Debug)]
pub struct Slot<W: Wish> {
    made: Option<(W, Arc<W::Made>)>,
    running: Option<Running<W>>,
    /// To be made when the running one has ended.
    next: Option<W>,
    /// Stopped by hand: not begun again by merely looking at it.
    stopped: Option<W>,
    jobs: u64,
}

#[derive(Debug)]
struct Running<W> {
    job: u64,
    wish: W,
    progress: f32,
    cancel: CancelFlag,
}

impl<W: Wish> Default for Slot<W> {
    fn default() -> Self {
        Self {
            made: None,
            running: None,
            next: None,
            stopped: None,
            jobs: 0,
        }
    }
}

impl<W: Wish> Slot<W> {
    /// The last result, and whether it is what is wished for now. One that is not is drawn dimmed.
    pub fn shown(&self, wish: &W) -> Option<(&W::Made, bool)> {
        let (of, made) = self.made.as_ref()?;
        Some((made, of == wish))
    }

    /// The last result and what it is of.
    pub fn last(&self) -> Option<(&W, &W::Made)> {
        self.made.as_ref().map(|(wish, made)| (wish, &**made))
    }

    /// How far the job under way is, in [0, 1].
    pub fn progress(&self) -> Option<f32> {
        self.running.as_ref().map(|running| running.progress)
    }

    /// Whether the job for this wish was stopped by hand.
    pub fn is_stopped(&self, wish: &W) -> bool {
        self.stopped.as_ref() == Some(wish)
    }

    fn has(&self, wish: &W) -> bool {
        let coming = match (&self.next, &self.running) {
            (Some(next), _) => Some(next),
            (None, Some(running)) => Some(&running.wish),
            (None, None) => self.made.as_ref().map(|(wish, _)| wish),
        };
        coming == Some(wish) || self.is_stopped(wish)
    }

    fn want(&mut self, wish: W) -> Option<Start<W>> {
        if self.has(&wish) {
            return None;
        }
        self.stopped = None;
        match &self.running {
            Some(_) if W::ENDS_FIRST => {
                self.next = Some(wish);
                None
            }
            Some(running) => {
                running.cancel.set();
                Some(self.start(wish))
            }
            None => Some(self.start(wish)),
        }
    }

    fn start(&mut self, wish: W) -> Start<W> {
        self.jobs += 1;
        self.next = None;
        let cancel = CancelFlag::default();
        self.running = Some(Running {
            job: self.jobs,
            wish: wish.clone(),
            progress: 0.0,
            cancel: cancel.clone(),
        });
        Start {
            job: self.jobs,
            wish,
            cancel,
        }
    }

    fn hear(&mut self, job: u64, heard: Heard<W::Made>) -> Option<Start<W>> {
        let running = self.running.as_mut().filter(|running| running.job == job)?;
        match heard {
            Heard::Step(Step::Progress(progress)) => running.progress = progress,
            Heard::Step(Step::Part(part)) => {
                self.made = Some((running.wish.clone(), Arc::new(part)));
            }
            Heard::Ended(made) => {
                let wish = running.wish.clone();
                self.running = None;
                match made {
                    Some(made) => self.made = Some((wish, Arc::new(made))),
                    // It cannot be made: looking at it again changes nothing.
                    None => self.stopped = Some(wish),
                }
                let next = self.next.take()?;
                return Some(self.start(next));
            }
        }
        None
    }

    fn stop(&mut self) {
        self.next = None;
        if let Some(running) = self.running.take() {
            running.cancel.set();
            self.stopped = Some(running.wish);
        }
    }
}

struct Start<W> {
    job: u64,
    wish: W,
    cancel: CancelFlag,
}

#[derive(Debug)]
enum Heard<T> {
    Step(Step<T>),
    Ended(Option<T>),
}

/// Asks for a result where the slot neither has it nor makes it.
pub fn want<W: Wish>(slot: &Slot<W>, wish: &W, out: &mut Vec<Msg>) {
    if !slot.has(wish) {
        out.push(Msg::Derived(Box::new(Want(wish.clone()))));
    }
}

/// Stops the job of a kind.
pub fn stop<W: Wish>() -> Msg {
    Msg::Derived(Box::new(Stop::<W>(std::marker::PhantomData)))
}

/// Makes a result again that was stopped.
pub fn again<W: Wish>(wish: &W) -> Msg {
    Msg::Derived(Box::new(Again(wish.clone())))
}

/// A message about a slot, whatever its kind.
pub trait DerivedMsg: fmt::Debug + Send {
    /// Does to the state what it says.
    fn apply(self: Box<Self>, state: &mut State) -> Option<Work>;
}

#[derive(Debug)]
struct Want<W>(W);

#[derive(Debug)]
struct Again<W>(W);

#[derive(Debug)]
struct Stop<W>(std::marker::PhantomData<fn() -> W>);

#[derive(Debug)]
struct Said<W: Wish> {
    job: u64,
    heard: Heard<W::Made>,
}

impl<W: Wish> DerivedMsg for Want<W> {
    fn apply(self: Box<Self>, state: &mut State) -> Option<Work> {
        W::slot(&mut state.derived).want(self.0).map(Work::of)
    }
}

impl<W: Wish> DerivedMsg for Again<W> {
    fn apply(self: Box<Self>, state: &mut State) -> Option<Work> {
        let slot = W::slot(&mut state.derived);
        slot.stopped = None;
        slot.want(self.0).map(Work::of)
    }
}

impl<W: Wish> DerivedMsg for Stop<W> {
    fn apply(self: Box<Self>, state: &mut State) -> Option<Work> {
        W::slot(&mut state.derived).stop();
        None
    }
}

impl<W: Wish> DerivedMsg for Said<W> {
    fn apply(self: Box<Self>, state: &mut State) -> Option<Work> {
        let start = W::slot(&mut state.derived).hear(self.job, self.heard);
        start.map(Work::of)
    }
}

/// A job to be run on a thread of its own.
pub struct Work(Box<dyn FnOnce(&Outbox) + Send>);

impl fmt::Debug for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("Work")
    }
}

impl Work {
    fn of<W: Wish>(start: Start<W>) -> Self {
        Self(Box::new(move |outbox| {
            let Start { job, wish, cancel } = start;
            let say = |heard| {
                outbox.send(Msg::Derived(Box::new(Said::<W> { job, heard })));
            };
            let made = wish.make(&mut |step| {
                if cancel.is_set() {
                    return ControlFlow::Break(());
                }
                say(Heard::Step(step));
                ControlFlow::Continue(())
            });
            say(Heard::Ended(made));
        }))
    }

    /// Runs it; the outbox hears how it goes.
    pub fn run(self, outbox: &Outbox) {
        (self.0)(outbox);
    }
}

/// What `apply` does with a message about a slot.
pub(super) fn apply(state: &mut State, msg: Box<dyn DerivedMsg>) -> Vec<Task> {
    msg.apply(state).map(Task::Derive).into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Its own half.
    #[derive(Clone, Debug, PartialEq)]
    struct Half<const ENDS_FIRST: bool>(f64);

    impl<const ENDS_FIRST: bool> Wish for Half<ENDS_FIRST> {
        type Made = f64;
        const ENDS_FIRST: bool = ENDS_FIRST;

        fn slot(_: &mut Derived) -> &mut Slot<Self> {
            unreachable!("the tests hold the slot themselves")
        }

        fn make(&self, _: &mut dyn FnMut(Step<f64>) -> ControlFlow<()>) -> Option<f64> {
            Some(0.5 * self.0)
        }
    }

    fn end<W: Wish>(slot: &mut Slot<W>, start: &Start<W>) -> Option<Start<W>> {
        let made = start.wish.make(&mut |_| ControlFlow::Continue(()));
        slot.hear(start.job, Heard::Ended(made))
    }

    #[test]
    fn a_result_is_made_once_and_stays_while_the_next_is_made() {
        let mut slot = Slot::<Half<true>>::default();
        let first = slot.want(Half(4.0)).expect("a start");
        assert!(slot.want(Half(4.0)).is_none(), "it is under way");
        assert!(end(&mut slot, &first).is_none());
        assert_eq!(slot.shown(&Half(4.0)), Some((&2.0, true)));
        assert!(slot.want(Half(4.0)).is_none(), "it is there");
        let second = slot.want(Half(6.0)).expect("a start");
        assert_eq!(slot.shown(&Half(6.0)), Some((&2.0, false)));
        end(&mut slot, &second);
        assert_eq!(slot.shown(&Half(6.0)), Some((&3.0, true)));
    }

    #[test]
    fn a_short_job_ends_and_the_newest_wish_follows() {
        let mut slot = Slot::<Half<true>>::default();
        let first = slot.want(Half(4.0)).expect("a start");
        assert!(slot.want(Half(6.0)).is_none());
        assert!(slot.want(Half(8.0)).is_none());
        assert!(!first.cancel.is_set());
        let next = end(&mut slot, &first).expect("the newest");
        assert_eq!(next.wish, Half(8.0));
        assert_eq!(slot.last(), Some((&Half(4.0), &2.0)));
    }

    #[test]
    fn a_long_job_makes_way_and_is_not_heard_again() {
        let mut slot = Slot::<Half<false>>::default();
        let first = slot.want(Half(4.0)).expect("a start");
        let second = slot.want(Half(6.0)).expect("a start");
        assert!(first.cancel.is_set() && !second.cancel.is_set());
        assert!(end(&mut slot, &first).is_none());
        assert_eq!(slot.last(), None);
        slot.hear(second.job, Heard::Step(Step::Progress(0.5)));
        assert_eq!(slot.progress(), Some(0.5));
        end(&mut slot, &second);
        assert_eq!(slot.last(), Some((&Half(6.0), &3.0)));
    }

    #[test]
    fn what_was_stopped_is_not_begun_again_by_looking() {
        let mut slot = Slot::<Half<false>>::default();
        let first = slot.want(Half(4.0)).expect("a start");
        slot.stop();
        assert!(first.cancel.is_set() && slot.is_stopped(&Half(4.0)));
        assert!(slot.want(Half(4.0)).is_none());
        assert!(slot.want(Half(6.0)).is_some(), "another one is");
    }
}
