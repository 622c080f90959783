//! The history of a robot's session as a file.

use std::fs::{self, File};
use std::io;
use std::path::Path;
use std::sync::Arc;

use bica_recording::{Header, MonitorRecorder, RecordedCycle, Report, create};
use serde_json::{Value, json};

use super::robot_recording::write_image;
use super::scenery::recorded_scenery;
use super::session::Session;
use crate::files::{WRITE_HELP, failed, make_folder_of};
use crate::protocol::Failed;

/// Number of cycles that are copied from the history under one lock.
const BATCH: usize = 256;

/// Writes the history of a robot's session to a new file. An incomplete file is removed.
pub(super) fn keep(session: &Arc<Session>, target: &Path) -> Result<Value, Failed> {
    make_folder_of(target)?;
    let scenery = recorded_scenery(&session.shared().scenery);
    let offers = session.shared().offers;
    let header = Header { scenery, ..Header::of_monitor(&session.name, &*session.description()?, offers) };
    let file = create(target, false).map_err(|error| failed("write", target, &error, WRITE_HELP))?;
    let reason = match MonitorRecorder::new(file, &header).and_then(|recorder| write(session, recorder)) {
        Ok(Report { reason: None, cycles: 0, .. }) => {
            let _ = fs::remove_file(target);
            return Err(Failed::new("nothing was received of this session yet", "wait until it is connected"));
        }
        Ok(Report { reason: None, cycles, .. }) => {
            return Ok(json!({ "path": target.display().to_string(), "cycles": cycles }));
        }
        Ok(Report { reason: Some(reason), .. }) => reason,
        Err(error) => error.to_string(),
    };
    // A failed removal is ignored: the user needs the error of the write.
    let _ = fs::remove_file(target);
    Err(failed("write", target, &reason, WRITE_HELP))
}

fn write(session: &Session, mut recorder: MonitorRecorder<File>) -> io::Result<Report> {
    let (epoch, until_us) = {
        let shared = session.shared();
        (shared.epoch, shared.history.span().1)
    };
    let mut after_us = None;
    loop {
        let part = {
            let shared = session.shared();
            // In another epoch the history is that of another run.
            if shared.epoch == epoch { shared.history.part(after_us, until_us, BATCH) } else { Vec::new() }
        };
        let Some(last) = part.last() else { return Ok(recorder.finish(None, 0)) };
        after_us = Some(last.time_us);
        for part in part {
            part.images.iter().try_for_each(|image| write_image(&mut recorder, image))?;
            let states = part.states.iter().map(|now| now.state);
            let mut cycle = RecordedCycle::received(part.cycle, part.time_us, states);
            for (component, output, value) in &part.outputs {
                cycle.add_output(*component, *output, Some(value));
            }
            part.told.into_iter().for_each(|told| told.record(&mut cycle));
            recorder.cycle(&cycle)?;
        }
    }
}
