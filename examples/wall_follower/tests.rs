//! Tests of the wall follower by the names of its states.

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
