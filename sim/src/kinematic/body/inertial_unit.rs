//! The inertial unit in the torso.

use bica_motion::model::RobotModel;
use bica_motion::robot::Inertial;
use glam::{Affine3A, Vec3, Vec3A};

use crate::random::Random;
use crate::world::CYCLE_SECONDS;
use bica_body::sensor_model::{ACCELEROMETER_RANGE, GRAVITY, measure_inertia};
use bica_body::transform::angular_velocity;

/// Filter gain of the acceleration per cycle: the structure damps the steps of the quasi-static motion (our estimate).
const ACCELERATION_GAIN: f32 = 0.2;
/// State of the inertial unit.
#[derive(Clone, Debug)]
pub(crate) struct InertialUnit {
    /// Robot frame in the previous cycle, field frame.
    previous: Affine3A,
    velocity: Vec3,
    acceleration: Vec3,
}

impl InertialUnit {
    /// Returns the unit of a robot at rest with this pose of the robot frame.
    pub(crate) const fn still(robot: Affine3A) -> Self {
        Self { previous: robot, velocity: Vec3::ZERO, acceleration: Vec3::ZERO }
    }

    /// Measures at the end of a cycle in which the robot frame moved to this pose.
    pub(crate) fn step(&mut self, model: &'static RobotModel, robot: &Affine3A, random: &mut Random) -> Inertial {
        let place = |pose: &Affine3A| pose.transform_point3(model.dimensions.inertial_unit);
        let velocity = (place(robot) - place(&self.previous)) / CYCLE_SECONDS;
        let acceleration = ((velocity - self.velocity) / CYCLE_SECONDS).clamp_length_max(ACCELEROMETER_RANGE);
        self.acceleration += ACCELERATION_GAIN * (acceleration - self.acceleration);
        let gyro = angular_velocity(&self.previous.matrix3, &robot.matrix3);
        self.velocity = velocity;
        self.previous = *robot;

        let specific_force = robot.matrix3.transpose() * Vec3A::from(self.acceleration + GRAVITY * Vec3::Z);
        let up = robot.matrix3.row(2).into();
        measure_inertia(gyro, specific_force.into(), up, |deviation| deviation * random.normal())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;
    use crate::random::Stream;

    #[test]
    fn unit_measures_gravity_and_angular_velocity() {
        let mut random = Random::new(3, Stream::Sensors);
        let mut unit = InertialUnit::still(Affine3A::from_rotation_y(0.2));
        let still = unit.step(TEST_MODEL, &Affine3A::from_rotation_y(0.2), &mut random);
        let lean = 0.2_f32;
        assert!((still.acceleration - GRAVITY * Vec3::new(-lean.sin(), 0.0, lean.cos())).length() < 0.1);
        assert!((still.pitch - 0.2).abs() < 0.01 && still.roll.abs() < 0.01);
        let turning = unit.step(TEST_MODEL, &Affine3A::from_rotation_y(0.21), &mut random);
        assert!((turning.gyro - Vec3::new(0.0, 1.0, 0.0)).length() < 0.02, "{}", turning.gyro);
    }

    #[test]
    fn unit_measures_acceleration_of_torso() {
        let mut random = Random::new(3, Stream::Sensors);
        let mut unit = InertialUnit::still(Affine3A::IDENTITY);
        let mut measured = Vec3::ZERO;
        for cycle in 1..=40 {
            let time = cycle as f32 * CYCLE_SECONDS;
            let offset = Vec3::new(0.5 * 1.5 * time * time, 0.0, 0.0);
            measured = unit.step(TEST_MODEL, &Affine3A::from_translation(offset), &mut random).acceleration;
        }
        assert!((measured - Vec3::new(1.5, 0.0, GRAVITY)).length() < 0.15, "{measured}");
    }
}
