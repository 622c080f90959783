//! Collisions of the robot with posts, nets and other robots.

use bica_motion::robot::Buttons;
use bica_motion::side::Side;
use glam::{Vec2, Vec3};

use super::body::Body;
use crate::obstacle::Obstacle;

/// Number of overlaps resolved in sequence; the two walls of a corner need two.
const ITERATIONS: usize = 3;
/// Cosine of the angle between foot and obstacle within which a bumper is pressed (60°).
const BUMPER_COSINE: f32 = 0.5;

/// Moves a body out of the obstacles that it overlaps, so that it slides along them. Returns the pressed bumpers and
/// whether there was any contact.
pub(crate) fn resolve(body: &mut Body, obstacles: &[Obstacle]) -> (Buttons, bool) {
    let mut buttons = Buttons::default();
    let mut hit = false;
    for _ in 0..ITERATIONS {
        let Some((normal, depth)) = deepest(body, obstacles) else { break };
        press(&mut buttons, body, obstacles);
        body.shift(normal * depth);
        hit = true;
    }
    (buttons, hit)
}

/// Returns the outward normal and the depth, m, of the deepest overlap.
fn deepest(body: &Body, obstacles: &[Obstacle]) -> Option<(Vec2, f32)> {
    let [left, right] = feet(body);
    let foot = body.model.extents.foot_front.radius;
    let parts = [(body.pose().position, body.model.extents.torso), (left, foot), (right, foot)];
    let overlaps = parts
        .iter()
        .flat_map(|&(centre, radius)| obstacles.iter().filter_map(move |obstacle| obstacle.overlap(centre, radius)));
    overlaps.max_by(|a, b| a.1.total_cmp(&b.1))
}

/// Presses the bumpers of feet that touch an obstacle in front of them.
fn press(buttons: &mut Buttons, body: &Body, obstacles: &[Obstacle]) {
    let feet = feet(body);
    for side in Side::BOTH {
        let ahead = (body.soles()[side.index()].matrix3.x_axis).truncate();
        let centre = feet[side.index()];
        let pressed =
            obstacles.iter().filter_map(|obstacle| obstacle.overlap(centre, body.model.extents.foot_front.radius));
        let pressed = pressed.into_iter().any(|(normal, _)| normal.dot(ahead) < -BUMPER_COSINE);
        match side {
            Side::Left => buttons.left_bumper |= pressed,
            Side::Right => buttons.right_bumper |= pressed,
        }
    }
}

/// Returns the centres of the discs around both feet, left first. Field frame, m.
fn feet(body: &Body) -> [Vec2; 2] {
    let centre = Vec3::new(body.model.extents.foot_front.ahead, 0.0, 0.0);
    body.soles().map(|sole| sole.transform_point3(centre).truncate())
}
