//! Numbers in parentheses, with types, with fractions.

use bica::prelude::*;

struct Fast;

#[component(hz = (30), budget_us = 40_u32)]
impl Fast {
    const fn new() -> Self {
        Self
    }
}

struct Slow;

#[component(hz = 0.5f32, budget_us = 1e3)]
impl Slow {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self, fast: &Fast) {}
}

activation_tree! {
    struct Robot { root: Slow, cycle_hz: ((100.0)), budget_ms: 0b1010, components: [Slow, Fast] }
}

#[test]
fn numbers_have_the_value_that_is_written() {
    let nodes = Robot::GRAPH.nodes;
    assert_eq!((nodes[0].hz, nodes[0].budget_us), (Some(0.5), Some(1000.0)));
    assert_eq!((nodes[1].hz, nodes[1].budget_us), (Some(30.0), Some(40.0)));
    assert_eq!((Robot::GRAPH.cycle_hz, Robot::GRAPH.budget_ms), (100.0, Some(10.0)));
}
