//! Tree with its inputs and outputs.

use bica_core::Tree;

/// Stack of a thread that builds or runs a robot or its world, bytes. A tree may hold a whole image, and is built on the stack before it
/// moves to the heap; without optimisation it is copied several times.
#[cfg(feature = "std")]
pub const STACK_BYTES: usize = 32 << 20;

/// Activation tree that can control a robot: defines the input of sensor values and the output of the command.
///
/// Implement it for the type that `activation_tree!` declares.
pub trait Robot: Tree {
    /// Sensor values of one cycle; `'a` is the lifetime of borrowed data, such as the pixels of an image.
    type Sensors<'a>;
    /// Command of all actuators for one cycle.
    type Command;
    /// Reason for which sensor values are rejected; [`Infallible`](core::convert::Infallible) if they are always accepted. Rust
    /// has no default for an associated type.
    type Error;

    /// Writes the sensor values of this cycle into the input components.
    ///
    /// # Errors
    /// If the tree cannot accept the values. The implementation decides which values it keeps in this case.
    fn sense(&mut self, sensors: &Self::Sensors<'_>) -> Result<(), Self::Error>;

    /// Reads the command from the output components. A robot whose components need the previous command stores it here.
    fn act(&mut self) -> Self::Command;
}
