//! The seven movements as key postures of arms and head.
//!
//! The ranges are those of the movements that the group of the paper used in its sessions. One differs from that of a
//! person, because the shoulder roll of the robot ends at 76°: `arms_open` ends a little below the height of the
//! shoulders.

use bica_motion::joints::Joint;

use crate::session::Movement;

/// Angles of some joints, degrees; all others are as at rest.
pub(super) type Key = &'static [(Joint, f32)];

/// Number of repetitions of a movement's keys.
pub(super) const ROUNDS: usize = 3;

/// Key postures of a movement, in order. Each round begins at rest, and the last one ends at rest.
pub(super) const fn keys(movement: Movement) -> &'static [Key] {
    use Joint::{
        HeadPitch, HeadYaw, LElbowRoll, LElbowYaw, LShoulderPitch, LShoulderRoll, RElbowRoll, RElbowYaw,
        RShoulderPitch, RShoulderRoll,
    };
    match movement {
        Movement::ArmsAlternately => {
            &[&[(LShoulderPitch, -61.0), (RShoulderPitch, 90.0)], &[(LShoulderPitch, 90.0), (RShoulderPitch, -61.0)]]
        }
        Movement::ArmsTogether => {
            &[&[(LShoulderPitch, -49.0), (RShoulderPitch, -49.0)], &[(LShoulderPitch, 88.0), (RShoulderPitch, 88.0)]]
        }
        Movement::ArmsOpen => {
            &[&[(LShoulderRoll, 71.0), (RShoulderRoll, -71.0)], &[(LShoulderRoll, 7.0), (RShoulderRoll, -7.0)]]
        }
        Movement::TouchShoulder => {
            &[&[(LShoulderPitch, 20.0), (LElbowRoll, -86.0)], &[], &[(RShoulderPitch, 20.0), (RElbowRoll, 86.0)], &[]]
        }
        Movement::TurnPalms => &[
            &[(LShoulderPitch, 40.0), (RShoulderPitch, 40.0), (LElbowYaw, -94.0), (RElbowYaw, 94.0)],
            &[(LShoulderPitch, 40.0), (RShoulderPitch, 40.0), (LElbowYaw, 94.0), (RElbowYaw, -94.0)],
        ],
        Movement::Nod => &[&[(HeadPitch, -37.0)], &[(HeadPitch, 28.0)]],
        Movement::TurnHead => &[&[(HeadYaw, 95.0)], &[(HeadYaw, -95.0)]],
    }
}
