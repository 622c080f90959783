//! What a posture is for a robot: places of its limbs, centre of mass, limits of its motors.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{Segment, Skeleton, ground_from_robot};
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::MujocoModel;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3, Vec3Swizzles as _};
use serde::Serialize;

use super::play::{self, Play, Run};

/// Distance of points of the soles from the ground below which they bear weight, m.
const CONTACT: f32 = 0.005;
/// Tolerance of limits, rad.
const ROUNDING: f32 = 0.01;

/// A model of a robot as values.
#[derive(Clone, Copy)]
pub(super) struct Robot {
    pub(super) stand: Joints,
    pub(super) shape: fn(&Joints) -> Shape,
    pub(super) limits: fn(&Joints, &Joints, f32) -> Limits,
    pub(super) play: fn(&Play) -> Result<Vec<Run>, bica_wire::model::Invalid>,
}

/// A posture in space. Frame: on the ground under the lower foot, x ahead, y to the left, z up; m.
#[derive(Serialize)]
pub(super) struct Shape {
    /// Lines along the limbs.
    lines: Vec<Vec<[f32; 3]>>,
    /// Outlines of both soles.
    soles: Vec<Vec<[f32; 3]>>,
    /// Centre of mass.
    centre: [f32; 3],
    /// Distance of the centre of mass, seen from above, from the edge of what the soles on the ground span; negative beyond it.
    margin: f32,
}

/// What of a motion from one posture to the next the motors cannot do.
#[derive(Serialize)]
pub(super) struct Limits {
    /// Joints beyond their ranges, with angle and nearest limit, degrees.
    beyond: Vec<(String, f32, f32)>,
    /// Joints faster than their motors, with the greatest speed and its limit, °/s.
    fast: Vec<(String, f32, f32)>,
    /// Least duration, s.
    least: f32,
}

impl Robot {
    pub(super) const fn of<M: MujocoModel>() -> Self {
        Self { stand: M::STAND, shape: shape::<M>, limits: limits::<M>, play: play::play::<M> }
    }
}

fn shape<M: RobotModel>(angles: &Joints) -> Shape {
    let skeleton = Skeleton::<M>::of(angles);
    let [left, right] = Side::BOTH.map(|side| skeleton.sole(side).translation.z);
    let ground = ground_from_robot::<M>(if left <= right { Side::Left } else { Side::Right }, angles);
    let place = |pose: Affine3A, point: Vec3| (ground * pose).transform_point3(point);
    let at = |segment| place(skeleton.pose(segment), Vec3::ZERO);
    let neck = at(Segment::Neck);
    let hips = place(Affine3A::IDENTITY, Vec3::ZERO);
    let mut lines = vec![vec![hips, neck, place(skeleton.pose(Segment::Head), M::DIMENSIONS.top_camera.position)]];
    for side in Side::BOTH {
        let hand = M::DIMENSIONS.hand * Vec3::new(1.0, side.sign(), 1.0);
        let hand = place(skeleton.pose(Segment::Hand(side)), hand);
        lines.push(vec![neck, at(Segment::Shoulder(side)), at(Segment::Elbow(side)), at(Segment::Hand(side)), hand]);
        lines.push(vec![hips, at(Segment::Thigh(side)), at(Segment::Tibia(side)), at(Segment::Ankle(side))]);
    }
    let sole = |side: Side| -> Vec<Vec3> {
        let point = |point: &Vec2| place(skeleton.sole(side), Vec3::new(point.x, side.sign() * point.y, 0.0));
        M::DIMENSIONS.sole_outline.iter().map(point).collect()
    };
    let soles = Side::BOTH.map(sole);
    let centre = ground.transform_point3(skeleton.centre_of_mass());
    let loaded = soles.iter().flatten().filter(|point| point.z < CONTACT).map(|point| point.xy()).collect();
    let all = |points: &Vec<Vec3>| points.iter().map(Vec3::to_array).collect();
    Shape {
        lines: lines.iter().map(all).collect(),
        soles: soles.iter().map(all).collect(),
        centre: centre.to_array(),
        margin: margin(loaded, centre.xy()),
    }
}

/// Distance of a point from the edge of the convex hull of others: positive inside.
fn margin(mut points: Vec<Vec2>, point: Vec2) -> f32 {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    // Andrew's monotone chain (1979), counter-clockwise: the lower half, then the upper one.
    let half = |points: &mut dyn Iterator<Item = Vec2>| {
        let mut chain: Vec<Vec2> = Vec::new();
        for next in points {
            while let [.., before, last] = chain[..]
                && (last - before).perp_dot(next - last) <= 0.0
            {
                chain.pop();
            }
            chain.push(next);
        }
        chain.pop();
        chain
    };
    let mut hull = half(&mut points.iter().copied());
    hull.extend(half(&mut points.iter().rev().copied()));
    let edges = hull.iter().zip(hull.iter().cycle().skip(1));
    let distance = |(from, to): (&Vec2, &Vec2)| (to - from).normalize_or_zero().perp_dot(point - from);
    edges.map(distance).fold(f32::INFINITY, f32::min)
}

/// `peak`: greatest speed of the motion as a multiple of its mean, over its duration: 1/s.
fn limits<M: RobotModel>(from: &Joints, to: &Joints, peak: f32) -> Limits {
    let named = |joint: Joint, found: f32, limit: f32| (format!("{joint:?}"), found.to_degrees(), limit.to_degrees());
    let (mut beyond, mut fast, mut least) = (Vec::new(), Vec::new(), 0.0_f32);
    for &joint in M::JOINTS {
        let (range, angle, most) = (M::LIMITS[joint], to[joint], M::MAX_SPEEDS[joint]);
        let nearest = range.clamp(angle);
        if (nearest - angle).abs() > ROUNDING {
            beyond.push(named(joint, angle, nearest));
        }
        let way = (angle - from[joint]).abs();
        if way * peak > most {
            fast.push(named(joint, way * peak, most));
        }
        least = least.max(way / most);
    }
    Limits { beyond, fast, least }
}

#[cfg(test)]
mod tests {
    use bica_motion::model::Nao;

    use super::*;

    #[test]
    fn the_margin_is_the_distance_from_the_nearest_edge() {
        let square = || vec![Vec2::ZERO, Vec2::X, Vec2::Y, Vec2::ONE, Vec2::new(0.5, 0.2)];
        for (point, expected) in [(Vec2::new(0.5, 0.4), 0.4), (Vec2::new(0.9, 0.5), 0.1), (Vec2::new(1.25, 0.5), -0.25)]
        {
            assert!((margin(square(), point) - expected).abs() < 1e-6, "{point}");
        }
    }

    #[test]
    fn the_stand_stands_and_a_fast_far_motion_is_reported() {
        let shape = shape::<Nao>(&Nao::STAND);
        assert!(shape.margin > 0.03 && shape.centre[2] > 0.2, "{} {:?}", shape.margin, shape.centre);
        let mut far = Nao::STAND;
        far[Joint::LShoulderPitch] = -2.5;
        let limits = limits::<Nao>(&Nao::STAND, &far, 1.0 / 0.1);
        assert_eq!((&*limits.beyond[0].0, &*limits.fast[0].0), ("LShoulderPitch", "LShoulderPitch"));
        assert!(limits.least > 0.3, "{}", limits.least);
    }
}
