//! A simulated page.

use std::cell::{Cell, RefCell};
use std::collections::BTreeMap;
use std::sync::atomic::{AtomicU32, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::sync::{Arc, Mutex};
use std::time::{Duration, Instant};

use bica_monitor::program::Program;
use bica_monitor::protocol::{FromPage, Open, Request, SessionId, ToPage};
use bica_monitor::sessions::{Frame, Key, Manager, Options, Outbox, PageId};
pub(crate) use bica_test_data::process::Folder;
use serde_json::Value;

/// Longest wait for anything.
pub(crate) const LONG: Duration = Duration::from_mins(2);

/// A message or a frame that a page received.
#[derive(Clone, Debug)]
pub(crate) enum Got {
    /// A message.
    Message(Value),
    /// A binary frame.
    Binary(Arc<[u8]>),
}

struct Channel(Mutex<Sender<Got>>);

impl Channel {
    fn send(&self, got: Got) {
        let _ = self.0.lock().unwrap().send(got);
    }
}

impl Outbox for Channel {
    fn state(&self, message: ToPage) {
        self.send(Got::Message(serde_json::to_value(message).unwrap()));
    }

    fn binary(&self, frame: Arc<[u8]>) {
        self.send(Got::Binary(frame));
    }

    fn data(&self, _key: Key, frame: Frame) {
        self.send(match frame {
            Frame::Message(message) => Got::Message(serde_json::to_value(&*message).unwrap()),
            Frame::Binary(bytes) => Got::Binary(bytes),
        });
    }
}

/// A manager with a folder of its own.
pub(crate) struct Bench {
    pub(crate) manager: Manager,
    pub(crate) folder: Arc<Folder>,
}

impl Bench {
    pub(crate) fn new() -> Arc<Self> {
        Self::with(Folder::new("sessions"), |options| options)
    }

    pub(crate) fn with(folder: Folder, options: impl Fn(Options) -> Options) -> Arc<Self> {
        let options = options(self::options(&folder));
        Self::of(&Arc::new(folder), options)
    }

    pub(crate) fn of(folder: &Arc<Folder>, options: Options) -> Arc<Self> {
        Self::of_program(folder, options, crate::program())
    }

    pub(crate) fn of_program(folder: &Arc<Folder>, options: Options, program: Program) -> Arc<Self> {
        Arc::new(Self { manager: Manager::new(options, program), folder: Arc::clone(folder) })
    }
}

/// A simulated page, which sends requests and receives messages.
pub(crate) struct Page {
    pub(crate) bench: Arc<Bench>,
    pub(crate) id: PageId,
    /// Session that requests concern: the first one, if no other was chosen.
    pub(crate) session: Cell<Option<SessionId>>,
    inbox: Receiver<Got>,
    last: AtomicU32,
    /// The newest message of each type. Messages of the type `session` are kept for each session.
    newest: RefCell<BTreeMap<String, Value>>,
}

impl Page {
    pub(crate) fn new(bench: &Arc<Bench>) -> Self {
        let (sender, inbox) = channel();
        let id = bench.manager.attach(Arc::new(Channel(Mutex::new(sender))));
        let (last, session) = (AtomicU32::new(0), Cell::new(None));
        Self { bench: Arc::clone(bench), id, session, inbox, last, newest: RefCell::default() }
    }

    /// Opens a session, for requests from now on.
    pub(crate) fn open(&self, source: Open) -> SessionId {
        let session = self.bench.manager.open(source).unwrap();
        self.session.set(Some(session));
        session
    }

    /// Sends a request; returns its number.
    pub(crate) fn send(&self, request: Request) -> u32 {
        let id = self.last.fetch_add(1, Ordering::Relaxed) + 1;
        let session = self.session.get().or(Some(1));
        self.bench.manager.handle(self.id, FromPage { id, session, request });
        id
    }

    /// Waits until `found` returns a value for a received message or frame. If it never does, the panic shows the newest messages.
    pub(crate) fn wait<T>(&self, what: &str, mut found: impl FnMut(&Got) -> Option<T>) -> T {
        let until = Instant::now() + LONG;
        loop {
            let left = until.saturating_duration_since(Instant::now());
            let got = self.inbox.recv_timeout(left).unwrap_or_else(|_| {
                panic!("{what} did not come; the newest of each type: {:#?}", self.newest.borrow())
            });
            if let Got::Message(message) = &got {
                let mut newest = self.newest.borrow_mut();
                if message["type"] == "described" {
                    // The last update belongs to the previous run.
                    newest.retain(|_, old| old["type"] != "update");
                }
                newest.insert(format!("{} {}", message["type"], message["session"]["id"]), message.clone());
            }
            if let Some(value) = found(&got) {
                return value;
            }
        }
    }

    /// Waits for a message of a type for which `found` returns a value.
    pub(crate) fn message<T>(&self, kind: &str, mut found: impl FnMut(&Value) -> Option<T>) -> T {
        self.wait(kind, |got| match got {
            Got::Message(message) if message["type"] == kind => found(message),
            _ => None,
        })
    }

    /// Returns the value of `found` for the newest message of a type, or waits for a message of this type for which it returns one.
    pub(crate) fn state<T>(&self, kind: &str, mut found: impl FnMut(&Value) -> Option<T>) -> T {
        let last = self.newest.borrow().values().filter(|one| one["type"] == kind).find_map(&mut found);
        last.unwrap_or_else(|| self.message(kind, found))
    }

    /// Sends a request and waits for its answer.
    pub(crate) fn ask(&self, request: Request) -> Result<Value, Value> {
        let id = self.send(request);
        self.message("answer", |message| answer(message, id))
    }

    /// Returns the state after the last cycle.
    pub(crate) fn now(&self) -> Value {
        self.ask(Request::At { time_us: u64::MAX, outputs: vec![], image: false }).unwrap()
    }

    /// Pauses the world; returns the state after the last cycle.
    pub(crate) fn paused(&self) -> Value {
        self.send(Request::Pause {});
        self.session(|session| session["paused"] == true);
        self.stands()
    }

    /// Returns the state of a paused world, once the last cycles before the pause have arrived.
    pub(crate) fn stands(&self) -> Value {
        std::thread::sleep(Duration::from_millis(300));
        self.now()
    }

    /// Waits for a cycle.
    pub(crate) fn cycle(&self, number: u64) {
        self.state("update", |update| (update["cycle"].as_u64()? >= number).then_some(()));
    }

    /// Returns all lines of the log.
    pub(crate) fn lines(&self) -> Vec<Value> {
        let request = Request::Lines { from_us: 0, until_us: u64::MAX, limit: 1000 };
        self.ask(request).unwrap().as_array().unwrap().clone()
    }

    /// Waits for a message about a session for which `is` returns true; returns the session.
    pub(crate) fn session(&self, mut is: impl FnMut(&Value) -> bool) -> Value {
        self.message("session", |message| is(&message["session"]).then(|| message["session"].clone()))
    }
}

impl Drop for Page {
    fn drop(&mut self) {
        self.bench.manager.detach(self.id);
    }
}

/// Returns the result or the error in the answer to a request.
pub(crate) fn answer(message: &Value, id: u32) -> Option<Result<Value, Value>> {
    (message["type"] == "answer" && message["id"] == id).then(|| match message.get("error") {
        Some(error) => Err(error.clone()),
        None => Ok(message.get("result").cloned().unwrap_or(Value::Null)),
    })
}

/// Options with all folders below this one.
pub(crate) fn options(folder: &Folder) -> Options {
    Options {
        recordings: folder.0.join("recordings"),
        tune: folder.0.join("tune"),
        layouts: folder.0.join("layouts.json"),
        spool: folder.0.join("spool"),
        ..Options::default()
    }
}
