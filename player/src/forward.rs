//! The tree, and its door to a robot.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::{Command, Light, Lights, Sensors};

use crate::behaviour::{
    Dribble, FaceBall, FallGuard, Fixmove, FollowBall, GoRound, LookAround, Player, SearchBall, SearchNet,
};
use crate::input::{Colours, Eye, FrameTooLarge, Measured};
use crate::motion::{Body, GoStraight, Head, Kicker, Turn, Walk};
use crate::output::{Gaze, Motors};
use crate::perception::{
    BallDetector, CameraPose, FallDetector, FieldBoundary, FieldLines, Localization, NetDetector, Odometry, OwnBody,
    RobotDetector,
};

activation_tree! {
    /// The forward of RoboCup 2009: finds the ball, walks to it, looks for the goal, lines up and kicks.
    pub struct Forward {
        root: Player,
        cycle_hz: 100,
        budget_ms: 200,
        components: [
            Player,
            SearchBall, FollowBall, SearchNet, LookAround, GoRound, Fixmove, Dribble, FallGuard, FaceBall,
            Body, GoStraight, Turn, Walk, Kicker, Head,
            Localization, BallDetector, NetDetector, FieldLines, RobotDetector, FieldBoundary, OwnBody, CameraPose, Odometry,
            FallDetector,
            Eye, Colours, Measured,
            Motors, Gaze,
        ],
    }
}

/// The chest of a robot in the game (rules of RoboCup 2009).
const GREEN: Light = Light(0.0, 1.0, 0.0);
/// The chest of a robot that was sent off.
const RED: Light = Light(1.0, 0.0, 0.0);

impl Robot for Forward {
    type Sensors<'a> = Sensors<'a>;
    type Command = Command;
    type Error = FrameTooLarge;

    fn sense(&mut self, sensors: &Sensors<'_>) -> Result<(), FrameTooLarge> {
        sense(self, sensors)
    }

    fn act(&mut self) -> Command {
        act(self)
    }
}

/// Before a tick: tells the tree what the robot senses.
///
/// # Errors
/// [`FrameTooLarge`] if the image does not fit into the eye; all else is taken in, and the last image stays.
pub fn sense(robot: &mut Forward, sensors: &Sensors<'_>) -> Result<(), FrameTooLarge> {
    let told = act(robot);
    robot.get_mut::<Measured>().measure(sensors);
    robot.get_mut::<Measured>().check(sensors, &told.targets, &told.stiffness);
    let angles = *robot.get::<Measured>().angles();
    sensors.image.as_ref().map_or(Ok(()), |image| robot.get_mut::<Eye>().see(image, &angles))
}

/// After a tick: what the robot is to do.
#[must_use]
pub fn act(robot: &Forward) -> Command {
    let (measured, motors) = (robot.get::<Measured>(), robot.get::<Motors>());
    Command {
        targets: motors.targets(),
        stiffness: measured.derated(motors.stiffness()),
        lights: Lights { chest: if measured.playing() { GREEN } else { RED }, ..Lights::default() },
        camera: robot.get::<Gaze>().camera(),
    }
}
