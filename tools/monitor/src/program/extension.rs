//! Panels that a program adds to the page.

use std::any::{Any, TypeId};
use std::collections::BTreeMap;
use std::sync::{Arc, MutexGuard};

use bica_link::Description;
use serde_json::Value;

use super::Image;
use crate::protocol::Failed;
use bica_wire::model::NamedSetting;

/// Panels that a program adds to the page, and what answers their messages.
///
/// The page sends a message as the request `extension` with `name` and `message`.
pub trait Extension: Send + Sync {
    /// Name: lower-case letters and digits.
    fn name(&self) -> &str;

    /// Text of an ES module. Its default export is `{panels, presets}`: panels by name, as in `page/lib/panels.js`, and layouts by name, as
    /// in `page/lib/presets.js`; one with `first` is that of a first visit, and one with `plain` has a bar for people who are not
    /// engineers. `lastPresets` are layouts after all others. It is loaded from the folder `extensions` beside `lib`.
    fn module(&self) -> &str;

    /// Whether pages that may only watch may send this message.
    fn only_reads(&self, message: &Value) -> bool;

    /// Answers a message of a page.
    ///
    /// # Errors
    /// Why it cannot be done.
    fn handle(&self, asked: &dyn Asked, message: Value) -> Result<Reply, Failed>;
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
pub trait Asked {
    /// The tree of the session, with the values of parameters; none before the first connection.
    fn description(&self) -> Option<Arc<Description>>;

    /// The image with a number.
    ///
    /// # Errors
    /// If it is not in memory any more, or cannot be read.
    fn image(&self, number: u32) -> Result<Image, Failed>;

    /// What extensions remember of this session.
    fn memory(&self) -> MutexGuard<'_, Remembered>;

    /// Sends one byte for each pixel of an image to the page, before the answer.
    fn send_classes(&self, image: &Image, classes: &[u8]);

    /// Sets parameters of the robot, if the page operates it; its answer follows.
    ///
    /// # Errors
    /// If the session has ended.
    fn set_params(&self, settings: Vec<NamedSetting>) -> Result<Reply, Failed>;

    /// Works in a thread of its own, and answers with the result.
    ///
    /// # Errors
    /// If there are too many threads.
    fn later(&self, work: Work) -> Result<Reply, Failed>;
}

/// Work whose result is the answer to a message.
pub type Work = Box<dyn FnOnce() -> Result<Value, Failed> + Send>;

/// What extensions remember of a session: one value of each type.
#[derive(Default)]
pub struct Remembered(BTreeMap<TypeId, Box<dyn Any + Send>>);

impl Remembered {
    /// The value of a type; its default at first.
    pub fn of<T: Default + Send + 'static>(&mut self) -> &mut T {
        let new = || Box::<T>::default() as Box<dyn Any + Send>;
        let value = self.0.entry(TypeId::of::<T>()).or_insert_with(new);
        let Some(value) = value.downcast_mut() else { unreachable!("the key is the type") };
        value
    }
}
