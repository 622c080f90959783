//! The built-in world with a second robot model: each expected number follows from that model.

use bica_motion::head::HeadAngles;
use bica_motion::joints::{Joint, Joints};
use bica_motion::kick::{Kick, KickMotion};
use bica_motion::kinematics::{Skeleton, ground_from_robot};
use bica_motion::model::RobotModel;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Command};
use bica_motion::side::Side;
use bica_motion::walk::{Feedback, Velocity, Walk};
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Posture;
use bica_sim::setup::{Setup, Start};
use bica_sim::{PixelLabel, World};
use glam::{Affine3A, Vec2};

use crate::tall::Tall;
use crate::world::CYCLE;

/// A world without other robots in which the robot starts at the centre mark.
fn world(ball: Vec2) -> KinematicWorld<Tall> {
    let start = Some(Start { robot: Pose2::ORIGIN, ball });
    KinematicWorld::new(&Setup { goalkeeper: false, start, ..Setup::default() }).expect("a valid start")
}

fn act(world: &mut KinematicWorld<Tall>, targets: Joints) {
    world.act(&Command::new(targets, 1.0));
}

fn stand(world: &mut KinematicWorld<Tall>, cycles: u32) {
    (0..cycles).for_each(|_| act(world, Tall::STAND));
}

#[test]
fn second_model_stands_with_its_weight_on_its_soles() {
    let mut world = world(Vec2::new(1.0, 1.0));
    stand(&mut world, 500);
    let sensors = world.sensors();
    let (left, right) = (sensors.left_foot, sensors.right_foot);
    assert!((left.total() + right.total() - 20.5 * 9.81).abs() < 2.0, "{left:?} {right:?}");
    // The centre of mass lies between the sensors at x 0.1 and −0.04 m.
    let mass = ground_from_robot::<Tall>(Side::Left, &Tall::STAND)
        .transform_point3(Skeleton::<Tall>::of(&Tall::STAND).centre_of_mass());
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
        let mut walk = Walk::<Tall>::new(&Tall::KINEMATIC_PROFILE.gait);
        for _ in 0..1000 {
            let targets = walk.step(velocity, &Feedback::from(&world.sensors()), CYCLE).joints();
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
    let mut posture = Tall::STAND;
    targets.write(&mut posture);
    let mut yaws = Vec::new();
    for _ in 0..100 {
        act(&mut world, posture);
        yaws.push(world.sensors().angles[Joint::HeadYaw]);
    }
    let step = Tall::MAX_SPEEDS[Joint::HeadYaw] * CYCLE;
    for (cycle, expected) in [(0, 0.0), (1, 0.0), (2, step), (3, 2.0 * step), (99, Tall::LIMITS[Joint::HeadYaw].max)] {
        assert!((yaws[cycle] - expected).abs() < 1e-3, "cycle {cycle}: {} is not {expected}", yaws[cycle]);
    }
}

#[test]
fn image_shows_ball_at_its_projection_of_model_camera() {
    let ball = Vec2::new(2.2, 0.3);
    let mut world = world(ball);
    stand(&mut world, 10);
    let hips = ground_from_robot::<Tall>(Side::Left, &Tall::STAND).translation.z;
    let camera =
        Affine3A::from_translation(hips * glam::Vec3::Z) * Skeleton::<Tall>::of(&Tall::STAND).camera(CameraId::Top);
    let seen = camera.inverse().transform_point3(ball.extend(0.0325));
    let size = Vec2::new(320.0, 240.0);
    let focal = size * Tall::DIMENSIONS.top_camera.focal;
    let expected = size / 2.0 - focal * Vec2::new(seen.y, seen.z) / seen.x;
    let labels = world.segmentation_mask();
    let shown: Vec<Vec2> = (0..labels.len())
        .filter(|&i| labels[i] == PixelLabel::Ball)
        .map(|i| Vec2::new((i % 320) as f32, (i / 320) as f32))
        .collect();
    let found = shown.iter().sum::<Vec2>() / shown.len() as f32;
    assert!(shown.len() > 20 && found.distance(expected) < 1.0, "{found} of {} pixels, not {expected}", shown.len());
}

#[test]
fn kicking_foot_of_second_model_moves_ball() {
    let kick = Kick { foot: Side::Left, ..Kick::ALL[0] };
    let mut world = world(kick.ball(&Tall::KINEMATIC_PROFILE.kicks));
    let mut motion = KickMotion::<Tall>::new(kick, Tall::KINEMATIC_PROFILE);
    while !motion.is_done() {
        let targets = motion.step(&Feedback::from(&world.sensors()), CYCLE).joints();
        act(&mut world, targets);
    }
    let moved = world.referee().ball() - kick.ball(&Tall::KINEMATIC_PROFILE.kicks);
    assert!(moved.x > 0.5 && world.referee().falls() == 0, "{moved}");
}

#[test]
fn ball_has_no_place_within_extents_of_model() {
    let mut world = world(Vec2::new(1.5, 1.0));
    let refused = |world: &mut KinematicWorld<Tall>, y| world.place_ball(Vec2::new(0.0, y)).is_err();
    assert!(refused(&mut world, 0.24) && !refused(&mut world, 0.26));
    let mut leaning = Tall::STAND;
    for ankle in [Joint::LAnklePitch, Joint::RAnklePitch] {
        leaning[ankle] += 0.6;
    }
    (0..200).for_each(|_| act(&mut world, leaning));
    assert_eq!(world.referee().posture(), Posture::Down(bica_motion::fall::Direction::Back));
    // The robot frame is as far from the feet as a fall of this model brings it.
    let at = world.referee().robot().position;
    assert!((at.x + 0.33).abs() < 0.15, "{at}");
    for (y, is_refused) in [(0.62, true), (0.65, false)] {
        assert_eq!(world.place_ball(at + y * Vec2::Y).is_err(), is_refused, "{y}");
    }
}
