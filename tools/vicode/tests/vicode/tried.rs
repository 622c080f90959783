//! `Explorer` as it was tried in VICODE.

use bica::Duration;
use bica::runner::harness::Harness;
use crate::wall_follower::Explorer;
use crate::wall_follower::WallFollower;

#[test]
#[ignore = "set the inputs of the conditions first"]
fn search_wall_then_turn_left() {
    let mut test = Harness::new(WallFollower::new());
    test.stays::<Explorer>("search_wall", Duration::from_millis(2000));
    // From here `wall_ahead` has to hold (it reads WallDetector): `wall.ahead < CORNER`.
    test.reaches::<Explorer>("turn_left", Duration::from_millis(80));
    test.stays::<Explorer>("turn_left", Duration::from_millis(3500));
    // From here `wall_ahead` must not hold (it reads WallDetector): `wall.ahead < CORNER`.
    test.stays::<Explorer>("turn_left", Duration::from_millis(1400));
}
