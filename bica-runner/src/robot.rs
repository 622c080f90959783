//! The tree with its inputs and outputs.

use bica_core::Tree;

/// An activation tree that can control a robot: how sensor values enter it and how the command leaves it.
///
/// Implement it for the type that `activation_tree!` declares.
pub trait Robot: Tree {
    /// The sensor values of one cycle; `'a` is the life of what they borrow, as the pixels of an image.
    type Sensors<'a>;
    /// What the actuators shall do for one cycle.
    type Command;
    /// The reason why sensor values are refused; `core::convert::Infallible` if they never are.
    type Error;

    /// Writes the sensor values of this cycle into the input components.
    ///
    /// # Errors
    /// If the tree cannot take the values. What it keeps then is the implementation's choice.
    fn sense(&mut self, sensors: &Self::Sensors<'_>) -> Result<(), Self::Error>;

    /// Reads the command from the output components. Components that need the previous command keep it here.
    fn act(&mut self) -> Self::Command;
}
