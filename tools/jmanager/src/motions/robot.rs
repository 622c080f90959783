//! Posture of a robot: positions of its limbs, centre of mass, and limits of its motors.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{Segment, Skeleton, ground_from_robot};
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3, Vec3Swizzles as _};
use serde::Serialize;

/// Distance of points of the soles from the ground below which they bear weight, m.
const CONTACT: f32 = 0.005;
/// Tolerance of limits, rad.
const ROUNDING: f32 = 0.01;
/// Acceleration of gravity, m/s².
const GRAVITY: f32 = 9.81;
/// Half of the step of derivatives, rad.
const STEP: f32 = 0.005;
/// Minimum distance of a handle from the axis of a joint that moves it, m.
const LEVER: f32 = 0.02;

/// A posture in space. Frame: on the ground under the lower foot, x ahead, y to the left, z up; m.
#[derive(Serialize)]
pub(super) struct Shape {
    /// Lines along the limbs.
    lines: Vec<Vec<[f32; 3]>>,
    /// Outlines of both soles.
    soles: Vec<Vec<[f32; 3]>>,
    /// Centre of mass.
    centre: [f32; 3],
    /// Poses of the torso and of the right sole, as three rows of four numbers.
    #[serde(skip)]
    pub(super) torso: [f32; 12],
    #[serde(skip)]
    pub(super) right_sole: [f32; 12],
    /// Distance of the centre of mass, seen from above, from the edge of the support polygon; negative outside.
    margin: f32,
    /// Current that each joint needs to hold the posture on the soles, as a multiple of its motor's continuous current; none if the robot
    /// does not stand on its soles.
    load: Vec<(String, f32)>,
}

/// A draggable point of a limb, robot frame, m.
pub(super) struct Handle {
    pub(super) point: Point,
    pub(super) at: Vec3,
    /// The joints that move it most directly, each with a point on its axis and the direction of the axis.
    pub(super) joints: Vec<(Joint, Vec3, Vec3)>,
}

/// Position of a handle on the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Point {
    Hips,
    Face,
    Elbow,
    Hand,
    Knee,
    Ankle(Side),
    Toes(Side),
}

/// Violations of the motors' limits in the motion from one posture to the next.
#[derive(Serialize)]
pub(super) struct Limits {
    /// Joints beyond their ranges, with angle and nearest limit, degrees.
    beyond: Vec<(String, f32, f32)>,
    /// Joints faster than their motors, with the largest speed and its limit, °/s.
    fast: Vec<(String, f32, f32)>,
    /// Minimum duration, s.
    least: f32,
}

pub(super) fn shape(model: &'static SimulatedModel, angles: &Joints) -> Shape {
    let skeleton = Skeleton::of(model, angles);
    let [left, right] = Side::BOTH.map(|side| skeleton.sole(side).translation.z);
    let ground = ground_from_robot(model, if left <= right { Side::Left } else { Side::Right }, angles);
    let place = |pose: Affine3A, point: Vec3| (ground * pose).transform_point3(point);
    let at = |segment| place(skeleton.pose(segment), Vec3::ZERO);
    let neck = at(Segment::Neck);
    let hips = place(Affine3A::IDENTITY, Vec3::ZERO);
    let mut lines = vec![vec![hips, neck, place(skeleton.pose(Segment::Head), model.dimensions.top_camera.position)]];
    for side in Side::BOTH {
        let hand = model.dimensions.hand * Vec3::new(1.0, side.sign(), 1.0);
        let hand = place(skeleton.pose(Segment::Hand(side)), hand);
        lines.push(vec![neck, at(Segment::Shoulder(side)), at(Segment::Elbow(side)), at(Segment::Hand(side)), hand]);
        lines.push(vec![hips, at(Segment::Thigh(side)), at(Segment::Tibia(side)), at(Segment::Ankle(side))]);
    }
    let sole = |side: Side| -> Vec<Vec3> {
        let point = |point: &Vec2| place(skeleton.sole(side), Vec3::new(point.x, side.sign() * point.y, 0.0));
        model.dimensions.sole_outline.iter().map(point).collect()
    };
    let soles = Side::BOTH.map(sole);
    let centre = ground.transform_point3(skeleton.centre_of_mass());
    let loaded = soles.iter().flatten().filter(|point| point.z < CONTACT).map(|point| point.xy()).collect();
    let all = |points: &Vec<Vec3>| points.iter().map(Vec3::to_array).collect();
    let margin = margin(loaded, centre.xy());
    Shape {
        lines: lines.iter().map(all).collect(),
        soles: soles.iter().map(all).collect(),
        centre: centre.to_array(),
        torso: rows(ground),
        right_sole: rows(ground * skeleton.sole(Side::Right)),
        margin,
        load: if margin > 0.0 { load(model, angles, &skeleton, ground) } else { Vec::new() },
    }
}

