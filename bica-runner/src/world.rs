//! The controlled system.

use core::fmt;

use bica_core::Instant;
use bica_core::action::Actions;
use bica_core::visual::Scene;

use crate::robot::Robot;

/// System that a robot program controls (the plant of control engineering): a real body, a simulation, or recorded
/// values.
///
/// The trait can be used as `dyn World<R>`.
pub trait World<R: Robot> {
    /// Time of this cycle on the clock of the world, whose zero may be any. If it steps, back or forth by more than a minute, a [`Runner`]
    /// lets the robot's time go on by one cycle.
    ///
    /// [`Runner`]: crate::Runner
    fn now(&self) -> Instant;

    /// Sensor values of this cycle.
    fn sensors(&mut self) -> R::Sensors<'_>;

    /// Applies a command for one cycle. A simulation advances by one cycle.
    fn act(&mut self, command: &R::Command);

    /// What an operator can do in this world, such as to push the robot; nothing by default. The attribute macro `world_actions`
    /// makes actions of methods; then this returns `Some(self)`.
    fn actions(&mut self) -> Option<&mut dyn Actions> {
        None
    }

    /// Whether the run has ended, as a game after its last minute. A program that runs worlds asks before each cycle.
    fn is_over(&self) -> bool {
        false
    }

    /// Writes the result of the run for people; nothing by default.
    ///
    /// # Errors
    /// If `out` cannot be written.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        Ok(())
    }

    /// Reports numbers of the result so far, each with its name and unit (`""`: none), in the same order each time; none by default. A
    /// search of parameters can optimise them; a NaN is a missing value. Names consist of letters, digits and `_`.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn figures(&self, figure: &mut dyn FnMut(&'static str, f64, &'static str)) {}

    /// Shows what does not move, such as walls, once before the first cycle; nothing by default.
    ///
    /// Neither this nor [`truth`](Self::truth) reaches the robot: only monitors see it.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn scenery(&self, scene: &mut dyn Scene) {}

    /// Shows the true state after the last cycle, such as the pose of the robot; nothing by default. It shows the same items each
    /// time, of which values may be missing: a list may be empty.
    #[expect(unused_variables, reason = "the names of the arguments are documentation")]
    fn truth(&self, scene: &mut dyn Scene) {}
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

        fn actions(&mut self) -> Option<&mut dyn Actions> {
            (**self).actions()
        }

        fn is_over(&self) -> bool {
            (**self).is_over()
        }

        fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
            (**self).report(out)
        }

        fn figures(&self, figure: &mut dyn FnMut(&'static str, f64, &'static str)) {
            (**self).figures(figure);
        }

        fn scenery(&self, scene: &mut dyn Scene) {
            (**self).scenery(scene);
        }

        fn truth(&self, scene: &mut dyn Scene) {
            (**self).truth(scene);
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
