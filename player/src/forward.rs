//! The tree of the forward, its inputs and its command.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Light, Sensors};

use crate::behaviour::{
    Dribble, FaceBall, Fixmove, FollowBall, GoRound, LookAround, Player, SafetyGuard, SearchBall, SearchNet,
};
use crate::input::{CameraInput, Colours, FrameTooLarge, GameState, HealthMonitor, RobotProfile, RobotState};
use crate::motion::{Body, GoStraight, Head, Kicker, Turn, Walk};
use crate::output::{CameraSelector, Motors};
use crate::perception::{
    self, BallDetector, CameraPose, FallDetector, FieldBoundary, FieldLines, GoalDetector, Localization, Odometry,
    OwnBody, RobotDetector,
};
use crate::robot;
use crate::roles::{Ball, Carpet, Eye, Falls, Game, Goal, Health, Legs, Odometer, Place, Robots, Views};

/// Chest light of a robot in the game (rules of RoboCup 2009).
const GREEN: Light = Light(0.0, 1.0, 0.0);
/// Chest light of a penalized robot.
const RED: Light = Light(1.0, 0.0, 0.0);

/// Declares the tree of the forward; `options` are those of `activation_tree!` besides root, rates and components.
macro_rules! forward {
    ($($option:ident)?) => {
        activation_tree! {
            /// The forward of RoboCup 2009: finds the ball, walks to it, finds the goal, lines up and kicks.
            pub struct Forward {
                root: Player,
                cycle_hz: 100,
                budget_ms: 200,
                $($option,)?
                roles: {
                    Ball: BallDetector, Goal: GoalDetector, Place: Localization, Odometer: Odometry,
                    Legs: Body, Falls: FallDetector, Health: HealthMonitor,
                    Robots: RobotDetector, Carpet: FieldBoundary, Eye: CameraPose, Views: CameraInput, Game: GameState,
                },
                components: [
                    Player,
                    SearchBall, FollowBall, SearchNet, LookAround, GoRound, Fixmove, Dribble, SafetyGuard, FaceBall,
                    Body, GoStraight, Turn, Walk, Kicker, Head,
                    Localization, BallDetector, GoalDetector, FieldLines, RobotDetector, FieldBoundary, OwnBody, CameraPose, Odometry,
                    FallDetector,
                    CameraInput, Colours, RobotState, HealthMonitor, GameState, RobotProfile,
                    Motors, CameraSelector,
                ],
            }
        }

        impl Robot for Forward {
            type Sensors<'a> = Sensors<'a>;
            type Command = Command;
            /// The image does not fit into [`CameraInput`]. The other values are accepted and the previous image is kept.
            type Error = FrameTooLarge;

            fn sense(&mut self, sensors: &Sensors<'_>) -> Result<(), FrameTooLarge> {
                perception::pass_cycle(self);
                robot::measure(self, sensors);
                self.get_mut::<GameState>().set_button(sensors.buttons.chest);
                robot::see(self, sensors)
            }

            fn act(&mut self) -> Command {
                let chest = if self.get::<GameState>().playing() { GREEN } else { RED };
                Command { camera: self.get::<CameraSelector>().selected(), ..robot::command(self, chest) }
            }
        }
    };
}

forward!();

/// The forward with parameters that can be changed while it runs: for programs that tune or monitor it.
#[cfg_attr(
    not(test),
    expect(clippy::wildcard_imports, reason = "the same components, sensor values and commands as the tree above")
)]
pub mod tunable {
    use super::*;

    forward!(tunable);
}