/// Returns rotation and translation as three rows.
pub(super) fn rows(pose: Affine3A) -> [f32; 12] {
    let [x, y, z, at] = pose.to_cols_array_2d();
    core::array::from_fn(|index| [x, y, z, at][index % 4][index / 4])
}

pub(super) fn handles(model: &'static SimulatedModel, angles: &Joints) -> Vec<Handle> {
    let skeleton = Skeleton::of(model, angles);
    let origin = |segment| Vec3::from(skeleton.pose(segment).translation);
    let on = |segment, point: Vec3| skeleton.pose(segment).transform_point3(point);
    let toes = model.dimensions.sole_outline.iter().map(|point| point.x).fold(0.0, f32::max);
    let face = on(Segment::Head, model.dimensions.top_camera.position);
    let head = &[Joint::HeadYaw, Joint::HeadPitch];
    let mut handles = vec![
        handle(model, angles, Point::Hips, Segment::Torso, Vec3::ZERO, &[]),
        handle(model, angles, Point::Face, Segment::Head, face, head),
    ];
    for side in Side::BOTH {
        let (arm, leg) = (side.arm(), model.leg_joints(side));
        let hand = on(Segment::Hand(side), model.dimensions.hand * Vec3::new(1.0, side.sign(), 1.0));
        let tip = skeleton.sole(side).transform_point3(Vec3::X * toes);
        handles.extend([
            handle(model, angles, Point::Elbow, Segment::Biceps(side), origin(Segment::Elbow(side)), &arm[..2]),
            handle(model, angles, Point::Hand, Segment::Hand(side), hand, &arm[2..5]),
            handle(model, angles, Point::Knee, Segment::Thigh(side), origin(Segment::Tibia(side)), &leg[..3]),
            handle(model, angles, Point::Ankle(side), Segment::Tibia(side), origin(Segment::Ankle(side)), &leg[3..4]),
            handle(model, angles, Point::Toes(side), Segment::Foot(side), tip, &leg[4..]),
        ]);
    }
    handles
}

/// A handle at a point of a segment. The axes are those of the motion of the segment by small steps of the joints, so that any order of
/// joints and any direction of axes is right.
fn handle(
    model: &'static SimulatedModel,
    angles: &Joints,
    point: Point,
    segment: Segment,
    at: Vec3,
    joints: &[Joint],
) -> Handle {
    let of = |&joint: &Joint| {
        let pose = |step: f32| {
            let mut moved = *angles;
            moved[joint] += step;
            Skeleton::of(model, &moved).pose(segment)
        };
        let own = pose(0.0).inverse().transform_point3(at);
        let [after, before] = [pose(STEP), pose(-STEP)];
        let turn = Quat::from_mat3a(&(after.matrix3 * before.matrix3.transpose())).to_scaled_axis() / (2.0 * STEP);
        let speed = (after.transform_point3(own) - before.transform_point3(own)) / (2.0 * STEP);
        let moves = turn.length() > 0.5 && speed.length() > LEVER;
        moves.then(|| (joint, at + turn.cross(speed) / turn.length_squared(), turn.normalize()))
    };
    Handle { point, at, joints: joints.iter().filter_map(of).collect() }
}

