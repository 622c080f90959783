//! Random views.

use std::f32::consts::PI;

use bica_motion::joints::Joint;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Setup, Start};
use glam::Vec2;
use rand_pcg::Pcg32;
use rand_pcg::rand_core::Rng;

/// Number of cycles until the head rests.
const REST: u32 = 70;

/// World with a robot that looks in a random direction and has a new image.
pub(crate) struct View {
    /// Seed of the view.
    pub(crate) number: u64,
    pub(crate) world: KinematicWorld,
}

struct Rng32(Pcg32);

impl Rng32 {
    fn between(&mut self, low: f32, high: f32) -> f32 {
        low + (high - low) * (self.0.next_u32() >> 8) as f32 / (1_u32 << 24) as f32
    }

    fn start(&mut self) -> Start {
        let robot = Pose2::new(self.between(-2.7, 2.7), self.between(-1.8, 1.8), self.between(-PI, PI));
        loop {
            let direction = robot.heading + self.between(-1.0, 1.0);
            let ball = robot.position + self.between(0.2, 3.5) * Vec2::from_angle(direction);
            if ball.x.abs() < 3.2 && ball.y.abs() < 2.2 {
                return Start { robot, ball };
            }
        }
    }
}

impl View {
    /// Creates the view of a number: a random pose on the field with a goalkeeper and four more robots, the ball at 0.2
    /// to 3.5 m, and a random head direction. Every third view is from the bottom camera. `None` if an object would be
    /// in a goal.
    pub(crate) fn new(number: u64) -> Option<Self> {
        let mut rng = Rng32(Pcg32::new(number, 2009));
        let setup = Setup { seed: number, robots: 4, start: Some(rng.start()), ..Setup::default() };
        let mut world = KinematicWorld::new(NAO, &setup).ok()?;
        let mut targets = world.sensors().angles;
        targets[Joint::HeadYaw] = rng.between(-1.2, 1.2);
        targets[Joint::HeadPitch] = rng.between(-0.2, 0.4);
        let camera = if number.is_multiple_of(3) { CameraId::Bottom } else { CameraId::Top };
        let command = Command { camera, ..Command::new(targets, 1.0) };
        (0..REST).for_each(|_| world.act(&command));
        while world.sensors().image.is_none() {
            world.act(&command);
        }
        Some(Self { number, world })
    }
}
