//! Some steps.

use bica::prelude::*;
use bica_motion::joints::Joints;
use bica_motion::model::{Nao, RobotModel};
use bica_motion::odometry::{MotionInput, Odometry};
use bica_motion::pose::Pose2;
use bica_motion::walk::{Feedback, Parameters, Phase, Velocity, Walk as Gait};

use super::motors::{Motors, REST};

const GAIT: &Parameters = &Nao::DYNAMIC_PROFILE.gait;
/// Forward and lateral speed, m/s, and turn rate, rad/s: slow, beside people.
const SPEED: [f32; 3] = [0.08, 0.05, 0.4];
/// Time in which the legs change from the stand to that of the gait before the first step, s.
const RISE: f32 = 1.0;
/// Stiffness of the legs.
const STANDING: f32 = 0.75;
const WALKING: f32 = 1.0;

/// Time in which the gait comes to rest, by which the request ends earlier, s.
const BRAKE: f32 = 0.4;

/// Walks a little. A stop ends it with the feet together: a robot that froze in a step would fall.
#[derive(Debug)]
pub struct Walk {
    gait: Gait<Nao>,
    /// What the robot measures in this cycle: feedback of the gait, and all angles.
    measured: Option<(Feedback, Joints)>,
    odometry: Odometry<Nao>,
    /// Where the walk began, and its way: forward and left, m, and a turn to the left, rad.
    from: Pose2,
    way: [f32; 3],
    /// Share of the change of the legs to the stand of the gait.
    risen: f32,
}

#[component(hz = 100, budget_us = 20)]
impl Walk {
    pub(crate) const fn new() -> Self {
        let (gait, odometry) = (Gait::new(GAIT), Odometry::new(&Nao::DYNAMIC_PROFILE.odometry));
        Self { gait, measured: None, odometry, from: Pose2::ORIGIN, way: [0.0; 3], risen: 0.0 }
    }

    /// Takes the measurements of this cycle, before it is stepped.
    pub(crate) const fn measure(&mut self, feedback: Feedback, angles: Joints) {
        self.measured = Some((feedback, angles));
    }

    fn step(&mut self, time: &Time, motors: &mut Motors) {
        let Some((feedback, angles)) = self.measured else { return };
        let (feet, gyro_turn) = ([&feedback.left_foot, &feedback.right_foot], Some(feedback.gyro.z * time.dt()));
        let commanded = Some(motors.targets());
        self.odometry.step(&MotionInput { commanded, angles: &angles, feet, gyro_turn });
        if self.has_way() && self.risen < 1.0 {
            self.risen = (self.risen + time.dt() / RISE).min(1.0);
        }
        let walks = self.risen >= 1.0 && self.is_walking();
        let limbs = if walks {
            let request = self.request();
            self.gait.step(request, &feedback, time.dt())
        } else {
            GAIT.stand::<Nao>()
        };
        let (mut legs, to) = (REST, limbs.joints::<Nao>());
        for (leg, to) in legs.0.iter_mut().zip(to.0) {
            *leg += self.risen * (to - *leg);
        }
        motors.set_legs(&legs, if walks { WALKING } else { STANDING });
    }

    /// The velocity to the end of the way, which ends once that is near.
    fn request(&mut self) -> Velocity {
        let at = self.from.inverse() * self.odometry.pose();
        let mut request = [0.0; 3];
        for (axis, at) in [at.position.x, at.position.y, at.heading].into_iter().enumerate() {
            let rest = self.way[axis] - at;
            if self.way[axis] != 0.0 && rest * self.way[axis].signum() > BRAKE * SPEED[axis] {
                request[axis] = SPEED[axis].copysign(rest);
            } else {
                self.way[axis] = 0.0;
            }
        }
        let [forward, left, turn] = request;
        Velocity::new(forward, left, turn)
    }

    /// Begins to walk: forward and left, m, and a turn to the left, rad.
    pub(crate) const fn begin(&mut self, way: [f32; 3]) {
        (self.from, self.way) = (self.odometry.pose(), way);
    }

    /// Ends the walk with the present step.
    pub(crate) const fn halt(&mut self) {
        self.way = [0.0; 3];
    }

    fn has_way(&self) -> bool {
        self.way.iter().any(|way| *way != 0.0)
    }

    /// Whether it walks, or has not yet brought the feet together.
    #[info]
    pub(crate) fn is_walking(&self) -> bool {
        self.has_way() || self.gait.phase() != Phase::Standing
    }
}