/// Loads of a posture at rest, by the principle of virtual work: the torque of a joint is the derivative by its angle of the potential
/// energy of all masses less that of the forces of the ground at the feet, while the torso stands still. Two feet on the ground share
/// the weight so that the centre of pressure is below the centre of mass, with no moments against each other.
fn load(model: &'static SimulatedModel, angles: &Joints, skeleton: &Skeleton, ground: Affine3A) -> Vec<(String, f32)> {
    let middle = |side: Side| (ground * skeleton.sole(side)).transform_point3(Vec3::X * model.extents.sole_middle);
    let [left, right] = Side::BOTH.map(middle);
    let centre = ground.transform_point3(skeleton.centre_of_mass()).with_z(0.0);
    let between = (left - right).with_z(0.0);
    let share = match [left, right].map(|foot| foot.z < CONTACT) {
        [true, true] => ((centre - right).dot(between) / between.length_squared()).clamp(0.0, 1.0),
        [is_left, _] => f32::from(u8::from(is_left)),
    };
    let off = centre - (right + share * between).with_z(0.0);
    // Centre of pressure of each foot, in the frame of its sole.
    let to_sole = |side: Side, foot: Vec3| (ground * skeleton.sole(side)).inverse().transform_point3(foot + off);
    let feet =
        [(Side::Left, share, to_sole(Side::Left, left)), (Side::Right, 1.0 - share, to_sole(Side::Right, right))];
    let up = ground.inverse().transform_vector3(Vec3::Z);
    let energy = |angles: &Joints| {
        let moved = Skeleton::of(model, angles);
        let ground =
            feet.iter().map(|(side, share, point)| *share * up.dot(moved.sole(*side).transform_point3(*point)));
        model.total_mass() * GRAVITY * (up.dot(moved.centre_of_mass()) - ground.sum::<f32>())
    };
    let of = |joint: &Joint| {
        let at = |step: f32| {
            let mut moved = *angles;
            moved[*joint] += step;
            energy(&moved)
        };
        let actuator = &model.actuators[*joint];
        let current = actuator.current((at(STEP) - at(-STEP)) / (2.0 * STEP));
        (format!("{joint:?}"), current / actuator.continuous_current())
    };
    model.joints.iter().map(of).filter(|(_, load)| load.is_finite()).collect()
}

/// Returns the distance of a point from the edge of the convex hull of others; positive inside.
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
pub(super) fn limits(model: &'static RobotModel, from: &Joints, to: &Joints, peak: f32) -> Limits {
    let named = |joint: Joint, found: f32, limit: f32| (format!("{joint:?}"), found.to_degrees(), limit.to_degrees());
    let (mut beyond, mut fast, mut least) = (Vec::new(), Vec::new(), 0.0_f32);
    for &joint in model.joints {
        let (range, angle, most) = (model.limits[joint], to[joint], model.max_speeds[joint]);
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
    use bica_motion::model::simulation::NAO;

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
    fn load_is_the_moment_of_the_carried_masses() {
        let mut posture = NAO.stand;
        posture[Joint::LShoulderPitch] = 0.0;
        let skeleton = Skeleton::of(NAO, &posture);
        let shoulder = skeleton.pose(Segment::Shoulder(Side::Left)).translation;
        // In the stand the torso is upright.
        let moment = |segment: &Segment| {
            let mass = NAO.masses.of(*segment);
            mass.mass * GRAVITY * (skeleton.pose(*segment).transform_point3(mass.centre).x - shoulder.x)
        };
        let torque: f32 = Segment::ALL[3..8].iter().map(moment).sum();
        let actuator = &NAO.actuators[Joint::LShoulderPitch];
        let expected = actuator.current(torque) / actuator.continuous_current();
        let of = |posture: &Joints, joint: Joint| {
            let name = format!("{joint:?}");
            shape(NAO, posture).load.into_iter().find(|(one, _)| *one == name).expect("a load").1
        };
        let found = of(&posture, Joint::LShoulderPitch);
        assert!((found / expected - 1.0).abs() < 0.05, "{found} {expected}");
        // Both legs bear the same; on one leg it bears more, and a leg in the air little.
        let [left, right] = [Joint::LHipRoll, Joint::RHipRoll].map(|joint| of(&NAO.stand, joint));
        assert!((left - right).abs() < 0.02 && left < 0.1, "{left} {right}");
        let kick = NAO.dynamic_profile.kicks.front.frames[1].pose.legs(NAO, Side::Left, &NAO.dynamic_profile.gait);
        let mut limbs = NAO.dynamic_profile.gait.stand(NAO);
        limbs.legs = kick;
        let lifted = limbs.joints(NAO);
        let [free, bears] = [Joint::LHipRoll, Joint::RHipRoll].map(|joint| of(&lifted, joint));
        assert!(bears > 3.0 * free && bears > 3.0 * right, "{free} {bears}");
    }

    #[test]
    fn the_stand_stands_and_a_fast_far_motion_is_reported() {
        let shape = shape(NAO, &NAO.stand);
        assert!(shape.margin > 0.03 && shape.centre[2] > 0.2, "{} {:?}", shape.margin, shape.centre);
        let mut far = NAO.stand;
        far[Joint::LShoulderPitch] = -2.5;
        let limits = limits(NAO, &NAO.stand, &far, 1.0 / 0.1);
        assert_eq!((&*limits.beyond[0].0, &*limits.fast[0].0), ("LShoulderPitch", "LShoulderPitch"));
        assert!(limits.least > 0.3, "{}", limits.least);
    }
}
