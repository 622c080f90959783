//! Rule 9, robustness: overload, a clock that stands still or jumps, and NaN never panic the framework; and the same
//! inputs at the same times give the same outputs.

use bica::Hold;
use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::{Cycle, play};
use crate::support::rig::Rig;
use crate::support::script::{Stress, scripts};
use crate::trees::modulated::Modulated;
use crate::trees::on_trees;
use crate::trees::timers::Timers;

const ALL: Stress = Stress { flags: 6, rates: 6, holds: 4, jumps: true };

on_trees!(goes_on(ALL));

/// Every cycle comes to its end, the root takes part, and what begins ends.
fn goes_on<T: Rig>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for cycle in cycles {
        prop_assert_eq!(cycle.events.first(), Some(&Event::CycleBegin(cycle.now)));
        prop_assert_eq!(cycle.events.last(), Some(&Event::CycleEnd));
        prop_assert_eq!(cycle.visit(T::GRAPH.root).is_none(), cycle.holds[T::GRAPH.root] == Hold::Latent);
        let mut open = None;
        for event in &cycle.events {
            match *event {
                Event::Begin(index) => prop_assert_eq!(open.replace(index), None, "stretches do not overlap"),
                Event::End(index) => prop_assert_eq!(open.take(), Some(index)),
                Event::Body { .. } | Event::Hook { .. } | Event::Asked { .. } | Event::Rated { .. } => {
                    prop_assert!(open.is_some());
                }
                _ => prop_assert_eq!(open, None, "the framework's own events come outside"),
            }
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(1000))]

    #[test]
    fn equal_inputs_give_equal_outputs(script in scripts(ALL)) {
        prop_assert_eq!(play::<Timers>(&script)?, play::<Timers>(&script)?);
        prop_assert_eq!(play::<Modulated>(&script)?, play::<Modulated>(&script)?);
    }
}
