//! Quasi-static world for tests. Joints follow their targets with dead time and limited speed; the lower sole is fixed
//! to the ground; the pose of the torso follows from the joint angles.

use bica_motion::joints::Joints;
use bica_motion::kinematics::Skeleton;
use bica_motion::model::RobotModel;
use bica_motion::pose::{Pose2, wrap};
use bica_motion::robot::FootPressure;
use bica_motion::side::Side;
use bica_motion::walk::Feedback;
use glam::{Affine3A, Quat, Vec2, Vec3};
use std::collections::VecDeque;

pub(crate) const CYCLE: f32 = 0.01;
/// Height difference at which the other sole becomes the support, m.
const HYSTERESIS: f32 = 0.001;
/// Maximum height of a sole with contact, m.
const CONTACT: f32 = 0.002;

pub(crate) struct World {
    pub(crate) angles: Joints,
    waiting: VecDeque<Joints>,
    pub(crate) support: Side,
    /// Pose of the support sole on the ground.
    anchor: Affine3A,
    pub(crate) robot: Affine3A,
    /// Angular velocity, rad/s, torso frame.
    pub(crate) gyro: Vec3,
    /// Number of cycles in which a joint could not follow its target.
    pub(crate) late: usize,
    model: &'static RobotModel,
}

impl World {
    pub(crate) fn standing(model: &'static RobotModel, angles: Joints) -> Self {
        let sole = Skeleton::of(model, &angles).sole(Side::Left);
        let anchor = flat(&Affine3A::from_translation(sole.translation.into()));
        let mut world = Self {
            angles,
            waiting: VecDeque::from(vec![angles; 3]),
            support: Side::Left,
            anchor,
            robot: Affine3A::IDENTITY,
            gyro: Vec3::ZERO,
            late: 0,
            model,
        };
        world.robot = world.anchor * world.skeleton().sole(Side::Left).inverse();
        world
    }

    pub(crate) fn skeleton(&self) -> Skeleton {
        Skeleton::of(self.model, &self.angles)
    }

    /// Runs one cycle.
    pub(crate) fn step(&mut self, targets: &Joints) {
        self.waiting.push_back(*targets);
        let due = self.waiting.pop_front().expect("three commands are pending");
        let moved = self.angles.moved_toward(self.model, &due, CYCLE).clamp_to_limits(self.model);
        self.late += usize::from(moved.0.iter().zip(due.0).any(|(a, b)| (a - b).abs() > 1e-6));
        self.angles = moved;
        let skeleton = self.skeleton();
        let before = self.robot;
        self.robot = self.anchor * skeleton.sole(self.support).inverse();
        let other = self.robot * skeleton.sole(self.support.other());
        if other.translation.z < -HYSTERESIS {
            self.support = self.support.other();
            self.anchor = flat(&other);
            self.robot = self.anchor * skeleton.sole(self.support).inverse();
        }
        let turn = before.matrix3.transpose() * self.robot.matrix3;
        self.gyro = Quat::from_mat3a(&turn).normalize().to_scaled_axis() / CYCLE;
    }

    pub(crate) fn sole(&self, side: Side) -> Affine3A {
        self.robot * self.skeleton().sole(side)
    }

    pub(crate) fn touches(&self, side: Side) -> bool {
        side == self.support || self.sole(side).translation.z < CONTACT
    }

    /// Pose of the torso projected to the ground.
    pub(crate) fn pose(&self) -> Pose2 {
        seen_from_above(&self.robot)
    }

    /// Pose midway between the feet, with their mean heading.
    pub(crate) fn ground(&self) -> Pose2 {
        let [left, right] = Side::BOTH.map(|side| seen_from_above(&self.sole(side)));
        Pose2 {
            position: left.position.midpoint(right.position),
            heading: left.heading + 0.5 * wrap(right.heading - left.heading),
        }
    }

    pub(crate) fn body(&self) -> Feedback {
        let [left, right] = self.forces();
        let all = |force: f32| FootPressure {
            front_left: force / 4.0,
            front_right: force / 4.0,
            rear_left: force / 4.0,
            rear_right: force / 4.0,
        };
        Feedback { gyro: self.gyro, left_foot: all(left), right_foot: all(right), ..Feedback::default() }
    }

