//! Rule 1, once per cycle: a component is visited at most once per tick, however many activate it.

use proptest::prelude::*;

use crate::support::event::Event;
use crate::support::play::Cycle;
use crate::support::script::Stress;
use crate::support::test_tree::TestTree;
use crate::trees::on_trees;

on_trees!(once(Stress { flags: 6, rates: 2, holds: 2, jumps: true }));

fn once<T: TestTree>(cycles: &[Cycle]) -> Result<(), TestCaseError> {
    for cycle in cycles {
        for index in 0..T::COUNT {
            let count = |event: &Event| cycle.events.iter().filter(|other| *other == event).count();
            let visits = count(&Event::Run(index)) + count(&Event::Skip(index));
            prop_assert_eq!(visits, usize::from(cycle.active.contains(&index)));
        }
    }
    Ok(())
}
