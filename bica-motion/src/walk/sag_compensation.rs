//! Compensation of weak legs.
//!
//! A motor with proportional control holds its joint like a spring: under load the joint lags behind its target, more in a
//! weak or worn leg than in a strong one. The hips then sink toward the swing foot, which no longer clears the ground. The
//! knee indicates the strength of a leg best, because the weight always bends the knee of the support leg. So the knee of
//! each leg is compared with its target while that leg alone bears the weight.

use crate::bounds::clamp;
use crate::joints::Joint;
use crate::limbs::LegAngles;
use crate::model::{MAX_FEEDBACK_DELAY, Parameters, RobotModel};
use crate::side::Side;
use crate::walk::Feedback;

/// Weight of a new measurement in the low-pass filter, per cycle of single support: a time constant of a few steps.
const NEW_WEIGHT: f32 = 0.02;
/// Maximum difference between measured and commanded knee angle, rad. With more, the knee is blocked or its sensor broken.
const MAX_SAG: f32 = 0.4;
/// Maximum compensated sag, rad: a knee at a third of its usual strength.
const MAX_COMPENSATED_SAG: f32 = 0.1;

/// Estimate of the sag of both knees.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SagCompensation {
    /// Commanded angles of both knees (left first) in the last cycles, the oldest first, rad.
    commanded: [[f32; 2]; MAX_FEEDBACK_DELAY],
    /// Low-pass filtered difference between measured and commanded angle of each knee, rad.
    sag: [f32; 2],
}

impl SagCompensation {
    /// No sag.
    pub(super) const fn new() -> Self {
        Self { commanded: [[0.0; 2]; MAX_FEEDBACK_DELAY], sag: [0.0; 2] }
    }

    /// Compares the knee of the support leg with its delayed target, in single support only.
    pub(super) fn measure(&mut self, model: &RobotModel, support: Side, feedback: &Feedback, gait: &Parameters) {
        let alone =
            feedback.force(support) >= model.support_force && feedback.force(support.other()) < gait.contact_force;
        let Some(joints) = feedback.joints.as_ref().filter(|_| alone) else { return };
        let side = support.index();
        let sag = joints[[Joint::LKneePitch, Joint::RKneePitch][side]]
            - self.commanded[MAX_FEEDBACK_DELAY - model.feedback_delay.cycles()][side];
        // The comparison is false for NaN.
        if sag.abs() < MAX_SAG {
            self.sag[side] += NEW_WEIGHT * (sag - self.sag[side]);
        }
    }

    /// Adds the compensation to the support leg, which bears this `share` of the weight: the hip lifts the other side, the
    /// knee is extended.
    pub(super) fn compensate(&self, leg: &mut LegAngles, support: Side, share: f32, gait: &Parameters) {
        let sag = share * clamp(self.sag[support.index()] - gait.expected_knee_sag, 0.0, MAX_COMPENSATED_SAG);
        leg.hip_roll += support.sign() * gait.sag_hip_gain * sag;
        leg.knee_pitch -= gait.sag_knee_gain * sag;
    }

    /// Stores the knee angles commanded in this cycle.
    pub(super) fn record(&mut self, legs: &[LegAngles; 2]) {
        self.commanded.rotate_left(1);
        self.commanded[MAX_FEEDBACK_DELAY - 1] = [legs[0].knee_pitch, legs[1].knee_pitch];
    }
}
