//! A new recording of a run that is repeated with other parameters.

use std::fmt::Display;
use std::path::Path;

use bica::runner::Robot;
use bica_wire::Recordable;
use bica_wire::message::LogSource;

use super::run::Again;
use super::{Subject, check_start, open, subject};
use crate::error::Error;
use crate::header::{Header, ImagePolicy};
use crate::message::LogLine;
use crate::program::{Program, Start};
use crate::recorder::{Backpressure, Recorder, RecorderOptions, Report, create};
use crate::request::RequestRecord;
use bica_wire::model::Invalid;

/// Remedy if the new recording cannot be written.
const NO_ROOM: &str = "make room on the disk, or name a file on another one";

/// Runs the code again on a recording, and writes the new course to a recording with sensor values. `subject` is as for
/// [`replay`](super::replay). `progress` is called every 100 cycles with the time of the last cycle since the first one, s; if it
/// returns false, the run ends there.
///
/// # Errors
/// If a file cannot be read or written to its end, or the recording cannot be replayed by this program.
pub fn rerun<R>(
    path: &Path,
    out: &Path,
    subject: impl FnOnce(&Header, bool) -> Result<Subject<R>, Invalid>,
    mut progress: impl FnMut(f64) -> bool,
) -> Result<Report, Invalid>
where
    R: Recordable,
    <R as Robot>::Error: Display,
{
    let mut recording = open(path)?;
    let header = recording.header().clone();
    check_start(path, &header)?;
    let subject = subject::checked(&header, header.images == ImagePolicy::None, subject)?;
    let new = Header {
        program: Program::of(&R::GRAPH),
        start: Start::now(),
        images: ImagePolicy::All,
        part: None,
        ..header.clone()
    }
    .of_robot(&*subject.robot);
    let (mut again, mut first) = (Again::new(subject, start(out, &new)?, true), None);
    loop {
        let recorded = match recording.next_cycle() {
            Ok(Some(recorded)) => recorded,
            Ok(None) | Err(Error::CutOff { .. } | Error::Damaged { .. }) => break,
            Err(error) => return Err(error.of(path)),
        };
        let instant = recorded.tick.instant;
        let t = header.seconds_since(*first.get_or_insert(instant), instant);
        if recorded.tick.cycle.is_multiple_of(100) && !progress(t) {
            break;
        }
        for request in &recorded.requests {
            let result = again.request(&recorded, request);
            let recorder = again.runner.observer_mut();
            match (result, request) {
                (Ok(()), RequestRecord::World { .. }) => recorder.add_request(request.clone()),
                (Ok(()), _) => {}
                (Err(error), _) => {
                    recorder.log(LogLine {
                        level: 3,
                        source: LogSource::Operator,
                        text: format!("request refused: {error}"),
                    });
                }
            }
        }
        again.cycle(&recorded)?;
        for event in again.events(&recorded) {
            again.runner.observer().event(event);
        }
    }
    let (_, (), (), recorder) = again.runner.into_parts();
    let report = recorder.finish("run again");
    let Some(reason) = &report.reason else { return Ok(report) };
    Err(Invalid::new(format!("`{}` ends after {} cycles: {reason}", out.display(), report.cycles), NO_ROOM))
}

fn start(out: &Path, header: &Header) -> Result<Recorder, Invalid> {
    let failed = |error| {
        let what = format!("cannot write `{}`: {error}", out.display());
        Invalid::new(what, NO_ROOM)
    };
    let file = create(out, true).map_err(failed)?;
    // The run has no clock, so the loop can wait for the disk.
    let options = RecorderOptions { backpressure: Backpressure::Wait, ..RecorderOptions::default() };
    // The report has the reason of an early end.
    Recorder::start(file, header, options, |_| {}).map_err(failed)
}
