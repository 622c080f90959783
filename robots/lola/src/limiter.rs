//! Commands within what the robot may be sent.

use bica_motion::bounds::clamp;
use bica_motion::head::{HeadAngles, pitch_range};
use bica_motion::joints::{Joint, Joints};
use bica_motion::model::NAO;

use crate::CYCLE_SECONDS;

/// Largest rise of the stiffness from one map to the next: from 0 to 1 in 0.6 s.
const MAX_RISE: f32 = 0.02;
/// Largest distance of a target from the measured angle at which a limp joint becomes stiff, rad. Half of what may be sent.
const MAX_START: f32 = 0.1;

/// Limiter of targets and stiffness from one actuator map to the next.
///
/// Targets are within the ranges of the joints and of the head's shell, and move at most at the top speed of each joint. A limp joint
/// follows its measured angle; it becomes stiff where it is, and gradually.
#[derive(Clone, Copy, Debug, Default)]
pub struct Limiter {
    /// Targets and stiffness of the last map; `None` before the first one of a connection.
    last: Option<(Joints, Joints)>,
}

impl Limiter {
    /// Forgets the last map: the robot may have been moved.
    pub const fn reset(&mut self) {
        self.last = None;
    }

    /// A limiter whose last map had these targets (rad) and this stiffness (0 to 1).
    pub(crate) const fn after(targets: Joints, stiffness: Joints) -> Self {
        Self { last: Some((targets, stiffness)) }
    }

    /// Targets of the last map, rad; the measured angles before the first one.
    #[must_use]
    pub fn targets(&self, measured: &Joints) -> Joints {
        self.last.map_or_else(|| within_ranges(measured, measured), |(targets, _)| targets)
    }

    /// Stiffness of the last map, 0 to 1.
    #[must_use]
    pub fn stiffness(&self) -> Joints {
        self.last.map_or(Joints::all(0.0), |(_, stiffness)| stiffness)
    }

    /// Limits targets (rad) and stiffness (0 to 1) for the next map, from the measured angles (rad) of this cycle. A value that is not
    /// finite keeps the last one.
    pub fn limit(&mut self, targets: &Joints, stiffness: &Joints, measured: &Joints) -> (Joints, Joints) {
        let from = self.targets(measured);
        let was_stiff = self.stiffness();
        let (mut goals, mut stiff) = (*measured, Joints::all(0.0));
        for joint in Joint::ALL {
            let requested =
                if stiffness[joint].is_nan() { was_stiff[joint] } else { clamp(stiffness[joint], 0.0, 1.0) };
            let may_start = was_stiff[joint] > 0.0 || (from[joint] - measured[joint]).abs() <= MAX_START;
            if may_start {
                stiff[joint] = requested.min(was_stiff[joint] + MAX_RISE);
            }
            if was_stiff[joint] > 0.0 && stiff[joint] > 0.0 {
                goals[joint] = if targets[joint].is_finite() { targets[joint] } else { from[joint] };
            }
        }
        let goals = within_ranges(&goals, &from);
        // The head's pitch stays within the range at the yaw that is reached in this map: the range narrows by less than a step of the
        // pitch while the yaw makes one.
        let mut next = from.moved_toward(NAO, &goals, CYCLE_SECONDS);
        let pitch = pitch_range(NAO, next[Joint::HeadYaw]).clamp(goals[Joint::HeadPitch]);
        let most = NAO.max_speeds[Joint::HeadPitch] * CYCLE_SECONDS;
        next[Joint::HeadPitch] = from[Joint::HeadPitch] + clamp(pitch - from[Joint::HeadPitch], -most, most);
        // Sums of rounded numbers may lie beyond a limit by their last digit.
        let next = within_ranges(&next, &from);
        self.last = Some((next, stiff));
        (next, stiff)
    }
}

