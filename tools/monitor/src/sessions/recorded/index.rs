//! One pass through a recording: states, outputs, log, places of images.

use std::fs::{self, File};
use std::io::BufReader;
use std::path::Path;

use bica::Hold;
use bica::runner::OwnedRequest;
use bica_link::Description;
use bica_recording::{Ending, Error, Header, HoldsRecord, Recording, RequestRecord};
use bica_wire::message::ComponentState;

use crate::files;
use crate::files::failed;
use crate::protocol::{Capabilities, Connection, Failed};
use crate::sessions::history::Told;
use crate::sessions::scenery::scenery;
use crate::sessions::session::Session;

/// Note of a recording that a monitor made.
const OF_MONITOR: &str = "a monitor recorded what the robot sent: it can be looked at, not run again or compared";
/// Number of cycles that are added to the history under one lock.
const BATCH: usize = 256;
/// Largest number of changes and of images in memory: the rest of a longer recording is not shown.
const MAX_CHANGES: usize = 2_000_000;
/// Largest number of cycles that are shown: more than a day.
const MAX_CYCLES: usize = 10_000_000;
/// Largest number of components of a recording that is shown.
const MAX_COMPONENTS: usize = 1024;

type FileRecording = Recording<BufReader<File>>;

/// Opens a recording and reads its header.
pub(super) fn open(path: &Path) -> Result<FileRecording, Failed> {
    let file = files::open(path).map_err(|error| failed("open", path, &error, "choose a recording of the list"))?;
    let failed = |error: Error| failed("open", path, &error, error.help());
    let recording = FileRecording::new(BufReader::with_capacity(1 << 16, file)).map_err(failed)?.without_blobs();
    describe(recording.header())?;
    Ok(recording)
}

/// Returns the description, if it is not too large and its indices are valid.
fn describe(header: &Header) -> Result<Description, Failed> {
    let count = header.tree.components.len();
    if count == 0 || count > MAX_COMPONENTS {
        let what = format!("the recording has {count} components");
        return Err(Failed::new(what, format!("only trees of 1 to {MAX_COMPONENTS} components are shown")));
    }
    Ok(header.tree.clone())
}

/// Holds and rates, as changed by requests, and the times of the cycles.
struct Requested {
    holds: Vec<Hold>,
    rates: Vec<Option<f32>>,
    times: Times,
}

/// Times since the first cycle. They never decrease, because a history finds them by their order.
#[derive(Default)]
struct Times {
    /// Time of the first cycle, ns since the start of the run's clock.
    first: Option<u64>,
    /// Time of the last cycle, µs.
    last: u64,
}

impl Times {
    /// Returns the time of a cycle, µs.
    fn next(&mut self, ns: u64) -> u64 {
        let time_us = ns.saturating_sub(*self.first.get_or_insert(ns)) / 1000;
        self.last = self.last.max(time_us);
        self.last
    }
}

impl Requested {
    /// Takes over the holds and rates of a recording that a monitor made.
    fn replace(&mut self, record: &HoldsRecord) {
        let all = self.holds.iter_mut().zip(&mut self.rates);
        let recorded = record.holds.iter().copied().zip(record.rates.iter().copied());
        all.zip(recorded).for_each(|((held, rate), now)| (*held, *rate) = now);
    }

    fn apply(&mut self, request: &RequestRecord) {
        match *request {
            RequestRecord::Tree(OwnedRequest::Hold { component, hold }) => {
                if let Some(held) = self.holds.get_mut(component.index()) {
                    *held = hold;
                }
            }
            RequestRecord::Tree(OwnedRequest::Rate { component, hz }) => {
                if let Some(rate) = self.rates.get_mut(component.index()) {
                    *rate = hz;
                }
            }
            _ => {}
        }
    }
}

