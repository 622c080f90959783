//! Actions: what an operator can do in a world.
//!
//! ```
//! use bica_core::Value;
//! use bica_core::action::{Actions, perform};
//! use bica_macros::world_actions;
//!
//! struct Room { robot: [f32; 2] }
//!
//! #[world_actions(crate = bica_core)]
//! impl Room {
//!     /// Puts the robot somewhere else.
//!     #[action(moves = "robot")]
//!     fn place_robot(
//!         &mut self,
//!         #[range(0.0..=8.0)] #[unit("m")] #[place("room.x")] x: f32,
//!         #[range(0.0..=5.0)] #[unit("m")] #[place("room.y")] y: f32,
//!     ) -> Result<(), &'static str> {
//!         if x > 7.0 && y > 4.0 {
//!             return Err("a pillar is there");
//!         }
//!         self.robot = [x, y];
//!         Ok(())
//!     }
//! }
//!
//! let mut room = Room { robot: [1.0, 1.0] };
//! perform(Some(&mut room), "place_robot", &[Value::F32(2.0), Value::F32(3.0)])?;
//! assert_eq!(room.robot, [2.0, 3.0]);
//!
//! let mut refused = |x, y| perform(Some(&mut room), "place_robot", &[Value::F32(x), Value::F32(y)]).unwrap_err();
//! assert_eq!(refused(9.0, 1.0).to_string(), "`world.x`: 9 is outside 0..=8");
//! assert_eq!(refused(7.5, 4.5).to_string(), "`world.place_robot`: a pillar is there");
//! # Ok::<(), bica_core::Refusal>(())
//! ```

use crate::key::Key;
use crate::modulation::Modulation;
use crate::params::Value;
use crate::refusal::{Reason, Refusal};

/// Description of an action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Action {
    /// Name, doc comment and arguments.
    pub call: Modulation,
    /// Item of the world's true state that it moves to the place of its arguments; `None` for an action that moves nothing there.
    pub moves: Option<&'static str>,
}

/// Actions of a world; `#[world_actions]` implements it.
pub trait Actions {
    /// The descriptions. The list of a world never changes.
    fn list(&self) -> &'static [Action];

    /// Performs the action at an index. Its arguments are valid: [`perform`] checks them.
    ///
    /// # Errors
    /// Why the world refuses it; then nothing changes.
    fn perform(&mut self, index: usize, arguments: &[Value]) -> Result<(), &'static str>;
}

/// What a method with `#[action]` returns: nothing, or a `Result` with the reason of a refusal.
#[diagnostic::on_unimplemented(
    message = "an action cannot return `{Self}`",
    label = "neither `()` nor `Result<(), &'static str>`",
    note = "return nothing, or `Result<(), &'static str>` with the reason for which the world refuses the action"
)]
pub trait Outcome {
    /// The result.
    ///
    /// # Errors
    /// The reason of a refusal.
    fn result(self) -> Result<(), &'static str>;
}

impl Outcome for () {
    fn result(self) -> Result<(), &'static str> {
        Ok(())
    }
}

impl Outcome for Result<(), &'static str> {
    fn result(self) -> Self {
        self
    }
}

/// Performs an action if its arguments are valid.
///
/// # Errors
/// If there is no world with such an action, or it does not accept a value; then nothing changes.
pub fn perform(world: Option<&mut dyn Actions>, action: impl Key, arguments: &[Value]) -> Result<(), Refusal> {
    let list = world.as_deref().map_or(&[][..], Actions::list);
    let refuse = |entry, name, reason| Err(Refusal { entry, component: "world", name, reason });
    let index = action.find(list.iter().map(|action| action.call.name));
    let found = index.and_then(|index| Some((index, &list.get(index)?.call)));
    let (Some(world), Some((index, call))) = (world, found) else {
        return refuse(0, "", Reason::UnknownAction { actions: list });
    };
    call.check(arguments).or_else(|(entry, name, reason)| refuse(entry, name, reason))?;
    world.perform(index, arguments).or_else(|reason| refuse(0, call.name, Reason::Rule(reason)))
}
