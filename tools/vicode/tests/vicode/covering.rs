//! Coverage of the states and transitions of a machine.

use std::fs;

use bica_recording::Recording;
use bica_test_data::process::Folder;
use bica_vicode::coverage::{Coverage, Visits};
use bica_vicode::read;

use crate::command::vicode;
use crate::sources;

const MACHINE: &str = "#[component]\nimpl A {\n    #[state(initial)]\n    fn one(&mut self) {}\n    \
    #[state]\n    fn two(&mut self) {}\n    #[state]\n    fn three(&mut self) {}\n    \
    #[transition(one -> two)]\n    fn go(&self) -> bool { true }\n    #[transition(one -> two)]\n    fn run(&self) -> bool { true }\n    \
    #[transition(two -> one)]\n    fn back(&self) -> bool { true }\n    \
    #[transition(* -> three)]\n    fn end(&self) -> bool { true }\n    \
    #[transition(two -> two)]\n    fn stay(&self) -> bool { true }\n}\n";

/// Changes of the state, with times in µs; the last entry is the end of the run.
const COURSE: [(u64, Option<&str>); 7] = [
    (0, None),
    (10, Some("one")),
    (30, Some("two")),
    (60, Some("one")),
    (70, None),
    (80, Some("one")),
    (90, Some("one")),
];

fn coverage(visits: &Visits) -> Coverage {
    Coverage::of(&read(MACHINE).components[0], visits)
}

#[test]
fn visits_times_and_transitions_are_counted() {
    let mut visits = Visits::default();
    visits.begin();
    for (time, state) in COURSE {
        visits.sample(time, state);
    }
    let found = coverage(&visits);
    let states: Vec<_> =
        found.states.iter().map(|one| (&*one.name, one.stays.visits, one.stays.us, one.stays.longest_us)).collect();
    assert_eq!(states, [("one", 3, 40, 20), ("two", 1, 30, 30), ("three", 0, 0, 0)]);
    let taken: Vec<_> = found.transitions.iter().map(|one| (&*one.name, &*one.from, one.taken, one.or.len())).collect();
    // Two transitions lead from `one` to `two`.
    assert_eq!(
        taken,
        [
            ("go", "one", Some(1), 1),
            ("run", "one", Some(1), 1),
            ("back", "two", Some(1), 0),
            ("end", "one", Some(0), 0)
        ]
        .into_iter()
        .chain([("end", "two", Some(0), 0), ("stay", "two", None, 0)])
        .collect::<Vec<_>>()
    );
    // States do not show a transition to the same state: it is neither taken nor missed.
    assert!(found.to_string().contains("stay: two -> two      ?"), "{found}");
    assert_eq!(found.summary(), "A: 2 of 3 states, 3 of 4 transitions, 0.00 s in 1 run");
}

#[test]
fn samples_of_all_cycles_count_as_those_of_changes() {
    let (mut changes, mut cycles) = (Visits::default(), Visits::default());
    for (time, state) in COURSE {
        changes.sample(time, state);
    }
    for time in 0..=90 {
        let state = COURSE.iter().rev().find(|(from, _)| *from <= time).and_then(|(_, state)| *state);
        cycles.sample(time, state);
    }
    assert_eq!(coverage(&changes), coverage(&cycles));
}

/// The time in each state agrees with the number of its cycles in the recording.
#[test]
fn coverage_of_a_recorded_game_has_all_its_time() {
    let root = sources::root().canonicalize().unwrap();
    let [source, game, other] = [
        "player/src/behaviour/player.rs",
        "tools/player/tests/recordings/game.mcap",
        "examples/goalkeeper/src/goalkeeper.rs",
    ]
    .map(|path| root.join(path).into_os_string().into_string().unwrap());
    let tests = Folder::new("covering");
    let found = vicode(&["coverage", &source, &game, "--json"], &tests).json();
    let mut recording = Recording::open(game.as_ref()).unwrap().without_blobs();
    let tree = recording.header().tree.clone();
    let player = tree.components.iter().position(|one| one.name == "Player").unwrap();
    let mut cycles = vec![0; tree.components[player].states.len()];
    while let Some(cycle) = recording.next_cycle().unwrap() {
        cycles[cycle.tree.state(player).unwrap()] += 1;
    }
    // The last cycle has no successor.
    assert_eq!(found["us"], 10_000 * (cycles.iter().sum::<u64>() - 1));
    for (state, number) in tree.components[player].states.iter().zip(&cycles) {
        let own = found["states"].as_array().unwrap().iter().find(|one| one["name"] == *state.name).unwrap();
        assert!(own["us"].as_u64().unwrap().abs_diff(10_000 * number) <= 10_000, "{own} and {number} cycles");
        assert_eq!(own["visits"] == 0, *number == 0, "{own}");
    }
    // A test of 2 s, and one of another robot.
    let lines = "0\tPlayer\tlook_for_ball\n500000\tPlayer\tapproach\n1500000\tPlayer\t-\n2000000\tOther\tx\n";
    fs::write(tests.file("1-0.states"), lines).unwrap();
    fs::write(tests.file("1-1.states"), "0\tOther\tx\n").unwrap();
    let summary = |from: &[&str]| {
        let ran = vicode(&[&["coverage", &source, "--summary"], from].concat(), &tests);
        ran.stdout + &ran.stderr
    };
    let alone = "Player: 2 of 9 states, 1 of 20 transitions, 1.50 s in 1 run\n";
    assert_eq!(summary(&[tests.text()]), alone);
    assert!(summary(&[&game, tests.text()]).ends_with(" in 2 runs\n"));
    // Two of a kind in one test are two runs: the states of one do not follow those of the other.
    let two = "0\tPlayer<0>\tlook_for_ball\n0\tPlayer<1>\tapproach\n1000000\tPlayer<0>\tlook_for_ball\n1000000\tPlayer<1>\tapproach\n";
    fs::write(tests.file("1-0.states"), two).unwrap();
    assert_eq!(summary(&[tests.text()]), "Player: 2 of 9 states, 0 of 20 transitions, 2.00 s in 2 runs\n");
    fs::remove_file(tests.file("1-0.states")).unwrap();
    assert!(summary(&[tests.text()]).contains("no test in it has run `Player`"));
    vicode(&["coverage", &other, &game], &tests).refused(&["has no component `Goalkeeper`; it has Player, "]);
}
