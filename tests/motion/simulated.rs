//! Built-in world with a second robot model; every expected number follows from that model.

use bica_motion::fall::Direction;
use bica_motion::head::HeadAngles;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kinematics::{Skeleton, ground_from_robot};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command};
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, Walk};
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Posture;
use bica_sim::setup::{Setup, Start};
use bica_sim::{PixelLabel, World};
use glam::{Affine3A, Vec2, Vec3};

use crate::motion::tall::TALL;
use crate::motion::world::CYCLE;

const BALL_RADIUS: f32 = 0.0325;
/// Height of the robot frame of a standing robot, m.
const HIPS: f32 = 0.3225;

/// A world without other robots in which the robot starts at the centre mark.
fn world(ball: Vec2) -> KinematicWorld {
    let start = Some(Start { robot: Pose2::ORIGIN, ball });
    KinematicWorld::new(TALL, &Setup { goalkeeper: false, start, ..Setup::default() }).expect("a valid start")
}

fn act(world: &mut KinematicWorld, targets: Joints) {
    world.act(&Command::new(targets, 1.0));
}

fn stand(world: &mut KinematicWorld, cycles: u32) {
    (0..cycles).for_each(|_| act(world, TALL.stand));
}

/// Projects a point to the image of the top camera of a robot that stands at the origin.
fn pixel(point: Vec3) -> Vec2 {
    let hips = Affine3A::from_translation(HIPS * Vec3::Z);
    let seen = (hips * Skeleton::of(TALL, &TALL.stand).camera(CameraId::Top)).inverse().transform_point3(point);
    let size = Vec2::new(320.0, 240.0);
    size / 2.0 - size * TALL.dimensions.top_camera.focal * Vec2::new(seen.y, seen.z) / seen.x
}

#[test]
fn second_model_stands_with_its_weight_on_its_soles() {
    let mut world = world(Vec2::new(1.0, 1.0));
    stand(&mut world, 500);
    let sensors = world.sensors();
    let (left, right) = (sensors.left_foot, sensors.right_foot);
    assert!((left.total() + right.total() - 20.5 * 9.81).abs() < 2.0, "{left:?} {right:?}");
    // The centre of mass lies between the sensors at x 0.1 and −0.04 m.
    let mass = ground_from_robot(TALL, Side::Left, &TALL.stand)
        .transform_point3(Skeleton::of(TALL, &TALL.stand).centre_of_mass());
    let front = (mass.x + 0.04) / 0.14;
    let measured = (left.front_left + left.front_right) / left.total();
    assert!((measured - front).abs() < 0.03, "{measured} of the force is on the front sensors, not {front}");
    assert_eq!((world.referee().falls(), world.referee().posture()), (0, Posture::Upright));
    assert!(world.referee().robot().position.length() < 1e-4, "{:?}", world.referee().robot());
}

#[test]
fn second_model_walks_commanded_distance() {
    for velocity in [Velocity::new(0.25, 0.0, 0.0), Velocity::new(0.0, 0.1, 0.0)] {
        let mut world = world(Vec2::new(-1.5, 1.5));
        let mut walk = Walk::new(TALL, &TALL.kinematic_profile.gait);
        for _ in 0..1000 {
            let targets = walk.step(velocity, &Feedback::from(&world.sensors()), CYCLE).joints(TALL);
            act(&mut world, targets);
        }
        assert_eq!(world.referee().falls(), 0, "{velocity:?}");
        let (moved, expected) = (world.referee().robot().position, 10.0 * Vec2::new(velocity.forward, velocity.left));
        assert!(moved.distance(expected) < 0.12 * expected.length(), "{moved} is not {expected}");
    }
}

#[test]
fn joints_have_dead_time_speed_and_limits_of_model() {
    let mut world = world(Vec2::new(1.0, 1.0));
    let targets = HeadAngles { yaw: 3.0, pitch: 0.0 };
    let mut posture = TALL.stand;
    targets.write(&mut posture);
    let mut yaws = Vec::new();
    for _ in 0..100 {
        act(&mut world, posture);
        yaws.push(world.sensors().angles[Joint::HeadYaw]);
    }
    let step = TALL.max_speeds[Joint::HeadYaw] * CYCLE;
    for (cycle, expected) in [(0, 0.0), (1, 0.0), (2, step), (3, 2.0 * step), (99, TALL.limits[Joint::HeadYaw].max)] {
        assert!((yaws[cycle] - expected).abs() < 1e-3, "cycle {cycle}: {} is not {expected}", yaws[cycle]);
    }
}