/// Reads a recording into a session.
pub(super) fn read(session: &Session, mut recording: FileRecording) {
    let header = recording.header().clone();
    let description = match describe(&header) {
        Ok(description) => description,
        Err(failed) => return session.set_connection(Connection::Ended, failed.text),
    };
    let is_own = session.program.rerun.is_some() && session.program.has_tree(&description.hash);
    let can = Capabilities { images: true, run_again: is_own && header.monitor.is_none(), ..Capabilities::default() };
    let mut requested = Requested {
        holds: vec![Hold::Tree; description.components.len()],
        rates: description.components.iter().map(|component| component.hz).collect(),
        times: Times::default(),
    };
    session.describe(description, can);
    session.show_scenery(&scenery(&header));
    let length = fs::metadata(&session.shared().recorded.path).map_or(0, |file| file.len()).max(1);
    let note = loop {
        if session.is_closed() {
            return;
        }
        match batch(session, &mut recording, &header, &mut requested) {
            Ok(true) => {}
            Ok(false) => {
                let time_us = session.shared().history.span().1;
                for told in Told::of_cycle(recording.rest().clone(), time_us) {
                    session.shared().history.told.push(time_us, told);
                }
                let result = recording.ending().map(Ending::text);
                session.shared().result = result.unwrap_or_default();
                break header.monitor.as_ref().map_or_else(String::new, |monitor| {
                    format!("{OF_MONITOR}; it lacks {}", monitor.lacks.join(", "))
                });
            }
            Err(note) => break note,
        }
        let percent = 100 * recording.position() / length;
        session.set_connection(Connection::Connecting, format!("{percent} % read"));
    };
    let has_images = !session.shared().recorded.places.is_empty();
    session.shared().can.images = has_images;
    session.set_connection(Connection::Connected, note);
    session.announce();
    session.show_update(Vec::new());
}

/// Reads a batch of cycles; returns whether there are more. The error is the reason why not all cycles can be shown.
fn batch(
    session: &Session,
    recording: &mut FileRecording,
    header: &Header,
    requested: &mut Requested,
) -> Result<bool, String> {
    let mut cycles = Vec::with_capacity(BATCH);
    let mut ended = Ok(true);
    while cycles.len() < BATCH {
        match recording.next_cycle() {
            Ok(Some(cycle)) => {
                let image = recording.blob_places().iter().find(|place| place.is_image);
                cycles.push((cycle, image.copied()));
            }
            Ok(None) => {
                ended = Ok(false);
                break;
            }
            Err(error) => {
                ended = Err(format!("{error}; what comes before it is shown"));
                break;
            }
        }
    }
    let mut shared = session.shared();
    for (cycle, place) in cycles {
        let time_us = requested.times.next(header.nanoseconds(cycle.tick.instant));
        cycle.requests.iter().for_each(|request| requested.apply(request));
        if let Some(holds) = &cycle.holds {
            requested.replace(holds);
        }
        let components = requested.holds.iter().zip(&requested.rates).enumerate();
        let states = components.map(|(index, (&held, &hz))| {
            let state = cycle.tree.state(index).map(|state| state as u16);
            ComponentState { active: cycle.tree.is_active(index), held, state, hz }
        });
        shared.history.states.push(time_us, cycle.tick.cycle, states);
        if let Some(place) = place {
            shared.images_taken += 1;
            let number = place.id.wrapping_sub(1);
            let of_place = place.time.saturating_sub(requested.times.first.unwrap_or_default()) / 1000;
            shared.recorded.places.push((number, of_place, place));
        }
        for value in cycle.outputs.iter().flat_map(|record| &record.values) {
            let (component, index) = (usize::from(value.component), usize::from(value.index));
            shared.history.outputs.push(component, index, time_us, &value.value);
        }
        for told in Told::of_cycle(cycle, time_us) {
            shared.history.told.push(time_us, told);
        }
        let (all, changes) = shared.history.states.sizes();
        if changes > MAX_CHANGES || all > MAX_CYCLES || shared.recorded.places.len() > MAX_CHANGES {
            return Err("the recording is too long: its beginning is shown".to_owned());
        }
    }
    shared.history.evict();
    ended
}
