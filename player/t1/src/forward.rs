//! The tree of the forward, and its command.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Lights};

use crate::behaviour::{
    Dribble, FaceBall, Fixmove, FollowBall, GoRound, LookAround, Player, SafetyGuard, SearchBall, SearchNet,
};
use crate::input::{CameraInput, GameState, HealthMonitor, RobotProfile, RobotState};
use crate::motion::{Body, GoStraight, Head, Kicker, Turn, Walk};
use crate::output::{CameraSelector, Motors};
use crate::perception::{
    self, BallDetector, CameraPose, FallDetector, FieldBoundary, GoalDetector, Localization, Odometry, RobotDetector,
};
use crate::roles::{Ball, Falls, Goal, Health, Legs, Odometer, Place};
use crate::senses::Senses;

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
        perception::pass_cycle(self);
        let commanded = *self.get::<Motors>().commanded();
        self.get_mut::<RobotState>().measure(&senses.body, &commanded);
        self.get_mut::<HealthMonitor>().check(&senses.body, &commanded);
        self.get_mut::<GameState>().set(senses.playing);
        if let Some(view) = &senses.view {
            let angles = *self.get::<RobotState>().angles();
            self.get_mut::<CameraInput>().receive(view, &angles);
        }
        Ok(())
    }

    fn act(&mut self) -> Command {
        let stiffness = self.get::<HealthMonitor>().derated(self.get::<Motors>().stiffness());
        let commanded = *self.get_mut::<Motors>().command(stiffness);
        Command {
            targets: commanded.targets,
            stiffness: commanded.stiffness,
            lights: Lights::default(),
            camera: self.get::<CameraSelector>().selected(),
        }
    }
}
