//! Results that views show and cannot compute within a frame: a cache of one result per kind of query.
//!
//! A view requests a result each time it is drawn ([`crate::app::msg::cache::request`]); nothing happens where the
//! cache has it or a job computes it. Otherwise a job starts, and the old result stays on screen, dimmed. A new kind is
//! a type that is a [`Query`]: caches are found by that type.

use crate::app::state::job::CancelFlag;
use std::any::{Any, TypeId};
use std::collections::HashMap;
use std::fmt;
use std::ops::ControlFlow;
use std::sync::Arc;

/// The inputs of a result that takes long; equal queries have equal results.
pub trait Query: Clone + PartialEq + fmt::Debug + Send + Sync + 'static {
    /// The result.
    type Output: fmt::Debug + Send + Sync + 'static;

    /// Activity of the job in words that follow "while": "computing the albedo".
    const DOING: &'static str;

    /// Fate of a running job when a newer query comes.
    const WHEN_NEWER: WhenNewer;

    /// Computes the result on a thread in the background; `None` where it cannot be computed. `report` shows progress
    /// and partial results; where it breaks, nobody waits any more.
    fn run(
        &self,
        report: &mut dyn FnMut(Update<Self::Output>) -> ControlFlow<()>,
    ) -> Option<Self::Output>;
}

/// Fate of a running job when a newer query comes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhenNewer {
    /// Cancelled: right for seconds of work.
    Cancel,
    /// Ended first, then the newest follows: right for what takes no longer than a few frames, as a slider that is
    /// dragged would otherwise never see a result.
    FinishFirst,
}

/// A report of a job under way.
#[derive(Debug)]
pub enum Update<T> {
    /// Progress of the job, in [0, 1].
    Progress(f32),
    /// A result that is shown until a better one comes.
    Partial(T),
}

/// One result, and the job that computes the next one.
#[derive(Debug)]
pub struct Cache<Q: Query> {
    result: Option<(Q, Arc<Q::Output>)>,
    running: Option<Running<Q>>,
    /// Query to be computed when the running job has ended.
    next: Option<Q>,
    /// Stopped by hand, or impossible: not computed again by merely looking at it.
    stopped: Option<Q>,
    jobs: u64,
}

#[derive(Debug)]
struct Running<Q> {
    job: u64,
    query: Q,
    progress: f32,
    cancel: CancelFlag,
}

impl<Q: Query> Default for Cache<Q> {
    fn default() -> Self {
        Self {
            result: None,
            running: None,
            next: None,
            stopped: None,
            jobs: 0,
        }
    }
}

impl<Q: Query> Cache<Q> {
    /// The last result, and whether it answers this query. One that does not is drawn dimmed.
    pub fn shown(&self, query: &Q) -> Option<(&Q::Output, bool)> {
        let (of, output) = self.result.as_ref()?;
        Some((output, of == query))
    }

    /// The last result and its query.
    pub fn last(&self) -> Option<(&Q, &Q::Output)> {
        self.result
            .as_ref()
            .map(|(query, output)| (query, &**output))
    }

    /// Progress of the job under way, in [0, 1].
    pub fn progress(&self) -> Option<f32> {
        self.running.as_ref().map(|running| running.progress)
    }

    /// Whether the job of this query was stopped by hand.
    pub fn is_stopped(&self, query: &Q) -> bool {
        self.stopped.as_ref() == Some(query)
    }

    /// Whether the result of this query is there or coming.
    pub fn has(&self, query: &Q) -> bool {
        let coming = match (&self.next, &self.running) {
            (Some(next), _) => Some(next),
            (None, Some(running)) => Some(&running.query),
            (None, None) => self.result.as_ref().map(|(query, _)| query),
        };
        coming == Some(query) || self.is_stopped(query)
    }

