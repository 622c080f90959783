//! Whether the robot is on its feet, as the referee sees it.

use bica_motion::pose::{Pose2, rotate};
use glam::{Affine3A, Vec2};
use libm::atan2f;

use crate::referee::{Event, Posture};
use crate::transform::fall_direction;

/// A torso whose axis rises less than this has fallen: it leans by 53°.
const FALLEN: f32 = 0.6;
/// A torso whose axis rises more than this stands: it leans by less than 20°.
const STANDING: f32 = 0.94;
/// Hips that stand are at least this high, m.
const STANDING_HIPS: f32 = 0.15;
/// Who stands for this long stands for good, cycles.
const PATIENCE: u32 = 50;

/// Sees a robot fall and get up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FallMonitor {
    posture: Posture,
    /// The heading while it can be told.
    heading: f32,
    standing: u32,
}

impl FallMonitor {
    /// Of a robot that stands.
    pub(crate) const fn new(heading: f32) -> Self {
        Self { posture: Posture::Upright, heading, standing: 0 }
    }

    /// Looks at the robot frame, once per cycle; `ground`: whether more than the feet touches the floor.
    pub(crate) fn look(&mut self, robot: &Affine3A, ground: bool) -> Option<Event> {
        let rise = robot.matrix3.z_axis.z;
        let upright = rise > STANDING && robot.translation.z > STANDING_HIPS && !ground;
        self.standing = if upright { self.standing + 1 } else { 0 };
        if self.posture == Posture::Upright && rise > FALLEN {
            self.heading = heading(robot);
            return None;
        }
        match self.posture {
            Posture::Upright => {
                let lean = rotate(Vec2::new(robot.matrix3.z_axis.x, robot.matrix3.z_axis.y), -self.heading);
                let fall = fall_direction(lean);
                self.posture = Posture::Down(fall);
                Some(Event::Fall(fall))
            }
            Posture::Down(_) if self.standing >= PATIENCE => {
                self.posture = Posture::Upright;
                self.heading = heading(robot);
                Some(Event::GotUp)
            }
            Posture::Down(_) => None,
        }
    }

    pub(crate) const fn posture(&self) -> Posture {
        self.posture
    }

    /// The ground under the middle between the hips; lying, the heading is the one that it had before.
    pub(crate) fn pose(&self, robot: &Affine3A) -> Pose2 {
        Pose2 { position: Vec2::new(robot.translation.x, robot.translation.y), heading: self.heading }
    }
}

fn heading(robot: &Affine3A) -> f32 {
    atan2f(robot.matrix3.x_axis.y, robot.matrix3.x_axis.x)
}
