//! Sessions in the simulated room.

use std::path::Path;

use bica::runner::harness::{Harness, InWorld};
use bica::{Duration, Tree};
use bica_motion::joints::{JOINTS, Joints};
use bica_motion::model::Nao;
use rand_pcg::{Pcg32, rand_core::Rng};
use therapy::body::Mover;
#[cfg(feature = "mujoco")]
use therapy::body::Walk;
use therapy::exercise::ExerciseCheck;
use therapy::input::Guard;
use therapy::robot::Therapist;
use therapy::room::Room;
use therapy::script::Script;
use therapy::session::{Session, Signal};

type Test = Harness<Therapist, InWorld<Room>>;

/// A session with all that can be stopped.
const LIVELY: &str = "say \"This text is long enough to be stopped at any time.\"\nmovement arms_together\nwait 4 s\n\
    repeat 3 times\nmovement arms_open\nsay \"Open.\"\nwait movement at most 30 s\nend\n\
    exercise arms_open reps 2 hold 1 s at most 60 s\nwait press left at most 20 s\nwait 1 s";

fn room(text: &str, seed: u64, person: bool) -> Test {
    let script = Script::parse(text).unwrap_or_else(|problems| panic!("{problems:?}"));
    let orders = script.orders(Path::new("."));
    let loaded = Duration::from_millis(10 * orders.len() as u64 + 20);
    let mut test = Harness::new(Therapist::new()).in_world(Room::new(orders, seed, person, false));
    test.run_for(loaded);
    test
}

fn start(text: &str) -> Test {
    let mut test = room(text, 0, true);
    test.tree_mut().get_mut::<Session>().start();
    test.run_for(ms(20));
    test
}

const fn ms(milliseconds: u64) -> Duration {
    Duration::from_millis(milliseconds)
}

/// Largest change of an angle, degrees.
fn way(from: &Joints, to: &Joints) -> f32 {
    (0..JOINTS).map(|joint| (to.0[joint] - from.0[joint]).abs().to_degrees()).fold(0.0, f32::max)
}

/// Asserts that nothing moves or sounds from 200 ms on, and that it stays so.
fn assert_stops(test: &mut Test, still: Duration) {
    test.run_for(ms(200));
    let (sound, targets) = (test.world().sound(), test.world().angles());
    assert_eq!((sound.speech, sound.music), (None, None));
    let steps = still.as_millis() / 100;
    for _ in 0..steps {
        test.run_for(ms(100));
        assert_eq!(test.state::<Session>(), Some("stopped"));
        let sound = test.world().sound();
        assert!(way(&targets, &test.world().angles()) < 1e-3 && (sound.speech, sound.music) == (None, None));
    }
}

#[test]
fn stop_at_a_thousand_instants_ends_all_until_somebody_lets_it_go_on() {
    let mut random = Pcg32::new(29, 1);
    let mut test = start(LIVELY);
    let mut seen = std::collections::BTreeMap::new();
    for stop in 0..1000 {
        let longest = if stop % 4 == 0 { 40_000 } else { 3000 };
        test.run_for(ms(20 + u64::from(random.next_u32() % longest)));
        *seen.entry(test.state::<Session>().expect("a state")).or_insert(0) += 1;
        match stop % 2 {
            0 => test.tree_mut().get_mut::<Session>().stop(),
            _ => {
                // The bumper that is not waited for.
                test.world_mut().press(Signal::Right, 0.2);
            }
        }
        assert_stops(&mut test, ms(500));
        if test.tree().get::<Session>().is_at_end() {
            test = start(LIVELY);
            continue;
        }
        test.tree_mut().get_mut::<Session>().go_on();
        test.run_for(ms(20));
        assert_ne!(test.state::<Session>(), Some("stopped"));
    }
    let states: Vec<_> = seen.keys().copied().collect();
    assert!(["exercising", "finished", "waiting"].iter().all(|state| states.contains(state)), "{seen:?}");
}

