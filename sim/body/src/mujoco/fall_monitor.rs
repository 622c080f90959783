//! Detection of falls and of getting up.

use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::{Pose2, rotate};
use glam::{Affine3A, Vec2};

use crate::Posture;
use crate::transform::{fall_direction, ground_pose};

/// Vertical component of the torso axis below which the robot falls: it leans by more than 53°.
const FALLEN_COSINE: f32 = 0.6;
/// Vertical component of the torso axis above which the robot is upright: it leans by less than 20°.
const UPRIGHT_COSINE: f32 = 0.94;
/// Time for which the robot must be upright to count as standing, cycles.
const STANDING_CYCLES: u32 = 50;

/// State of the detection.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FallMonitor {
    posture: Posture,
    /// Heading before a fall, rad.
    heading: f32,
    /// Consecutive upright cycles.
    standing: u32,
}

impl FallMonitor {
    /// Returns the monitor of a standing robot.
    pub(crate) const fn new(heading: f32) -> Self {
        Self { posture: Posture::Upright, heading, standing: 0 }
    }

    /// Updates with the pose of the robot frame, once per cycle; `floor`: whether a part other than the feet touches the floor.
    /// Returns the new posture if the robot falls or gets up.
    pub(crate) fn step(&mut self, model: &'static SimulatedModel, robot: &Affine3A, floor: bool) -> Option<Posture> {
        let up = robot.matrix3.z_axis.z;
        let upright = up > UPRIGHT_COSINE && robot.translation.z > model.extents.min_hip_height && !floor;
        self.standing = if upright { self.standing + 1 } else { 0 };
        if self.posture == Posture::Upright && up > FALLEN_COSINE {
            self.heading = heading(robot);
            return None;
        }
        match self.posture {
            Posture::Upright => {
                let lean = rotate(Vec2::new(robot.matrix3.z_axis.x, robot.matrix3.z_axis.y), -self.heading);
                self.posture = Posture::Down(fall_direction(lean));
            }
            Posture::Down(_) if self.standing >= STANDING_CYCLES => {
                self.posture = Posture::Upright;
                self.heading = heading(robot);
            }
            Posture::Down(_) => return None,
        }
        Some(self.posture)
    }

    /// Returns whether the robot stands or has fallen.
    pub(crate) const fn posture(&self) -> Posture {
        self.posture
    }

    /// Projects the robot frame to the ground; while the robot lies, with the heading before the fall.
    pub(crate) fn pose(&self, robot: &Affine3A) -> Pose2 {
        Pose2 { position: Vec2::new(robot.translation.x, robot.translation.y), heading: self.heading }
    }
}

fn heading(robot: &Affine3A) -> f32 {
    ground_pose(robot).heading
}