    /// Forces on both feet, left first, N, computed from the position of the centre of mass between the ankles and the
    /// contact of the soles.
    pub(crate) fn forces(&self) -> [f32; 2] {
        let [left, right] = Side::BOTH.map(|side| self.sole(side).translation.truncate());
        let across = right - left;
        let to_right = ((self.mass() - left).dot(across) / across.length_squared()).clamp(0.0, 1.0);
        let touch = |side: Side| {
            let height = self.sole(side).translation.z;
            if side == self.support { 1.0 } else { (1.0 - height / CONTACT).clamp(0.0, 1.0) }
        };
        let (left, right) = (touch(Side::Left) * (1.0 - to_right), touch(Side::Right) * to_right);
        let weight = self.model.total_mass() * 9.81;
        match (left + right, self.support) {
            (0.0, Side::Left) => [weight, 0.0],
            (0.0, Side::Right) => [0.0, weight],
            (sum, _) => [weight * left / sum, weight * right / sum],
        }
    }

    /// Centre of mass projected to the ground.
    pub(crate) fn mass(&self) -> Vec2 {
        self.robot.transform_point3(self.skeleton().centre_of_mass()).truncate()
    }

    /// Distance of the centre of mass from the edge of the support polygon, m; negative outside.
    pub(crate) fn margin(&self) -> f32 {
        let mut corners = Vec::new();
        for side in Side::BOTH.into_iter().filter(|&side| self.touches(side)) {
            corners.extend(outline(self.model, side, &self.sole(side)).into_iter().map(Vec3::truncate));
        }
        inside(&corners, self.mass())
    }
}

pub(crate) fn outline(model: &'static RobotModel, side: Side, sole: &Affine3A) -> Vec<Vec3> {
    model
        .dimensions
        .sole_outline
        .iter()
        .map(|p| sole.transform_point3(Vec3::new(p.x, side.sign() * p.y, 0.0)))
        .collect()
}

/// Distance of both soles in the ground plane, m; not positive if they overlap.
pub(crate) fn gap(model: &'static RobotModel, soles: [&Affine3A; 2]) -> f32 {
    let [left, right] = [(Side::Left, soles[0]), (Side::Right, soles[1])]
        .map(|(side, sole)| outline(model, side, sole).into_iter().map(Vec3::truncate).collect::<Vec<_>>());
    // Separating axes: the distance of convex polygons is at least the largest gap along the normals of their edges.
    let mut widest = f32::NEG_INFINITY;
    for (shape, other) in [(&left, &right), (&right, &left)] {
        for (a, b) in shape.iter().zip(shape.iter().cycle().skip(1)) {
            let normal = (*b - *a).normalize().perp();
            let reach = |points: &[Vec2], pick: fn(f32, f32) -> f32| {
                points.iter().map(|point| normal.dot(*point)).reduce(pick).expect("a sole has corners")
            };
            widest = widest.max(reach(other, f32::min) - reach(shape, f32::max));
            widest = widest.max(reach(shape, f32::min) - reach(other, f32::max));
        }
    }
    widest
}

/// Minimum distance to the edges of the convex hull.
fn inside(corners: &[Vec2], point: Vec2) -> f32 {
    let mut least = f32::INFINITY;
    for &a in corners {
        for &b in corners {
            let Some(along) = (b - a).try_normalize() else { continue };
            if corners.iter().all(|&c| along.perp_dot(c - a) >= -1e-6) {
                least = least.min(along.perp_dot(point - a));
            }
        }
    }
    least
}

fn seen_from_above(pose: &Affine3A) -> Pose2 {
    let ahead = pose.matrix3.x_axis;
    Pose2 { position: pose.translation.truncate(), heading: ahead.y.atan2(ahead.x) }
}

fn flat(sole: &Affine3A) -> Affine3A {
    let seen = seen_from_above(sole);
    Affine3A::from_translation(seen.position.extend(0.0)) * Affine3A::from_rotation_z(seen.heading)
}
