//! A connected session.

use std::collections::HashMap;
use std::sync::Arc;
use std::sync::mpsc::TryRecvError;
use std::time::{Duration, Instant};

use bica_link::{Client, Description, Event, Snapshot};
use bica_recording::{RequestRecord, RunEvent};
use bica_wire::message::{ExtraKind, LogSource, Offers, WorldChange};
use serde_json::Value;

use super::inbox::{Exit, Inbox};
use super::operation::Operation;
use super::returned::is_same_run;
use crate::protocol::{Capabilities, ComponentNow, Connection, Reached, Request, ToPage};
use crate::sessions::breakpoint_target::{self, Activity};
use crate::sessions::commands::Command;
use crate::sessions::history::Told;
use crate::sessions::robot_recording::RobotRecorder;
use crate::sessions::session::Session;
use crate::sessions::watching::{Sample, UPDATE};
use crate::sessions::world::World;

/// Longest wait for a message of the robot.
const POLL: Duration = Duration::from_millis(5);
/// Interval of checks of slowly changing state.
const SLOW: Duration = Duration::from_millis(500);
/// Interval of the samples of each output, cycles.
const OUTPUT_EVERY: u16 = 10;
/// Silence of a robot after which pages are notified.
const SILENCE: Duration = Duration::from_secs(2);
/// Largest number of events that are handled before commands are handled.
const EVENTS: usize = 256;
/// Largest number of samples for one message.
const MAX_SAMPLES: usize = 4096;

/// A connected session.
pub(super) struct Attached<'a> {
    pub(super) session: &'a Arc<Session>,
    pub(super) client: Client,
    pub(super) world: Option<World>,
    pub(super) operation: Operation,
    /// Interval in which each output is watched, cycles.
    watched: HashMap<(usize, usize), u16>,
    changes: Vec<(usize, u64, bool, Option<u16>)>,
    /// Samples since the last update.
    samples: Vec<Sample>,
    /// Watched data besides states and outputs, with n for every n-th cycle or image.
    pub(super) watched_extras: HashMap<ExtraKind, u16>,
    updated: Instant,
    slow: Instant,
    received: Instant,
    has_news: bool,
    /// Whether the world was paused at the last announcement.
    pub(super) is_paused: bool,
    /// Instant of the last message to pages about the size of the recording.
    pub(super) announced: Instant,
}

impl<'a> Attached<'a> {
    pub(super) fn new(session: &'a Arc<Session>, client: Client, world: Option<World>) -> Self {
        let can = capabilities(client.offers(), session.options.read_only);
        let goes_on = world.is_none() && is_same_run(session, &client);
        session.begin(client.description().clone(), can, goes_on);
        session.shared().offers = client.offers();
        session.record_robot(RobotRecorder::connected);
        session.set_connection(Connection::Connected, "");
        session.announce();
        let is_paused = session.is_paused();
        let now = Instant::now();
        Self {
            session,
            client,
            world,
            operation: Operation::default(),
            watched: HashMap::new(),
            changes: Vec::new(),
            samples: Vec::new(),
            watched_extras: HashMap::new(),
            updated: now,
            slow: now,
            received: now,
            has_news: false,
            is_paused,
            announced: now,
        }
    }

    /// Works until the session or the connection ends.
    pub(super) fn run(mut self, inbox: &Inbox) -> Exit {
        let exit = match self.begin() {
            Ok(()) => self.work(inbox),
            Err(error) => Exit::Lost(error.into()),
        };
        self.refuse_pending();
        if let Some(world) = &self.world {
            self.session.shared().is_over = world.run.is_over();
        }
        if let (Exit::Lost(failed), Some(world)) = (&exit, self.world.as_mut()) {
            // The error of the world is more informative than that of its link.
            let reason = if world.has_ended() { world.ending().err() } else { None };
            return Exit::Lost(reason.unwrap_or_else(|| failed.clone()));
        }
        exit
    }

    /// Begins to watch, and then continues a world of this process, which starts paused.
    fn begin(&mut self) -> Result<(), bica_link::Error> {
        self.client.watch(1)?;
        self.watch()?;
        self.resume_control()?;
        if self.world.is_some() && self.client.offers().contains(Offers::OPERATE) && !self.is_paused {
            self.request_pace(WorldChange::Resume)?;
        }
        Ok(())
    }

