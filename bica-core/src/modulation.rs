//! Modulations: methods of a component that an operator may call as an activator does.
//!
//! `#[modulation(stop)]` declares a *stop*: after the call the tree, left to itself, moves the robot no more until a person starts it
//! again. A stop takes no arguments. A server applies it without a lease, and ends the lease of whoever operates the robot.
//!
//! `#[modulation(drives)]` declares by which modulation tools drive the body, with speeds in m/s and rad/s, or turn the head, with angles
//! in rad. They use the first of each in the tree's list.
//!
//! ```
//! use bica_core::{Instant, Tree, Value};
//! use bica_macros::{activation_tree, component};
//!
//! pub struct Turn { speed: f32 }
//!
//! #[component(crate = bica_core)]
//! impl Turn {
//!     pub const fn new() -> Self { Self { speed: 0.0 } }
//!
//!     /// Turns on the spot, to the left if positive.
//!     #[modulation]
//!     pub fn turn(&mut self, #[range(-1.0..=1.0)] #[unit("rad/s")] speed: f32) { self.speed = speed; }
//! }
//!
//! activation_tree! { pub struct Robot { root: Turn, cycle_hz: 100, components: [Turn], crate: bica_core } }
//!
//! let mut robot = Robot::new();
//! robot.modulate("Turn", "turn", &[Value::F32(0.5)])?;
//! assert_eq!(robot.get::<Turn>().speed, 0.5);
//!
//! let refusal = robot.modulate("Turn", "turn", &[Value::F32(2.0)]).unwrap_err();
//! assert_eq!(refusal.to_string(), "`Turn.speed`: 2 is outside -1..=1");
//! # Ok::<(), bica_core::Refusal>(())
//! ```

use crate::params::{Kind, Param, Value};
use crate::refusal::Reason;
use crate::text::Text;

/// Largest number of arguments of a modulation or an action: requests have room for them.
pub const MAX_ARGUMENTS: usize = 16;

/// Stops the compiler if there are too many, or if an argument of a modulation that drives cannot be zero.
///
/// # Panics
/// If it is so.
#[track_caller]
pub const fn assert_arguments(modulation: &Modulation) {
    if modulation.arguments.len() > MAX_ARGUMENTS {
        let mut text = Text::<128>::new();
        text.push("an operator calls a method with at most ");
        text.push_number(MAX_ARGUMENTS as f64);
        text.push(" arguments: make two of it, or parameters of some");
        panic!("{}", text.as_str());
    }
    let mut index = 0;
    while modulation.drives && index < modulation.arguments.len() {
        let Param { name, kind, .. } = modulation.arguments[index];
        if matches!(kind, Kind::F32 { min, max, .. } if min > 0.0 || max < 0.0) {
            let mut text = Text::<128>::new();
            text.push("tools end a motion with zeros, which the range of `");
            text.push(name);
            text.push("` lacks: include 0");
            panic!("{}", text.as_str());
        }
        index += 1;
    }
}

/// Description of a modulation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Modulation {
    /// The method's name.
    pub name: &'static str,
    /// The method's doc comment.
    pub doc: &'static str,
    /// Whether the call stops the robot: it takes no arguments, and everybody who reaches the robot may call it.
    pub stops: bool,
    /// Whether tools drive the robot by it: it takes the speeds `forward` and `turn`, and perhaps `left`, or the angles `pan` and perhaps
    /// `tilt`.
    pub drives: bool,
    /// The arguments. One that declares no default has the number of its range that is nearest to zero, `false`, or the
    /// first variant.
    pub arguments: &'static [Param],
}

impl Modulation {
    /// Checks the values of a call. The error has the index and the name of what is refused.
    pub(crate) fn check(&self, values: &[Value]) -> Result<(), (usize, &'static str, Reason)> {
        let (expected, found) = (self.arguments.len(), values.len());
        if expected != found {
            return Err((0, self.name, Reason::ArgumentCount { expected, found }));
        }
        let mut pairs = self.arguments.iter().zip(values).enumerate();
        pairs.try_for_each(|(entry, (argument, value))| {
            argument.kind.accepts(*value).map_err(|reason| (entry, argument.name, reason))
        })
    }
}
