//! Place and time of the next footstep that catch a push.
//!
//! The *divergent component of motion* (DCM; the capture point of Pratt et al. 2006) is the position of the centre of mass plus
//! its velocity divided by the pendulum's natural frequency. Over a resting foot its distance from the foot grows with e^(ωt)
//! (Takenaka et al. 2009). Every cycle a quadratic program chooses the place of the next foot, e^(ω · remaining time), and the
//! offset of the DCM from that foot at touchdown, near their planned values (Khadiv et al. 2016). The measured DCM connects
//! the three by an equation, which eliminates the offset: three variables within bounds are left.

use glam::Vec2;
use libm::{expf, logf};
use nalgebra::{Matrix3, Vector3};

use crate::bounds::clamp;
use crate::model::Parameters;

/// Minimum time until a foot touches down, s.
const MIN_REMAINING: f32 = 0.03;
/// Maximum number of solved linear systems: each one fixes or releases a variable.
const MAX_SYSTEMS: usize = 8;

/// A step in progress. Positions in m from the support ankle, x forward, y toward the swing side.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Situation {
    /// Measured DCM.
    pub(super) dcm: Vec2,
    /// Planned place of the swing foot.
    pub(super) place: Vec2,
    /// Planned offset of the DCM from that place at touchdown.
    pub(super) offset: Vec2,
    /// Time since the step began, s.
    pub(super) elapsed: f32,
    /// Planned time until touchdown, s.
    pub(super) remaining: f32,
    /// Natural frequency of the pendulum, 1/s.
    pub(super) frequency: f32,
}

/// Correction of a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Recovery {
    /// Displacement of the swing foot from its planned place, m.
    pub(super) displacement: Vec2,
    /// Time until touchdown, s.
    pub(super) remaining: f32,
}

impl Parameters {
    /// The best step: the planned one if the DCM is as planned.
    pub(super) fn recovery(&self, now: &Situation) -> Recovery {
        let [place, time, offset] = self.recovery_weights;
        let growth = |remaining: f32| expf(now.frequency * remaining);
        let (planned, dcm) = (growth(now.remaining), now.dcm);
        // Variables: displacement x and y, growth. The offset is `dcm * growth - place - displacement`.
        let wanted = now.place + now.offset;
        let hessian = Matrix3::new(
            place + offset,
            0.0,
            -offset * dcm.x,
            0.0,
            place + offset,
            -offset * dcm.y,
            -offset * dcm.x,
            -offset * dcm.y,
            time + offset * dcm.length_squared(),
        );
        let gradient = Vector3::new(offset * wanted.x, offset * wanted.y, -time * planned - offset * dcm.dot(wanted));
        let earliest = (self.min_recovery_duration - now.elapsed).max(MIN_REMAINING).min(now.remaining);
        let latest = (self.max_recovery_duration - now.elapsed).max(now.remaining);
        let most = self.max_capture_step;
        let low = Vector3::new(-most.x, -self.max_inward_step, growth(earliest));
        let high = Vector3::new(most.x, most.y, growth(latest));
        let best = minimum(&hessian, &gradient, &low, &high);
        Recovery { displacement: Vec2::new(best.x, best.y), remaining: logf(best.z) / now.frequency }
    }
}

/// Minimum of `x·Hx/2 + g·x` with `low <= x <= high`, for a positive definite `H`: active-set method (Nocedal and Wright 2006).
fn minimum(hessian: &Matrix3<f32>, gradient: &Vector3<f32>, low: &Vector3<f32>, high: &Vector3<f32>) -> Vector3<f32> {
    let (mut fixed, mut best) = ([None; 3], (low + high) * 0.5);
    for _ in 0..MAX_SYSTEMS {
        let Some(solved) = with_fixed(hessian, gradient, &fixed) else { break };
        best = solved;
        let beyond = |i: usize| (best[i] - high[i]).max(low[i] - best[i]);
        let free = (0..3).filter(|&i| fixed[i].is_none() && beyond(i) > 0.0);
        if let Some(worst) = free.max_by(|&a, &b| beyond(a).total_cmp(&beyond(b))) {
            fixed[worst] = Some(clamp(best[worst], low[worst], high[worst]));
            continue;
        }
        let slope = hessian * best + gradient;
        // Positive where the minimum lies on the inner side of the bound.
        let inward = |i: usize| fixed[i].map_or(0.0, |at: f32| if at <= low[i] { -slope[i] } else { slope[i] });
        match (0..3).filter(|&i| inward(i) > 1e-6).max_by(|&a, &b| inward(a).total_cmp(&inward(b))) {
            Some(released) => fixed[released] = None,
            None => break,
        }
    }
    best.zip_zip_map(low, high, clamp)
}

/// Minimum with some variables fixed; none if the matrix is not positive definite.
fn with_fixed(hessian: &Matrix3<f32>, gradient: &Vector3<f32>, fixed: &[Option<f32>; 3]) -> Option<Vector3<f32>> {
    let at = Vector3::from_fn(|i, _| fixed[i].unwrap_or(0.0));
    let mut right = -(gradient + hessian * at);
    let mut left = *hessian;
    for (i, value) in fixed.iter().enumerate() {
        if let Some(value) = value {
            left.fill_row(i, 0.0);
            left.fill_column(i, 0.0);
            left[(i, i)] = 1.0;
            right[i] = *value;
        }
    }
    left.cholesky().map(|factor| factor.solve(&right))
}
