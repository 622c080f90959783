//! Obstacles on the field as shapes on the ground.

use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use glam::{Affine3A, Vec2, Vec3};

use crate::field::{GOAL_BACK, POST, POST_RADIUS};

/// A capsule on the ground, all points within `radius` of a segment; a disc if both ends coincide. Field frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Obstacle {
    /// One end of the segment.
    pub(crate) from: Vec2,
    /// The other end of the segment.
    pub(crate) to: Vec2,
    /// Radius.
    pub(crate) radius: f32,
    /// Coefficient of restitution for a ball, 0 to 1.
    pub(crate) restitution: f32,
    /// Fraction of its tangential speed that a ball loses on contact, 0 to 1.
    pub(crate) tangential_loss: f32,
}

impl Obstacle {
    const fn post(x: f32, y: f32) -> Self {
        let place = Vec2::new(x, y);
        Self { from: place, to: place, radius: POST_RADIUS, restitution: 0.6, tangential_loss: 0.05 }
    }

    const fn net(from: Vec2, to: Vec2) -> Self {
        Self { from, to, radius: 0.01, restitution: 0.1, tangential_loss: 0.6 }
    }

    /// Returns the shape of the legs of a standing robot.
    pub(crate) fn legs(model: &'static SimulatedModel, robot: &Pose2) -> Self {
        let (hip, leg) = (model.dimensions.hip, model.extents.leg);
        let [from, to] = [hip.y, -hip.y].map(|y| robot.place(Vec2::new(hip.x + leg.ahead, y)));
        Self { from, to, radius: leg.radius, restitution: 0.4, tangential_loss: 0.2 }
    }

    /// Returns the shape of a robot lying on the ground, with this pose of the robot frame.
    pub(crate) fn lying(model: &'static SimulatedModel, robot: &Affine3A) -> Self {
        let [from, to] = [0.0, model.extents.trunk_length].map(|z| robot.transform_point3(z * Vec3::Z).truncate());
        Self { from, to, radius: model.extents.trunk_radius, restitution: 0.3, tangential_loss: 0.3 }
    }

    /// Returns the point of the segment nearest to `point`.
    pub(crate) fn nearest(&self, point: Vec2) -> Vec2 {
        let along = self.to - self.from;
        let length = along.length_squared();
        let t = if length > 0.0 { ((point - self.from).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
        self.from + t * along
    }

    /// Returns the outward normal and the depth, m, by which a disc penetrates this shape; `None` if it does not.
    pub(crate) fn overlap(&self, centre: Vec2, radius: f32) -> Option<(Vec2, f32)> {
        let outward = centre - self.nearest(centre);
        let distance = outward.length();
        let depth = self.radius + radius - distance;
        let normal =
            if distance > 1e-6 { outward / distance } else { (self.to - self.from).perp().normalize_or(Vec2::X) };
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn overlap_is_the_shortest_way_out() {
        let wall = Obstacle::net(Vec2::ZERO, Vec2::X);
        let (normal, depth) = wall.overlap(Vec2::new(0.5, 0.03), 0.05).unwrap();
        assert!(normal.distance(Vec2::Y) < 1e-6 && (depth - 0.03).abs() < 1e-6, "{normal} {depth}");
        let (normal, depth) = wall.overlap(Vec2::new(1.03, 0.04), 0.05).unwrap();
        assert!(normal.distance(Vec2::new(0.6, 0.8)) < 1e-6 && (depth - 0.01).abs() < 1e-6, "{normal} {depth}");
        assert_eq!(wall.overlap(Vec2::new(0.5, 0.061), 0.05), None);
    }

    #[test]
    fn centred_disc_is_pushed_across_segment() {
        let wall = Obstacle::net(Vec2::ZERO, Vec2::X);
        let (normal, depth) = wall.overlap(Vec2::new(0.5, 0.0), 0.05).unwrap();
        assert!(normal.dot(Vec2::X).abs() < 1e-6 && (depth - 0.06).abs() < 1e-6, "{normal} {depth}");
    }
}
