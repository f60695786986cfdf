//! Work for the background.

use crate::app::msg::Msg;
use std::fmt;

/// Sends messages to the window.
pub type SendMsg<'a> = dyn Fn(Msg) + Sync + 'a;

/// Does the work.
pub type WorkFn = Box<dyn FnOnce(&SendMsg) + Send>;

/// Work for a thread in the background, and what becomes of the state where it panics.
pub struct Work {
    /// Activity in words that follow "while": "reading teflon.binary".
    pub doing: String,
    /// Whether it waits for others.
    pub order: Order,
    /// Function that runs on a background thread and sends messages as it goes.
    pub run: WorkFn,
    /// Change of the state where it panics.
    pub on_panic: OnPanic,
}

/// Change of the state where work panics. A notice says it once in any case.
pub enum OnPanic {
    /// No change: nothing is left to be mended.
    Notify,
    /// Message in place of what the work would have sent at its end.
    NotifyAndSend(Box<Msg>),
    /// A message that carries the text, and whose reducer shows it as it does with any other failure.
    Send(Box<dyn FnOnce(String) -> Msg + Send>),
}

/// Whether work waits for other work. A lane is a name that works share.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Waits for nothing.
    AtOnce,
    /// Waits for all that came before it in its lane.
    InTurn(&'static str),
    /// Waits for what runs in its lane, and takes the place of what waits there.
    Newest(&'static str),
}

impl fmt::Debug for Work {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Work({}, {:?})", self.doing, self.order)
    }
}

impl Work {
    /// Work that waits for nothing and leaves nothing to be mended where it panics.
    pub fn new(doing: impl Into<String>, run: impl FnOnce(&SendMsg) + Send + 'static) -> Self {
        Self {
            doing: doing.into(),
            order: Order::AtOnce,
            run: Box::new(run),
            on_panic: OnPanic::Notify,
        }
    }

    /// Work that waits for all that came before it in this lane.
    pub fn in_turn(mut self, lane: &'static str) -> Self {
        self.order = Order::InTurn(lane);
        self
    }

    /// Work that waits for what runs in this lane; what waits there is dropped.
    pub fn newest(mut self, lane: &'static str) -> Self {
        self.order = Order::Newest(lane);
        self
    }

    /// Work with a message that is sent after the notice where it panics.
    pub fn or_send(mut self, failed: Msg) -> Self {
        self.on_panic = OnPanic::NotifyAndSend(Box::new(failed));
        self
    }

    /// Work with a message that carries the text of the notice where it panics.
    pub fn or_tell(mut self, failed: impl FnOnce(String) -> Msg + Send + 'static) -> Self {
        self.on_panic = OnPanic::Send(Box::new(failed));
        self
    }
}
