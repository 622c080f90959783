//! Bodies of the robots as links with triangles, for the map in three dimensions.

use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{SEGMENTS, Segment, Skeleton};
use bica_motion::model::simulation::{Figure, Paint, Part, SimulatedModel, Solid};
use glam::{Affine3A, Quat, Vec3};
use serde::Serialize;

use super::robot::rows;

/// Step of a joint with which its axis is determined, rad.
const STEP: f32 = 0.1;
/// Minimum angle of a step that is no rounding error, rad.
const LEAST: f32 = 0.01;
/// Number of sides of a tube, and of meridians of a sphere.
const SIDES: usize = 10;
/// Number of bands of a sphere.
const BANDS: usize = 5;

/// Body of a robot: its links from the torso outwards.
#[derive(Serialize)]
pub(super) struct Body {
    /// Frame of the first link, as named in outputs.
    frame: &'static str,
    /// All joints of the robot.
    #[serde(skip)]
    pub(super) joints: Vec<String>,
    links: Vec<Link>,
}

/// A rigid link.
#[derive(Serialize)]
struct Link {
    /// Index of the link that carries it; none for the first one.
    parent: Option<usize>,
    /// Pose in the frame of its parent while the joint is at 0: three rows of four numbers, m.
    pose: [f32; 12],
    /// Joint that rotates it about `axis`, a unit vector through the origin of its frame.
    joint: Option<String>,
    axis: [f32; 3],
    meshes: Vec<Mesh>,
}

/// Triangles of one colour, counter-clockwise from outside: three corners each, frame of the link, mm.
#[derive(Serialize)]
struct Mesh {
    colour: &'static str,
    triangles: Vec<[i16; 3]>,
}

impl Body {
    pub(super) fn of(model: &'static SimulatedModel) -> Self {
        let Figure { trunk, side, head, .. } = model.figure;
        let right = side.iter().map(Part::mirrored);
        let parts: Vec<Part> = trunk.iter().chain(*side).chain(*head).copied().chain(right).collect();
        let links = (0..SEGMENTS).map(|index| link(model, index, &parts)).collect();
        Self { frame: "torso", joints: model.joints.iter().map(|joint| format!("{joint:?}")).collect(), links }
    }
}

/// Returns the index of the segment that carries another one.
fn parent(index: usize) -> Option<usize> {
    match Segment::ALL[index] {
        Segment::Torso => None,
        Segment::Neck | Segment::Shoulder(_) | Segment::Pelvis(_) => Some(0),
        _ => Some(index - 1),
    }
}

fn link(model: &'static SimulatedModel, index: usize, parts: &[Part]) -> Link {
    let in_parent = |angles: &Joints| {
        let skeleton = Skeleton::of(model, angles);
        let above = parent(index).map_or(Affine3A::IDENTITY, |parent| skeleton.pose(Segment::ALL[parent]));
        above.inverse() * skeleton.pose(Segment::ALL[index])
    };
    let rest = Joints::all(0.0);
    let pose = in_parent(&rest);
    let turn = |&joint: &Joint| {
        let mut moved = rest;
        moved[joint] = STEP;
        let turn = Quat::from_mat3a(&(pose.matrix3.transpose() * in_parent(&moved).matrix3)).to_scaled_axis();
        (turn.length() > LEAST).then(|| (format!("{joint:?}"), turn.normalize()))
    };
    let (joint, axis) = model.joints.iter().find_map(turn).unzip();
    let own = |part: &&Part| part.0 == Segment::ALL[index];
    Link {
        parent: parent(index),
        pose: rows(pose),
        joint,
        axis: axis.unwrap_or(Vec3::Z).to_array(),
        meshes: parts.iter().filter(own).map(Mesh::of).collect(),
    }
}

impl Mesh {
    fn of(&Part(_, paint, solid): &Part) -> Self {
        let colour = match paint {
            Paint::Shell => "#dfe3e8",
            Paint::Joint => "#5b6470",
            Paint::Team => "#3b6fd8",
        };
        let corners = match solid {
            Solid::Sphere(centre, radius) => sphere(centre.into(), radius),
            Solid::Tube(ends, radii) => tube(ends.map(Vec3::from), radii),
            Solid::Block(centre, half) => block(centre.into(), half.into()),
        };
        let rounded = |point: Vec3| point.to_array().map(|metres| (1000.0 * metres).round() as i16);
        Self { colour, triangles: corners.into_iter().map(rounded).collect() }
    }
}

/// Returns the two triangles of a face with four corners.
fn face([a, b, c, d]: [Vec3; 4]) -> [Vec3; 6] {
    [a, b, c, a, c, d]
}

