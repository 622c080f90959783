//! Series of shots.

use std::process::Command;

use goalkeeper::shots::{Plan, Robot};

#[test]
#[ignore = "slow: CI plays 100 shots"]
fn slow_goalkeeper_halves_goals_of_idle_robot() {
    let plan = Plan::default();
    assert_eq!((plan.seed, plan.shots), (0, 100));
    let let_in = |robot| {
        let results = plan.play(robot).expect("valid shots");
        assert_eq!(results.len(), 100);
        results.iter().filter(|result| result.let_in).count()
    };
    let (idle, goalkeeper) = (let_in(Robot::Idle), let_in(Robot::Goalkeeper(&[])));
    assert!(idle >= 60, "the shots are too easy: an idle robot lets in {idle}");
    assert!(2 * goalkeeper <= idle, "the goalkeeper lets in {goalkeeper}, an idle robot {idle}");
}

#[test]
fn recorded_series_replays_bit_for_bit() {
    let file = std::env::temp_dir().join(format!("goalkeeper-{}.mcap", std::process::id()));
    let run = |arguments: &[&str]| {
        let program = env!("CARGO_BIN_EXE_goalkeeper");
        let ended = Command::new(program).args(arguments).arg(&file).output().expect("the program");
        assert!(ended.status.success(), "{arguments:?}: {}", String::from_utf8_lossy(&ended.stderr));
        String::from_utf8(ended.stdout).expect("a text")
    };
    // Without images the replay makes the world of the series again.
    let played = run(&["run", "--seed", "4001", "--option", "shots=1", "--images", "none", "--record"]);
    assert!(played.contains("1 shots, "), "{played}");
    let replayed = run(&["replay"]);
    std::fs::remove_file(&file).expect("the recording");
    assert!(replayed.contains("equal"), "{replayed}");
}
