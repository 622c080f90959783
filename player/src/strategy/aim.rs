//! Targets of a kick.

use bica_field::FIELD;
use glam::Vec2;

use super::situation::Goal;

/// Offset of the target from the middle of the goal while the gap is unknown, m: the keeper is in the middle.
const BESIDE: f32 = 0.38;
/// Number of further targets on each side of the middle of the goal.
const OTHERS: i8 = 4;
/// Distance of the outermost target from the middle of the goal, as a share of the distance to the post.
const OUTERMOST: f32 = 0.75;
/// Cost per metre of distance from the best target, rad/m.
const OFFSET_COST: f32 = 1.0;
/// Distance from the goal line of the targets in front of the goal, m.
const BEFORE: f32 = 1.2;
/// Targets in front of the goal: offset along the goal line, m, and cost, rad.
const BEFORE_GOAL: [(f32, f32); 3] = [(0.0, 0.0), (0.6, 0.4), (-0.6, 0.4)];

/// Target of a kick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aim {
    /// Position in the ground frame, m.
    pub(super) at: Vec2,
    /// Cost, rad of turning.
    pub(super) cost: f32,
}

/// Targets on the goal line, the best ones first.
pub(super) fn scoring(goal: &Goal) -> [Aim; 2 + 2 * OTHERS as usize + 1] {
    let best = goal.gap.map_or([BESIDE, -BESIDE], |gap| [gap; 2]);
    core::array::from_fn(|i| {
        let half = 0.5 * FIELD.goal_width() * OUTERMOST;
        let aside = best.get(i).copied().unwrap_or_else(|| half * (f32::from(i as i8 - 2) / f32::from(OTHERS) - 1.0));
        let off = best.iter().map(|best| libm::fabsf(best - aside)).fold(f32::INFINITY, f32::min);
        Aim { at: goal.middle + aside * goal.across, cost: OFFSET_COST * off }
    })
}

/// Targets in front of the goal, for a ball without a free path into it.
pub(super) fn open(goal: &Goal) -> [Aim; 3] {
    BEFORE_GOAL.map(|(aside, cost)| Aim { at: goal.middle + aside * goal.across + BEFORE * goal.across.perp(), cost })
}