    fn work(&mut self, inbox: &Inbox) -> Exit {
        loop {
            match self.commands(inbox) {
                Ok(None) => {}
                Ok(Some(exit)) => return exit,
                Err(error) => return Exit::Lost(error.into()),
            }
            if let Err(error) = self.events(inbox) {
                return Exit::Lost(error.into());
            }
            if let Err(error) = self.look_at_pause() {
                return Exit::Lost(error.into());
            }
            if self.updated.elapsed() >= UPDATE {
                self.updated = Instant::now();
                self.update();
            }
            if self.slow.elapsed() >= SLOW {
                self.slow = Instant::now();
                self.look();
            }
        }
    }

    fn commands(&mut self, inbox: &Inbox) -> Result<Option<Exit>, bica_link::Error> {
        self.check_operator()?;
        loop {
            match inbox.commands.try_recv() {
                Ok(Command::Operate { page, id, request: Request::Restart { seed, .. } }) if self.world.is_some() => {
                    self.session.pages.answer(page, id, Ok(Value::Null));
                    return Ok(Some(Exit::Restart(seed)));
                }
                Ok(Command::Operate { page, id, request }) => self.operate(page, id, request)?,
                Ok(Command::Note { page, id, text }) => {
                    if let Some(world) = &self.world {
                        world.run.add_note(&text);
                    }
                    self.session.log(2, LogSource::Note, text);
                    self.session.pages.answer(page, id, Ok(Value::Null));
                }
                Ok(Command::Watch) => self.watch()?,
                Ok(Command::Left(page)) => {
                    self.left(page)?;
                    self.watch()?;
                }
                Ok(Command::Close) | Err(TryRecvError::Disconnected) => {
                    self.give_back()?;
                    return Ok(Some(Exit::Close));
                }
                Err(TryRecvError::Empty) => return Ok(None),
            }
        }
    }

    /// Watches the outputs that pages watch, and each output at least in the interval [`OUTPUT_EVERY`].
    fn watch(&mut self) -> Result<(), bica_link::Error> {
        let mut wanted = HashMap::new();
        for (component, described) in self.client.description().components.iter().enumerate() {
            for output in 0..described.outputs.len() {
                wanted.insert((component, output), OUTPUT_EVERY);
            }
        }
        for watch in self.session.shared().watching.watches().flat_map(|watch| &watch.outputs) {
            if let Some(every) = wanted.get_mut(&(watch.component, watch.output)) {
                *every = gcd(*every, watch.every.max(1));
            }
        }
        for (&(component, output), &every) in &wanted {
            if self.watched.get(&(component, output)) != Some(&every) {
                self.client.watch_output(component, output, every)?;
            }
        }
        self.watched = wanted;
        self.watch_extras()
    }

    fn events(&mut self, inbox: &Inbox) -> Result<(), bica_link::Error> {
        let mut wait = POLL;
        for _ in 0..EVENTS {
            let Some(event) = self.client.poll_or_wake(wait, &inbox.wakeups)? else { return Ok(()) };
            wait = Duration::ZERO;
            self.received = Instant::now();
            self.event(event)?;
        }
        Ok(())
    }

    pub(super) fn event(&mut self, event: Event) -> Result<(), bica_link::Error> {
        match event {
            Event::Snapshot(snapshot) => self.snapshot(&snapshot),
            Event::Output { cycle, component, output, value } => self.output(cycle, component, output, value),
            Event::Params { component } => self.params(component),
            Event::Lease(lease) => return self.lease(lease),
            Event::Answer(answer) => self.answered(answer),
            Event::Log(line) => self.session.add_line(line),
            Event::Requested { time_us, request } => {
                let request = RequestRecord::new(request.borrow(), &self.client.description().actions);
                self.session.tell(time_us, Told::Request(request));
            }
            Event::Happened { time_us, kind, detail } => {
                let at_ns = time_us.saturating_mul(1000);
                self.session.tell(time_us, Told::Event(RunEvent { at_ns, kind, detail }));
            }
            Event::World(state) => self.session.shared().paused = state.paused,
            other => self.link_extra(other),
        }
        Ok(())
    }

