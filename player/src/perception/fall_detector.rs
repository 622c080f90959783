//! Falls.

use bica::prelude::*;
use bica_motion::fall::{FallDetector as Detector, FallState, FallTuning};
use bica_motion::model::FallLimits;

use crate::MODEL;
use crate::input::RobotState;

/// Detection of falls.
#[derive(Params)]
#[params(check = Self::is_ordered)]
pub struct FallDetection {
    /// Pitch of the torso above which the robot falls forward.
    #[param(default = MODEL.fall_limits.forward_pitch, range = 0.1..=1.5, unit = "rad", step = 0.02)]
    forward_pitch: f32,
    /// Pitch of the torso below which the robot falls backward.
    #[param(default = MODEL.fall_limits.backward_pitch, range = -1.5..=-0.1, unit = "rad", step = 0.02)]
    backward_pitch: f32,
    /// Magnitude of the roll above which the robot falls to a side.
    #[param(default = MODEL.fall_limits.roll, range = 0.1..=1.5, unit = "rad", step = 0.02)]
    side_roll: f32,
    /// Maximum tilt of a robot that has got up.
    #[param(default = 0.3, range = 0.05..=1.0, unit = "rad", step = 0.02)]
    risen_tilt: f32,
    /// Time within that tilt after which the robot counts as upright.
    #[param(default = 0.3, range = 0.0..=5.0, unit = "s", step = 0.05)]
    risen_time: f32,
    /// Maximum difference from the acceleration of a lying robot.
    #[param(default = 7.0, range = 1.0..=9.8, unit = "m/s²", step = 0.1)]
    lying_tolerance: f32,
    /// Time after which a falling robot counts as fallen in any case.
    #[param(default = 1.0, range = 0.1..=5.0, unit = "s", step = 0.1)]
    max_fall_time: f32,
}

impl FallDetection {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        let nearest = self.forward_pitch.min(-self.backward_pitch).min(self.side_roll);
        if self.risen_tilt < nearest {
            Ok(())
        } else {
            Err("`risen_tilt` must be below the limits of pitch and roll, or a robot that has got up falls at once")
        }
    }

    const fn tuning(&self) -> FallTuning {
        FallTuning {
            limits: FallLimits {
                backward_pitch: self.backward_pitch,
                forward_pitch: self.forward_pitch,
                roll: self.side_roll,
            },
            risen_tilt: self.risen_tilt,
            risen_time: self.risen_time,
            lying_tolerance: self.lying_tolerance,
            max_fall_time: self.max_fall_time,
        }
    }
}

/// Detects a fall before its end, and the side on which the robot lies.
#[derive(Debug)]
pub struct FallDetector {
    detector: Detector,
}

#[component(budget_us = 2)]
impl FallDetector {
    /// Creates the component with an upright robot.
    #[must_use]
    pub const fn new() -> Self {
        Self { detector: Detector::new(MODEL) }
    }

    fn step(&mut self, tuned: &Tuned<FallDetection>, time: &Time, state: &RobotState) {
        self.detector.set_tuning(&tuned.tuning());
        self.detector.step(state.inertial(), time.dt());
    }

    /// The state of the balance: upright, falling or fallen, with the side.
    #[output]
    #[must_use]
    pub const fn state(&self) -> FallState {
        self.detector.state()
    }

    /// Whether the robot falls or lies.
    #[output]
    #[must_use]
    pub fn is_down(&self) -> bool {
        self.state() != FallState::Upright
    }
}

#[cfg(test)]
mod tests {
    use bica_motion::joints::{JOINTS, Joints};
    use bica_motion::robot::{Inertial, Sensors};

    use super::*;
    use crate::output::JointCommand;

    #[test]
    fn default_values_are_those_of_robot() {
        assert_eq!(FallDetection::DEFAULT.tuning(), FallTuning::of(MODEL));
    }

    #[test]
    fn robot_after_get_up_is_within_limits() {
        let detection = || FallDetection::DEFAULT;
        assert!(FallDetection { risen_tilt: 0.4, ..detection() }.is_ordered().is_err());
        assert!(FallDetection { forward_pitch: 0.3, ..detection() }.is_ordered().is_err());
        assert!(FallDetection { backward_pitch: -0.31, side_roll: 0.31, ..detection() }.is_ordered().is_ok());
    }

    #[test]
    fn wider_limit_detects_same_tilt_as_upright() {
        let mut state = RobotState::new();
        let sensors = Sensors { inertial: Inertial { pitch: 0.7, ..Inertial::default() }, ..Sensors::UNMEASURED };
        state.measure(&sensors, &JointCommand { targets: Joints([0.0; JOINTS]), stiffness: Joints([1.0; JOINTS]) });
        for (forward_pitch, is_down) in [(0.6, true), (0.8, false)] {
            let mut detector = FallDetector::new();
            let tuned = Tuned::new(FallDetection { forward_pitch, ..FallDetection::DEFAULT });
            (0..5).for_each(|_| detector.step(&tuned, &crate::behaviour::test_time(10), &state));
            assert_eq!(detector.is_down(), is_down, "limit {forward_pitch} rad");
        }
    }
}
