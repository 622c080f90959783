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
fn long_stops_end_the_motion_of_all_joints_within_half_a_second() {
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
    for (metres, degrees) in walk_each_way(1..=1) {
        assert!(metres < 0.06 && degrees < 10.0, "{metres} m, {degrees}°");
    }
}

#[test]
#[ignore = "long: `cargo xtask long` runs it"]
fn long_walks_end_on_their_feet() {
    walk_each_way(1..=20);
}

/// Walks each way with each seed, prints how far from their ends the walks end, and returns the largest distance, m and degrees.
fn walk_each_way(seeds: RangeInclusive<u64>) -> Vec<(f32, f32)> {
    let ways = [
        ("walk forward 0.3 m", [0.3, 0.0, 0.0]),
        ("walk backward 0.2 m", [-0.2, 0.0, 0.0]),
        ("walk left 0.2 m", [0.0, 0.2, 0.0]),
        ("walk right 0.2 m", [0.0, -0.2, 0.0]),
        ("turn left 60", [0.0, 0.0, 60.0]),
        ("turn right 60", [0.0, 0.0, -60.0]),
    ];
    let far = |(text, [forward, left, turn]): (&str, [f32; 3])| {
        let far = seeds.clone().map(|seed| {
            let mut test = start(&format!("{text}\nwait walk at most 30 s\nwait 2 s"), body(seed));
            test.reaches::<Session>("finished", ms(40_000));
            assert!(!has_fallen(&test), "{text}, seed {seed}");
            let Body::Forces(humanoid) = &test.world().body else { panic!("no forces") };
            let at = humanoid.ground_pose();
            (at.position.distance(glam::Vec2::new(forward, left)), (at.heading.to_degrees() - turn).abs())
        });
        let (metres, degrees): (Vec<_>, Vec<_>) = far.unzip();
        let [metres, degrees] = [metres, degrees].map(|all| {
            let mean = all.iter().sum::<f32>() / all.len() as f32;
            (mean, all.into_iter().fold(0.0, f32::max))
        });
        println!("{text}, seeds {seeds:?}: mean and largest distance {metres:.3?} m, {degrees:.1?}°");
        (metres.1, degrees.1)
    };
    ways.into_iter().map(far).collect()
}
