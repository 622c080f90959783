//! Short walks.

use bica::prelude::*;
use bica_motion::joints::Joints;
use bica_motion::model::NAO;
use bica_motion::odometry::{MotionInput, Odometry};
use bica_motion::pose::Pose2;
use bica_motion::walk::{Feedback, Parameters, Phase, Velocity, Walk as Gait};
use glam::Vec2;

use super::motors::Motors;

/// Low, quick steps: the body sways less and soon stands still. Found in trials in `MuJoCo`: with lower steps the feet
/// scuff the floor; with larger capture steps one of twenty robots kept stepping after the end of its path.
const GAIT: &Parameters = &Parameters {
    step_duration: 0.19,
    step_height: 0.018,
    velocity_drift: Velocity::ZERO,
    max_capture_step: Vec2::splat(0.02),
    ..NAO.dynamic_profile.gait
};
/// Forward and lateral speed, m/s, and turn rate, rad/s: slow, beside people.
const SPEED: [f32; 3] = [0.06, 0.02, 0.2];
/// Gain of the velocity that corrects a displacement along an axis without a request, m/s per m and rad/s per rad.
const CORRECTION: f32 = 0.2;
/// Time in which the legs move to the stand of the gait before the first step, s.
const RISE: f32 = 1.0;
/// Time in which the legs move to this stand after a stop, s. The feet are at most 3 cm and 3° away from it.
const LAND: f32 = 0.04;
/// Stiffness of the legs. After a stop it is low and rises slowly: a stiffer robot rocks about its ankles, and the
/// knees of a softer one are slow.
const STANDING: f32 = 0.75;
const WALKING: f32 = 1.0;
const LANDING: f32 = 0.36;
const STIFFENING: f32 = 0.02;
/// Time in which the gait comes to rest, s. The request ends earlier by this time.
const BRAKE: f32 = 0.4;

/// Walks a little, in steps so short that a stop can bring the feet together at once: a robot that froze in a step would fall.
#[derive(Debug)]
pub struct Walk {
    gait: Gait,
    /// What the robot measures in this cycle: feedback of the gait, and all angles.
    measured: Option<(Feedback, Joints)>,
    odometry: Odometry,
    /// Where the walk began, and its way: forward and left, m, and a turn to the left, rad.
    from: Pose2,
    way: [f32; 3],
    /// Remaining time until the legs are in the stand of the gait, s; `None` unless they move to it.
    left: Option<f32>,
    stiffness: f32,
}

#[component(hz = 100, budget_us = 20)]
impl Walk {
    pub(crate) const fn new() -> Self {
        let (gait, odometry) = (Gait::new(NAO, GAIT), Odometry::new(NAO, &NAO.dynamic_profile.odometry));
        Self { gait, measured: None, odometry, from: Pose2::ORIGIN, way: [0.0; 3], left: None, stiffness: STANDING }
    }

    /// Stores the measurements of this cycle. It must be called before the component runs.
    pub(crate) const fn measure(&mut self, feedback: Feedback, angles: Joints) {
        self.measured = Some((feedback, angles));
    }

    fn step(&mut self, time: &Time, motors: &mut Motors) {
        let Some((feedback, angles)) = self.measured else { return };
        let (feet, gyro_turn) = ([&feedback.left_foot, &feedback.right_foot], Some(feedback.gyro.z * time.dt()));
        self.odometry.step(&MotionInput { commanded: Some(motors.targets()), angles: &angles, feet, gyro_turn });
        let mut legs = *motors.targets();
        if let Some(left) = self.left {
            let share = (time.dt() / left).min(1.0);
            for (leg, stand) in legs.0.iter_mut().zip(GAIT.stand(NAO).joints(NAO).0) {
                *leg += share * (stand - *leg);
            }
            self.left = Some(left - time.dt()).filter(|left| *left > 0.0);
        } else if self.gait.phase() != Phase::Standing || (self.has_way() && motors.arms_rest()) {
            let request = self.request();
            legs = self.gait.step(request, &feedback, time.dt()).joints(NAO);
            self.stiffness = WALKING;
        } else {
            self.stiffness = (self.stiffness + time.dt() * STIFFENING).min(STANDING);
        }
        motors.set_legs(&legs, self.stiffness);
    }

    /// Returns the velocity toward the end of the path. Each axis ends when its remainder is small; zero at the end of all axes.
    fn request(&mut self) -> Velocity {
        let at = self.from.inverse() * self.odometry.pose();
        let mut request = [0.0; 3];
        for (axis, at) in [at.position.x, at.position.y, at.heading].into_iter().enumerate() {
            let (rest, speed) = (self.way[axis] - at, SPEED[axis]);
            if rest * self.way[axis].signum() <= BRAKE * speed {
                self.way[axis] = 0.0;
            }
            let correction = (CORRECTION * rest).clamp(-speed, speed);
            request[axis] = if self.way[axis] == 0.0 { correction } else { speed.copysign(rest) };
        }
        let [forward, left, turn] = request;
        if self.has_way() { Velocity::new(forward, left, turn) } else { Velocity::ZERO }
    }

    /// Begins to walk as soon as the arms are at rest: forward and left, m, and a turn to the left, rad.
    pub(crate) fn begin(&mut self, way: [f32; 3]) {
        if !self.is_walking() {
            self.left = Some(RISE);
        }
        (self.from, self.way) = (self.odometry.pose(), way);
    }

    /// Ends the walk with the current step.
    pub(crate) fn halt(&mut self) {
        if self.has_way() {
            (self.way, self.left) = ([0.0; 3], None);
        }
    }

    /// Ends the walk at once: the legs move to the stand. Before the first step they stay where they are.
    pub(crate) fn freeze(&mut self) {
        self.halt();
        if self.gait.phase() != Phase::Standing {
            self.gait.reset();
            (self.left, self.stiffness) = (Some(LAND), LANDING);
        }
    }

    fn has_way(&self) -> bool {
        self.way.iter().any(|way| *way != 0.0)
    }

    /// Whether it walks, or the legs come to the stand.
    #[output]
    pub(crate) fn is_walking(&self) -> bool {
        self.has_way() || self.left.is_some() || self.gait.phase() != Phase::Standing
    }
}
