//! Panels that a program adds to the page.

use std::any::{Any, TypeId};
use std::collections::BTreeMap;
use std::sync::{Arc, MutexGuard};

use bica_link::Description;
use serde_json::Value;

use super::Image;
use crate::protocol::Failed;
use bica_wire::model::NamedSetting;

/// Panels that a program adds to the page, and the handler of their messages.
///
/// The page sends a message as the request `extension` with `name` and `message`.
pub trait Extension: Send + Sync {
    /// Name: lower-case letters and digits.
    fn name(&self) -> &str;

    /// Text of an ES module, which the page loads from the folder `extensions` beside `lib`. Its default export is
    /// `{panels, presets}`: panels by name, as in `page/lib/panels.js`, and layouts by name, as in `page/lib/presets.js`. A layout
    /// with `first` is that of a first visit to a tree that has what it `needs`, with at least so many sessions; with 0 also before a
    /// tree is known. A layout with `plain` has a bar for people who are not engineers. `lastPresets` are layouts that are listed after
    /// all others. `label` names a robot by its outputs, such as `{Game.team}-{Game.player}`, in place of its address.
    fn module(&self) -> &str;

    /// Returns whether pages that may only watch may send this message; by default none may.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn only_reads(&self, message: &Value) -> bool {
        false
    }

    /// Answers a message of a page; by default there are no messages.
    ///
    /// # Errors
    /// If the message cannot be handled.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn handle(&self, asked: &dyn Asked, message: Value) -> Result<Reply, Failed> {
        Err(Failed::new(format!("the extension `{}` has no messages", self.name()), "reload the page"))
    }
}

/// Answer to a message of a panel.
#[derive(Debug)]
pub enum Reply {
    /// The result.
    Done(Value),
    /// The answer follows later.
    Later,
}

/// Context of a message: the session that it concerns, and the page that waits for the answer.
pub trait Asked {
    /// Returns the tree of the session with the values of its parameters; none before the first connection.
    fn description(&self) -> Option<Arc<Description>>;

    /// Returns the image with this number.
    ///
    /// # Errors
    /// If the image is no longer in memory, or cannot be read.
    fn image(&self, number: u32) -> Result<Image, Failed>;

    /// Returns the data that extensions store for this session.
    fn memory(&self) -> MutexGuard<'_, Remembered>;

    /// Sends one byte for each pixel of an image to the page, before the answer.
    fn send_classes(&self, image: &Image, classes: &[u8]);

    /// Sets parameters of the robot, if the page operates it. The answer follows later.
    ///
    /// # Errors
    /// If the session has ended.
    fn set_params(&self, settings: Vec<NamedSetting>) -> Result<Reply, Failed>;

    /// Runs work in a new thread, and answers with its result.
    ///
    /// # Errors
    /// If the thread cannot be started.
    fn later(&self, work: Work) -> Result<Reply, Failed>;
}

/// Work whose result is the answer to a message.
pub type Work = Box<dyn FnOnce() -> Result<Value, Failed> + Send>;

/// Data that extensions store for a session: one value of each type.
#[derive(Default)]
pub struct Remembered(BTreeMap<TypeId, Box<dyn Any + Send>>);

impl Remembered {
    /// Returns the value of a type; initially its default.
    pub fn of<T: Default + Send + 'static>(&mut self) -> &mut T {
        let new = || Box::<T>::default() as Box<dyn Any + Send>;
        let value = self.0.entry(TypeId::of::<T>()).or_insert_with(new);
        let Some(value) = value.downcast_mut() else { unreachable!("the key is the type") };
        value
    }
}
