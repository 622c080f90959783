//! The activation tree of the goalkeeper, its sensors and its command.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Light, Sensors};
use bica_player::behaviour::{FaceBall, Fixmove, FollowBall, SafetyGuard, SearchBall};
use bica_player::input::{CameraInput, Colours, FrameTooLarge, GameState, HealthMonitor, RobotProfile, RobotState};
use bica_player::motion::{Body, GoStraight, Head, Kicker, Turn, Walk};
use bica_player::output::{CameraSelector, Motors};
use bica_player::perception::{
    self, BallDetector, CameraPose, FallDetector, FieldBoundary, FieldLines, GoalDetector, Localization, Odometry,
    OwnBody, RobotDetector,
};
use bica_player::referee::FieldPose;
use bica_player::robot;
use bica_player::roles::{Ball, Carpet, Eye, Falls, Game, Health, Legs, Odometer, Place, Robots, Views};

use crate::Goalkeeper;
use crate::skills::{BallPath, Dive, GuardPost};

activation_tree! {
    /// A goalkeeper: stands in its goal, watches the ball, blocks it and kicks it away.
    pub struct Keeper {
        root: Goalkeeper,
        cycle_hz: 100,
        budget_ms: 200,
        tunable,
        roles: {
            Ball: BallDetector, Place: Localization, Odometer: Odometry,
            Legs: Body, Falls: FallDetector, Health: HealthMonitor,
            Robots: RobotDetector, Carpet: FieldBoundary, Eye: CameraPose, Views: CameraInput, Game: GameState,
        },
        components: [
            Goalkeeper,
            SearchBall, FollowBall, Fixmove, SafetyGuard, FaceBall,
            BallPath, FieldPose, GuardPost, Dive,
            Body, GoStraight, Turn, Walk, Kicker, Head,
            Localization, BallDetector, GoalDetector, FieldLines, RobotDetector, FieldBoundary, OwnBody, CameraPose, Odometry,
            FallDetector,
            CameraInput, Colours, RobotState, HealthMonitor, GameState, RobotProfile,
            Motors, CameraSelector,
        ],
    }
}

impl Robot for Keeper {
    type Sensors<'a> = Sensors<'a>;
    type Command = Command;
    type Error = FrameTooLarge;

    fn sense(&mut self, sensors: &Sensors<'_>) -> Result<(), FrameTooLarge> {
        perception::pass_cycle(self);
        robot::measure(self, sensors);
        self.get_mut::<GameState>().set_button(sensors.buttons.chest);
        robot::see(self, sensors)
    }

    fn act(&mut self) -> Command {
        Command { camera: self.get::<CameraSelector>().selected(), ..robot::command(self, Light::default()) }
    }
}
