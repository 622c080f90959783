//! The controlled system.

use bica_core::Instant;

use crate::robot::Robot;

/// System that a robot program controls (the plant of control engineering): a real body, a simulation, or recorded
/// values.
///
/// The trait can be used as `dyn World<R>`.
pub trait World<R: Robot> {
    /// Time of this cycle on the clock of the world, which never runs backwards.
    fn now(&self) -> Instant;

    /// Sensor values of this cycle.
    fn sensors(&mut self) -> R::Sensors<'_>;

    /// Applies a command for one cycle. A simulation advances by one cycle.
    fn act(&mut self, command: &R::Command);
}

macro_rules! forward_to_target {
    () => {
        fn now(&self) -> Instant {
            (**self).now()
        }

        fn sensors(&mut self) -> R::Sensors<'_> {
            (**self).sensors()
        }

        fn act(&mut self, command: &R::Command) {
            (**self).act(command);
        }
    };
}

impl<R: Robot, W: World<R> + ?Sized> World<R> for &mut W {
    forward_to_target!();
}

#[cfg(feature = "std")]
impl<R: Robot, W: World<R> + ?Sized> World<R> for std::boxed::Box<W> {
    forward_to_target!();
}
