//! Rule 8, hold: any component can be forced active, forced latent, or left to the tree from outside.

use bica::Hold;
use proptest::prelude::*;

use super::active::reached;
use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::script::Stress;
use crate::support::test_tree::TestTree;
use crate::trees::on_trees;

on_trees!(hold(Stress { flags: 4, rates: 1, holds: 8, jumps: false }));

fn hold<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for cycle in cycles {
        let forced = (0..T::COUNT).filter(|&index| cycle.holds[index] == Hold::Active);
        let roots = forced.chain([T::GRAPH.root]).collect();
        prop_assert_eq!(&cycle.active, &reached::<T>(cycle, roots));
        for index in (0..T::COUNT).filter(|&index| cycle.holds[index] == Hold::Latent) {
            let started = cycle.has(&Event::Start(index)) || cycle.has(&Event::Begin(index));
            prop_assert!(!started && cycle.visit(index).is_none());
        }
    }
    Ok(())
}
