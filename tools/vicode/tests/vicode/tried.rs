//! `Player` as it was tried in VICODE.

use bica::Duration;
use bica::runner::harness::Harness;
use bica_player::Forward;
use bica_player::behaviour::Player;

#[test]
#[ignore = "set the inputs of the conditions first"]
fn look_for_ball_then_approach_then_search_net() {
    let mut test = Harness::new(Forward::new());
    test.stays::<Player>("look_for_ball", Duration::from_millis(2000));
    // From here `ball_seen` has to hold (it reads BallDetector): `ball.is_confirmed()`.
    test.reaches::<Player>("approach", Duration::from_millis(100));
    test.stays::<Player>("approach", Duration::from_millis(3490));
    // From here `ball_seen` must not hold (it reads BallDetector): `ball.is_confirmed()`.
    // From here `ball_reached` has to hold (it reads FollowBall): `follow.reached()`.
    test.reaches::<Player>("search_net", Duration::from_millis(100));
    test.stays::<Player>("search_net", Duration::from_millis(1390));
}
