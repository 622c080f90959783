//! All detectors, as the forward calls them.

use bica_motion::side::Side;
use bica_sim::World;
use bica_vision::ball::{self, Ball, BallFinder};
use bica_vision::centre_circle::{self, CentreCircle};
use bica_vision::crossings::{self, Crossings};
use bica_vision::field_end::FieldEnd;
use bica_vision::frame::Frame;
use bica_vision::goal::{GoalFinder, Goals};
use bica_vision::lines::{self, Lines};
use bica_vision::profile::BUILT_IN_TABLE;
use bica_vision::projection::Camera;
use bica_vision::robots::{self, Robots};

use super::look::Look;

/// Lines are asked for up to this distance, m.
const LINES_FAR: f32 = 4.5;

/// What looks.
pub(super) struct Eyes {
    balls: BallFinder<512>,
    goals: GoalFinder<1024>,
}

/// What is seen.
pub(super) struct Seen {
    pub(super) camera: Camera,
    pub(super) end: FieldEnd,
    pub(super) ball: Option<Ball>,
    pub(super) goals: Goals,
    pub(super) robots: Robots,
    /// In the image, px.
    pub(super) raw: Lines,
    /// On the ground, m.
    pub(super) lines: Lines,
    pub(super) crossings: Crossings,
    pub(super) circle: Option<CentreCircle>,
}

impl Eyes {
    pub(super) const fn new() -> Self {
        Self { balls: BallFinder::new(ball::RADIUS), goals: GoalFinder::new() }
    }

    pub(super) fn see(&mut self, look: &Look) -> Seen {
        let mut world = look.world.clone();
        let sensors = world.sensors();
        let image = sensors.image.expect("there is a new one");
        let frame = Frame::from_image(&image).expect("a frame");
        let camera = Camera::of_nao(image.camera, &sensors.angles, Side::Left, image.width, image.height);
        let colours = &BUILT_IN_TABLE;
        let end = FieldEnd::find(&frame, colours);
        let ball = self.balls.find(&frame, colours, &end, Some(&camera));
        let goals = self.goals.find(&frame, colours, &end, Some(&camera));
        let robots = robots::find(&frame, colours, &end, Some(&camera));
        let mut lines = lines::find(&frame, colours, &end);
        lines.retain(|line| !robots.iter().any(|robot| robot.covers(line.from.midpoint(line.to))));
        let crossings = crossings::among(&lines, 0.05 * f32::from(frame.height()));
        let raw = lines;
        let lines = lines::on_ground(&raw, &camera, LINES_FAR);
        let circle = centre_circle::among(&lines);
        Seen { camera, end, ball, goals, robots, raw, lines, crossings, circle }
    }
}
