//! Work in the background: whatever takes more than a few milliseconds runs here, and the window goes on.
//!
//! A job is [`Work`]: what it does in words, a closure, and what the state is told where it panics. It is declared
//! where it is used and started by [`Jobs::start`]. Every job has a thread of its own; what jobs compute in parallel
//! runs in one pool, rayon's global one ([`prepare_threads`]). A panic is caught in one place, is said once, and the
//! next job runs.

pub mod autosave;
pub mod dialogs;
pub mod fit;
pub mod folder_fit;
pub mod fonts;
pub mod library;
pub mod load;
pub mod scan;
pub mod sender;
pub mod session;

use crate::app::jobs::sender::Sender;
use crate::app::msg::Msg;
use crate::app::msg::work::{OnPanic, Order, Work};
use crate::app::state::notice::Severity;
use std::any::Any;
use std::collections::{HashMap, VecDeque};
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::sync::mpsc::channel;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::thread;
use std::time::{Duration, Instant};

/// Makes the pool of threads for what is computed in parallel. To be called on the window's thread: it is one of the
/// pool's, but takes part only in what it asks for itself, so jobs leave it a core.
pub fn prepare_threads() {
    let cores = thread::available_parallelism().map_or(2, usize::from);
    // Where there is a pool already (a second window of a test), that one is used.
    let _ = rayon::ThreadPoolBuilder::new()
        .num_threads(cores.max(2))
        .use_current_thread()
        .thread_name(|k| format!("pool {k}"))
        .build_global();
}

/// The result of `answer`, if it comes within this time. One that comes later is dropped.
pub fn within<T: Send + 'static>(
    patience: Duration,
    answer: impl FnOnce() -> T + Send + 'static,
) -> Option<T> {
    let (sender, receiver) = channel();
    thread::spawn(move || sender.send(answer()));
    receiver.recv_timeout(patience).ok()
}

/// Starts jobs.
#[derive(Clone)]
pub struct Jobs {
    sender: Sender,
    shared: Arc<Mutex<Shared>>,
}

#[derive(Default)]
struct Shared {
    /// Number of threads that run jobs.
    running: usize,
    /// Jobs that wait for the one before them, by the lane they share. A lane that is here has a thread.
    lanes: HashMap<&'static str, VecDeque<Work>>,
    /// A test lets the next job panic that does this.
    planted_panic: Option<String>,
}

impl Jobs {
    /// Job system in which nothing runs yet.
    pub fn new(sender: Sender) -> Self {
        Self {
            sender,
            shared: Arc::default(),
        }
    }

    /// The way back to the window.
    pub fn sender(&self) -> &Sender {
        &self.sender
    }

    /// Starts a job, now or when those before it in its lane have ended. Does not wait.
    pub fn start(&self, work: Work) {
        let lane = {
            let mut shared = self.lock();
            let lane = match work.order {
                Order::AtOnce => None,
                Order::InTurn(lane) | Order::Newest(lane) => Some(lane),
            };
            if let Some(lane) = lane {
                let waiting = shared.lanes.get_mut(lane);
                if let Some(waiting) = waiting {
                    if matches!(work.order, Order::Newest(_)) {
                        waiting.clear();
                    }
                    waiting.push_back(work);
                    return;
                }
                shared.lanes.insert(lane, VecDeque::new());
            }
            shared.running += 1;
            lane
        };
        let jobs = self.clone();
        let doing = work.doing.clone();
        let started = thread::Builder::new()
            .name(lane.unwrap_or("job").into())
            .spawn(move || jobs.run_lane(lane, work));
        if let Err(error) = started {
            let mut shared = self.lock();
            shared.running -= 1;
            if let Some(lane) = lane {
                shared.lanes.remove(lane);
            }
            drop(shared);
            let text = format!("Could not start a thread for {doing}: {error}.");
            self.sender.send(Msg::Notify(Severity::Error, text));
        }
    }

    /// Runs a job, then those that wait in its lane.
    fn run_lane(&self, lane: Option<&'static str>, work: Work) {
        let mut next = Some(work);
        while let Some(work) = next {
            self.run(work);
            let mut shared = self.lock();
            next = lane
                .and_then(|lane| shared.lanes.get_mut(lane))
                .and_then(VecDeque::pop_front);
            if next.is_none() {
                if let Some(lane) = lane {
                    shared.lanes.remove(lane);
                }
                shared.running -= 1;
            }
        }
    }

