//! Weak legs, and what makes up for them.
//!
//! A motor holds its joint like a spring: under load the joint stays behind its target, in a weak or worn leg farther
//! than in a strong one. Then the hips sink toward the swinging foot, which clears the ground no more, and the robot
//! stumbles over it. The knee tells best how weak a leg is: whatever the body does, its weight bends the knee that carries
//! it. So each leg's knee is compared with its target while that leg alone carries.

use crate::bounds::clamp;
use crate::kinematics::LegAngles;
use crate::side::Side;
use crate::walk::{Feedback, Parameters};

/// From a target to its trace in what joints measure, cycles of 10 ms. Source: 36 ms, B-Human 2023.
const LATE: usize = 4;
/// Share of a new measurement in the smoothed one, per cycle with all weight on the leg: some steps count.
const NEW: f32 = 0.02;
/// A knee farther from its target than this is not under load but blocked, or its sensor is broken, rad.
const FARTHEST: f32 = 0.4;
/// The least force on a foot that carries all weight, N.
const CARRIES: f32 = 30.0;
/// The most that is made up for, rad: a knee bends so far at a third of its usual strength.
const MOST: f32 = 0.1;

/// How weak each leg is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct SagCompensation {
    /// What both knees were told in the last cycles, left first, the oldest first, rad.
    commanded: [[f32; 2]; LATE],
    /// How much farther each knee bends under the body than it was told, smoothed, rad.
    sag: [f32; 2],
}

impl SagCompensation {
    /// Legs as strong as the gait expects.
    pub(super) const fn new() -> Self {
        Self { commanded: [[0.0; 2]; LATE], sag: [0.0; 2] }
    }

    /// Compares the knee of the leg that is to carry with what it was told, if that leg alone does carry.
    pub(super) fn measure(&mut self, carrying: Side, feedback: &Feedback, gait: &Parameters) {
        let alone = feedback.force(carrying) >= CARRIES && feedback.force(carrying.other()) < gait.contact_force;
        let Some(knees) = feedback.knees.filter(|_| alone) else { return };
        let side = carrying.index();
        let bent = knees[side] - self.commanded[0][side];
        // False for what is no number, too.
        if bent.abs() < FARTHEST {
            self.sag[side] += NEW * (bent - self.sag[side]);
        }
    }

    /// Strengthens the leg that carries this `share` of the body: its hip lifts the other side, its knee straightens.
    pub(super) fn compensate(&self, leg: &mut LegAngles, carrying: Side, share: f32, gait: &Parameters) {
        let weak = share * clamp(self.sag[carrying.index()] - gait.expected_knee_sag, 0.0, MOST);
        leg.hip_roll += carrying.sign() * gait.sag_hip_gain * weak;
        leg.knee_pitch -= gait.sag_knee_gain * weak;
    }

    /// Remembers what the legs are told in this cycle.
    pub(super) fn record(&mut self, legs: &[LegAngles; 2]) {
        self.commanded.rotate_left(1);
        self.commanded[LATE - 1] = [legs[0].knee_pitch, legs[1].knee_pitch];
    }
}
