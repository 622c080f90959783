//! One robot of a match.

use bica::Instant;
use bica::runner::{Requests, Runner};
use bica_app::{Failure, RecordedFile};
use bica_link::LinkObserver;
use bica_motion::robot::{Command, Sensors};
use bica_player::referee::{TeamCommand, TeamForward, TeamSensors};
use bica_recording::Recorder;
use bica_sim::match_field::{MatchField, MatchWorld};
use bica_sim::show_truth;

use super::links::PlayerLink;
use super::recording::RobotRecording;
use crate::referee::network::PlayerNetwork;

/// What carries packets and messages between a robot and the others.
pub(super) trait Network: Send {
    /// Adds what has arrived until `now`, µs, to the sensor values of a body.
    #[expect(clippy::large_types_passed_by_value, reason = "it becomes a part of the returned value")]
    fn sensors<'a>(&mut self, now: u64, body: Sensors<'a>) -> TeamSensors<'a>;

    /// Sends what a command has for the network.
    fn send(&mut self, command: &TeamCommand);
}

impl Network for PlayerNetwork {
    fn sensors<'a>(&mut self, now: u64, body: Sensors<'a>) -> TeamSensors<'a> {
        self.sensors(now, body)
    }

    fn send(&mut self, command: &TeamCommand) {
        self.send(command);
    }
}

/// Observers of a robot, if it is served and recorded.
type Observers = (Option<LinkObserver<TeamForward>>, Option<Recorder>);

/// A robot with its network.
pub(super) struct Player<N> {
    runner: Runner<Box<TeamForward>, (), (), Observers>,
    link: Option<PlayerLink>,
    file: Option<RecordedFile>,
    pub(super) network: N,
}

impl<N: Network> Player<N> {
    /// Creates a robot at its start, which may be recorded.
    pub(super) fn new(forward: Box<TeamForward>, network: N, recording: Option<RobotRecording>) -> Self {
        let (file, recorder) = recording.unzip();
        Self { runner: Runner::new(forward, ()).with_observer((None, recorder)), link: None, file, network }
    }

    /// Serves the robot to monitors.
    pub(super) fn serve(&mut self, (link, view): (PlayerLink, LinkObserver<TeamForward>)) {
        (self.link, self.runner.observer_mut().0) = (Some(link), Some(view));
    }

    /// Applies what monitors request of the robot, or of its world.
    pub(super) fn apply_requests(&mut self, now: Instant, field: &mut MatchField, robot: usize) {
        let Some(PlayerLink { requests, .. }) = &mut self.link else { return };
        while let Some(request) = requests.next(now) {
            let result = field.operate(robot, |world| self.runner.request_in(now, Some(world), request));
            requests.answered(now, result);
        }
    }

    /// Shows monitors the true state of the robot's world.
    pub(super) fn show_truth(&self, world: &dyn MatchWorld) {
        if let (Some(view), _) = self.runner.observer() {
            view.show_scene(|scene| show_truth(world.referee(), scene));
        }
    }

    /// Tells monitors an event of the match.
    pub(super) fn tell(&self, kind: &str, detail: &str) {
        if let Some(PlayerLink { server, .. }) = &self.link {
            server.event(kind, detail);
        }
    }

    /// Tree of the robot.
    pub(super) fn forward(&self) -> &TeamForward {
        self.runner.robot()
    }

    /// Plays a cycle.
    pub(super) fn play(&mut self, now: Instant, world: &mut dyn MatchWorld) -> Result<Command, Failure> {
        let sensors = self.network.sensors(now.as_micros(), world.sensors());
        let taken = self.runner.sense(now, &sensors);
        taken.map_err(|error| Failure::new(error.to_string(), "give a smaller --size"))?;
        let command = self.runner.think(now);
        self.network.send(&command);
        Ok(command.body)
    }

    /// Returns why the recording ended before the match; only once.
    pub(super) fn recording_ended(&self) -> Option<String> {
        self.file.as_ref().and_then(RecordedFile::newly_ended)
    }

    /// Closes the recording; returns a line of text about it.
    pub(super) fn close(&mut self) -> Option<String> {
        let recorder = self.runner.observer_mut().1.take();
        self.file.take().zip(recorder).map(|(file, recorder)| file.describe(&recorder.finish("end of the match")))
    }
}
