//! What stands in the way on the ground.

use bica_field::FIELD;
use glam::Vec2;

const GOAL_BACK: f32 = FIELD.goal_back();
const POST: Vec2 = FIELD.goal_post();
const POST_RADIUS: f32 = FIELD.post_radius();

/// A wall with round ends, seen from above; a disc if both ends are the same. Field frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Obstacle {
    /// One end.
    pub(crate) from: Vec2,
    /// The other end.
    pub(crate) to: Vec2,
    /// Half its thickness.
    pub(crate) radius: f32,
    /// Share of the speed across its surface with which a ball comes back.
    pub(crate) bounce: f32,
    /// Share of the speed along its surface that a ball loses.
    pub(crate) grip: f32,
}

impl Obstacle {
    const fn post(x: f32, y: f32) -> Self {
        let place = Vec2::new(x, y);
        Self { from: place, to: place, radius: POST_RADIUS, bounce: 0.6, grip: 0.05 }
    }

    const fn net(from: Vec2, to: Vec2) -> Self {
        Self { from, to, radius: 0.01, bounce: 0.1, grip: 0.6 }
    }

    /// Robot legs, standing still.
    pub(crate) const fn legs(left: Vec2, right: Vec2) -> Self {
        Self { from: left, to: right, radius: 0.07, bounce: 0.4, grip: 0.2 }
    }

    /// A robot's body lying on the ground.
    pub(crate) const fn lying(hips: Vec2, head: Vec2) -> Self {
        Self { from: hips, to: head, radius: 0.09, bounce: 0.3, grip: 0.3 }
    }

    /// The point of the middle line nearest to `point`.
    pub(crate) fn nearest(&self, point: Vec2) -> Vec2 {
        let along = self.to - self.from;
        let length = along.length_squared();
        let t = if length > 0.0 { ((point - self.from).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
        self.from + t * along
    }

    /// How a disc overlaps this: the direction that leads out, and how far. `None` if it does not.
    pub(crate) fn overlap(&self, centre: Vec2, radius: f32) -> Option<(Vec2, f32)> {
        let out = centre - self.nearest(centre);
        let distance = out.length();
        let depth = self.radius + radius - distance;
        let normal = if distance > 1e-6 { out / distance } else { (self.to - self.from).perp().normalize_or(Vec2::X) };
        (depth > 0.0).then_some((normal, depth))
    }
}

/// Posts and nets of both goals.
pub(crate) const GOALS: [Obstacle; 10] = {
    let [a, b, c, d, e] = goal(1.0);
    let [f, g, h, i, j] = goal(-1.0);
    [a, b, c, d, e, f, g, h, i, j]
};

const fn goal(end: f32) -> [Obstacle; 5] {
    let (front, back) = (end * POST.x, end * GOAL_BACK);
    let corners =
        [Vec2::new(front, -POST.y), Vec2::new(back, -POST.y), Vec2::new(back, POST.y), Vec2::new(front, POST.y)];
    [
        Obstacle::post(front, -POST.y),
        Obstacle::post(front, POST.y),
        Obstacle::net(corners[0], corners[1]),
        Obstacle::net(corners[1], corners[2]),
        Obstacle::net(corners[2], corners[3]),
    ]
}
