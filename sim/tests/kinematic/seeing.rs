use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{camera, ground_from_robot};
use bica_motion::model::simulation::NAO;
use bica_motion::pose::{Pose2, rotate};
use bica_motion::robot::{CameraId, Command};
use bica_motion::side::Side;
use bica_sim::PixelLabel;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use glam::{Affine3A, Vec2, Vec3};
use rand_pcg::{Pcg32, rand_core::Rng};

use crate::support::alone;

const BALL_RADIUS: f32 = 0.0325;
const SIZE: Vec2 = Vec2::new(320.0, 240.0);
const FOCAL: Vec2 = Vec2::new(618.66 / 2.0, 617.16 / 2.0);

/// Returns the pose of a camera from joint angles, standing on the left foot.
fn camera_pose(id: CameraId, robot: Pose2, angles: &Joints) -> Affine3A {
    let from_ground = ground_from_robot(NAO, Side::Left, angles);
    let under_hips = Pose2::new(from_ground.translation.x, from_ground.translation.y, 0.0);
    let ground = robot * under_hips.inverse();
    let field = Affine3A::from_translation(ground.position.extend(0.0)) * Affine3A::from_rotation_z(ground.heading);
    field * from_ground * camera(NAO, id, angles)
}

/// Projects a point in the camera frame to the image.
fn pixel(seen: Vec3) -> Vec2 {
    SIZE / 2.0 - FOCAL * Vec2::new(seen.y, seen.z) / seen.x
}

/// Returns blue and red chroma of a pixel.
fn chroma(yuyv: &[u8], u: usize, v: usize) -> (i32, i32) {
    let pair = &yuyv[(v * 320 + u / 2 * 2) * 2..][..4];
    (pair[1].into(), pair[3].into())
}

/// Turns the head, waits until it is still, and returns the next image with the true joint angles.
fn image_at(world: &mut KinematicWorld, id: CameraId, yaw: f32, pitch: f32) -> (Vec<u8>, Joints) {
    let mut targets = NAO.stand;
    (targets[Joint::HeadYaw], targets[Joint::HeadPitch]) = (yaw, pitch);
    for _ in 0..60 {
        world.act(&Command { camera: id, ..Command::new(targets, 1.0) });
    }
    loop {
        if let Some(image) = world.sensors().image {
            return (image.yuyv.to_vec(), targets);
        }
        world.act(&Command { camera: id, ..Command::new(targets, 1.0) });
    }
}

/// Returns centroid and area of the pixels near a point that are as red as only a ball is.
fn orange(yuyv: &[u8], near: Vec2, within: f32) -> (Vec2, f32) {
    let (mut sum, mut weight) = (Vec2::ZERO, 0.0);
    for v in 0..240 {
        for u in 0..160 {
            let at = Vec2::new(2.0 * u as f32 + 0.5, v as f32);
            let (_, cr) = chroma(yuyv, 2 * u, v);
            if at.distance(near) < within && cr > 138 {
                let share = ((cr - 128) as f32 / 40.0).min(1.0) * 2.0;
                sum += at * share;
                weight += share;
            }
        }
    }
    (sum / weight, weight)
}

#[test]
fn image_and_mask_show_ball_at_its_projection() {
    let mut random = Pcg32::new(7, 7);
    let mut any = |low: f32, high: f32| low + (high - low) * (random.next_u32() >> 8) as f32 / 16_777_216.0;
    let mut seen = 0;
    for round in 0..60 {
        let id = if round % 2 == 0 { CameraId::Top } else { CameraId::Bottom };
        let robot = Pose2::new(any(-1.5, 1.0), any(-1.0, 1.0), any(-3.0, 3.0));
        let (yaw, pitch) = (any(-0.8, 0.8), any(-0.2, 0.3));
        let distance = if id == CameraId::Top { any(0.9, 2.2) } else { any(0.35, 0.8) };
        let ball = robot.place(rotate(Vec2::new(distance, 0.0), yaw + any(-0.3, 0.3)));
        let mut world = alone(round, robot, ball);
        let (image, angles) = image_at(&mut world, id, yaw, pitch);
        let centre = camera_pose(id, robot, &angles).inverse().transform_point3(ball.extend(BALL_RADIUS));
        let radius = FOCAL.x * BALL_RADIUS / centre.x;
        // The outline of a sphere is an ellipse whose centre lies farther out than the projected centre of the sphere.
        let stretch = centre.x * centre.x / (centre.x * centre.x - BALL_RADIUS * BALL_RADIUS);
        let expected = SIZE / 2.0 + (pixel(centre) - SIZE / 2.0) * stretch;
        let room = Vec2::splat(radius + 6.0);
        if centre.x < 0.1 || expected.clamp(room, SIZE - room) != expected {
            continue;
        }
        seen += 1;
        let (found, area) = orange(&image, expected, radius + 6.0);
        assert!(found.distance(expected) < 1.0, "round {round}: {found}, expected {expected}, radius {radius}");
        let disc = core::f32::consts::PI * radius * radius;
        assert!((0.6..1.6).contains(&(area / disc)), "round {round}: {area} of {disc}");
        let labels = world.segmentation_mask();
        let shown = labels.iter().filter(|label| **label == PixelLabel::Ball).count() as f32;
        assert!((0.8..1.6).contains(&(shown / disc)), "round {round}: {shown} pixels of {disc}");
        assert_eq!(labels[expected.y as usize * 320 + expected.x as usize], PixelLabel::Ball, "round {round}");
    }
    assert!(seen > 20, "{seen}");
}
