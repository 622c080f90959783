//! Nothing passes through posts, nets and other robots.

use bica_motion::robot::Buttons;
use bica_motion::side::Side;
use glam::{Vec2, Vec3};

use super::body::Body;
use crate::obstacle::Obstacle;

/// How thick the torso is between the arms, which give way, m.
const TORSO_RADIUS: f32 = 0.09;
/// The middle of a disc in the sole's frame that reaches to the toes, and its radius, m.
const FOOT: (Vec3, f32) = (Vec3::new(0.035, 0.0, 0.0), 0.065);
/// How often the overlaps are resolved one after the other; two walls of a corner need two.
const ROUNDS: usize = 3;
/// A foot feels what is within this of its front, as the cosine of the angle.
const BUMPER: f32 = 0.5;

/// Moves a body out of the obstacles that it ran into, so that it slides along them. Says which bumpers that pressed,
/// and whether it ran into any at all.
pub(crate) fn resolve(body: &mut Body, obstacles: &[Obstacle]) -> (Buttons, bool) {
    let mut buttons = Buttons::default();
    let mut hit = false;
    for _ in 0..ROUNDS {
        let Some((normal, depth)) = deepest(body, obstacles) else { break };
        press(&mut buttons, body, obstacles);
        body.shift(normal * depth);
        hit = true;
    }
    (buttons, hit)
}

fn deepest(body: &Body, obstacles: &[Obstacle]) -> Option<(Vec2, f32)> {
    let [left, right] = feet(body);
    let parts = [(body.pose().position, TORSO_RADIUS), (left, FOOT.1), (right, FOOT.1)];
    let overlaps = parts
        .iter()
        .flat_map(|&(centre, radius)| obstacles.iter().filter_map(move |obstacle| obstacle.overlap(centre, radius)));
    overlaps.max_by(|a, b| a.1.total_cmp(&b.1))
}

fn press(buttons: &mut Buttons, body: &Body, obstacles: &[Obstacle]) {
    let feet = feet(body);
    for side in Side::BOTH {
        let ahead = (body.soles()[side.index()].matrix3.x_axis).truncate();
        let centre = feet[side.index()];
        let pressed = obstacles.iter().filter_map(|obstacle| obstacle.overlap(centre, FOOT.1));
        let pressed = pressed.into_iter().any(|(normal, _)| normal.dot(ahead) < -BUMPER);
        match side {
            Side::Left => buttons.left_bumper |= pressed,
            Side::Right => buttons.right_bumper |= pressed,
        }
    }
}

fn feet(body: &Body) -> [Vec2; 2] {
    body.soles().map(|sole| sole.transform_point3(FOOT.0).truncate())
}
