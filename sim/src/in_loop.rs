//! The worlds as the plant of a [`Runner`](bica_runner::Runner).

use bica_core::action::Actions;
use bica_core::visual::Scene;
use bica_field::FIELD;
use bica_motion::robot::{Command, Sensors};
use bica_runner::Robot;

use crate::kinematic::KinematicWorld;
use crate::scene::{show_field, show_truth};
use crate::spectator::SpectatorView;
use crate::world::World;

/// Implements the runner's trait on the basis of this crate's trait, for every robot with the sensors and the command
/// of a humanoid.
macro_rules! controlled {
    ($world:ty) => {
        impl<R> bica_runner::World<R> for $world
        where
            R: Robot<Command = Command>,
            for<'a> R: Robot<Sensors<'a> = Sensors<'a>>,
        {
            fn now(&self) -> bica_core::Instant {
                bica_core::Instant::from_micros(World::now(self).as_micros() as u64)
            }

            fn sensors(&mut self) -> Sensors<'_> {
                World::sensors(self)
            }

            fn act(&mut self, command: &Command) {
                World::act(self, command);
            }

            fn actions(&mut self) -> Option<&mut dyn Actions> {
                Some(World::actions(self))
            }

            fn is_over(&self) -> bool {
                World::failure(self).is_some()
            }

            fn report(&self, out: &mut dyn core::fmt::Write) -> core::fmt::Result {
                World::failure(self).map_or(Ok(()), |failure| writeln!(out, "{failure}"))
            }

            fn scenery(&self, scene: &mut dyn Scene) {
                show_field(&FIELD, scene);
            }

            fn truth(&self, scene: &mut dyn Scene) {
                show_truth(World::referee(self), scene);
            }
        }
    };
}

controlled!(KinematicWorld);
controlled!(dyn SpectatorView + '_);
#[cfg(feature = "mujoco")]
controlled!(crate::mujoco::MujocoWorld);
