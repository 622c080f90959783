//! A folder of images as a session: for the colour tuner.

use std::sync::Arc;
use std::thread;

use bica_evaluation::frame_io::{RecordedFrame, list};
use bica_link::Description;

use super::commands::Commands;
use super::history::StoredImage;
use super::session::Session;
use crate::options::Options;
use crate::pages::Pages;
use crate::protocol::{Capabilities, Connection, Failed, SessionId, SessionKind};

/// Time from one image to the next, µs.
const PERIOD_US: u64 = 1_000_000;

/// Opens the folder of labelled images. Images are read in the background.
pub(super) fn open(id: SessionId, options: &Arc<Options>, pages: &Arc<Pages>) -> Result<Arc<Session>, Failed> {
    let none = || Failed::new("there are no labelled images", "start the program with --images DIR");
    let folder = options.images.clone().ok_or_else(none)?;
    let files = list(&folder)?;
    // Nobody receives commands: a session of images cannot be operated.
    let commands = Commands::of_nobody();
    let identity = (id, SessionKind::Recording, folder.display().to_string());
    let session = Arc::new(Session::new(identity, Arc::clone(options), Arc::clone(pages), commands, None));
    let own = Arc::clone(&session);
    let work = move || {
        own.describe(Description::default(), Capabilities { images: true, ..Capabilities::default() });
        let mut skipped = Vec::new();
        for (number, file) in files.iter().enumerate() {
            match RecordedFrame::read(file) {
                Ok(frame) => add(&own, number as u32, &frame),
                Err(why) => skipped.push(format!("{}: {why}", file.display())),
            }
            if number % 16 == 0 {
                own.set_connection(Connection::Connecting, format!("{} of {} images read", number, files.len()));
            }
        }
        own.set_connection(Connection::Connected, skipped.join("; "));
    };
    let started = thread::Builder::new().name("images".to_owned()).spawn(work);
    started.map_err(|error| Failed::new(error.to_string(), "close other programs"))?;
    Ok(session)
}

fn add(session: &Session, number: u32, frame: &RecordedFrame) {
    let image = frame.image();
    let time_us = u64::from(number) * PERIOD_US;
    let mut shared = session.shared();
    shared.history.states.push(time_us, number.into(), std::iter::empty());
    shared.history.images.push(StoredImage {
        number,
        time_us,
        bottom_camera: false,
        width: image.width,
        height: image.height,
        yuyv: image.yuyv.into(),
    });
}