/// Returns the surface between rings of [`SIDES`] points: `point(ring, side)`.
fn between(rings: usize, point: impl Fn(usize, usize) -> Vec3) -> Vec<Vec3> {
    let side = |ring: usize, side: usize| {
        face([point(ring, side), point(ring, side + 1), point(ring + 1, side + 1), point(ring + 1, side)])
    };
    (0..rings - 1)
        .flat_map(|ring| (0..SIDES).flat_map(move |at| [(ring, at)]))
        .flat_map(|(ring, at)| side(ring, at))
        .collect()
}

fn around(side: usize) -> (f32, f32) {
    (std::f32::consts::TAU * side as f32 / SIDES as f32).sin_cos()
}

fn sphere(centre: Vec3, radius: f32) -> Vec<Vec3> {
    between(BANDS + 1, |ring, side| {
        let (sin, cos) = (std::f32::consts::PI * ring as f32 / BANDS as f32).sin_cos();
        let (y, x) = around(side);
        centre + radius * Vec3::new(sin * x, sin * y, -cos)
    })
}

/// A tube with flat ends.
fn tube([from, to]: [Vec3; 2], [first, last]: [f32; 2]) -> Vec<Vec3> {
    let (across, aside) = (to - from).normalize_or(Vec3::Z).any_orthonormal_pair();
    let rings = [(from, 0.0), (from, first), (to, last), (to, 0.0)];
    between(rings.len(), |ring, side| {
        let ((sin, cos), (end, radius)) = (around(side), rings[ring]);
        end + radius * (cos * across + sin * aside)
    })
}

fn block(centre: Vec3, half: Vec3) -> Vec<Vec3> {
    let axes = [(Vec3::X, Vec3::Y, Vec3::Z), (Vec3::Y, Vec3::Z, Vec3::X), (Vec3::Z, Vec3::X, Vec3::Y)];
    let faces = axes.into_iter().flat_map(|(out, u, v)| [(out, u, v), (-out, v, u)]);
    let corners = faces.flat_map(|(out, u, v)| face([out - u - v, out + u - v, out + u + v, out - u + v]));
    corners.map(|corner| centre + half * corner).collect()
}

#[cfg(test)]
mod tests {
    use bica_motion::model::simulation::HUMANOIDS;

    use super::*;

    /// Poses of the links as the page computes them.
    fn posed(body: &Body, angle: impl Fn(&str) -> f32) -> Vec<Affine3A> {
        let mut poses: Vec<Affine3A> = Vec::new();
        for Link { parent, pose, joint, axis, .. } in &body.links {
            let matrix = Affine3A::from_cols_array(&[0, 4, 8, 1, 5, 9, 2, 6, 10, 3, 7, 11].map(|at| pose[at]));
            let turn = joint.as_deref().map_or(0.0, &angle);
            let own = matrix * Affine3A::from_axis_angle((*axis).into(), turn);
            poses.push(parent.map_or(own, |parent| poses[parent] * own));
        }
        poses
    }

    fn follows(model: &'static SimulatedModel) {
        let body = Body::of(model);
        for number in 0..50_u16 {
            let mut angles = Joints::all(0.0);
            for (index, &joint) in model.joints.iter().enumerate() {
                angles[joint] = ((f32::from(number) + 1.0) * (index as f32 + 1.0) * 0.618).sin();
            }
            let skeleton = Skeleton::of(model, &angles);
            let of = |name: &str| {
                let joint = model.joints.iter().find(|joint| format!("{joint:?}") == name);
                angles[*joint.expect("a joint of the robot")]
            };
            for (segment, pose) in Segment::ALL.into_iter().zip(posed(&body, of)) {
                let expected = skeleton.pose(segment);
                assert!(pose.abs_diff_eq(expected, 1e-3), "{} {segment:?} {pose:?} {expected:?}", model.name);
            }
        }
        let volume = |mesh: &Mesh| {
            let corners: Vec<Vec3> = mesh.triangles.iter().map(|at| Vec3::from(at.map(f32::from))).collect();
            corners.chunks(3).map(|at| at[0].dot(at[1].cross(at[2]))).sum::<f32>()
        };
        let meshes: Vec<_> = body.links.iter().flat_map(|link| &link.meshes).collect();
        assert!(meshes.len() > 10, "{} parts of {}", meshes.len(), model.name);
        assert!(meshes.iter().all(|mesh| volume(mesh) > 0.0), "a surface of {} is inside out", model.name);
    }

    #[test]
    fn links_of_each_robot_follow_its_kinematics() {
        HUMANOIDS.iter().copied().for_each(follows);
    }
}
