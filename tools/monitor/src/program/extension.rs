//! Panels that a program adds to the page.

use std::any::Any;
use std::sync::Arc;

use bica_link::Description;
use serde_json::Value;

use super::Image;
use crate::pages::PageId;
use crate::protocol::binary::{ImageHead, PixelKind};
use crate::protocol::{Failed, Request};
use crate::sessions::commands::Command;
use crate::sessions::session::Session;
use bica_wire::model::{NamedRequest, NamedSetting};

/// Panels that a program adds to the page, and what answers their messages.
///
/// The page sends a message as the request `extension` with `name` and `message`.
pub trait Extension: Send + Sync {
    /// Name: lower-case letters and digits.
    fn name(&self) -> &str;

    /// Text of an ES module. Its default export is `{panels, presets}`: panels by name, as in `page/lib/panels.js`, and layouts by name, as
    /// in `page/lib/presets.js`. It is loaded from the folder `extensions` beside `lib`.
    fn module(&self) -> &str;

    /// Whether pages that may only watch may send this message.
    fn only_reads(&self, message: &Value) -> bool;

    /// Answers a message of a page.
    ///
    /// # Errors
    /// Why it cannot be done.
    fn handle(&self, asked: Asked<'_>, message: Value) -> Result<Reply, Failed>;
}

/// Answer to a message of a panel.
#[derive(Debug)]
pub enum Reply {
    /// The result.
    Done(Value),
    /// It follows.
    Later,
}

/// The session that a message is about, and the page that waits for the answer.
#[derive(Clone, Copy)]
pub struct Asked<'a> {
    session: &'a Arc<Session>,
    page: PageId,
    id: u32,
}

impl<'a> Asked<'a> {
    pub(crate) const fn new(session: &'a Arc<Session>, page: PageId, id: u32) -> Self {
        Self { session, page, id }
    }

    /// The tree of the session, with the values of parameters; none before the first connection.
    #[must_use]
    pub fn description(&self) -> Option<Arc<Description>> {
        self.session.shared().description.clone()
    }

    /// The image with a number.
    ///
    /// # Errors
    /// If it is not in memory any more, or cannot be read.
    pub fn image(&self, number: u32) -> Result<Image, Failed> {
        self.session.image(number)
    }

    /// What extensions remember of this session, one value of each type.
    pub fn state<T: Default + Send + 'static, R>(&self, work: impl FnOnce(&mut T) -> R) -> R {
        let mut shared = self.session.shared();
        let new = || Box::<T>::default() as Box<dyn Any + Send>;
        let value = shared.extensions.entry(std::any::TypeId::of::<T>()).or_insert_with(new);
        let Some(value) = value.downcast_mut() else { unreachable!("the key is the type") };
        work(value)
    }

    /// Sends one byte for each pixel of an image to the page, before the answer.
    pub fn send_classes(&self, image: &Image, classes: &[u8]) {
        let head = ImageHead {
            kind: PixelKind::Classes,
            bottom_camera: image.bottom_camera,
            session: self.session.id,
            number: image.number,
            width: image.width,
            height: image.height,
            time_us: image.time_us,
            id: self.id,
        };
        self.session.pages.binary(self.page, head.frame(classes).into());
    }

    /// Sets parameters of the robot, if the page operates it; its answer follows.
    ///
    /// # Errors
    /// If the session has ended.
    pub fn set_params(&self, settings: Vec<NamedSetting>) -> Result<Reply, Failed> {
        let request = Request::Operate { request: NamedRequest::Set { settings } };
        self.session.command(Command::Operate { page: self.page, id: self.id, request }).map(|()| Reply::Later)
    }

    /// Works in a thread of its own, and answers with the result.
    ///
    /// # Errors
    /// If there are too many threads.
    pub fn later(&self, work: impl FnOnce() -> Result<Value, Failed> + Send + 'static) -> Result<Reply, Failed> {
        let (session, page, id) = (Arc::clone(self.session), self.page, self.id);
        let answer = move || session.pages.answer(page, id, work());
        let started = std::thread::Builder::new().name("extension".to_owned()).spawn(answer);
        started.map(|_| Reply::Later).map_err(|error| Failed::new(error.to_string(), "close other programs"))
    }
}
