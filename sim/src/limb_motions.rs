//! Motions of limbs that an operator requests, in place of the commands of the robot's program.

use std::collections::VecDeque;

use bica_macros::ParamEnum;
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::RobotModel;
use bica_motion::robot::Command;
use bica_motion::side::Side;

use crate::world::CYCLE_SECONDS;

/// Number of joints of the largest limb.
pub(crate) const LIMB_JOINTS: usize = 6;
/// Maximum number of waiting motions of a limb.
const MAX_MOTIONS: usize = 2000;

/// A part of the body that is moved as one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ParamEnum)]
#[params(crate = bica_core)]
pub(crate) enum Limb {
    /// Yaw and pitch.
    Head,
    /// Shoulder pitch and roll, elbow yaw and roll, wrist, hand.
    LeftArm,
    /// Shoulder pitch and roll, elbow yaw and roll, wrist, hand.
    RightArm,
    /// Hip yaw, roll and pitch, knee, ankle pitch and roll.
    LeftLeg,
    /// Hip yaw, roll and pitch, knee, ankle pitch and roll.
    RightLeg,
}

impl Limb {
    fn joints(self, model: &'static RobotModel) -> [Option<Joint>; LIMB_JOINTS] {
        match self {
            Self::Head => [Some(Joint::HeadYaw), Some(Joint::HeadPitch), None, None, None, None],
            Self::LeftArm => Side::Left.arm().map(Some),
            Self::RightArm => Side::Right.arm().map(Some),
            Self::LeftLeg => model.leg_joints(Side::Left).map(Some),
            Self::RightLeg => model.leg_joints(Side::Right).map(Some),
        }
    }
}

/// Motion of a limb to given angles.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Motion {
    /// Duration, s.
    pub(crate) seconds: f32,
    /// Angles at the end, rad, in the order of the limb's joints.
    pub(crate) angles: [f32; LIMB_JOINTS],
    /// Stiffness, 0 to 1.
    pub(crate) stiffness: f32,
    /// Whether the speed is constant; otherwise the limb starts and ends at rest.
    pub(crate) even: bool,
}

/// Queue of the motions of one limb.
#[derive(Clone, Debug, Default)]
struct Queue {
    waiting: VecDeque<Motion>,
    /// Angles at which the first motion began, rad, and the number of cycles since then.
    begun: Option<([f32; LIMB_JOINTS], u32)>,
}

impl Queue {
    fn step(&mut self, now: [f32; LIMB_JOINTS]) -> Option<([f32; LIMB_JOINTS], f32)> {
        let motion = *self.waiting.front()?;
        let (from, cycle) = self.begun.map_or((now, 1), |(from, cycles)| (from, cycles + 1));
        let share = (cycle as f32 * CYCLE_SECONDS / motion.seconds).min(1.0);
        let eased = if motion.even { share } else { share * share * (3.0 - 2.0 * share) };
        self.begun = Some((from, cycle));
        // Half a cycle of tolerance, so that a sum of durations is not rounded up.
        if (cycle as f32 + 0.5) * CYCLE_SECONDS > motion.seconds {
            self.waiting.pop_front();
            self.begun = (!self.waiting.is_empty()).then_some((motion.angles, 0));
        }
        let angles = core::array::from_fn(|at| from[at] + eased * (motion.angles[at] - from[at]));
        Some((angles, motion.stiffness))
    }
}

/// Motions of all limbs. A limb without a motion follows the command of the robot's program.
#[derive(Clone, Debug, Default)]
pub(crate) struct LimbMotions([Queue; 5]);

impl LimbMotions {
    /// Adds a motion after the waiting motions of the limb.
    pub(crate) fn add(&mut self, limb: Limb, motion: Motion) -> Result<(), &'static str> {
        let Queue { waiting, .. } = &mut self.0[limb as usize];
        if waiting.len() >= MAX_MOTIONS {
            return Err("2000 motions of this limb wait already");
        }
        waiting.push_back(motion);
        Ok(())
    }

    /// The command of a cycle, with these motions over that of the program. `angles` are measured.
    pub(crate) fn over(&mut self, model: &'static RobotModel, command: &Command, angles: &Joints) -> Command {
        let mut command = *command;
        let limbs = [Limb::Head, Limb::LeftArm, Limb::RightArm, Limb::LeftLeg, Limb::RightLeg];
        for (limb, queue) in limbs.into_iter().zip(&mut self.0) {
            let joints = limb.joints(model);
            let now = joints.map(|joint| joint.map_or(0.0, |joint| angles[joint]));
            let Some((targets, stiffness)) = queue.step(now) else { continue };
            for (joint, target) in joints.into_iter().zip(targets).filter_map(|(joint, target)| Some((joint?, target)))
            {
                command.targets[joint] = model.limits[joint].clamp(target);
                command.stiffness[joint] = stiffness;
            }
        }
        command
    }
}
