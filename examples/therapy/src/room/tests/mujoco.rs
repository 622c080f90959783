//! Sessions in MuJoCo.

use super::*;

fn body(seed: u64) -> Body {
    Body::with_forces(seed).unwrap_or_else(|failure| panic!("{failure:?}"))
}

#[test]
fn a_session_keeps_ranges_speed_and_time() {
    play_long("language", 1..=1, body);
}

#[test]
fn stop_slows_all_joints_within_half_a_second() {
    stop_at_random(1..=4, 10, body);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_stops_end_all_motion_within_half_a_second() {
    stop_at_random(1..=20, 50, body);
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_sessions_keep_ranges_speed_and_time() {
    std::thread::scope(|scope| {
        for name in ["physiotherapy", "music", "language"] {
            scope.spawn(move || play_long(name, 1..=20, body));
        }
    });
}

#[test]
fn walk_goes_the_way_and_ends_on_its_feet() {
    for (text, [forward, left, turn]) in [
        ("walk forward 0.3 m", [0.3, 0.0, 0.0]),
        ("walk backward 0.2 m", [-0.2, 0.0, 0.0]),
        ("walk left 0.2 m", [0.0, 0.2, 0.0]),
        ("turn right 60", [0.0, 0.0, -60.0_f32]),
    ] {
        let mut test = start(&format!("{text}\nwait walk at most 30 s\nwait 2 s"), body(1));
        test.reaches::<Session>("finished", ms(40_000));
        let Body::Forces(humanoid) = &test.world().body else { panic!("no forces") };
        let at = humanoid.ground_pose();
        assert!(at.position.distance([forward, left].into()) < 0.06, "{text}: {at:?}");
        assert!((at.heading.to_degrees() - turn).abs() < 10.0 && !has_fallen(&test), "{text}: {at:?}");
    }
}
