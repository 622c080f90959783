//! Postures: how high the hips are, and motions from one posture to another.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::sole;
use bica_motion::model::NAO;
use bica_motion::side::Side;

use crate::CYCLE_SECONDS;
use crate::sensor_map::SensorMap;

/// Largest height of the hips over the soles in a robot that sits, m. It cannot fall far from there.
pub const SITTING_HEIGHT: f32 = 0.175;
/// Tilt of a torso that lies, or falls beyond what a motion can stop, rad.
const LYING: f32 = 0.7;

/// Height of the hips over the lower sole, m, from angles of the joints, rad.
#[must_use]
pub fn hip_height(angles: &Joints) -> f32 {
    let [left, right] = Side::BOTH.map(|side| -sole(NAO, side, angles).translation.z);
    left.max(right)
}

/// Whether the robot can lose its stiffness without a fall: it sits, or lies already.
#[must_use]
pub(crate) fn is_low(map: &SensorMap) -> bool {
    is_lying(map) || hip_height(&map.positions()) <= SITTING_HEIGHT
}

/// Whether the torso lies, or falls.
pub(crate) fn is_lying(map: &SensorMap) -> bool {
    map.angles.iter().any(|angle| angle.abs() > LYING)
}

/// Whether a joint belongs to a leg.
pub(crate) const fn is_in_leg(joint: Joint) -> bool {
    matches!(joint.index(), 7..=17)
}

/// Motion of all joints from rest to rest.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Transition {
    from: Joints,
    to: Joints,
    /// Duration, s.
    seconds: f32,
    /// Time since the start, s.
    time: f32,
}

impl Transition {
    pub(crate) const fn new(from: Joints, to: Joints, seconds: f32) -> Self {
        Self { from, to, seconds, time: 0.0 }
    }

    /// Targets of the next cycle, rad.
    pub(crate) fn step(&mut self) -> Joints {
        self.time += CYCLE_SECONDS;
        let t = (self.time / self.seconds).min(1.0);
        let share = t * t * (3.0 - 2.0 * t);
        let mut targets = self.from;
        for (target, goal) in targets.0.iter_mut().zip(self.to.0) {
            *target += share * (goal - *target);
        }
        targets
    }

    pub(crate) fn is_done(&self) -> bool {
        self.time >= self.seconds
    }
}

#[cfg(test)]
mod tests {

    use super::*;

    #[test]
    fn sitting_posture_is_low_and_standing_is_not() {
        assert!(hip_height(&NAO.sit) <= SITTING_HEIGHT - 0.02, "{}", hip_height(&NAO.sit));
        assert!(hip_height(&NAO.stand) > 0.2);
        assert!((hip_height(&Joints::all(0.0)) - 0.248_09).abs() < 1e-4, "straight legs, from the lengths of the NAO");
    }

    #[test]
    fn lifted_foot_does_not_lower_the_hips() {
        let mut angles = NAO.stand;
        for (joint, angle) in [(Joint::RHipPitch, -1.5), (Joint::RKneePitch, 2.1)] {
            angles[joint] = angle;
        }
        assert!(hip_height(&angles) > 0.2);
    }

    #[test]
    fn transition_begins_and_ends_at_rest() {
        let mut transition = Transition::new(NAO.stand, NAO.sit, 2.0);
        let (mut last, mut fastest) = (NAO.stand, 0.0_f32);
        let first = transition.step();
        assert!((first[Joint::LKneePitch] - NAO.stand[Joint::LKneePitch]).abs() < 1e-3);
        while !transition.is_done() {
            let next = transition.step();
            fastest = fastest.max((next[Joint::LKneePitch] - last[Joint::LKneePitch]).abs());
            last = next;
        }
        assert!(last == NAO.sit && fastest < 0.012, "{fastest}");
    }
}