/// Angles within the ranges of the joints and of the head's shell; `otherwise` (rad) in place of what is not finite.
fn within_ranges(angles: &Joints, otherwise: &Joints) -> Joints {
    let mut finite = *angles;
    for joint in Joint::ALL {
        if !finite[joint].is_finite() {
            finite[joint] = otherwise[joint];
        }
    }
    let mut clamped = finite.clamp_to_limits(NAO);
    HeadAngles::read(&clamped).clamped(NAO).write(&mut clamped);
    clamped
}

#[cfg(test)]
mod tests {
    use proptest::prelude::*;

    use super::*;

    /// Rule A.4 of the interface, with its own margins: 1.5 times the top speed and 0.02 rad.
    fn check(before: Option<(Joints, Joints)>, (now, stiffness): (Joints, Joints), measured: &Joints) {
        let head = HeadAngles::read(&now);
        assert!(
            pitch_range(NAO, head.yaw).min - 1e-4 <= head.pitch && head.pitch <= pitch_range(NAO, head.yaw).max + 1e-4
        );
        assert!(now.within_limits(NAO), "{now:?}");
        for joint in Joint::ALL {
            assert!((0.0..=1.0).contains(&stiffness[joint]));
            let was_stiff = before.map_or(0.0, |(_, stiffness)| stiffness[joint]);
            if was_stiff <= 0.0 && stiffness[joint] > 0.0 {
                assert!((now[joint] - measured[joint]).abs() <= 0.2, "{joint:?} starts far away");
            }
            if let Some((before, _)) = before {
                let way = (now[joint] - before[joint]).abs();
                assert!(way <= 1.001 * NAO.max_speeds[joint] * CYCLE_SECONDS + 1e-5, "{joint:?} moves by {way}");
            }
        }
    }

    proptest! {
        #[test]
        fn any_commands_are_limited(
            steps in prop::collection::vec(
                (prop::collection::vec(-4.0_f32..4.0, 25), prop::collection::vec(-0.5_f32..1.5, 25), -0.3_f32..0.3),
                1..60,
            ),
        ) {
            let mut limiter = Limiter::default();
            let mut measured = NAO.stand;
            let mut before = None;
            for (targets, stiffness, slip) in steps {
                let targets = Joints(targets.try_into().expect("25 targets"));
                let stiffness = Joints(stiffness.try_into().expect("25 values"));
                let now = limiter.limit(&targets, &stiffness, &measured);
                check(before, now, &measured);
                before = Some(now);
                // The joints follow, and a person moves the robot.
                measured = Joints(now.0.0.map(|angle| angle + slip)).clamp_to_limits(NAO);
            }
        }
    }

    #[test]
    fn limp_joint_becomes_stiff_where_it_is() {
        let mut limiter = Limiter::default();
        let (mut measured, stiffness) = (NAO.sit, Joints::all(0.8));
        let (first, stiff) = limiter.limit(&NAO.stand, &stiffness, &measured);
        assert_eq!(first, within_ranges(&measured, &measured));
        assert!(stiff.0.iter().all(|&stiff| (stiff - MAX_RISE).abs() < 1e-6));
        // Limp again, and moved by hand: the targets follow before the joint becomes stiff.
        limiter.limit(&NAO.stand, &Joints::all(0.0), &measured);
        measured[Joint::LKneePitch] -= 1.0;
        let (_, stiff) = limiter.limit(&NAO.stand, &stiffness, &measured);
        assert_eq!((stiff[Joint::LKneePitch] > 0.0, stiff[Joint::RKneePitch] > 0.0), (false, true));
    }

    #[test]
    fn numbers_that_are_not_finite_change_nothing() {
        let mut limiter = Limiter::default();
        let wrong = Joints::all(f32::NAN);
        for _ in 0..60 {
            limiter.limit(&NAO.stand, &Joints::all(0.5), &NAO.stand);
        }
        let before = limiter.last.expect("it has limited");
        assert_eq!(limiter.limit(&wrong, &wrong, &NAO.stand), before);
        let infinite = Joints::all(f32::INFINITY);
        assert_eq!(limiter.limit(&infinite, &Joints::all(0.5), &NAO.stand), before);
    }
}
