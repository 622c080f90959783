//! Where to kick the ball.

use bica_field::FIELD;
use glam::Vec2;

use super::situation::Goal;

/// How far beside the goal's middle to aim where the gap is not known, m: the keeper stands in the middle.
const BESIDE: f32 = 0.38;
/// Other places on the goal line that are aimed at if the best one is not possible: so many on each side of the middle, up to
/// this part of the way to the post.
const OTHERS: (i8, f32) = (4, 0.75);
/// What it costs to aim beside the best place, rad for each metre.
const OFF: f32 = 1.0;
/// A ball that cannot get into the goal is kicked to places this far before it, and this far aside, m; aside costs more, rad.
const OPEN: (f32, [(f32, f32); 3]) = (1.2, [(0.0, 0.0), (0.6, 0.4), (-0.6, 0.4)]);

/// A place to kick the ball to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Aim {
    /// m, ground frame.
    pub(super) at: Vec2,
    /// What it costs to aim there, rad of turning.
    pub(super) cost: f32,
}

/// Places on the goal line, the best ones first.
pub(super) fn scoring(goal: &Goal) -> [Aim; 2 + 2 * OTHERS.0 as usize + 1] {
    let best = goal.gap.map_or([BESIDE, -BESIDE], |gap| [gap; 2]);
    core::array::from_fn(|i| {
        let half = 0.5 * FIELD.goal_width() * OTHERS.1;
        let aside = best.get(i).copied().unwrap_or_else(|| half * (f32::from(i as i8 - 2) / f32::from(OTHERS.0) - 1.0));
        let off = best.iter().map(|best| libm::fabsf(best - aside)).fold(f32::INFINITY, f32::min);
        Aim { at: goal.middle + aside * goal.across, cost: OFF * off }
    })
}

/// Places on the field before the goal.
pub(super) fn open(goal: &Goal) -> [Aim; 3] {
    OPEN.1.map(|(aside, cost)| Aim { at: goal.middle + aside * goal.across + OPEN.0 * goal.across.perp(), cost })
}
