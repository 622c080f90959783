//! Motors: joints follow their targets late and no faster than they can.

use bica_motion::head::HeadAngles;
use bica_motion::joints::{JOINTS, Joint, Joints};
use bica_motion::model::{Nao, RobotModel};
use bica_motion::robot::Command;

use crate::motor_heat::MotorHeat;
use crate::world::CYCLE_SECONDS;

/// Cycles from a command to the first motion.
const DELAY: usize = (Nao::DEAD_TIME / CYCLE_SECONDS + 0.5) as usize;
/// From this stiffness on a joint reaches its full speed; below, proportionally less (our estimate).
const FULL_SPEED: f32 = 0.2;

/// What motors draw to hold the legs that carry the robot, to hold anything else, and in addition to turn at full speed:
/// shares of what they bear for good. Our estimate; this world knows no forces.
const DRAWN: [f32; 3] = [0.4, 0.1, 0.6];

/// All motors of a robot.
#[derive(Clone, Debug)]
pub(crate) struct Motors {
    angles: Joints,
    /// Commands on their way, the oldest at `next`.
    waiting: [(Joints, Joints); DELAY],
    next: usize,
    heat: MotorHeat,
}

impl Motors {
    /// Motors that hold these angles.
    pub(crate) fn holding(angles: Joints) -> Self {
        Self { angles, waiting: [(angles, Joints::all(1.0)); DELAY], next: 0, heat: MotorHeat::new() }
    }

    /// True angles now, rad.
    pub(crate) const fn angles(&self) -> &Joints {
        &self.angles
    }

    /// How hot the motors are and what they draw.
    pub(crate) const fn heat(&self) -> &MotorHeat {
        &self.heat
    }

    /// Makes a motor that hot, °C.
    pub(crate) fn heat_up(&mut self, joint: Joint, temperature: f32) {
        self.heat.set(joint, temperature);
    }

    /// The stiffness that acts now.
    pub(crate) fn stiffness(&self, joint: Joint) -> f32 {
        self.waiting[(self.next + DELAY - 1) % DELAY].1[joint]
    }

    /// Turns the joints for one cycle. Targets beyond the limits stop there; what is no number moves nothing.
    pub(crate) fn step(&mut self, command: &Command) {
        let due = core::mem::replace(&mut self.waiting[self.next], (command.targets, command.stiffness));
        self.next = (self.next + 1) % DELAY;
        let before = self.angles;
        let moved = self.angles.moved_toward::<Nao>(&due.0, CYCLE_SECONDS).clamp_to_limits::<Nao>();
        for i in 0..JOINTS {
            let strength = (due.1.0[i] / FULL_SPEED).clamp(0.0, 1.0);
            if strength > 0.0 {
                self.angles.0[i] += strength * (moved.0[i] - self.angles.0[i]);
            }
        }
        HeadAngles::read(&self.angles).clamped::<Nao>().write(&mut self.angles);
        self.heat.step(drawn(&before, &self.angles, &due.1));
    }
}

/// The currents of a cycle between these angles at this stiffness, A.
fn drawn(before: &Joints, after: &Joints, stiffness: &Joints) -> Joints {
    let [legs, others, full_speed] = DRAWN;
    Joints(Joint::ALL.map(|joint| {
        let held = if (7..=17).contains(&joint.index()) { legs } else { others };
        let speed = (after[joint] - before[joint]).abs() / CYCLE_SECONDS / Nao::MAX_SPEEDS[joint];
        let firmness = if stiffness[joint] > 0.0 { stiffness[joint].min(1.0) } else { 0.0 };
        Nao::CONTINUOUS_CURRENTS[joint] * (held * firmness + full_speed * speed)
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use bica_motion::robot::{CameraId, Lights};

    fn command(target: f32, stiffness: f32) -> Command {
        let (targets, stiffness) = (Joints::all(target), Joints::all(stiffness));
        Command { targets, stiffness, lights: Lights::default(), camera: CameraId::Top }
    }

    #[test]
    fn a_joint_moves_after_thirty_milliseconds_at_its_own_speed() {
        let mut motors = Motors::holding(Joints::all(0.3));
        for _ in 0..3 {
            motors.step(&command(0.9, 1.0));
            assert_eq!(motors.angles()[Joint::LKneePitch], 0.3);
        }
        motors.step(&command(0.9, 1.0));
        let moved = motors.angles()[Joint::LKneePitch] - 0.3;
        assert!((moved - Nao::MAX_SPEEDS[Joint::LKneePitch] * 0.01).abs() < 1e-6);
    }

    #[test]
    fn a_limp_joint_and_one_with_a_wrong_target_stay() {
        for wrong in [command(0.5, 0.0), command(f32::NAN, 1.0), command(0.5, f32::NAN), command(0.5, -1.0)] {
            let held = Joints::all(0.0).clamp_to_limits::<Nao>();
            let mut motors = Motors::holding(held);
            for _ in 0..10 {
                motors.step(&wrong);
            }
            assert_eq!(*motors.angles(), held);
        }
    }

    #[test]
    fn no_joint_passes_its_limit() {
        let mut motors = Motors::holding(Joints::all(0.3));
        for _ in 0..300 {
            motors.step(&command(9.0, 1.0));
        }
        assert!(motors.angles().within_limits::<Nao>());
        let head = HeadAngles::read(motors.angles());
        assert_eq!(head, head.clamped::<Nao>());
    }
}
