//! A field with two robots, each in its own world.

use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_sim::match_field::{Entrant, MatchField};
use bica_sim::setup::{Frame, Setup};
use glam::Vec2;

/// A robot of each team: the second one stands 0.7 m ahead of the first one and faces it.
const ENTRANTS: [Entrant; 2] = [
    Entrant { is_second: false, at: Pose2::new(-1.5, 0.0, 0.0) },
    Entrant { is_second: true, at: Pose2::new(0.8, 0.0, 0.0) },
];

fn field() -> MatchField {
    let setup = Setup { seed: 3, frame: Frame::Small, ..Setup::default() };
    MatchField::in_mujoco(NAO, &setup, &ENTRANTS).expect("there is room")
}

#[test]
fn robots_of_a_match_see_and_know_each_other() {
    let stand = Command::new(NAO.stand, 1.0);
    let mut field = field();
    (0..50).for_each(|_| field.act(&[stand; 2]));
    assert_eq!(field.failure(), None);
    let other = |robot: usize| field.truth(robot).others()[0].position;
    assert!(other(0).distance(Vec2::new(-0.8, 0.0)) < 0.05 && other(1).distance(Vec2::new(1.5, 0.0)) < 0.05);
    // The image of the first robot without the second one differs in many pixels.
    let image = |field: &mut MatchField| loop {
        field.act(&[stand; 2]);
        if let Some(image) = field.sensors(0).image {
            return image.yuyv.to_vec();
        }
    };
    let with = image(&mut field);
    field.put_robot(1, Pose2::new(-2.0, 1.5, 0.0)).expect("a free place");
    let without = image(&mut field);
    let changed = with.iter().zip(&without).filter(|(one, other)| one.abs_diff(**other) > 40).count();
    assert!(changed > with.len() / 50, "{changed} of {} bytes", with.len());
}

#[test]
fn ball_of_a_match_is_one() {
    let stand = Command::new(NAO.stand, 1.0);
    let mut field = field();
    field.put_ball(Vec2::new(0.4, 1.0)).expect("a free place");
    (0..20).for_each(|_| field.act(&[stand; 2]));
    let balls = [0, 1].map(|robot| field.truth(robot).ball());
    assert!(balls[0].distance(Vec2::new(0.4, 1.0)) < 0.01 && balls[0].distance(-balls[1]) < 0.01, "{balls:?}");
}