#[test]
fn stop_holds_in_every_state_and_against_every_button() {
    for state in ["ready", "running", "paused", "stopped", "finished"] {
        let mut test = if state == "finished" { start("volume 50") } else { room(LIVELY, 0, true) };
        if state == "paused" {
            test.tree_mut().get_mut::<Session>().start();
            test.run_for(ms(1000));
            test.tree_mut().get_mut::<Session>().pause();
        } else if state == "running" {
            test.tree_mut().get_mut::<Session>().start();
        } else if state == "stopped" {
            test.tree_mut().get_mut::<Session>().stop();
        }
        test.reaches::<Session>(state, ms(1000));
        test.tree_mut().get_mut::<Session>().stop();
        test.reaches::<Session>("stopped", ms(50));
        test.world_mut().press(Signal::Chest, 0.5);
        test.world_mut().press(Signal::Head, 0.2);
        assert_stops(&mut test, ms(5000));
    }
    let mut test = start(LIVELY);
    test.tree_mut().get_mut::<Session>().stop();
    test.reaches::<Session>("stopped", ms(50));
    test.world_mut().press(Signal::Chest, 2.5);
    test.stays::<Session>("stopped", ms(1900));
    test.reaches::<Session>("running", ms(200));
}

#[test]
fn pause_lowers_the_arms_and_repeats_what_was_begun() {
    let mut test = start("movement arms_open\nwait movement at most 60 s\nmovement nod\nwait movement at most 60 s");
    test.run_for(ms(1500));
    let raised = test.world().angles();
    test.world_mut().press(Signal::Chest, 0.2);
    test.reaches::<Session>("paused", ms(50));
    test.until("the arms are down", ms(5000), |test| !test.tree().get::<Mover>().is_running());
    assert!(way(&raised, &test.world().angles()) > 20.0);
    test.stays::<Session>("paused", ms(3000));
    test.world_mut().press(Signal::Chest, 0.2);
    test.reaches::<Session>("waiting", ms(50));
    assert_eq!(test.tree().get::<Session>().at(), 1, "the first movement begins anew");
}

#[test]
fn wait_ends_at_its_limit() {
    let mut test = start("wait press chest at most 2 s\nwait touch head at most 3 s");
    test.reaches::<Session>("waiting", ms(50));
    assert!(test.reaches::<Session>("running", ms(3000)) >= ms(1950));
    test.run_for(ms(100));
    test.world_mut().press(Signal::Head, 0.2);
    test.reaches::<Session>("finished", ms(50));
}

#[test]
fn next_ends_at_the_end_and_previous_at_the_begin() {
    let mut test = start("volume 10\nwait 50 s\nvolume 20\nwait 50 s");
    let mut at = |wish: fn(&mut Session), steps: u16| {
        wish(test.tree_mut().get_mut::<Session>());
        test.run_for(ms(50));
        assert_eq!(test.tree().get::<Session>().at(), steps);
        test.state::<Session>().expect("a state")
    };
    assert_eq!(at(Session::previous, 1), "waiting", "there is nothing before");
    assert_eq!(at(Session::next, 3), "waiting");
    assert_eq!(at(Session::previous, 1), "waiting");
    assert_eq!(at(Session::next, 3), "waiting");
    assert_eq!(at(Session::repeat, 3), "waiting");
    assert_eq!(at(Session::stop, 3), "stopped");
    assert_eq!(at(Session::next, 4), "stopped", "it stays stopped");
    assert_eq!(at(Session::go_on, 4), "finished");
    assert_eq!(at(Session::next, 4), "finished", "not past the end");
}

#[test]
fn each_result_of_an_exercise_has_its_branch() {
    let text = |limit| {
        format!(
            "exercise arms_open reps 2 at most {limit} s\nwhen done\nvolume 11\nwhen not_done\nvolume 22\nwhen nobody\nvolume 33\nend"
        )
    };
    for (person, limit, volume) in [(true, 60, 0.11), (true, 5, 0.22), (false, 60, 0.33)] {
        let mut test = room(&text(limit), 0, person);
        test.tree_mut().get_mut::<Session>().start();
        test.reaches::<Session>("finished", ms(61_000));
        assert!((test.world().sound().volume - volume).abs() < 1e-6, "{person} {limit}: {:?}", test.world().sound());
        let counts = test.tree().get::<ExerciseCheck>().counts();
        assert_eq!(counts.correct, if volume < 0.2 { 2 } else { 0 }, "{counts:?}");
    }
}