#[test]
fn image_shows_ball_at_its_projection_of_model_camera() {
    let ball = Vec2::new(2.2, 0.3);
    let mut world = world(ball);
    stand(&mut world, 10);
    let expected = pixel(ball.extend(BALL_RADIUS));
    let labels = world.segmentation_mask();
    let shown: Vec<Vec2> = (0..labels.len())
        .filter(|&i| labels[i] == PixelLabel::Ball)
        .map(|i| Vec2::new((i % 320) as f32, (i / 320) as f32))
        .collect();
    let found = shown.iter().sum::<Vec2>() / shown.len() as f32;
    assert!(shown.len() > 20 && found.distance(expected) < 1.0, "{found} of {} pixels, not {expected}", shown.len());
}

#[test]
fn rolling_ball_stops_at_toes_of_model() {
    let mut world = world(Vec2::new(1.0, 0.075));
    world.set_ball(Vec2::new(1.0, 0.075), Vec2::new(-1.0, 0.0)).expect("a free place");
    let mut nearest = f32::INFINITY;
    for _ in 0..200 {
        stand(&mut world, 1);
        nearest = nearest.min(world.referee().ball().x);
    }
    let toes = Skeleton::of(TALL, &TALL.stand).sole(Side::Left).translation.x + 0.15;
    assert!((nearest - (toes + BALL_RADIUS)).abs() < 0.01, "the ball came to {nearest} m, the toes are at {toes} m");
}

#[test]
fn image_shows_other_robot_as_tall_as_model() {
    let setup = Setup { goalkeeper: true, ..Setup::default() };
    let keeper = KinematicWorld::new(TALL, &setup).expect("a valid setup").referee().others()[0].position;
    let start = Some(Start { robot: Pose2::new(keeper.x - 2.0, keeper.y, 0.0), ball: Vec2::new(0.0, 1.5) });
    let mut world = KinematicWorld::new(TALL, &Setup { start, ..setup }).expect("a valid start");
    let labels = world.segmentation_mask();
    let shown = |row: &usize| labels[row * 320..][..320].contains(&PixelLabel::OtherRobot(0));
    let (first, last) = ((0..240).find(shown), (0..240).rfind(shown));
    // The robot's visible box reaches from 0.1 m below its hips to 0.5 m above; its front is 0.08 m nearer than its centre.
    let row = |z: f32| pixel(Vec3::new(1.92, 0.0, HIPS + z)).y;
    for (found, expected) in [(first, row(0.5)), (last, row(-0.1))] {
        let found = found.expect("the keeper is in the image") as f32;
        assert!((found - expected).abs() < 3.0, "row {found}, not {expected}");
    }
}

#[test]
fn ball_has_no_place_within_extents_of_model() {
    let mut world = world(Vec2::new(1.5, 1.0));
    let refused = |world: &mut KinematicWorld, y| world.put_ball(Vec2::new(0.0, y)).is_err();
    assert!(refused(&mut world, 0.24) && !refused(&mut world, 0.26));
    let mut leaning = TALL.stand;
    for ankle in [Joint::LAnklePitch, Joint::RAnklePitch] {
        leaning[ankle] += 0.6;
    }
    let mut upright = Vec2::ZERO;
    while world.referee().posture() == Posture::Upright && world.now().as_secs() < 5 {
        upright = world.referee().robot().position;
        act(&mut world, leaning);
    }
    assert_eq!(world.referee().posture(), Posture::Down(Direction::Back));
    let at = world.referee().robot().position;
    assert!((at.distance(upright) - 0.33).abs() < 0.01, "the robot fell from {upright} to {at}");
    for (y, is_refused) in [(0.62, true), (0.65, false)] {
        assert_eq!(world.put_ball(at + y * Vec2::Y).is_err(), is_refused, "{y}");
    }
}
