//! The runs that a recording is compared with.

use std::fmt::Display;
use std::path::Path;

use bica::action::perform;
use bica::runner::workers::{HeldJobs, Pace, Workers};
use bica::runner::{Cycle, Jobs, Observer, Robot, Runner, World};
use bica::{ComponentId, Instant, JobEnd, Probe, Refusal, Tree};
use bica_wire::Recordable;
use crc32fast::Hasher;

use super::subject::{RepeatedWorld, Subject};
use super::{FileRecording, open};
use crate::digest::RunningFingerprint;
use crate::header::Header;
use crate::message::RunEvent;
use crate::program::Program;
use crate::recorder::tree_record;
use crate::recording::RecordedCycle;
use crate::request::RequestRecord;
use bica_wire::model::Invalid;

/// The run that a recording is compared with.
pub(super) trait Run {
    /// Returns the cycle that corresponds to a recorded one; none after the last.
    fn next(&mut self, recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Invalid>;

    /// Returns the program of another recording; none if the code runs in this program.
    fn program(&self) -> Option<Program> {
        None
    }

    /// Returns whether there are cycles beyond those of the recording.
    fn goes_on(&mut self) -> Result<bool, Invalid> {
        Ok(false)
    }
}

/// Another recording.
pub(super) struct Other<'a> {
    path: &'a Path,
    recording: FileRecording,
}

impl<'a> Other<'a> {
    pub(super) fn open(path: &'a Path, header: &Header) -> Result<Self, Invalid> {
        let recording = open(path)?;
        let other = recording.header();
        if other.tree.hash != header.tree.hash || other.messages() != header.messages() {
            let what = format!("`{}` is a recording of another tree", path.display());
            return Err(Invalid::new(what, "compare recordings of one tree"));
        }
        Ok(Self { path, recording })
    }
}

impl Run for Other<'_> {
    fn next(&mut self, _recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Invalid> {
        self.recording.next_cycle().map_err(|error| error.of(self.path))
    }

    fn program(&self) -> Option<Program> {
        Some(self.recording.header().program.clone())
    }

    fn goes_on(&mut self) -> Result<bool, Invalid> {
        Ok(self.next(&RecordedCycle::default())?.is_some())
    }
}

/// Who runs the jobs of a robot that runs again.
pub(super) enum RepeatedJobs<R> {
    /// Results arrive in the recorded cycles.
    Recorded(HeldJobs<R>),
    /// They arrive when they are due.
    Due(Workers<R>),
}

impl<R: Tree> Jobs<R> for RepeatedJobs<R> {
    fn deliver(&mut self, now: Instant, tree: &R) {
        match self {
            Self::Recorded(held) => held.deliver(now, tree),
            Self::Due(workers) => workers.deliver(now, tree),
        }
    }

    fn collect(&mut self, tree: &R) {
        match self {
            Self::Recorded(held) => held.collect(tree),
            Self::Due(workers) => workers.collect(tree),
        }
    }
}

/// Robot that runs again on recorded cycles, with an observer.
pub(super) struct Again<R: Robot, O> {
    pub(super) runner: Runner<Box<R>, (), (), O, RepeatedJobs<R>>,
    world: Option<Box<dyn RepeatedWorld<R>>>,
}

impl<R, O> Again<R, O>
where
    R: Recordable,
    <R as Robot>::Error: Display,
    O: Observer<R>,
{
    /// In a run that is expected to differ, as one with other parameters, the results of jobs arrive when they are due; in others as in
    /// the recorded run.
    pub(super) fn new(subject: Subject<R>, observer: O, differs: bool) -> Self {
        let jobs = if differs {
            RepeatedJobs::Due(Workers::new(1, Pace::Simulated))
        } else {
            RepeatedJobs::Recorded(HeldJobs::new())
        };
        Self { runner: Runner::new(subject.robot, ()).with_observer(observer).with_jobs(jobs), world: subject.world }
    }

    fn now(&self, recorded: &RecordedCycle) -> Instant {
        self.world.as_ref().map_or(Instant::from_ticks(recorded.tick.instant), World::now)
    }

    /// Applies a request of the recorded run. Without a repeated world, actions of the world are ignored: the stored sensor
    /// values already show their effects.
    ///
    /// # Errors
    /// The refusal of a change by the world. A refusal by the tree is a difference of the run.
    pub(super) fn request(&mut self, recorded: &RecordedCycle, request: &RequestRecord) -> Result<(), Refusal> {
        match request {
            RequestRecord::World { name, values } => {
                let Some(world) = &mut self.world else { return Ok(()) };
                perform(world.actions(), name.as_str(), values)
            }
            RequestRecord::Tree(request) => {
                // The observer receives the refusal.
                let _ = self.runner.request(self.now(recorded), request.borrow());
                Ok(())
            }
            RequestRecord::Ended { component, .. } => {
                // The observer receives the end.
                if let (RepeatedJobs::Recorded(held), robot) = self.runner.jobs_mut() {
                    held.end(robot, *component);
                }
                Ok(())
            }
        }
    }

    /// Runs one cycle on recorded sensor values, or on those of the world.
    pub(super) fn cycle(&mut self, recorded: &RecordedCycle) -> Result<(), Invalid> {
        let now = self.now(recorded);
        let sensed = if let Some(world) = &mut self.world {
            self.runner.sense(now, &world.sensors())
        } else {
            let (message, blobs) = (recorded.sensors.as_deref().unwrap_or_default(), recorded.blob_bytes());
            let sensors = R::decode_sensors(message, &blobs).ok_or_else(|| {
                let what = format!("cycle {} has no sensor values that can be read", recorded.tick.cycle);
                Invalid::new(what, "the file is damaged: replay it up to there with --until")
            })?;
            self.runner.sense(now, &sensors)
        };
        match sensed {
            // A robot may refuse values whose large data was dropped while recording.
            Err(error) if !recorded.is_gap() => {
                let what = format!("the robot refuses the sensor values of cycle {}: {error}", recorded.tick.cycle);
                return Err(Invalid::new(what, "record with a program that accepts them"));
            }
            _ => {}
        }
        let command = self.runner.think(now);
        if let Some(world) = &mut self.world {
            world.act(&command);
        }
        Ok(())
    }

    /// Returns the events of the last cycle: those of the world, or the recorded ones.
    pub(super) fn events(&mut self, recorded: &RecordedCycle) -> Vec<RunEvent> {
        self.world.as_mut().map_or_else(|| recorded.events.clone(), |world| world.take_events())
    }
}

