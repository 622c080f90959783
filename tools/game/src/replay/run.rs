//! The runs that a recording is compared with.

use std::path::Path;

use bica::runner::{Cycle, Observer, OwnedRequest, RequestQueue, Robot, Runner};
use bica::{Instant, Probe};
use bica_console::Failure;
use bica_motion::robot::{self, CameraId};
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_recording::{
    Header, RecordedCycle, RequestRecord, RunningFingerprint, command_digest, image_digest, sensors_digest, tree_record,
};
use bica_wire::message::{Command as CommandMessage, Sensors as SensorsMessage};

use super::set_up::{layers, set_up};
use super::world::ReplayWorld;
use super::{FileRecording, failure, open};

/// Returns whether a cycle had an image that was dropped while recording.
pub(super) fn is_gap(recorded: &RecordedCycle) -> bool {
    recorded.sensors.is_some_and(|sensors| sensors.image.is_some()) && recorded.image.is_none()
}

/// The run that a recording is compared with.
pub(super) trait Run {
    /// Returns the cycle that corresponds to a recorded one; none after the last.
    fn next(&mut self, recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Failure>;

    /// Returns whether there are cycles beyond those of the recording.
    fn goes_on(&mut self) -> Result<bool, Failure> {
        Ok(false)
    }
}

/// Another recording.
pub(super) struct Other<'a> {
    path: &'a Path,
    recording: FileRecording,
}

impl<'a> Other<'a> {
    pub(super) fn open(path: &'a Path, header: &Header) -> Result<Self, Failure> {
        let recording = open(path)?;
        if recording.header().tree.components != header.tree.components {
            let what = format!("`{}` is a recording of another tree", path.display());
            return Err(Failure::new(what, "compare recordings of one tree"));
        }
        Ok(Self { path, recording })
    }
}

impl Run for Other<'_> {
    fn next(&mut self, _recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Failure> {
        self.recording.next_cycle().map_err(|error| failure(self.path, &error))
    }

    fn goes_on(&mut self) -> Result<bool, Failure> {
        Ok(self.next(&RecordedCycle::default())?.is_some())
    }
}

/// The forward of this program.
pub(super) struct Repeated {
    runner: Runner<Box<Forward>, ReplayWorld, RequestQueue, Taken>,
    fingerprint: RunningFingerprint,
    cycle: u64,
}

impl Repeated {
    pub(super) fn new(header: &Header, set: &[String], closed_loop: bool) -> Result<Self, Failure> {
        let (world, profile, attacks) = set_up(header, closed_loop)?;
        let mut robot = Box::new(Forward::new());
        bica::Tree::get_mut::<RobotProfile>(&mut *robot).set(profile);
        bica::Tree::get_mut::<GoalDetector>(&mut *robot).attack(attacks);
        layers(header, set)?.apply(&mut *robot)?;
        let runner = Runner::new(robot, world).with_requests(RequestQueue::new()).with_observer(Taken::default());
        Ok(Self { runner, fingerprint: RunningFingerprint::default(), cycle: 0 })
    }
}

impl Run for Repeated {
    fn next(&mut self, recorded: &RecordedCycle) -> Result<Option<RecordedCycle>, Failure> {
        if self.cycle == 0 && recorded.tick.cycle > 0 {
            let what = format!("the recording begins with cycle {}", recorded.tick.cycle);
            return Err(Failure::new(what, "a replay needs the start of the run: give the file that was trimmed"));
        }
        let mut requests = Vec::with_capacity(recorded.requests.len());
        for request in &recorded.requests {
            match *request {
                // A placement that the repeated world refuses is a difference.
                RequestRecord::Ball { x, y } if self.runner.world_mut().place_ball([x, y]).is_err() => continue,
                RequestRecord::Ball { .. } => {}
                _ => self.runner.requests_mut().push(request_of(request)?),
            }
            self.fingerprint.add_request(request);
            requests.push(request.clone());
        }
        if let ReplayWorld::Stored(cycle) = self.runner.world_mut() {
            (**cycle).clone_from(recorded);
        }
        self.runner.cycle().map_err(|error| Failure::new(error.to_string(), "record with a smaller --size"))?;
        let mut repeated = std::mem::take(&mut self.runner.observer_mut().0);
        if is_gap(recorded) {
            // The image was there, but is not in the file.
            repeated.tick.image = recorded.tick.image;
            let image = recorded.sensors.and_then(|sensors| sensors.image);
            repeated.sensors = repeated.sensors.map(|sensors| SensorsMessage { image, ..sensors });
        }
        repeated.tick.cycle = self.cycle;
        repeated.requests = requests;
        repeated.tick.fingerprint = self.fingerprint.add_tick(&repeated.tick);
        self.cycle += 1;
        Ok(Some(repeated))
    }
}

pub(super) fn request_of(request: &RequestRecord) -> Result<OwnedRequest, Failure> {
    request.to_request().ok_or_else(|| {
        let what = format!("the recording has a request that this program does not know: {request:?}");
        Failure::new(what, "replay it with the program that recorded it")
    })
}

/// Observer that keeps the cycle as it would have been recorded.
#[derive(Default)]
struct Taken(RecordedCycle);

impl Probe for Taken {}

impl Observer<Forward> for Taken {
    fn sensing(&mut self, now: Instant, sensors: &<Forward as Robot>::Sensors<'_>) {
        let message = SensorsMessage::new(now.as_micros(), sensors, 0);
        self.0.tick.sensors = sensors_digest(&message);
        self.0.tick.image = sensors.image.map_or(0, |robot::Image { camera, width, height, yuyv }| {
            image_digest(camera == CameraId::Bottom, width, height, yuyv)
        });
        self.0.sensors = Some(message);
    }

    fn acted(&mut self, cycle: &Cycle<'_, Forward>) {
        let command = CommandMessage::new(cycle.now.as_micros(), cycle.command);
        self.0.tick.instant = cycle.now.as_ticks();
        self.0.tick.command = command_digest(&command);
        self.0.tree = tree_record(cycle.robot);
        self.0.tick.tree = self.0.tree.digest();
        self.0.command = Some(command);
    }
}
