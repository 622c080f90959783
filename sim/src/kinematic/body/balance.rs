//! Static balance: the centre of mass over the support polygon, and the distribution of the weight on the soles.

use bica_motion::model::RobotModel;
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};

use crate::kinematic::convex_hull::convex_hull;
use crate::kinematic::foot_contact::outline;
use bica_body::sensor_model::GRAVITY;

/// Maximum height of a sole in contact with the ground, m.
const CONTACT_HEIGHT: f32 = 0.002;

/// Both soles and the centre of mass. Field frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Balance {
    model: &'static RobotModel,
    /// Poses of the soles, left first.
    soles: [Affine3A; 2],
    /// The support foot, which always has contact.
    support: Side,
    /// Centre of mass, m.
    mass: Vec3,
}

impl Balance {
    /// Returns the state of these soles, left first, and this centre of mass, m.
    pub(crate) const fn new(model: &'static RobotModel, soles: [Affine3A; 2], support: Side, mass: Vec3) -> Self {
        Self { model, soles, support, mass }
    }

    /// Returns the offset from the support polygon to the projected centre of mass, m; `None` if that lies inside.
    pub(crate) fn offset_outside_support(&self) -> Option<Vec2> {
        let mut corners = Vec::with_capacity(26);
        for side in Side::BOTH {
            let touching = |corner: &Vec3| side == self.support || corner.z < CONTACT_HEIGHT;
            let points = outline(self.model, side, &self.soles[side.index()]);
            corners.extend(points.filter(touching).map(Vec3::truncate));
        }
        offset_outside(&convex_hull(corners), self.mass.truncate())
    }

    /// Returns the forces on the pressure sensors of both soles, N, left first, without noise.
    pub(crate) fn pressure(&self) -> [FootPressure; 2] {
        let [left, right] = self.shares();
        [self.sole_pressure(Side::Left, left), self.sole_pressure(Side::Right, right)]
    }

    /// Returns the fraction of the weight on each foot, from the position of the centre of mass between them and their contact.
    fn shares(&self) -> [f32; 2] {
        let [left, right] = self.soles.map(|sole| sole.translation.truncate());
        let across = right - left;
        let to_right = ((self.mass.truncate() - left).dot(across) / across.length_squared().max(1e-6)).clamp(0.0, 1.0);
        let touch = |side: Side| {
            let height = self.soles[side.index()].translation.z;
            if side == self.support { 1.0 } else { (1.0 - height / CONTACT_HEIGHT).clamp(0.0, 1.0) }
        };
        let (left, right) = (touch(Side::Left) * (1.0 - to_right), touch(Side::Right) * to_right);
        match (left + right, self.support) {
            (0.0, Side::Left) => [1.0, 0.0],
            (0.0, Side::Right) => [0.0, 1.0],
            (sum, _) => [left / sum, right / sum],
        }
    }

    fn sole_pressure(&self, side: Side, share: f32) -> FootPressure {
        let places = if side == Side::Left {
            &self.model.dimensions.left_pressure
        } else {
            &self.model.dimensions.right_pressure
        };
        let [front_left, front_right, rear_left, rear_right] = *places;
        let centre = self.soles[side.index()].inverse().transform_point3(self.mass.with_z(0.0)).truncate();
        let between = |value: f32, low: f32, high: f32| ((value - low) / (high - low)).clamp(0.0, 1.0);
        let front = between(centre.x, rear_left.x, front_left.x);
        let left = between(centre.y, front_right.y, front_left.y);
        let rear_share = between(centre.y, rear_right.y, rear_left.y);
        let force = share * self.model.total_mass() * GRAVITY;
        FootPressure {
            front_left: force * front * left,
            front_right: force * front * (1.0 - left),
            rear_left: force * (1.0 - front) * rear_share,
            rear_right: force * (1.0 - front) * (1.0 - rear_share),
        }
    }
}

/// Returns the offset from the nearest point of a convex polygon to a point outside; `None` if the point is inside.
fn offset_outside(polygon: &[Vec2], point: Vec2) -> Option<Vec2> {
    let edges = || polygon.iter().zip(polygon.iter().cycle().skip(1));
    if edges().all(|(&a, &b)| (b - a).perp_dot(point - a) >= 0.0) {
        return None;
    }
    let offsets = edges().map(|(&a, &b)| {
        let t = ((point - a).dot(b - a) / (b - a).length_squared().max(1e-12)).clamp(0.0, 1.0);
        point - a.lerp(b, t)
    });
    offsets.min_by(|a, b| a.length_squared().total_cmp(&b.length_squared()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::TEST_MODEL;

    fn standing(mass: Vec3, right_height: f32) -> Balance {
        let at = |y, z| Affine3A::from_translation(Vec3::new(0.0, y, z));
        Balance::new(TEST_MODEL, [at(0.05, 0.0), at(-0.05, right_height)], Side::Left, mass)
    }

    #[test]
    fn support_polygon_includes_ground_between_soles() {
        assert_eq!(standing(Vec3::new(0.02, 0.0, 0.25), 0.0).offset_outside_support(), None);
        assert_eq!(standing(Vec3::new(0.099, 0.0, 0.25), 0.0).offset_outside_support(), None);
        let offset = standing(Vec3::new(0.12, 0.0, 0.25), 0.0).offset_outside_support().unwrap();
        assert!((offset - Vec2::new(0.0199, 0.0)).length() < 1e-5, "{offset}");
        let offset = standing(Vec3::new(0.02, 0.2, 0.25), 0.0).offset_outside_support().unwrap();
        assert!((offset - Vec2::new(0.0, 0.2 - 0.1017)).length() < 1e-5, "{offset}");
    }

    #[test]
    fn lifted_sole_supports_nothing_and_has_no_pressure() {
        let lifted = standing(Vec3::new(0.02, 0.0, 0.25), 0.01);
        let offset = lifted.offset_outside_support().unwrap();
        assert!((offset - Vec2::new(0.0, -0.0112)).length() < 1e-5, "{offset}");
        assert_eq!(lifted.pressure()[1].total(), 0.0);
        assert!((lifted.pressure()[0].total() - TEST_MODEL.total_mass() * GRAVITY).abs() < 1e-3);
    }

    #[test]
    fn pressure_moves_with_centre_of_mass() {
        let [left, right] = standing(Vec3::new(0.02, 0.0, 0.25), 0.0).pressure();
        assert!((left.total() - right.total()).abs() < 1e-3);
        let [left, right] = standing(Vec3::new(0.02, 0.04, 0.25), 0.0).pressure();
        assert!(left.total() > 8.0 * right.total() && right.total() > 0.0);
        let [ahead, _] = standing(Vec3::new(0.06, 0.0, 0.25), 0.0).pressure();
        assert!(ahead.front_left + ahead.front_right > ahead.rear_left + ahead.rear_right);
    }
}