    /// Runs work, and turns its panic into a message: the one place where a panic of a job is caught.
    fn run(&self, work: Work) {
        let Work {
            doing,
            run,
            on_panic,
            ..
        } = work;
        let planted = {
            let planted = &mut self.lock().planted_panic;
            planted.take_if(|planted| doing.contains(&**planted))
        };
        let send = |msg| self.sender.send(msg);
        let result = catch_unwind(AssertUnwindSafe(|| {
            assert!(planted.is_none(), "planted");
            run(&send);
        }));
        if let Err(payload) = result {
            let text = format!(
                "An error of the program stopped it while {doing} ({}). The rest goes on; please report it.",
                reason(&*payload)
            );
            let notice = |text| send(Msg::Notify(Severity::Error, text));
            match on_panic {
                OnPanic::Notify => notice(text),
                OnPanic::NotifyAndSend(failed) => {
                    notice(text);
                    send(*failed);
                }
                OnPanic::Send(failed) => send(failed(text)),
            }
        }
    }

    /// Waits until no job runs, for this long at most, so that the program does not end in the middle of one.
    pub fn wait(&self, at_most: Duration) {
        let start = Instant::now();
        while start.elapsed() < at_most && self.lock().running > 0 {
            thread::sleep(Duration::from_millis(2));
        }
    }

    /// Lets the next job panic whose words contain `doing`: for tests.
    pub fn plant_panic(&self, doing: &str) {
        self.lock().planted_panic = Some(doing.into());
    }

    /// Locks the shared state. Every write under this lock is a single one, so what a panic leaves behind is whole.
    fn lock(&self) -> MutexGuard<'_, Shared> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// The message of a panic.
fn reason(payload: &(dyn Any + Send)) -> &str {
    let text = payload.downcast_ref::<&str>().copied();
    text.or_else(|| payload.downcast_ref::<String>().map(String::as_str))
        .unwrap_or("no reason given")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::app::msg::work::SendMsg;
    use std::sync::mpsc::Receiver;

    fn jobs() -> (Jobs, Receiver<Msg>) {
        let (sender, inbox) = Sender::new(egui::Context::default());
        (Jobs::new(sender), inbox)
    }

    const WAIT: Duration = Duration::from_secs(60);

    fn texts(inbox: &Receiver<Msg>, count: usize) -> Vec<String> {
        let mut texts = Vec::new();
        while texts.len() < count {
            match inbox.recv_timeout(WAIT).expect("a message") {
                Msg::Notify(_, text) => texts.push(text),
                other => panic!("{other:?}"),
            }
        }
        texts
    }

    fn say(text: &str) -> Msg {
        Msg::Notify(Severity::Info, text.into())
    }

    #[test]
    fn a_panic_is_said_once_and_the_next_job_of_the_lane_runs() {
        let (jobs, inbox) = jobs();
        let broken = Work::new("counting sheep", |_| panic!("there is no sheep"));
        jobs.start(broken.in_turn("sheep").or_send(say("mended")));
        jobs.start(Work::new("counting on", |send| send(say("went on"))).in_turn("sheep"));
        let texts = texts(&inbox, 3);
        assert!(
            texts[0].contains("while counting sheep (there is no sheep)"),
            "{texts:?}"
        );
        assert_eq!(texts[1..], ["mended", "went on"]);
        jobs.wait(WAIT);
        assert!(inbox.try_recv().is_err(), "nothing is said twice");
    }

    #[test]
    fn a_lane_keeps_its_order_or_only_the_newest() {
        for (newest, expected) in [(false, "0 1 2 3"), (true, "0 3")] {
            let (jobs, inbox) = jobs();
            let (go, waits) = channel::<()>();
            let mut waits = Some(waits);
            for k in 0..4 {
                let gate = waits.take();
                let work = Work::new("counting", move |send: &SendMsg| {
                    if let Some(gate) = gate {
                        let _ = gate.recv();
                    }
                    send(say(&k.to_string()));
                });
                jobs.start(if newest {
                    work.newest("n")
                } else {
                    work.in_turn("n")
                });
            }
            drop(go);
            jobs.wait(WAIT);
            let said = texts(&inbox, expected.split(' ').count());
            assert_eq!(said.join(" "), expected);
        }
    }

    #[test]
    fn a_planted_panic_meets_the_job_that_is_meant() {
        let (jobs, inbox) = jobs();
        jobs.plant_panic("sheep");
        jobs.start(Work::new("counting cows", |send| send(say("cows"))));
        assert_eq!(texts(&inbox, 1), ["cows"]);
        jobs.start(Work::new("counting sheep", |send| send(say("sheep"))));
        assert!(texts(&inbox, 1)[0].contains("planted"));
        jobs.start(Work::new("counting sheep", |send| send(say("sheep"))));
        assert_eq!(texts(&inbox, 1), ["sheep"]);
    }
}
