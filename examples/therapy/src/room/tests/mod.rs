//! Sessions in the simulated room.

mod long;
#[cfg(feature = "mujoco")]
mod mujoco;

use std::collections::BTreeMap;
use std::ops::RangeInclusive;
use std::path::Path;

use bica::runner::harness::{Harness, InWorld};

use self::long::play_long;
use super::*;
use crate::body::{Motors, Mover, Walk, way};
use crate::exercise::ExerciseCheck;
use crate::input::Guard;
use crate::script::Script;
use crate::session::Session;

type Test = Harness<Therapist, InWorld<Room>>;
type Wish = fn(&mut Session);

/// Session with everything that a stop must end.
const LIVELY: &str = "say \"This text is long enough to be stopped at any time.\"\nmovement arms_together\nwait 4 s\n\
    walk forward 0.3 m\nwait walk at most 9 s\nwalk backward 0.2 m\nmovement arms_alternately\nwait walk at most 9 s\n\
    repeat 3 times\nmovement arms_open\nsay \"Open.\"\nwait movement at most 30 s\nwalk left 0.1 m\nwait walk at most 9 s\nend\n\
    exercise arms_open reps 2 hold 1 s at most 60 s\nturn right 90\nwait press left at most 20 s\nwait 1 s";

fn orders(text: &str) -> Vec<Order> {
    Script::parse(text).unwrap_or_else(|problems| panic!("{problems:?}")).orders(Path::new("."))
}

/// Returns a robot that has loaded a session.
fn loaded(text: &str, person: bool, body: Body) -> Test {
    let orders = orders(text);
    let seconds = ms(10 * orders.len() as u64 + 20);
    let mut test = Harness::new(Therapist::new()).in_world(Room { body, ..Room::new(orders, 1, person, false) });
    test.run_for(seconds);
    test
}

fn start(text: &str, body: Body) -> Test {
    let mut test = loaded(text, true, body);
    wish(&mut test, Session::start);
    test.run_for(ms(20));
    test
}

fn wish(test: &mut Test, wish: Wish) {
    wish(test.tree_mut().get_mut());
}

const fn ms(milliseconds: u64) -> Duration {
    Duration::from_millis(milliseconds)
}

fn angles(test: &Test) -> Joints {
    match &test.world().body {
        Body::Ideal(body) => *body.angles(),
        #[cfg(feature = "mujoco")]
        Body::Forces(humanoid) => humanoid.angles(),
    }
}

fn has_fallen(test: &Test) -> bool {
    test.world().log.iter().any(|line| line.ends_with("falls"))
}

/// Asserts that a stop holds for `still` ms: after 200 ms no sound plays and no target changes; after 500 ms all joints
/// are slower than 5 °/s and the robot stands. Returns the largest speed after that, °/s. `about` describes the stop in
/// a failure.
fn assert_stops(test: &mut Test, still: u64, about: &str) -> f32 {
    test.run_for(ms(200));
    let (targets, mut fastest) = (*test.tree().get::<Motors>().targets(), 0.0_f32);
    for cycle in 20..still / 10 {
        let before = angles(test);
        test.cycle();
        let Sounding { speech, music, .. } = test.world().sound;
        assert_eq!((test.state::<Session>(), speech, music), (Some("stopped"), None, None), "{about}");
        assert!(way(&targets, test.tree().get::<Motors>().targets()) < 1e-3, "{about}: {cycle}");
        fastest = if cycle < 50 { 0.0 } else { fastest.max(100.0 * way(&before, &angles(test))) };
    }
    assert!(fastest < 5.0 && !has_fallen(test), "{about}: {fastest} °/s, fell: {}", has_fallen(test));
    fastest
}

/// Stops lively sessions at random times and continues them. Returns how often each state, and a walk, was stopped.
fn stop_at_random(seeds: RangeInclusive<u64>, stops: u32, body: impl Fn(u64) -> Body) -> BTreeMap<&'static str, u32> {
    let (mut seen, mut fastest) = (BTreeMap::new(), 0.0_f32);
    for seed in seeds.clone() {
        let (mut random, mut test) = (Random::new(seed, 29_u64), start(LIVELY, body(seed)));
        for stop in 0..stops {
            let longest = if stop % 4 == 0 { 40_000.0 } else { 2000.0 };
            test.run_for(ms(random.between(20.0, longest) as u64));
            let walking = test.tree().get::<Walk>().is_walking().then_some("walking");
            let state = test.state::<Session>();
            state.into_iter().chain(walking).for_each(|state| *seen.entry(state).or_default() += 1);
            let about = format!("seed {seed}, stop {stop}, {:?}, {state:?}, {walking:?}", test.now());
            match stop % 2 {
                0 => wish(&mut test, Session::stop),
                // The bumper that the session does not wait for.
                _ => test.world_mut().press(Signal::Right, 0.2),
            }
            fastest = fastest.max(assert_stops(&mut test, 700, &about));
            if test.tree().get::<Session>().plan.step().is_none() {
                test = start(LIVELY, body(seed));
                continue;
            }
            wish(&mut test, Session::go_on);
            test.run_for(ms(20));
            assert_ne!(test.state::<Session>(), Some("stopped"));
        }
    }
    println!("seeds {seeds:?}, {stops} stops each: at most {fastest:.2} °/s half a second later, {seen:?}");
    seen
}

#[test]
fn stop_at_any_instant_ends_all() {
    let seen = stop_at_random(1..=1, 1000, |_| Body::default());
    assert!(["exercising", "finished", "waiting", "walking"].iter().all(|state| seen.contains_key(state)), "{seen:?}");
}

