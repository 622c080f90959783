//! Judgement of the budget report on constructed times.

use bica_times::limits::{Row, never_ran, over_budget, over_limit};
use bica_times::measurements::{ACT, CHAIN, CHANNELS, Cycle, Measurements, SEEING, SENSE};
use bica_times::quantiles::Quantiles;

/// Measurements in which channel 0 takes these times, ns: one list for each repetition, one entry for each cycle.
fn measured(repetitions: &[&[u32]]) -> Result<Measurements, usize> {
    let mut measurements = Measurements::new();
    for repetition in repetitions {
        measurements.begin_repetition();
        for &time in *repetition {
            let mut cycle: Cycle = [None; CHANNELS];
            cycle[0] = Some(time);
            measurements.record(&cycle)?;
        }
    }
    Ok(measurements)
}

fn row(measurements: &Measurements, budget: f64) -> Row {
    let times = measurements.minima(0);
    Row {
        name: "Ball",
        runs: times.len(),
        time: Quantiles::of(times),
        ever: measurements.maximum(0),
        budget: Some(budget),
    }
}

#[test]
fn one_slow_run_exceeds_the_budget() {
    let measurements = measured(&[&[1000, 5100, 1000], &[1000, 5300, 1000]]).expect("the same game");
    let findings: Vec<String> = over_budget(&[row(&measurements, 5.0)]).collect();
    assert_eq!(findings.len(), 1);
    assert!(findings[0].contains("Ball takes 5.1 µs in its slowest run and declares 5 µs"), "{}", findings[0]);
    assert_eq!(over_budget(&[row(&measurements, 5.1)]).count(), 0);
}

#[test]
fn an_interruption_appears_only_in_the_maximum() {
    let measurements = measured(&[&[1000, 90_000, 1000], &[1000, 1200, 80_000]]).expect("the same game");
    let row = row(&measurements, 5.0);
    assert_eq!(row.time, Some(Quantiles { p50: 1.0, p99: 1.2, max: 1.2 }));
    assert!((row.ever - 90.0).abs() < 1e-9);
    assert!((row.headroom().expect("it ran") - 0.76).abs() < 1e-9);
    assert_eq!(over_budget(&[row]).count(), 0);
}

#[test]
fn a_component_that_never_ran_is_reported() {
    let measurements = measured(&[&[1000]]).expect("one game");
    let ran = row(&measurements, 5.0);
    let never = Row { runs: 0, time: Quantiles::of(measurements.minima(1)), ..ran.clone() };
    assert_eq!(never_ran(std::slice::from_ref(&ran)).count(), 0);
    assert!(never_ran(&[ran, never]).next().is_some_and(|finding| finding.contains("Ball ran in none of the games")));
}

#[test]
fn repetitions_that_differ_are_refused() {
    let mut measurements = measured(&[&[1000, 2000]]).expect("one game");
    measurements.begin_repetition();
    let mut cycle: Cycle = [None; CHANNELS];
    for channel in [SENSE, ACT, CHAIN, SEEING] {
        cycle[channel] = Some(1);
    }
    assert_eq!(measurements.record(&cycle), Err(0), "channel 0 ran in the first repetition only");
    assert_eq!((measurements.cycles(), measurements.repetitions()), (2, 2));
}

#[test]
fn quantiles_use_the_nearest_rank() {
    let quantiles = Quantiles::of((1..=200).rev().map(f64::from).collect());
    assert_eq!(quantiles, Some(Quantiles { p50: 100.0, p99: 198.0, max: 200.0 }));
    assert_eq!(quantiles.map(|quantiles| quantiles.times(2.0).max), Some(400.0));
    assert_eq!(Quantiles::of(Vec::new()), None);
}

#[test]
fn a_chain_above_its_limit_is_reported() {
    assert_eq!(over_limit("the chain", 1500.0, 1500.0), None);
    let finding = over_limit("the chain", 1510.0, 1500.0);
    assert_eq!(finding.as_deref(), Some("the chain takes 1.51 ms, the limit is 1.50 ms"));
}