#[test]
fn troubles_pause_or_stop_and_only_a_person_lets_it_go_on() {
    let mut test = start(LIVELY);
    test.world_mut().heat(true);
    test.reaches::<Session>("paused", ms(50));
    test.tree_mut().get_mut::<Session>().go_on();
    test.stays::<Session>("paused", ms(1000));
    test.world_mut().heat(false);
    test.stays::<Session>("paused", ms(1000));
    test.world_mut().press(Signal::Chest, 0.2);
    test.reaches::<Session>("waiting", ms(100));
    test.world_mut().push_over(true);
    test.reaches::<Session>("stopped", ms(50));
    test.world_mut().push_over(false);
    assert_stops(&mut test, ms(3000));
    test.tree_mut().get_mut::<Session>().go_on();
    test.reaches::<Session>("waiting", ms(100));
    test.tree_mut().get_mut::<Guard>().page_is_here();
    test.run_for(ms(2900));
    assert_ne!(test.state::<Session>(), Some("paused"));
    test.reaches::<Session>("paused", ms(300));
}

#[test]
fn equal_seeds_give_equal_logs() {
    let play = |seed| {
        let mut test = room(LIVELY, seed, true);
        test.tree_mut().get_mut::<Session>().start();
        test.reaches::<Session>("finished", ms(300_000));
        test.world().log().to_vec()
    };
    assert_eq!(play(1), play(1));
    assert!(play(1).len() > 6);
}

/// A silent song of three minutes: 8000 bytes a second.
fn song(folder: &Path) {
    let size: u32 = 180 * 8000;
    let mut wav = b"RIFF\0\0\0\0WAVEfmt \x10\0\0\0\x01\0\x01\0\x40\x1f\0\0\x40\x1f\0\0\x01\0\x08\0data".to_vec();
    wav.extend(size.to_le_bytes());
    wav.resize(wav.len() + size as usize, 128);
    std::fs::write(folder.join("song.wav"), wav).expect("a file");
}

