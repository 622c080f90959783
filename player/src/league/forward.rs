//! The tree of the forward, and its command.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Light};

use super::input::{CameraInput, GameState};
use super::perception::{BallDetector, CameraPose, FieldBoundary, GoalDetector, Localization, RobotDetector};
use super::senses::Senses;
use crate::behaviour::{
    Dribble, FaceBall, Fixmove, FollowBall, GoRound, LookAround, Player, SafetyGuard, SearchBall, SearchNet,
};
use crate::input::{HealthMonitor, RobotProfile, RobotState};
use crate::motion::{Body, GoStraight, Head, Kicker, Turn, Walk};
use crate::output::{CameraSelector, Motors};
use crate::perception::{FallDetector, Odometry};
use crate::robot;
use crate::roles::{Ball, Carpet, Eye, Falls, Game, Goal, Health, Legs, Odometer, Place, Robots, Views};

activation_tree! {
    /// The forward of RoboCup 2009 on a robot of today: finds the ball, walks to it, finds the goal, lines up and kicks.
    pub struct Forward {
        root: Player,
        cycle_hz: 100,
        budget_ms: 200,
        tunable,
        roles: {
            Ball: BallDetector, Goal: GoalDetector, Place: Localization, Odometer: Odometry,
            Legs: Body, Falls: FallDetector, Health: HealthMonitor,
            Robots: RobotDetector, Carpet: FieldBoundary, Eye: CameraPose, Views: CameraInput, Game: GameState,
        },
        components: [
            Player,
            SearchBall, FollowBall, SearchNet, LookAround, GoRound, Fixmove, Dribble, SafetyGuard, FaceBall,
            Body, GoStraight, Turn, Walk, Kicker, Head,
            Localization, BallDetector, GoalDetector, RobotDetector, FieldBoundary, CameraPose, Odometry, FallDetector,
            CameraInput, RobotState, HealthMonitor, GameState, RobotProfile,
            Motors, CameraSelector,
        ],
    }
}

impl Robot for Forward {
    type Sensors<'a> = Senses<'a>;
    type Command = Command;
    type Error = core::convert::Infallible;

    fn sense(&mut self, senses: &Senses<'_>) -> Result<(), Self::Error> {
        // What a component that does not run has estimated becomes old.
        self.get_mut::<BallDetector>().pass_cycle();
        self.get_mut::<GoalDetector>().pass_cycle();
        self.get_mut::<RobotDetector>().pass_cycle();
        self.get_mut::<Localization>().pass_cycle();
        self.get_mut::<CameraPose>().pass_cycle();
        self.get_mut::<Odometry>().pass_cycle();
        robot::measure(self, &senses.body);
        self.get_mut::<GameState>().set(senses.playing);
        if let Some(view) = &senses.view {
            let angles = *self.get::<RobotState>().angles();
            self.get_mut::<CameraInput>().receive(view, &angles);
        }
        Ok(())
    }

    fn act(&mut self) -> Command {
        Command { camera: self.get::<CameraSelector>().selected(), ..robot::command(self, Light::default()) }
    }
}
