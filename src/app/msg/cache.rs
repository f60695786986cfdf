//! Messages about results that views show and cannot compute within a frame ([`crate::app::state::cache`]).

use crate::app::msg::Msg;
use crate::app::msg::work::{SendMsg, Work};
use crate::app::state::cache::{Cache, Caches, Query, Start, Update};
use std::fmt;
use std::marker::PhantomData;
use std::ops::ControlFlow;

/// Asks for a result where its cache neither has it nor computes it.
pub fn request<Q: Query>(caches: &Caches, query: &Q, out: &mut Vec<Msg>) {
    if !caches.has(query) {
        out.push(Msg::Cache(Box::new(Request(query.clone()))));
    }
}

/// Stops the job of a kind of query.
pub fn stop<Q: Query>() -> Msg {
    Msg::Cache(Box::new(Stop::<Q>(PhantomData)))
}

/// Computes a result after all whose job was stopped.
pub fn again<Q: Query>(query: &Q) -> Msg {
    Msg::Cache(Box::new(RequestAgain(query.clone())))
}

/// A message about one cache, whatever its kind.
pub trait CacheMsg: fmt::Debug + Send {
    /// Does to the caches what it says; the job that starts.
    fn apply(self: Box<Self>, caches: &mut Caches) -> Option<Work>;
}

#[derive(Debug)]
struct Request<Q>(Q);

#[derive(Debug)]
struct RequestAgain<Q>(Q);

#[derive(Debug)]
struct Stop<Q>(PhantomData<fn() -> Q>);

/// A job reports.
#[derive(Debug)]
struct Updated<Q: Query> {
    job: u64,
    update: Update<Q::Output>,
}

/// A job has ended.
#[derive(Debug)]
struct Ended<Q: Query> {
    job: u64,
    output: Option<Q::Output>,
}

impl<Q: Query> CacheMsg for Request<Q> {
    fn apply(self: Box<Self>, caches: &mut Caches) -> Option<Work> {
        caches.get_mut().request(self.0).map(work)
    }
}

impl<Q: Query> CacheMsg for RequestAgain<Q> {
    fn apply(self: Box<Self>, caches: &mut Caches) -> Option<Work> {
        caches.get_mut().request_again(self.0).map(work)
    }
}

impl<Q: Query> CacheMsg for Stop<Q> {
    fn apply(self: Box<Self>, caches: &mut Caches) -> Option<Work> {
        caches.get_mut::<Q>().stop();
        None
    }
}

impl<Q: Query> CacheMsg for Updated<Q> {
    fn apply(self: Box<Self>, caches: &mut Caches) -> Option<Work> {
        caches.get_mut::<Q>().update(self.job, self.update);
        None
    }
}

impl<Q: Query> CacheMsg for Ended<Q> {
    fn apply(self: Box<Self>, caches: &mut Caches) -> Option<Work> {
        let cache: &mut Cache<Q> = caches.get_mut();
        cache.end(self.job, self.output).map(work)
    }
}

fn ended<Q: Query>(job: u64, output: Option<Q::Output>) -> Msg {
    Msg::Cache(Box::new(Ended::<Q> { job, output }))
}

fn work<Q: Query>(start: Start<Q>) -> Work {
    let Start { job, query, cancel } = start;
    let failed = ended::<Q>(job, None);
    let run = move |send: &SendMsg| {
        let output = query.run(&mut |update| {
            if cancel.is_set() {
                return ControlFlow::Break(());
            }
            send(Msg::Cache(Box::new(Updated::<Q> { job, update })));
            ControlFlow::Continue(())
        });
        send(ended::<Q>(job, output));
    };
    Work::new(Q::DOING, run).or_send(failed)
}
