//! Whether a joint follows its target.

/// Minimum deviation of a stuck leg joint from its target, rad: nearly three times the lag in the fastest kick.
const DEVIATION: f32 = 0.65;
/// Minimum deviation of a stuck head joint, rad: its target moves slowly, and nothing loads it.
const HEAD_DEVIATION: f32 = 0.3;
/// The same of a head joint that does not move, rad.
const RESTING_HEAD_DEVIATION: f32 = 0.08;
/// Number of cycles of 10 ms after which a deviating joint is stuck.
const DEVIATION_CYCLES: u8 = 100;
/// Deviation from which on a leg joint that does not move is evidence, rad, and how much it is in a cycle of 10 ms. In a get-up the ground
/// holds hip rolls 0.3 rad from their targets for seconds. See [`RobotModel::stuck_evidence`](crate::model::RobotModel::stuck_evidence).
const RESTING: (f32, u8) = (0.3, 2);
/// The same of a robot that is not upright.
const RESTING_DOWN: (f32, u8) = (0.2, 1);
/// Least swing of a target, rad: the legs' swing in a walk is more.
const SWING: f32 = 0.04;
/// Number of swings to alternating sides after which a joint that has not moved is stuck. A motion that the ground blocks is one or two
/// swings: no joint had more in 100 games of the built-in world, nor in 12 games and 32 falls in MuJoCo.
const SWINGS: u8 = 4;
/// Range of the angles of a joint that does not move, rad: some steps of its encoder, and play.
pub(super) const STILL: f32 = 0.01;

/// Monitor of one joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Following {
    /// Number of cycles for which the joint has deviated.
    deviates: u8,
    /// Evidence since the joint moved last, see [`RESTING`].
    evidence: u8,
    /// Number of swings of the target since the joint moved last, and whether the present one is upwards.
    swings: u8,
    rises: bool,
    /// Greatest target of a swing upwards, least target of a swing downwards, so far, rad.
    turn: f32,
    /// Least and greatest angle since the joint moved last, rad.
    angles: [f32; 2],
}

impl Following {
    /// A joint that has moved to an angle, rad.
    pub(super) const fn at(angle: f32) -> Self {
        Self { deviates: 0, evidence: 0, swings: 0, rises: true, turn: angle, angles: [angle; 2] }
    }

    /// Processes the target and the angle of one cycle, rad; whether the joint is stuck. The ground may block a robot that is not upright:
    /// there only a joint that does not move is. With `enough` evidence it is stuck.
    pub(super) fn is_stuck(
        &mut self,
        target: f32,
        angle: f32,
        is_head: bool,
        upright: bool,
        enough: Option<u8>,
    ) -> bool {
        let has_moved = self.moves(angle);
        if has_moved {
            *self = Self { deviates: self.deviates, turn: target, ..Self::at(angle) };
        }
        let most = match (upright, is_head, has_moved) {
            (false, ..) => f32::INFINITY,
            (true, false, _) => DEVIATION,
            (true, true, true) => HEAD_DEVIATION,
            (true, true, false) => RESTING_HEAD_DEVIATION,
        };
        let (resting, evidence) = if upright { RESTING } else { RESTING_DOWN };
        let deviation = (target - angle).abs();
        // A measurement that is no number deviates, too.
        let exceeds = |limit: f32| deviation > limit || deviation.is_nan();
        self.deviates = if exceeds(most) { self.deviates.saturating_add(1) } else { 0 };
        if exceeds(resting) && !is_head {
            self.evidence = self.evidence.saturating_add(evidence);
        }
        if upright {
            self.swing(target);
        }
        let rests = enough.is_some_and(|enough| self.evidence >= enough);
        rests || self.deviates >= DEVIATION_CYCLES || self.swings >= SWINGS
    }

    /// Processes the angle of a cycle, rad, in which the joint need not follow: what it did before still counts if it does not move.
    pub(super) fn pause(&mut self, angle: f32) {
        self.deviates = 0;
        if self.moves(angle) {
            *self = Self::at(angle);
        }
    }

    /// Extends the range of the angles; whether the joint has moved.
    fn moves(&mut self, angle: f32) -> bool {
        self.angles = [self.angles[0].min(angle), self.angles[1].max(angle)];
        self.angles[1] - self.angles[0] > STILL
    }

    fn swing(&mut self, target: f32) {
        let back = if self.rises { self.turn - target } else { target - self.turn };
        if back > SWING {
            (self.rises, self.turn, self.swings) = (!self.rises, target, self.swings.saturating_add(1));
        } else if back < 0.0 {
            self.turn = target;
        }
    }
}
