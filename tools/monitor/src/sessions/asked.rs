//! Messages of a page to an extension.

use std::sync::{Arc, MutexGuard};

use bica::runner::STACK_BYTES;
use bica_link::Description;

use super::commands::Command;
use super::session::Session;
use crate::pages::{PageId, lock};
use crate::program::{Asked, Image, Remembered, Reply, Work};
use crate::protocol::binary::PixelKind;
use crate::protocol::{Failed, Request};
use bica_wire::model::{NamedRequest, NamedSetting};

/// A message of a page about a session.
pub(super) struct Message<'a> {
    pub(super) session: &'a Arc<Session>,
    pub(super) page: PageId,
    /// Identifier of the message.
    pub(super) id: u32,
}

impl Asked for Message<'_> {
    fn description(&self) -> Option<Arc<Description>> {
        self.session.shared().description.clone()
    }

    fn image(&self, number: u32) -> Result<Image, Failed> {
        self.session.image(number)
    }

    fn memory(&self) -> MutexGuard<'_, Remembered> {
        lock(&self.session.remembered)
    }

    fn send_classes(&self, image: &Image, classes: &[u8]) {
        let frame = self.session.image_frame(image, (PixelKind::Classes, classes), self.id);
        self.session.pages.binary(self.page, frame);
    }

    fn set_params(&self, settings: Vec<NamedSetting>) -> Result<Reply, Failed> {
        let request = Request::Operate { request: NamedRequest::Set { settings } };
        self.session.command(Command::Operate { page: self.page, id: self.id, request }).map(|()| Reply::Later)
    }

    fn later(&self, work: Work) -> Result<Reply, Failed> {
        let (session, page, id) = (Arc::clone(self.session), self.page, self.id);
        let answer = move || session.pages.answer(page, id, work());
        let started = std::thread::Builder::new().name("extension".to_owned()).stack_size(STACK_BYTES).spawn(answer);
        started.map(|_| Reply::Later).map_err(|error| Failed::new(error.to_string(), "close other programs"))
    }
}
