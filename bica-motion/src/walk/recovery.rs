//! Place and time of the next footstep that catch a push.
//!
//! The *divergent component of motion* (DCM; the capture point of Pratt et al. 2006) is the position of the centre of mass plus
//! its velocity divided by the pendulum's natural frequency. Over a resting foot its distance from the foot grows with e^(ωt)
//! (Takenaka et al. 2009). Every cycle a quadratic program chooses the place of the next foot, e^(ω · remaining time), and the
//! offset of the DCM from that foot at touchdown, near their planned values (Khadiv et al. 2016). The measured DCM connects
//! the three by an equation, which eliminates the offset. For a given time the best place follows in closed form, so a
//! bisection over the time solves the program exactly, without a matrix.

use glam::Vec2;
use libm::{expf, logf};

use crate::model::Parameters;

/// Minimum time until a foot touches down, s.
const MIN_REMAINING: f32 = 0.03;
/// Number of bisections: the last one changes the time by less than 10 µs.
const BISECTIONS: usize = 18;

/// A step in progress. Positions in m from the support ankle, x forward, y toward the swing side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Situation {
    /// Measured DCM.
    pub dcm: Vec2,
    /// Planned place of the swing foot.
    pub place: Vec2,
    /// Planned offset of the DCM from that place at touchdown.
    pub offset: Vec2,
    /// Time since the step began, s.
    pub elapsed: f32,
    /// Planned time until touchdown, s.
    pub remaining: f32,
    /// Natural frequency of the pendulum, 1/s.
    pub frequency: f32,
}

/// Correction of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recovery {
    /// Displacement of the swing foot from its planned place, m.
    pub displacement: Vec2,
    /// Time until touchdown, s.
    pub remaining: f32,
}

impl Parameters {
    /// The best step: the planned one if the DCM is as planned. Pure; it allocates nothing.
    #[must_use]
    pub fn recovery(&self, now: &Situation) -> Recovery {
        let [place, time, offset] = self.recovery_weights;
        let growth = |remaining: f32| expf(now.frequency * remaining);
        let (planned, wanted) = (growth(now.remaining), now.place + now.offset);
        let earliest = (self.min_recovery_duration - now.elapsed).max(MIN_REMAINING).min(now.remaining);
        let latest = (self.max_recovery_duration - now.elapsed).max(now.remaining);
        let (inward, outward) = (self.max_capture_step.with_y(self.max_inward_step), self.max_capture_step);
        let displaced = |growth: f32| {
            let free = (now.dcm * growth - wanted) * (offset / (place + offset));
            free.clamp(-inward, outward)
        };
        // The derivative of the cost by the growth, each with the best place, increases with it.
        let slope = |growth: f32| {
            let off = now.dcm * growth - wanted - displaced(growth);
            time * (growth - planned) + offset * now.dcm.dot(off)
        };
        let (mut low, mut high) = (growth(earliest), growth(latest));
        for _ in 0..BISECTIONS {
            let middle = 0.5 * (low + high);
            if slope(middle) > 0.0 { high = middle } else { low = middle }
        }
        let best = 0.5 * (low + high);
        Recovery { displacement: displaced(best), remaining: logf(best) / now.frequency }
    }
}