/// The repeated run of the robot of this program.
pub(super) struct Repeated<R: Robot> {
    again: Again<R, Taken>,
    fingerprint: RunningFingerprint,
    cycle: u64,
}

impl<R> Repeated<R>
where
    R: Recordable,
    <R as Robot>::Error: Display,
{
    pub(super) fn new(subject: Subject<R>, differs: bool) -> Self {
        let again = Again::new(subject, Taken::default(), differs);
        Self { again, fingerprint: RunningFingerprint::default(), cycle: 0 }
    }
}

impl<R> Run for Repeated<R>
where
    R: Recordable,
    <R as Robot>::Error: Display,
{
    fn next(&mut self, recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Invalid> {
        if self.cycle == 0 && recorded.tick.cycle > 0 {
            let what = format!("the recording begins with cycle {}", recorded.tick.cycle);
            return Err(Invalid::new(what, "a replay needs the start of the run: give the file that was trimmed"));
        }
        let mut requests = Vec::with_capacity(recorded.requests.len());
        for request in &recorded.requests {
            let refused = self.again.request(recorded, request).is_err();
            // A change that the repeated world refuses is a difference; ends of jobs follow.
            if refused || matches!(request, RequestRecord::Ended { .. }) {
                continue;
            }
            self.fingerprint.add_request(request);
            requests.push(request.clone());
        }
        self.again.cycle(recorded)?;
        let mut repeated = std::mem::take(&mut self.again.runner.observer_mut().0);
        for ended in std::mem::take(&mut repeated.requests) {
            self.fingerprint.add_request(&ended);
            requests.push(ended);
        }
        if recorded.is_gap() {
            // The recorded run had the data, but the file does not contain it.
            repeated.tick.blobs = recorded.tick.blobs;
            repeated.tick.sensors = recorded.tick.sensors;
            repeated.sensors.clone_from(&recorded.sensors);
        }
        repeated.tick.cycle = self.cycle;
        repeated.requests = requests;
        repeated.tick.fingerprint = self.fingerprint.add_tick(&repeated.tick);
        self.cycle += 1;
        Ok(Some(repeated))
    }
}

/// Observer that keeps the cycle as it would have been recorded.
#[derive(Default)]
struct Taken(RecordedCycle);

impl Probe for Taken {
    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {
        self.0.requests.push(RequestRecord::Ended { component, end });
    }
}

impl<R: Recordable> Observer<R> for Taken {
    fn sensing(&mut self, _now: Instant, sensors: &R::Sensors<'_>) {
        let mut hash = Hasher::new();
        let message = R::encode_sensors(sensors, Vec::new(), |_, bytes| hash.update(bytes)).unwrap_or_default();
        self.0.tick.sensors = crc32fast::hash(&message);
        self.0.tick.blobs = hash.finalize();
        self.0.sensors = Some(message);
    }

    fn acted(&mut self, cycle: &Cycle<'_, R>) {
        let command = R::encode_command(cycle.command, Vec::new()).unwrap_or_default();
        self.0.tick.instant = cycle.now.as_ticks();
        self.0.tick.command = crc32fast::hash(&command);
        self.0.tree = tree_record(cycle.robot);
        self.0.tick.tree = self.0.tree.digest();
        self.0.command = Some(command);
    }
}
