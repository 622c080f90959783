//! Motors that get warm.

use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::{Actuator, Nao, RobotModel};

use crate::world::CYCLE_SECONDS;

/// The hall, and a motor that did nothing yet, °C.
const HALL: f32 = 25.0;
/// How much warmer than the hall a motor becomes that loses in its coil what it may lose for good, K. Our estimate: 85 °C,
/// where a NAO's firmware has weakened it for long.
const RISE: f32 = 60.0;
/// How fast it becomes so, s. Our estimate: a motor of 22 mm in a shell; teams report hot knees after a half of ten minutes.
const SLOWNESS: f32 = 600.0;

/// Currents and temperatures of all motors: each motor and its gear as one body that is heated in proportion to the square
/// of the current and cools in proportion to how much warmer it is than the hall.
#[derive(Clone, Debug)]
pub(crate) struct MotorHeat {
    temperatures: Joints,
    currents: Joints,
    /// The current at which each motor becomes [`RISE`] warmer, A.
    bears: Joints,
}

impl MotorHeat {
    /// Motors that did nothing yet.
    pub(crate) fn new() -> Self {
        let bears = Joints(Joint::ALL.map(bears));
        Self { temperatures: Joints::all(HALL), currents: Joints::all(0.0), bears }
    }

    /// Lets a control cycle pass in which the motors draw these currents, A.
    pub(crate) fn step(&mut self, currents: Joints) {
        self.currents = currents;
        for i in 0..JOINTS {
            let share = currents.0[i] / self.bears.0[i];
            let goal = HALL + RISE * share * share;
            self.temperatures.0[i] += CYCLE_SECONDS / SLOWNESS * (goal - self.temperatures.0[i]);
        }
    }

    /// Makes a motor that hot, °C.
    pub(crate) fn set(&mut self, joint: Joint, temperature: f32) {
        self.temperatures[joint] = temperature;
    }

    /// What the motors draw, A.
    pub(crate) const fn currents(&self) -> Joints {
        self.currents
    }

    /// What the robot tells of its temperatures: whole degrees, °C.
    pub(crate) fn temperatures(&self) -> Joints {
        Joints(self.temperatures.0.map(libm::floorf))
    }
}

/// What the motor of a joint bears for good: as its maker says; but what warms is the loss in the coil. For the pitch of the
/// shoulder 2.6 mNm are given, an eighth of what it stalls at: a loss of 0.4 W where the other motors of the arm, no larger,
/// bear 3 W. It is taken to bear what they do.
fn bears(joint: Joint) -> f32 {
    let motor = Nao::ACTUATORS[joint];
    let of = match joint {
        Joint::LShoulderPitch | Joint::RShoulderPitch => Nao::ACTUATORS[Joint::LShoulderRoll],
        _ => motor,
    };
    libm::sqrtf(loss(&of) / motor.resistance())
}

/// What a motor may lose in its coil for good, W.
fn loss(motor: &Actuator) -> f32 {
    motor.resistance() * motor.continuous_current() * motor.continuous_current()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_minute_s_push_warms_the_motors_of_an_arm_alike() {
        let mut heat = MotorHeat::new();
        let blocked = Joints(Joint::ALL.map(|joint| Nao::ACTUATORS[joint].current(1.3)));
        for _ in 0..6000 {
            heat.step(blocked);
        }
        for joint in [Joint::LShoulderPitch, Joint::LShoulderRoll, Joint::RElbowRoll] {
            let warm = heat.temperatures()[joint];
            assert!((35.0..45.0).contains(&warm), "{joint:?}: {warm}");
        }
    }

    #[test]
    fn a_motor_at_its_continuous_current_gets_too_hot_in_minutes_and_cools_as_slowly() {
        let mut heat = MotorHeat::new();
        let minutes = |heat: &mut MotorHeat, minutes: u32, currents: Joints| {
            for _ in 0..6000 * minutes {
                heat.step(currents);
            }
            heat.temperatures()[Joint::LKneePitch]
        };
        let after_ten = minutes(&mut heat, 10, *Nao::CONTINUOUS_CURRENTS);
        assert!((60.0..65.0).contains(&after_ten), "{after_ten}");
        let at_last = minutes(&mut heat, 60, *Nao::CONTINUOUS_CURRENTS);
        assert!((83.0..=85.0).contains(&at_last), "{at_last}");
        let rested = minutes(&mut heat, 10, Joints::all(0.0));
        assert!((45.0..50.0).contains(&rested), "{rested}");
    }
}
