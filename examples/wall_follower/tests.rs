//! Tests of the wall follower by the names of its states.

use bica::action::perform;
use bica::prelude::*;
use bica::runner::harness::{Harness, InWorld};

use super::robot::{Explorer, WallFollower};
use super::room::Room;

fn start() -> Harness<WallFollower, InWorld<Room>> {
    Harness::new(WallFollower::new()).in_world(Room::new())
}

#[test]
fn robot_finds_wall_and_follows_it() {
    let mut test = start();
    test.stays::<Explorer>("search_wall", Duration::from_secs(2));
    test.reaches::<Explorer>("turn_left", Duration::from_secs(10));
    test.reaches::<Explorer>("follow_wall", Duration::from_secs(3));
}

#[test]
fn robot_drives_around_end_of_wall() {
    let mut test = start();
    test.reaches::<Explorer>("round_end", Duration::from_secs(60));
    test.reaches::<Explorer>("follow_wall", Duration::from_secs(5));
}

#[test]
fn lap_ends_without_touching_a_wall() {
    let mut test = start();
    test.reaches::<Explorer>("arrive", Duration::from_secs(200));
    test.run_for(Duration::from_secs(1));
    let before = test.world().to_string();
    test.stays::<Explorer>("arrive", Duration::from_secs(5));
    assert_eq!(test.world().to_string(), before, "it stands");
    assert!(!test.world().collided(), "{before}");
}

#[test]
fn wall_end_starts_rounding() {
    let mut test = start();
    test.reaches::<Explorer>("follow_wall", Duration::from_secs(20));
    test.world_mut().put([3.0, 3.0], 0.0);
    let took = test.reaches::<Explorer>("round_end", Duration::from_secs(1));
    assert!(took <= Duration::from_millis(80), "two periods at 25 Hz: {took:?}");
}

#[test]
fn robot_turns_before_a_box_that_an_operator_places() {
    let mut test = start();
    test.stays::<Explorer>("search_wall", Duration::from_secs(2));
    let mut act = |name: &str, values: &[f32]| {
        let values: Vec<_> = values.iter().map(|&value| Value::F32(value)).collect();
        perform(test.world_mut().actions(), name, &values).map_err(|refusal| refusal.to_string())
    };
    assert_eq!(act("place_box", &[3.2, 2.375]), Ok(()), "0.8 m ahead of the robot");
    assert_eq!(act("push", &[0.0, 0.5, 0.0]), Err("`world.push`: a wall or the box is in the way".to_owned()));
    assert_eq!(act("push", &[9.0, 0.5, 0.0]), Err("`world.direction`: 9 is outside -3.15..=3.15".to_owned()));
    let took = test.reaches::<Explorer>("turn_left", Duration::from_secs(2));
    assert!(!test.world().collided(), "{took:?}");
}

#[test]
fn stop_brakes_within_200_ms_until_released() {
    let mut test = start();
    test.run_for(Duration::from_secs(3));
    test.tree_mut().modulate("Drive", "stop", &[]).expect("a stop");
    test.run_for(Duration::from_millis(200));
    let before = test.world().to_string();
    test.run_for(Duration::from_secs(5));
    assert_eq!(test.world().to_string(), before, "it stands");
    test.tree_mut().modulate("Drive", "release", &[]).expect("a release");
    test.run_for(Duration::from_secs(1));
    assert_ne!(test.world().to_string(), before, "it drives");
}
