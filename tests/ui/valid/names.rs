//! Raw identifiers, names in other scripts, and words that macros could confuse.

use bica::prelude::*;

struct Größe;

#[component]
impl Größe {
    const fn new() -> Self {
        Self
    }

    /// No step: it is spelt much like one, but is a word of its own.
    #[expect(dead_code, reason = "nothing stops")]
    fn stop(&mut self) {}
}

struct Option;

#[component]
impl Option {
    const fn new() -> Self {
        Self
    }
}

struct r#Match {
    kicks: u32,
}

#[component]
impl r#Match {
    const fn new() -> Self {
        Self { kicks: 0 }
    }

    #[state(initial)]
    fn r#loop(&mut self, größe: &Größe) {}

    #[state]
    fn r#final(&mut self, time: &Time, cycle: &Größe) {}

    #[transition(r#loop -> r#final)]
    fn r#if(&self) -> bool {
        true
    }

    #[transition(* -> r#loop)]
    fn machine(&self) -> bool {
        false
    }

    #[entry(r#final)]
    fn step(&mut self, option: &Option) {
        self.kicks += 1;
    }
}

activation_tree! {
    struct Robot { root: r#Match, cycle_hz: 100, components: [r#Match, Größe, Option] }
}

#[test]
fn raw_identifiers_are_shown_without_their_mark() {
    let mut robot = Robot::new();
    robot.tick(Instant::from_millis(0));
    assert_eq!(robot.get::<r#Match>().kicks, 1);
    let states: Vec<_> = Robot::GRAPH.nodes[0].states.iter().map(|state| state.name).collect();
    assert_eq!(states, ["loop", "final"]);
    assert_eq!(Match::NAME, "Match");
}
