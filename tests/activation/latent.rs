//! In every cycle of a game the active components are those that the states reach.

use bica::graph::{Graph, LinkKind};
use bica::prelude::*;
use bica::runner::Observer;
use bica_player::Forward;
use bica_sim::setup::{Frame, Setup};
use proptest::prelude::*;

use crate::game::new_game;

/// Transitions of the current cycle: machine, and state that it left.
#[derive(Default)]
struct Taken(Vec<(usize, usize)>);

impl Probe for Taken {
    fn cycle_begin(&mut self, _: Instant) {
        self.0.clear();
    }

    fn transition(&mut self, component: ComponentId, from: usize, _to: usize) {
        self.0.push((component.index(), from));
    }
}

impl Observer<Forward> for Taken {}

/// Components that the states reach from the root. A machine that took a transition has also visited the requirements
/// of the old state.
fn reached(graph: &Graph, state: impl Fn(usize) -> Option<usize>, taken: &[(usize, usize)]) -> Vec<bool> {
    let mut reached = vec![false; graph.nodes.len()];
    let mut open = vec![graph.root];
    while let Some(index) = open.pop() {
        if std::mem::replace(&mut reached[index], true) {
            continue;
        }
        let left = taken.iter().find(|(component, _)| *component == index).map(|(_, from)| *from);
        for link in graph.nodes[index].links {
            let now = link.state.is_none() || link.state == state(index);
            let before = link.kind == LinkKind::Requirement && link.state.is_some() && link.state == left;
            if now || before {
                open.push(link.to);
            }
        }
    }
    reached
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 8, ..ProptestConfig::default() })]

    #[test]
    #[ignore = "slow: `cargo xtask ci` runs it"]
    fn slow_active_components_are_those_that_the_states_reach(seed: u64, robots in 0_usize..4) {
        let mut game = new_game(&Setup { seed, frame: Frame::Small, robots, ..Setup::default() }).with_observer(Taken::default());
        for cycle in 0..2500 {
            game.cycle().expect("the image fits");
            let expected = reached(&Forward::GRAPH, |index| game.robot().state(ComponentId::new(index)), &game.observer().0);
            for (index, node) in Forward::GRAPH.nodes.iter().enumerate() {
                let active = game.robot().is_active(ComponentId::new(index));
                prop_assert_eq!(active, expected[index], "{} in cycle {}", node.name, cycle);
            }
        }
    }
}