#[test]
fn stop_holds_in_every_state_and_against_every_button() {
    let wishes: [(_, _, &[Wish]); 5] = [
        ("ready", LIVELY, &[]),
        ("running", LIVELY, &[Session::start]),
        ("paused", LIVELY, &[Session::start, Session::pause]),
        ("stopped", LIVELY, &[Session::stop]),
        ("finished", "volume 50", &[Session::start]),
    ];
    for (state, text, wishes) in wishes {
        let mut test = loaded(text, true, Body::default());
        for one in wishes {
            wish(&mut test, *one);
            test.cycle();
        }
        test.reaches::<Session>(state, ms(100));
        // Requests in the same cycle do not replace the stop either.
        for one in [Session::stop, Session::go_on, Session::start, Session::next] {
            wish(&mut test, one);
        }
        test.reaches::<Session>("stopped", ms(50));
        for button in [Signal::Chest, Signal::Head, Signal::Left] {
            test.world_mut().press(button, 0.5);
            assert_stops(&mut test, 2000, state);
        }
        test.world_mut().press(Signal::Chest, 2.5);
        test.stays::<Session>("stopped", ms(1900));
        test.reaches::<Session>(if state == "finished" { "finished" } else { "running" }, ms(200));
    }
}

#[test]
fn pause_lowers_the_arms_and_repeats_what_was_begun() {
    let text = "movement arms_open\nwait movement at most 60 s\nmovement nod\nwait movement at most 60 s";
    let mut test = start(text, Body::default());
    test.run_for(ms(1500));
    let raised = angles(&test);
    test.world_mut().press(Signal::Chest, 0.2);
    test.reaches::<Session>("paused", ms(50));
    test.until("the arms are down", ms(5000), |test| !test.tree().get::<Mover>().is_running());
    assert!(way(&raised, &angles(&test)) > 20.0);
    test.stays::<Session>("paused", ms(3000));
    test.world_mut().press(Signal::Chest, 0.2);
    test.reaches::<Session>("waiting", ms(50));
    assert_eq!(test.tree().get::<Session>().at(), 1, "the session repeats the first movement");
}

#[test]
fn wait_ends_at_its_limit() {
    let mut test = start("wait press chest at most 2 s\nwait touch head at most 3 s", Body::default());
    test.reaches::<Session>("waiting", ms(50));
    assert!(test.reaches::<Session>("running", ms(3000)) >= ms(1950));
    test.run_for(ms(100));
    test.world_mut().press(Signal::Head, 0.2);
    test.reaches::<Session>("finished", ms(50));
}

#[test]
fn next_ends_at_the_end_and_previous_at_the_begin() {
    let mut test = start("volume 10\nwait 50 s\nvolume 20\nwait 50 s", Body::default());
    let wishes: [(Wish, _, _); 9] = [
        (Session::previous, 1, "waiting"),
        (Session::next, 3, "waiting"),
        (Session::previous, 1, "waiting"),
        (Session::next, 3, "waiting"),
        (Session::repeat, 3, "waiting"),
        (Session::stop, 3, "stopped"),
        (Session::next, 4, "stopped"),
        (Session::go_on, 4, "finished"),
        (Session::next, 4, "finished"),
    ];
    for (index, (one, at, state)) in wishes.into_iter().enumerate() {
        wish(&mut test, one);
        test.run_for(ms(50));
        assert_eq!((test.tree().get::<Session>().at(), test.state::<Session>()), (at, Some(state)), "wish {index}");
    }
}

#[test]
fn each_result_of_an_exercise_has_its_branch() {
    let branches = "when done\nvolume 11\nwhen not_done\nvolume 22\nwhen nobody\nvolume 33\nend";
    for (person, limit, volume) in [(true, 60, 0.11), (true, 5, 0.22), (false, 60, 0.33)] {
        let text = format!("exercise arms_open reps 2 at most {limit} s\n{branches}");
        let mut test = loaded(&text, person, Body::default());
        wish(&mut test, Session::start);
        test.reaches::<Session>("finished", ms(61_000));
        assert!((test.world().sound.volume - volume).abs() < 1e-6, "{person} {limit}");
        assert_eq!(test.tree().get::<ExerciseCheck>().counts().correct, if volume < 0.2 { 2 } else { 0 });
    }
}

#[test]
fn only_a_person_ends_a_pause_after_trouble() {
    let mut test = start(LIVELY, Body::default());
    test.world_mut().heat(true);
    test.reaches::<Session>("paused", ms(50));
    wish(&mut test, Session::go_on);
    test.stays::<Session>("paused", ms(1000));
    test.world_mut().heat(false);
    test.stays::<Session>("paused", ms(1000));
    test.world_mut().press(Signal::Chest, 0.2);
    test.reaches::<Session>("waiting", ms(100));
    test.world_mut().push_over(true);
    test.reaches::<Session>("stopped", ms(50));
    test.world_mut().push_over(false);
    assert_stops(&mut test, 3000, "after a fall");
    wish(&mut test, Session::go_on);
    test.reaches::<Session>("waiting", ms(100));
    test.tree_mut().get_mut::<Guard>().page_is_here();
    test.run_for(ms(2900));
    assert_ne!(test.state::<Session>(), Some("paused"));
    test.reaches::<Session>("paused", ms(300));
}

#[test]
fn sessions_keep_ranges_speed_and_time() {
    for name in ["physiotherapy", "music", "language"] {
        play_long(name, 1..=1, |_| Body::default());
    }
}

#[test]
fn a_walk_ends_by_itself_in_a_room_without_forces() {
    for text in ["walk forward 0.3 m", "walk backward 0.2 m", "walk left 0.2 m", "turn right 60"] {
        let mut test = start(&format!("{text}\nwait walk at most 30 s"), Body::default());
        test.reaches::<Session>("finished", ms(15_000));
    }
}