    /// Asks for a result; the job to start, if one is to start now.
    pub fn request(&mut self, query: Q) -> Option<Start<Q>> {
        if self.has(&query) {
            return None;
        }
        self.stopped = None;
        match &self.running {
            Some(_) if Q::WHEN_NEWER == WhenNewer::FinishFirst => {
                self.next = Some(query);
                None
            }
            Some(running) => {
                running.cancel.set();
                Some(self.start(query))
            }
            None => Some(self.start(query)),
        }
    }

    /// Asks once more for a result whose job was stopped.
    pub fn request_again(&mut self, query: Q) -> Option<Start<Q>> {
        self.stopped = None;
        self.request(query)
    }

    fn start(&mut self, query: Q) -> Start<Q> {
        self.jobs += 1;
        self.next = None;
        let cancel = CancelFlag::default();
        self.running = Some(Running {
            job: self.jobs,
            query: query.clone(),
            progress: 0.0,
            cancel: cancel.clone(),
        });
        Start {
            job: self.jobs,
            query,
            cancel,
        }
    }

    /// Takes in what a job reports. One that was replaced changes nothing.
    pub fn update(&mut self, job: u64, update: Update<Q::Output>) {
        let Some(running) = self.running.as_mut().filter(|running| running.job == job) else {
            return;
        };
        match update {
            Update::Progress(progress) => running.progress = progress,
            Update::Partial(part) => {
                self.result = Some((running.query.clone(), Arc::new(part)));
            }
        }
    }

    /// A job has ended, with a result or without; the job to start now, if one was waiting.
    pub fn end(&mut self, job: u64, output: Option<Q::Output>) -> Option<Start<Q>> {
        let running = self.running.take_if(|running| running.job == job)?;
        match output {
            Some(output) => self.result = Some((running.query, Arc::new(output))),
            // It cannot be computed: looking at it again changes nothing.
            None => self.stopped = Some(running.query),
        }
        let next = self.next.take()?;
        Some(self.start(next))
    }

    /// Cancels the job under way; its query is not computed again until it is asked for by hand.
    pub fn stop(&mut self) {
        self.next = None;
        if let Some(running) = self.running.take() {
            running.cancel.set();
            self.stopped = Some(running.query);
        }
    }
}

/// A job that is to start.
#[derive(Debug)]
pub struct Start<Q> {
    /// Number of the job in its cache.
    pub job: u64,
    /// The query to compute.
    pub query: Q,
    /// Set where nobody waits any more.
    pub cancel: CancelFlag,
}

/// The caches of all kinds of queries.
#[derive(Debug, Default)]
pub struct Caches(HashMap<TypeId, Box<dyn AnyCache>>);

trait AnyCache: Any + fmt::Debug + Send {}

impl<Q: Query> AnyCache for Cache<Q> {}

impl Caches {
    /// The cache of a kind of query; `None` before its first request.
    pub fn get<Q: Query>(&self) -> Option<&Cache<Q>> {
        let cache: &dyn Any = &**self.0.get(&TypeId::of::<Q>())?;
        cache.downcast_ref()
    }

    /// The cache of a kind of query, made where there is none yet.
    pub fn get_mut<Q: Query>(&mut self) -> &mut Cache<Q> {
        let cache = self.0.entry(TypeId::of::<Q>());
        let cache: &mut dyn Any = &mut **cache.or_insert_with(|| Box::new(Cache::<Q>::default()));
        cache
            .downcast_mut()
            .expect("a cache is kept under the type of its query")
    }

    /// See [`Cache::shown`].
    pub fn shown<Q: Query>(&self, query: &Q) -> Option<(&Q::Output, bool)> {
        self.get::<Q>()?.shown(query)
    }

    /// See [`Cache::last`].
    pub fn last<Q: Query>(&self) -> Option<(&Q, &Q::Output)> {
        self.get::<Q>()?.last()
    }

    /// See [`Cache::progress`].
    pub fn progress<Q: Query>(&self) -> Option<f32> {
        self.get::<Q>()?.progress()
    }

    /// See [`Cache::is_stopped`].
    pub fn is_stopped<Q: Query>(&self, query: &Q) -> bool {
        self.get::<Q>().is_some_and(|cache| cache.is_stopped(query))
    }

