//! Motion of the ball during a control cycle, in contact with feet and obstacles.

use bica_motion::model::simulation::SimulatedModel;
use bica_motion::side::Side;
use glam::Affine3A;

use super::ball::Ball;
use super::foot_contact::FootContact;
use crate::obstacle::Obstacle;
use crate::world::CYCLE_SECONDS;

/// Integration steps per control cycle: enough that neither ball nor foot passes through the other at 4 m/s.
const SUB_STEPS: u32 = 10;

/// Moves the ball for one control cycle. Returns the foot that touched it last, if any did.
///
/// `soles`: poses of both soles at the start and at the end of the cycle, field frame, left first. Obstacles do not move.
pub(crate) fn advance(
    model: &'static SimulatedModel,
    ball: &mut Ball,
    soles: [(Affine3A, Affine3A); 2],
    obstacles: &[Obstacle],
) -> Option<Side> {
    let feet = Side::BOTH.map(|side| {
        let (from, to) = &soles[side.index()];
        (side, FootContact::new(model, side, from, to, CYCLE_SECONDS))
    });
    let mut touching = None;
    for step in 1..=SUB_STEPS {
        ball.roll(CYCLE_SECONDS / SUB_STEPS as f32);
        for (side, foot) in &feet {
            if foot.is_near(ball.position) && foot.push(ball, step as f32 / SUB_STEPS as f32) {
                touching = Some(*side);
            }
        }
        for obstacle in obstacles {
            ball.bounce_off(obstacle);
        }
    }
    touching
}
