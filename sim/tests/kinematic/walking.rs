use bica_motion::model::{Nao, RobotModel};
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use bica_motion::stiffness::Stiffness;
use bica_motion::walk::{Feedback, Velocity, Walk};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use glam::Vec2;

use crate::support::{SWAY, alone, command, glide};

/// Takes one slow step: lifts the swing foot, sets it down ahead and shifts the hips over it.
fn step(world: &mut KinematicWorld<Nao>, swing: Side, behind: f32, ahead: f32) {
    let feet = |swing_x: f32, lift: f32, support_x: f32| {
        let mut feet = [(support_x, 0.05 + swing.sign() * SWAY, 0.0), (support_x, -0.05 + swing.sign() * SWAY, 0.0)];
        feet[swing.index()].0 = swing_x;
        feet[swing.index()].2 = lift;
        feet
    };
    let over_other = |x: f32| {
        let feet = feet(x, 0.0, 0.0);
        let swung = feet[swing.index()].0;
        feet.map(|(x, y, lift)| (x - swung, y - 2.0 * swing.sign() * SWAY, lift))
    };
    glide(world, feet(behind, 0.0, 0.0), feet(behind, 0.02, 0.0), 20);
    glide(world, feet(behind, 0.02, 0.0), feet(ahead, 0.02, 0.0), 40);
    glide(world, feet(ahead, 0.02, 0.0), feet(ahead, 0.0, 0.0), 20);
    glide(world, feet(ahead, 0.0, 0.0), over_other(ahead), 50);
}

#[test]
fn scripted_steps_move_robot_by_their_length() {
    let mut world = alone(3, Pose2::new(-2.0, 0.0, 0.0), Vec2::new(2.0, 1.5));
    let start = [(0.0, 0.05, 0.0), (0.0, -0.05, 0.0)];
    let over_right = start.map(|(x, y, lift)| (x, y + SWAY, lift));
    glide(&mut world, start, over_right, 60);
    let before = world.referee().robot().position;
    for index in 0..10 {
        let behind = if index == 0 { 0.0 } else { -0.04 };
        step(&mut world, if index % 2 == 0 { Side::Left } else { Side::Right }, behind, 0.04);
    }
    let moved = world.referee().robot().position - before;
    assert_eq!(world.referee().falls(), 0);
    assert!((moved.x - 0.4).abs() < 0.04, "{moved}");
    assert!(moved.y.abs() < 0.06, "{moved}");
}

#[test]
fn walk_covers_commanded_distance_and_no_other() {
    // The gait loses up to 8 % of the distance while it starts and slips by some centimetres.
    let tolerance = Pose2::new(0.08, 0.08, 0.1);
    for velocity in [
        Velocity::new(0.1, 0.0, 0.0),
        Velocity::new(-0.1, 0.0, 0.0),
        Velocity::new(0.0, 0.08, 0.0),
        Velocity::new(0.0, 0.0, 0.25),
    ] {
        let moved = walk(&mut alone(5, Pose2::ORIGIN, Vec2::new(2.0, 1.5)), velocity, 1_000, |_| ());
        let expected = [10.0 * velocity.forward, 10.0 * velocity.left, 10.0 * velocity.turn];
        let off = [moved.position.x - expected[0], moved.position.y - expected[1], moved.heading - expected[2]];
        assert!(off[0].abs() < tolerance.position.x, "{velocity:?}: {moved:?}");
        assert!(off[1].abs() < tolerance.position.y, "{velocity:?}: {moved:?}");
        assert!(off[2].abs() < tolerance.heading, "{velocity:?}: {moved:?}");
    }
}

#[test]
fn goal_post_stops_robot_and_presses_its_bumper() {
    let mut world = alone(5, Pose2::new(2.5, 0.7, 0.0), Vec2::new(0.0, 1.5));
    let mut nearest = f32::INFINITY;
    let mut pressed = false;
    walk(&mut world, Velocity::new(0.15, 0.0, 0.0), 1_000, |world| {
        let buttons = world.sensors().buttons;
        pressed |= buttons.left_bumper || buttons.right_bumper;
        nearest = nearest.min(world.referee().robot().position.distance(Vec2::new(3.05, 0.7)));
    });
    assert!((0.1399..0.25).contains(&nearest), "{nearest}");
    assert!(pressed && world.referee().count(|event| *event == Event::Collision) > 0);
}

/// Walks for some cycles and calls `watch` after each. Returns the final pose relative to the first.
fn walk(
    world: &mut KinematicWorld<Nao>,
    velocity: Velocity,
    cycles: u32,
    mut watch: impl FnMut(&mut KinematicWorld<Nao>),
) -> Pose2 {
    let mut walk = Walk::<Nao>::new(&Nao::KINEMATIC_PROFILE.gait);
    let start = world.referee().robot();
    for _ in 0..cycles {
        let sensors = world.sensors();
        let limbs = walk.step(velocity, &Feedback::from(&sensors), 0.01);
        let stiffness = Stiffness::Walk.joints::<Nao>();
        world.act(&bica_motion::robot::Command { stiffness, ..command(limbs.joints()) });
        watch(world);
    }
    assert_eq!(world.referee().falls(), 0, "{velocity:?}");
    start.inverse() * world.referee().robot()
}