    /// See [`Cache::has`].
    pub fn has<Q: Query>(&self, query: &Q) -> bool {
        self.get::<Q>().is_some_and(|cache| cache.has(query))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Half of a number; 1 finishes first, 0 is cancelled.
    #[derive(Clone, Debug, PartialEq)]
    struct Half<const FINISHES: bool>(f64);

    impl<const FINISHES: bool> Query for Half<FINISHES> {
        type Output = f64;
        const DOING: &'static str = "halving a number";
        const WHEN_NEWER: WhenNewer = if FINISHES {
            WhenNewer::FinishFirst
        } else {
            WhenNewer::Cancel
        };

        fn run(&self, _: &mut dyn FnMut(Update<f64>) -> ControlFlow<()>) -> Option<f64> {
            Some(self.0 / 2.0)
        }
    }

    fn end<Q: Query>(cache: &mut Cache<Q>, start: &Start<Q>) -> Option<Start<Q>> {
        let output = start.query.run(&mut |_| ControlFlow::Continue(()));
        cache.end(start.job, output)
    }

    #[test]
    fn a_result_is_computed_once_and_stays_while_the_next_is_computed() {
        let mut cache = Cache::<Half<true>>::default();
        let first = cache.request(Half(4.0)).expect("a start");
        assert!(cache.request(Half(4.0)).is_none(), "it is under way");
        assert!(end(&mut cache, &first).is_none());
        assert_eq!(cache.shown(&Half(4.0)), Some((&2.0, true)));
        assert!(cache.request(Half(4.0)).is_none(), "it is there");
        let second = cache.request(Half(6.0)).expect("a start");
        assert_eq!(cache.shown(&Half(6.0)), Some((&2.0, false)));
        end(&mut cache, &second);
        assert_eq!(cache.shown(&Half(6.0)), Some((&3.0, true)));
    }

    #[test]
    fn a_short_job_ends_and_the_newest_query_follows() {
        let mut cache = Cache::<Half<true>>::default();
        let first = cache.request(Half(4.0)).expect("a start");
        assert!(cache.request(Half(6.0)).is_none());
        assert!(cache.request(Half(8.0)).is_none());
        assert!(!first.cancel.is_set());
        let next = end(&mut cache, &first).expect("the newest");
        assert_eq!(next.query, Half(8.0));
        assert_eq!(cache.last(), Some((&Half(4.0), &2.0)));
    }

    #[test]
    fn a_long_job_makes_way_and_changes_nothing_any_more() {
        let mut cache = Cache::<Half<false>>::default();
        let first = cache.request(Half(4.0)).expect("a start");
        let second = cache.request(Half(6.0)).expect("a start");
        assert!(first.cancel.is_set() && !second.cancel.is_set());
        assert!(end(&mut cache, &first).is_none());
        assert_eq!(cache.last(), None);
        cache.update(second.job, Update::Progress(0.5));
        assert_eq!(cache.progress(), Some(0.5));
        end(&mut cache, &second);
        assert_eq!(cache.last(), Some((&Half(6.0), &3.0)));
    }

    #[test]
    fn a_stopped_query_is_not_begun_again_by_looking() {
        let mut cache = Cache::<Half<false>>::default();
        let first = cache.request(Half(4.0)).expect("a start");
        cache.stop();
        assert!(first.cancel.is_set() && cache.is_stopped(&Half(4.0)));
        assert!(cache.request(Half(4.0)).is_none());
        assert!(cache.request(Half(6.0)).is_some(), "another one is");
    }

    #[test]
    fn each_kind_of_query_has_its_own_cache() {
        let mut caches = Caches::default();
        assert!(!caches.has(&Half::<true>(4.0)));
        let cache = caches.get_mut::<Half<true>>();
        let start = cache.request(Half(4.0)).expect("a start");
        end(cache, &start);
        assert_eq!(caches.shown(&Half::<true>(4.0)), Some((&2.0, true)));
        assert!(caches.get::<Half<false>>().is_none());
    }
}
