//! Targets of a kick.

use glam::Vec2;

use super::Planning;
use super::situation::Goal;

/// Number of further targets on each side of the middle of the goal.
const OTHERS: i8 = 4;

/// Target of a kick.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aim {
    /// Position in the ground frame, m.
    pub(super) at: Vec2,
    /// Cost, rad of turning.
    pub(super) cost: f32,
}

/// Targets on the goal line, the best ones first.
pub(super) fn scoring(goal: &Goal, planning: &Planning) -> [Aim; 2 + 2 * OTHERS as usize + 1] {
    let beside = planning.keeper_offset;
    let best = goal.gap.map_or([beside, -beside], |gap| [gap; 2]);
    core::array::from_fn(|i| {
        let half = 0.5 * goal.width * planning.outermost_target;
        let aside = best.get(i).copied().unwrap_or_else(|| half * (f32::from(i as i8 - 2) / f32::from(OTHERS) - 1.0));
        let off = best.iter().map(|best| libm::fabsf(best - aside)).fold(f32::INFINITY, f32::min);
        Aim { at: goal.middle + aside * goal.across, cost: planning.offset_cost * off }
    })
}

/// Targets in front of the goal, for a ball without a free path into it.
pub(super) fn open(goal: &Goal, planning: &Planning) -> [Aim; 3] {
    let (before, aside, cost) = (planning.before_distance, planning.before_offset, planning.before_offset_cost);
    [(0.0, 0.0), (aside, cost), (-aside, cost)]
        .map(|(aside, cost)| Aim { at: goal.middle + aside * goal.across + before * goal.across.perp(), cost })
}
