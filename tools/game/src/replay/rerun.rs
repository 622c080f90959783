//! A new recording of a run that is repeated with other parameters.

use std::path::Path;

use bica::runner::{RequestQueue, Runner};
use bica_console::{Failure, interrupt};
use bica_player::input::RobotProfile;
use bica_player::perception::GoalDetector;
use bica_player::tunable::Forward;
use bica_recording::{
    Backpressure, Error, FORMAT, Header, ImagePolicy, LogLine, Program, Recorder, RecorderOptions, RefereeEvent,
    Report, RequestRecord, Start, create,
};

use super::run::request_of;
use super::set_up::{check_tree, layers, set_up};
use super::world::ReplayWorld;
use super::{failure, open};
use crate::event::EventRecord;

/// Runs the code again on a recording, with other parameters, and writes the new course to a recording with images.
/// `progress` is called now and then with the time of the last cycle, s; if it returns false, the run ends there.
///
/// # Errors
/// If a file cannot be read or written, or the recording cannot be replayed by this program.
pub fn rerun(
    path: &Path,
    set: &[String],
    out: &Path,
    mut progress: impl FnMut(f64) -> bool,
) -> Result<Report, Failure> {
    let mut recording = open(path)?;
    let header = recording.header().clone();
    check_tree(&header)?;
    let (world, profile, attacks) = set_up(&header, false)?;
    let mut robot = Box::new(Forward::new());
    bica::Tree::get_mut::<RobotProfile>(&mut *robot).set(profile);
    bica::Tree::get_mut::<GoalDetector>(&mut *robot).attack(attacks);
    layers(&header, set)?.apply(&mut *robot)?;
    let new = Header {
        format: FORMAT,
        program: Program::current(),
        start: Some(Start::now()),
        images: ImagePolicy::All,
        ..header.clone()
    }
    .of_tree(&*robot);
    let recorder = start(out, &new)?;
    let mut runner = Runner::new(robot, world).with_requests(RequestQueue::new()).with_observer(recorder);
    let mut events = 0;
    loop {
        let recorded = match recording.next_cycle() {
            Ok(Some(recorded)) => recorded,
            Ok(None) | Err(Error::CutOff { .. } | Error::Damaged { .. }) => break,
            Err(error) => return Err(failure(path, &error)),
        };
        let t = header.nanoseconds(recorded.tick.instant) as f64 * 1e-9;
        if interrupt::requested() || (recorded.tick.cycle.is_multiple_of(100) && !progress(t)) {
            break;
        }
        for request in &recorded.requests {
            let RequestRecord::Ball { x, y } = *request else {
                runner.requests_mut().push(request_of(request)?);
                continue;
            };
            match runner.world_mut().place_ball([x, y]) {
                Ok(()) => runner.observer_mut().ball_placed([x, y]),
                Err(error) => runner.observer().log(LogLine { level: 3, text: format!("request refused: {error}") }),
            }
        }
        if let ReplayWorld::Stored(cycle) = runner.world_mut() {
            (**cycle).clone_from(&recorded);
        }
        runner.cycle().map_err(|error| Failure::new(error.to_string(), "record with a smaller --size"))?;
        let new: Vec<RefereeEvent> = match runner.world_mut() {
            ReplayWorld::Stored(cycle) => cycle.events.clone(),
            ReplayWorld::Simulated(world) => world.referee().events()[events..].iter().map(event).collect(),
        };
        events += new.len();
        for event in new {
            runner.observer().event(event);
        }
    }
    let (_, _, _, recorder) = runner.into_parts();
    Ok(recorder.finish("run again"))
}

fn event(event: &bica_sim::referee::TimedEvent) -> RefereeEvent {
    let EventRecord { event: kind, detail, .. } = EventRecord::from(event);
    RefereeEvent { at_ns: event.at.as_nanos() as u64, kind: kind.to_owned(), detail }
}

fn start(out: &Path, header: &Header) -> Result<Recorder, Failure> {
    let help = "name a file that can be made, on a disk with room";
    let file = create(out, true).map_err(|error| Failure::of_path("write", out, &error, help))?;
    // Without a clock nothing has to be lost.
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..RecorderOptions::default() };
    // The reason of an early end is in the report.
    Recorder::start(file, header, options, |_| {}).map_err(|error| Failure::of_path("write", out, &error, help))
}