    fn snapshot(&mut self, snapshot: &Snapshot) {
        self.session.record_robot(|recorder| recorder.snapshot(snapshot, &self.session.name, &self.client));
        let Snapshot { info, states } = snapshot;
        let mut shared = self.session.shared();
        (shared.images_taken, shared.overruns) = (info.images, info.overruns);
        shared.received = Some(Instant::now());
        let ends_gap = shared.history.states.is_interrupted();
        let before: Vec<Activity> = shared.history.states.current().iter().map(ComponentNow::activity).collect();
        let changed = shared.history.states.push(info.time_us, info.cycle, states.iter().copied());
        // A program that sends conditions checks the stops itself.
        let targets = if shared.can.conditions { &[] } else { &shared.breakpoints[..] };
        let reached = breakpoint_target::reached(targets, &before, &changed);
        let visible = changed.iter().filter(|change| change.visible);
        let brief = visible.map(|change| {
            let (active, state) = change.now.activity();
            (usize::from(change.component), change.time_us, active, state)
        });
        self.changes.extend(brief);
        if self.changes.len() > MAX_SAMPLES {
            let surplus = self.changes.len() - MAX_SAMPLES;
            self.changes.drain(..surplus);
        }
        self.has_news = true;
        let gap = shared.history.states.gaps().last().copied().filter(|_| ends_gap);
        drop(shared);
        if let Some((from_us, until_us)) = gap {
            let seconds = (until_us - from_us) as f64 / 1e6;
            self.session.log(3, LogSource::Monitor, format!("the connection is restored: {seconds:.1} s are missing"));
            self.session.announce();
        }
        let time_us = info.time_us;
        for breakpoint in reached {
            self.session.hit(Reached { time_us, breakpoint }, false);
        }
    }

    fn output(&mut self, cycle: u64, component: usize, output: usize, value: Option<Vec<u8>>) {
        let mut shared = self.session.shared();
        let Some((time, last)) = shared.history.states.last() else { return };
        let period = 1e6 / f64::from(self.client.description().cycle_hz.max(1.0));
        let before = last.saturating_sub(cycle) as f64 * period;
        let time_us = time.saturating_sub(before as u64);
        let known = |tree: &Description| Some(tree.components.get(component)?.outputs.get(output)?.schema.is_some());
        let has_schema = |tree: &Description| known(tree) == Some(true);
        // A microcontroller sends a schema before the first value.
        if has_schema(self.client.description()) && !shared.description.as_deref().is_some_and(has_schema) {
            shared.description = Some(Arc::new(self.client.description().clone()));
        }
        shared.history.outputs.push(component, output, time_us, value.as_deref().unwrap_or_default());
        drop(shared);
        self.session.record_robot(|recorder| recorder.output(component, output, value.as_deref()));
        let value = value.unwrap_or_default();
        self.samples.push(Sample { cycle, time_us, component, output, value });
        if self.samples.len() >= MAX_SAMPLES {
            self.session.show_samples(&std::mem::take(&mut self.samples));
        }
    }

    fn params(&mut self, component: usize) {
        let description = self.client.description();
        let Some(described) = description.components.get(component) else { return };
        let values = described.params.iter().map(|param| param.plain(param.current())).collect();
        self.session.shared().description = Some(Arc::new(description.clone()));
        self.session.pages.broadcast(&ToPage::Params { session: self.session.id, component, values });
    }

    /// Sends new data to the pages.
    fn update(&mut self) {
        if std::mem::take(&mut self.has_news) {
            self.session.show_update(std::mem::take(&mut self.changes));
        }
        self.session.show_samples(&std::mem::take(&mut self.samples));
        self.session.send_image(&mut self.session.shared());
    }

    /// Updates slowly changing state: limits of the history, recording, note of the connection.
    pub(super) fn look(&mut self) {
        let session = self.session;
        session.shared().history.evict();
        let paused = session.is_paused();
        let note = match &self.world {
            Some(world) if world.run.is_over() && paused => {
                "the game is over: restart the world, or continue it".to_owned()
            }
            _ if !paused && self.received.elapsed() > SILENCE => "nothing comes from the robot".to_owned(),
            _ => String::new(),
        };
        self.look_at_recording();
        session.set_connection(Connection::Connected, note);
    }
}

/// Returns the supported operations and data of a connected session.
fn capabilities(offers: Offers, read_only: bool) -> Capabilities {
    Capabilities {
        operate: offers.contains(Offers::OPERATE) && !read_only,
        pause: offers.contains(Offers::PAUSE.with(Offers::OPERATE)) && !read_only,
        truth: offers.contains(Offers::TRUTH),
        images: offers.contains(Offers::IMAGES),
        costs: offers.contains(Offers::COSTS),
        conditions: offers.contains(Offers::CONDITIONS),
        run_again: false,
    }
}

/// Greatest common divisor: one interval in cycles that serves both.
const fn gcd(a: u16, b: u16) -> u16 {
    let (mut a, mut b) = (a, b);
    while b > 0 {
        (a, b) = (b, a % b);
    }
    a
}
