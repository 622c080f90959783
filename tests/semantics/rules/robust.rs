//! Rule 9, robustness: overload, a clock that stands still or jumps, and NaN never cause a panic of the framework. The
//! same inputs at the same times give the same outputs.

use bica::Hold;
use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::{Cycle, play};
use crate::support::script::{Stress, scripts};
use crate::support::test_tree::TestTree;
use crate::trees::modulated::Modulated;
use crate::trees::on_trees;
use crate::trees::timers::Timers;

const ALL: Stress = Stress { flags: 6, rates: 6, holds: 4, jumps: true };

on_trees!(every_cycle_is_complete(ALL));

/// Checks that every cycle ends, that the root is visited unless held latent, and that every begin has its end.
fn every_cycle_is_complete<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for cycle in cycles {
        prop_assert_eq!(cycle.events.first(), Some(&Event::CycleBegin(cycle.now)));
        prop_assert_eq!(cycle.events.last(), Some(&Event::CycleEnd));
        prop_assert_eq!(cycle.visit(T::GRAPH.root).is_none(), cycle.holds[T::GRAPH.root] == Hold::Latent);
        let mut open = None;
        for event in &cycle.events {
            match *event {
                Event::Begin(index) => prop_assert_eq!(open.replace(index), None, "sections do not overlap"),
                Event::End(index) => prop_assert_eq!(open.take(), Some(index)),
                Event::Body { .. }
                | Event::Hook { .. }
                | Event::Evaluated { .. }
                | Event::Condition(..)
                | Event::RateSet { .. } => {
                    prop_assert!(open.is_some());
                }
                _ => prop_assert_eq!(open, None, "events of the framework are outside sections"),
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(crate::trees::cases()))]

    #[test]
    fn equal_inputs_give_equal_outputs(script in scripts(ALL)) {
        prop_assert_eq!(play::<Timers>(&script)?, play::<Timers>(&script)?);
        prop_assert_eq!(play::<Modulated>(&script)?, play::<Modulated>(&script)?);
    }
}
