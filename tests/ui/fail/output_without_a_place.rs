use bica::prelude::*;
use bica::visual::{Point2, Pose2};

struct Ball;

#[component]
impl Ball {
    const fn new() -> Self {
        Self
    }

    /// Distance to the ball.
    #[info(unit = "m", frame = "robot")]
    fn distance(&self) -> f32 {
        0.0
    }

    /// The ball.
    #[info(unit = "m", frame = "robot", child = "ball")]
    fn ball(&self) -> Option<Point2> {
        None
    }

    /// The robot.
    #[info(frame = "field", child = "robot")]
    fn robot(&self) -> Option<&Pose2> {
        None
    }

    fn step(&mut self) {}
}

activation_tree! {
    struct Robot { root: Ball, cycle_hz: 100, components: [Ball] }
}

fn main() {
    Robot::new().tick(Instant::from_ticks(0));
}
