use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_motion::stiffness::Stiffness;
use bica_motion::walk::{Feedback, Velocity, Walk};
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::referee::Event;
use glam::Vec2;

use crate::support::alone;

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
    world: &mut KinematicWorld,
    velocity: Velocity,
    cycles: u32,
    mut watch: impl FnMut(&mut KinematicWorld),
) -> Pose2 {
    let mut walk = Walk::new(NAO, &NAO.kinematic_profile.gait);
    let start = world.referee().robot();
    for _ in 0..cycles {
        let sensors = world.sensors();
        let limbs = walk.step(velocity, &Feedback::from(&sensors), 0.01);
        let stiffness = Stiffness::Walk.joints(NAO);
        world.act(&Command { stiffness, ..Command::new(limbs.joints(NAO), 1.0) });
        watch(world);
    }
    assert_eq!(world.referee().falls(), 0, "{velocity:?}");
    start.inverse() * world.referee().robot()
}
