//! Files of images as a session.

use std::sync::Arc;
use std::thread;

use bica_link::Description;

use super::commands::Commands;
use super::common::Common;
use super::session::Session;
use crate::program::Image;
use crate::protocol::{Capabilities, Connection, Failed, SessionId, SessionKind};

/// Time from one image to the next, µs.
const PERIOD_US: u64 = 1_000_000;

/// Opens the images of the program. They are read in the background.
pub(super) fn open(id: SessionId, common: &Common) -> Result<Arc<Session>, Failed> {
    let none = || Failed::new("the program has no images", "start it with a folder of images");
    let images = common.program.images.as_ref().ok_or_else(none)?;
    let files = images.list()?;
    // Commands have no receiver: a session of images cannot be operated.
    let identity = (id, SessionKind::Recording, images.name());
    let session = Arc::new(Session::new(identity, common.clone(), Commands::of_nobody(), None));
    let own = Arc::clone(&session);
    let work = move || {
        own.describe(Description::default(), Capabilities { images: true, ..Capabilities::default() });
        let mut skipped = Vec::new();
        for (number, file) in files.iter().enumerate() {
            let Some(images) = &own.program.images else { return };
            match images.read(file) {
                Ok(image) => add(&own, number as u32, image),
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

fn add(session: &Session, number: u32, (width, height, yuyv): (u16, u16, Vec<u8>)) {
    let time_us = u64::from(number) * PERIOD_US;
    let mut shared = session.shared();
    shared.history.states.push(time_us, number.into(), std::iter::empty());
    shared.history.images.push(Image { number, time_us, camera: "".into(), width, height, yuyv: yuyv.into() });
}
