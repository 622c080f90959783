//! The tree of a forward that a referee commands.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Light};

use super::{FieldPose, GameController, GoTo, Order, Reporter, TeamCommand, TeamPlayer, TeamSensors, Whistle};
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
use crate::roles::{
    Ball, Carpet, Ears, Eye, Falls, Game, Goal, Health, Legs, Odometer, Place, Robots, Views, Whereabouts,
};
use crate::team::{Positioning, Roles, TeamBall, TeamComm, TeamMates, TeamPlay};

activation_tree! {
    /// The forward in a team: a referee commands it through the `GameController`.
    pub struct TeamForward {
        root: TeamPlayer,
        cycle_hz: 100,
        budget_ms: 200,
        tunable,
        roles: {
            Ball: BallDetector, Goal: GoalDetector, Place: Localization, Odometer: Odometry,
            Legs: Body, Falls: FallDetector, Health: HealthMonitor, Whereabouts: FieldPose, Ears: Whistle,
            Robots: RobotDetector, Carpet: FieldBoundary, Eye: CameraPose, Views: CameraInput, Game: GameState,
        },
        components: [
            TeamPlayer, TeamPlay, Positioning, Player,
            SearchBall, FollowBall, SearchNet, LookAround, GoRound, Fixmove, Dribble, SafetyGuard, FaceBall, GoTo,
            Body, GoStraight, Turn, Walk, Kicker, Head,
            FieldPose, Localization, BallDetector, GoalDetector, FieldLines, RobotDetector, FieldBoundary, OwnBody, CameraPose,
            Odometry, FallDetector,
            TeamComm, Roles, TeamBall, TeamMates, GameController, Whistle,
            CameraInput, Colours, RobotState, HealthMonitor, GameState, RobotProfile,
            Motors, CameraSelector, Reporter,
        ],
    }
}

impl Robot for TeamForward {
    type Sensors<'a> = TeamSensors<'a>;
    type Command = TeamCommand;
    /// The image does not fit into [`CameraInput`]. The other values are accepted and the previous image is kept.
    type Error = FrameTooLarge;

    fn sense(&mut self, sensors: &TeamSensors<'_>) -> Result<(), FrameTooLarge> {
        let TeamSensors { body, me, packet, ignored, heard, refused } = sensors;
        perception::pass_cycle(self);
        robot::measure(self, body);
        let game = self.get_mut::<GameController>();
        game.receive(*me, packet.as_ref(), *ignored);
        let penalizes = game.take_button(body.buttons.chest);
        self.get_mut::<GameState>().set_button(penalizes);
        self.get_mut::<TeamMates>().receive(heard.as_ref(), *refused);
        robot::see(self, body)
    }

    fn act(&mut self) -> TeamCommand {
        let chest = light(self.get::<GameController>().order());
        let body = Command { camera: self.get::<CameraSelector>().selected(), ..robot::command(self, chest) };
        let (answer, message) = (self.get_mut::<Reporter>().take(), self.get_mut::<TeamComm>().take());
        TeamCommand { body, answer, message }
    }
}

/// Chest light of an order (rules of the Standard Platform League).
const fn light(order: Order) -> Light {
    match order {
        Order::Initial | Order::Finished => Light(0.0, 0.0, 0.0),
        Order::Ready => Light(0.0, 0.0, 1.0),
        Order::Set | Order::Wait | Order::Stopped => Light(1.0, 1.0, 0.0),
        Order::Playing => Light(0.0, 1.0, 0.0),
        Order::Penalized => Light(1.0, 0.0, 0.0),
    }
}
