//! The budget report's judgement: times as they would be measured, and what it finds in them.

use bica_benches::budget::lanes::{ACT, CHAIN, Cycle, LANES, Lanes, SEEING, SENSE};
use bica_benches::budget::spread::Spread;
use bica_benches::budget::verdict::{Row, broken, idle, late};

/// Lane 0 takes these times, in every playing of the game, cycle by cycle, ns.
fn played(games: &[&[u32]]) -> Result<Lanes, usize> {
    let mut lanes = Lanes::new();
    for game in games {
        lanes.rewind();
        for &time in *game {
            let mut cycle: Cycle = [None; LANES];
            cycle[0] = Some(time);
            lanes.note(&cycle)?;
        }
    }
    Ok(lanes)
}

fn row(lanes: &Lanes, budget: f64) -> Row {
    let times = lanes.least(0);
    Row { name: "Ball", runs: times.len(), time: Spread::of(times), most: lanes.most(0), budget: Some(budget) }
}

#[test]
fn a_component_that_is_too_slow_in_one_cycle_is_named() {
    let lanes = played(&[&[1000, 5100, 1000], &[1000, 5300, 1000]]).expect("the same game");
    let findings: Vec<String> = broken(&[row(&lanes, 5.0)]).collect();
    assert_eq!(findings.len(), 1);
    assert!(findings[0].contains("Ball takes 5.1 µs in its slowest run and declares 5 µs"), "{}", findings[0]);
    assert_eq!(broken(&[row(&lanes, 5.1)]).count(), 0);
}

#[test]
fn what_comes_in_between_once_decides_nothing_and_is_told() {
    let lanes = played(&[&[1000, 90_000, 1000], &[1000, 1200, 80_000]]).expect("the same game");
    let row = row(&lanes, 5.0);
    assert_eq!(row.time, Some(Spread { p50: 1.0, p99: 1.2, max: 1.2 }));
    assert!((row.most - 90.0).abs() < 1e-9);
    assert!((row.headroom().expect("it ran") - 0.76).abs() < 1e-9);
    assert_eq!(broken(&[row]).count(), 0);
}

#[test]
fn a_component_that_never_runs_is_not_proved() {
    let lanes = played(&[&[1000]]).expect("one game");
    let ran = row(&lanes, 5.0);
    let never = Row { runs: 0, time: Spread::of(lanes.least(1)), ..ran.clone() };
    assert_eq!(idle(std::slice::from_ref(&ran)).count(), 0);
    assert!(idle(&[ran, never]).next().is_some_and(|finding| finding.contains("Ball ran in none of the games")));
}

#[test]
fn a_game_that_differs_when_played_again_is_refused() {
    let mut lanes = played(&[&[1000, 2000]]).expect("one game");
    lanes.rewind();
    let mut cycle: Cycle = [None; LANES];
    for lane in [SENSE, ACT, CHAIN, SEEING] {
        cycle[lane] = Some(1);
    }
    assert_eq!(lanes.note(&cycle), Err(0), "lane 0 ran before and not now");
    assert_eq!((lanes.cycles(), lanes.games()), (2, 2));
}

#[test]
fn ranks_are_the_nearest() {
    let spread = Spread::of((1..=200).rev().map(f64::from).collect());
    assert_eq!(spread, Some(Spread { p50: 100.0, p99: 198.0, max: 200.0 }));
    assert_eq!(spread.map(|spread| spread.times(2.0).max), Some(400.0));
    assert_eq!(Spread::of(Vec::new()), None);
}

#[test]
fn a_late_chain_is_told() {
    assert_eq!(late("the chain", 1500.0, 1500.0), None);
    let finding = late("the chain", 1510.0, 1500.0);
    assert_eq!(finding.as_deref(), Some("the chain takes 1.51 ms and may take 1.50 ms"));
}
