//! Rule 3, rate: a fixed grid, N ± 1 runs in N periods, a late run once and at once. A visit without a run still visits
//! the children.

use bica::Tree;
use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::{Cycle, play};
use crate::support::script::{Clock, Script, Stress, Tick};
use crate::support::test_tree::TestTree;
use crate::trees::fan::Fan;
use crate::trees::on_trees;

on_trees!(rate(Stress { flags: 4, ..Stress::default() }));

/// Declared period, clock ticks.
pub(crate) fn period(hz: f32) -> u64 {
    (1e6 / f64::from(hz)) as u64
}

fn rate<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for (index, node) in T::GRAPH.nodes.iter().enumerate() {
        let is_skipped = |cycle: &Cycle| cycle.has(&Event::Skip(index));
        match node.hz.map(period) {
            None => prop_assert!(!cycles.iter().any(is_skipped)),
            Some(period) => {
                no_run_is_discarded(cycles, index, period)?;
                activations(cycles, index).iter().try_for_each(|runs| no_burst(period, runs))?;
            }
        }
        for cycle in cycles.iter().filter(|cycle| is_skipped(cycle)) {
            prop_assert!(
                cycle.links::<T>(index).all(|link| cycle.visit(link.to).is_some()),
                "the children are visited"
            );
        }
    }
    Ok(())
}

/// Instants of the runs, for each time span in which the component was active.
fn activations(cycles: &[Cycle], index: usize) -> Vec<Vec<u64>> {
    let mut activations: Vec<Vec<u64>> = Vec::new();
    for cycle in cycles {
        if cycle.has(&Event::Start(index)) {
            activations.push(Vec::new());
        }
        if cycle.has(&Event::Run(index)) {
            activations.last_mut().expect("a run follows a start").push(cycle.now);
        }
    }
    activations
}

/// Checks that a visited component runs if a period has passed since its last run.
fn no_run_is_discarded(cycles: &[Cycle], index: usize, period: u64) -> Result<(), TestCaseError> {
    let mut last = None;
    for cycle in cycles {
        if cycle.has(&Event::Run(index)) {
            last = Some(cycle.now);
        }
        if cycle.has(&Event::Skip(index)) {
            prop_assert!(last.is_some_and(|last| cycle.now - last < period));
        }
    }
    Ok(())
}

/// Checks that missed runs are not made up for: each run belongs to its own grid point, in a window that is a period
/// and at most a cycle long.
pub(crate) fn no_burst(period: u64, runs: &[u64]) -> Result<(), TestCaseError> {
    const CYCLE: u64 = 10_000;
    for (place, first) in runs.iter().enumerate() {
        for (between, last) in runs[place + 1..].iter().enumerate() {
            prop_assert!(last - first + CYCLE > between as u64 * period || between == 0);
        }
    }
    Ok(())
}

/// Cycles that are fast enough for all rates.
fn fast() -> impl Strategy<Value = Script> {
    let tick = (1..9_000_u64).prop_map(|ticks| Tick { actions: Vec::new(), clock: Clock::Later(ticks) });
    prop::collection::vec(tick, 2..400)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::trees::cases()))]

    #[test]
    fn n_periods_have_n_plus_or_minus_one_runs(script in fast()) {
        let cycles = play::<Fan>(&script)?;
        for (index, node) in Fan::GRAPH.nodes.iter().enumerate() {
            let Some(period) = node.hz.map(period) else { continue };
            let runs: Vec<bool> = cycles.iter().map(|cycle| cycle.has(&Event::Run(index))).collect();
            for first in 0..cycles.len() {
                let mut count = 0;
                for last in first + 1..cycles.len() {
                    count += u64::from(runs[last]);
                    let span = cycles[last].now - cycles[first].now;
                    prop_assert!(count + 1 >= span / period && count <= span.div_ceil(period) + 1);
                }
            }
        }
    }
}
