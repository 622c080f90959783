//! What is not needed is latent: the active components are those that the states reach, in every cycle of a game.

use bica::graph::{Graph, LinkKind};
use bica::prelude::*;
use bica_player::Forward;
use bica_sim::setup::Setup;
use proptest::prelude::*;

use crate::game::Game;

/// The transition that each machine took in this cycle.
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

/// The components that the states reach from the root. A machine that changed its state has read what the old one
/// requires before it changed.
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
    fn active_is_what_the_states_reach(seed: u64, robots in 0_usize..4) {
        let mut game = Game::new(&Setup { seed, robots, ..Setup::default() });
        let mut taken = Taken::default();
        for cycle in 0..2500 {
            game.cycle(&mut taken);
            let wanted = reached(&Forward::GRAPH, |index| game.robot.state(ComponentId::new(index)), &taken.0);
            for (index, node) in Forward::GRAPH.nodes.iter().enumerate() {
                let active = game.robot.is_active(ComponentId::new(index));
                prop_assert_eq!(active, wanted[index], "{} in cycle {}", node.name, cycle);
            }
        }
    }
}