/// Plays a session of more than ten minutes, in a room that is made for each seed.
fn play_long(name: &str, seeds: std::ops::RangeInclusive<u64>, make: impl Fn(Room, u64) -> Room) {
    let folder = std::env::temp_dir().join(format!("therapy-{name}-{}-{}", seeds.end(), std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    song(&folder);
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("sessions/{name}.session"));
    let script = Script::parse(&std::fs::read_to_string(file).expect("a session")).expect("a right session");
    assert_eq!(script.check_files(&folder), []);
    for seed in seeds {
        let room = make(Room::new(script.orders(&folder), seed, true, true), seed);
        let mut test = Harness::new(Therapist::new()).in_world(room);
        let (mut last, mut at_once, mut latest, mut fastest) = (test.world().angles(), 0, 0, 0.0_f32);
        while test.state::<Session>() != Some("finished") {
            test.cycle();
            let angles = test.world().angles();
            // The stops of the fingers, which stay closed, yield by 0.007° in MuJoCo.
            let beyond = way(&angles, &angles.clamp_to_limits::<Nao>());
            assert!(beyond < 0.01, "{name} {seed} {:?}: {beyond}° beyond the limits, {angles:?}", test.now());
            fastest = fastest.max(100.0 * way(&last, &angles));
            // The cycles between two waits: each command begins within 100 ms of its place.
            at_once = if test.state::<Session>() == Some("running") { at_once + 1 } else { 0 };
            latest = latest.max(10 * at_once);
            last = angles;
        }
        let (minutes, falls) = (test.now().as_secs() as f32 / 60.0, test.world().falls());
        println!("{name} {seed}: {minutes:.1} min, {falls} falls, {fastest:.1} °/s, {latest} ms");
        assert!((10.0..20.0).contains(&minutes) && falls == 0 && fastest <= 65.0 && latest <= 100);
    }
    std::fs::remove_dir_all(&folder).expect("the folder");
}

#[test]
fn sessions_keep_ranges_speed_and_time() {
    for name in ["physiotherapy", "music", "language"] {
        play_long(name, 1..=1, |room, _| room);
    }
}

#[cfg(feature = "mujoco")]
mod with_forces {
    use super::*;

    fn play(name: &str) {
        play_long(name, 1..=20, |room, seed| room.with_forces(seed).expect("a body"));
    }

    #[test]
    fn a_session_in_mujoco_keeps_all_that() {
        play_long("language", 1..=1, |room, seed| room.with_forces(seed).expect("a body"));
    }

    #[test]
    #[ignore = "long: `cargo xtask long` runs it"]
    fn long_stops_slow_all_joints_within_half_a_second() {
        stop_with_forces(20, 50);
    }

    #[test]
    #[ignore = "long: `cargo xtask long` runs it"]
    fn long_physiotherapy_keeps_all_that() {
        play("physiotherapy");
    }

    #[test]
    #[ignore = "long: `cargo xtask long` runs it"]
    fn long_music_keeps_all_that() {
        play("music");
    }

    #[test]
    #[ignore = "long: `cargo xtask long` runs it"]
    fn long_language_keeps_all_that() {
        play("language");
    }
}

/// Stops lively sessions at random instants: all joints are slow half a second later, and the robot stands.
#[cfg(feature = "mujoco")]
fn stop_with_forces(seeds: u64, stops: u32) {
    let (mut random, orders) =
        (Pcg32::new(29, 2), Script::parse(LIVELY).expect("a right script").orders(Path::new(".")));
    let mut fastest = 0.0_f32;
    for seed in 0..seeds {
        let make = || Room::new(orders.clone(), seed, true, true).with_forces(seed).expect("a body");
        let mut test = Harness::new(Therapist::new()).in_world(make());
        test.run_for(ms(3000));
        for stop in 0..stops {
            test.run_for(ms(u64::from(random.next_u32() % 5000)));
            test.tree_mut().get_mut::<Session>().stop();
            test.run_for(ms(500));
            let last = test.world().angles();
            test.cycle();
            let speed = 100.0 * way(&last, &test.world().angles());
            assert!(speed < 5.0 && test.world().falls() == 0, "seed {seed}, stop {stop}: {speed} °/s");
            fastest = fastest.max(speed);
            if test.tree().get::<Session>().is_at_end() {
                test = Harness::new(Therapist::new()).in_world(make());
                test.run_for(ms(3000));
            }
            test.tree_mut().get_mut::<Session>().go_on();
        }
    }
    println!("{seeds} × {stops} stops: at most {fastest:.2} °/s");
}

#[cfg(feature = "mujoco")]
#[test]
fn stop_in_mujoco_slows_all_joints_within_half_a_second() {
    stop_with_forces(4, 10);
}

#[cfg(feature = "mujoco")]
#[test]
fn walk_in_mujoco_goes_the_way_and_ends_on_its_feet_also_after_a_stop() {
    for (text, [forward, left, turn]) in [
        ("walk forward 0.3 m", [0.3, 0.0, 0.0]),
        ("walk backward 0.2 m", [-0.2, 0.0, 0.0]),
        ("walk left 0.2 m", [0.0, 0.2, 0.0]),
        ("turn right 60", [0.0, 0.0, -60.0_f32]),
    ] {
        let script = Script::parse(&format!("{text}\nwait walk at most 30 s\nwait 2 s")).expect("a right script");
        let room = || Room::new(script.orders(Path::new(".")), 1, true, true).with_forces(1).expect("a body");
        let mut test = Harness::new(Therapist::new()).in_world(room());
        test.reaches::<Session>("finished", ms(40_000));
        let at = test.world().place();
        assert_eq!(test.world().falls(), 0, "{text}");
        assert!(at.position.distance(glam::Vec2::new(forward, left)) < 0.06, "{text}: {at:?}");
        assert!((at.heading.to_degrees() - turn).abs() < 10.0, "{text}: {at:?}");

        let mut test = Harness::new(Therapist::new()).in_world(room());
        test.run_for(ms(3210));
        assert!(test.tree().get::<Walk>().is_walking(), "{text}");
        test.tree_mut().get_mut::<Session>().stop();
        test.until("the feet are together", ms(3000), |test| !test.tree().get::<Walk>().is_walking());
        test.run_for(ms(500));
        let still = test.world().angles();
        test.run_for(ms(2000));
        assert_eq!((test.world().falls(), test.state::<Session>()), (0, Some("stopped")), "{text}");
        assert!(way(&still, &test.world().angles()) < 1.0, "{text}: the feet stay where they are");
    }
}
