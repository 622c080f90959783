//! What transitions carry, and what runs before them.

use bica_core::{ComponentId, Found};

use super::*;

/// A value that no other module can name.
#[derive(Debug, PartialEq)]
struct Kick(u32);

pub(crate) struct Striker {
    /// Number of the kick that the next condition finds.
    plan: Option<u32>,
    /// What happened, in order.
    log: Vec<&'static str>,
    kick: Option<Kick>,
    /// What the last entry hook of the initial state took.
    begun: Option<u8>,
}

#[component(hz = 50, crate = bica_core)]
impl Striker {
    const fn new() -> Self {
        Self { plan: None, log: Vec::new(), kick: None, begun: Some(0) }
    }

    #[state(initial)]
    fn look(&mut self) {
        self.log.push("look");
    }

    #[state]
    fn kick(&mut self, leg: &mut Leg) {
        self.log.push("kick");
    }

    #[state(last)]
    fn rest(&mut self) {}

    #[before(look | kick)]
    fn think(&mut self, leg: &Leg) {
        self.log.push("think");
        self.plan = leg.0;
    }

    #[transition(look | kick -> kick)]
    fn found(&self) -> Option<Kick> {
        self.plan.map(Kick)
    }

    #[transition(kick -> look, after_ms = 100)]
    fn again(&self) -> Option<u8> {
        Some(7)
    }

    #[transition(kick -> rest, after_ms = 200)]
    fn tired(&self) -> bool {
        true
    }

    #[exit(look)]
    fn leave(&mut self) {
        self.log.push("leave");
    }

    #[entry(kick)]
    fn take(&mut self, Found(kick): Found<Kick>, leg: &mut Leg) {
        self.log.push("take");
        self.kick = Some(kick);
        leg.0 = None;
    }

    #[entry(look)]
    fn begin(&mut self, again: Option<Found<u8>>) {
        self.log.push("begin");
        self.begun = again.map(|Found(number)| number);
    }
}

pub(crate) struct Leg(Option<u32>);

#[component(crate = bica_core)]
impl Leg {
    const fn new() -> Self {
        Self(None)
    }
}

activation_tree! {
    pub(crate) struct Team { root: Striker, cycle_hz: 100, components: [Striker, Leg], crate: bica_core }
}

/// The log of one cycle.
fn log(tree: &mut Team, ms: u64) -> Vec<&'static str> {
    tree.tick(at(ms));
    std::mem::take(&mut tree.get_mut::<Striker>().log)
}

#[test]
fn before_runs_in_due_runs_that_begin_in_its_state() {
    let mut tree = Team::new();
    assert_eq!(log(&mut tree, 0), ["begin", "think", "look"], "after the entry hook");
    assert_eq!(log(&mut tree, 10), [""; 0], "not due");
    assert_eq!(log(&mut tree, 20), ["think", "look"]);
    tree.get_mut::<Leg>().0 = Some(3);
    assert_eq!(log(&mut tree, 40), ["think", "leave", "take", "kick"], "not in the state that is entered");
    assert_eq!(log(&mut tree, 60), ["think", "kick"]);
}

#[test]
fn the_entry_hook_takes_what_the_transition_found() {
    let mut tree = Team::new();
    tree.get_mut::<Leg>().0 = Some(3);
    tree.tick(at(0));
    assert_eq!((tree.get::<Striker>().kick.as_ref(), tree.get::<Striker>().begun), (Some(&Kick(3)), None));
    tree.get_mut::<Leg>().0 = Some(4);
    tree.tick(at(20));
    assert_eq!(tree.get::<Striker>().kick, Some(Kick(4)), "a state that is entered from itself takes it anew");
    tree.tick(at(120));
    assert_eq!(tree.of::<Striker>().state_name(), Some("look"));
    assert_eq!(tree.get::<Striker>().begun, Some(7), "the initial state takes it from a transition");
    tree.of_mut::<Striker>().hold(Hold::Latent);
    tree.tick(at(140));
    tree.of_mut::<Striker>().hold(Hold::Tree);
    tree.tick(at(160));
    assert_eq!(tree.get::<Striker>().begun, None, "nothing is left of an earlier cycle");
}

/// The values of conditions that a probe gets.
#[derive(Default)]
struct Conditions(Vec<(usize, bool)>);

impl Probe for Conditions {
    fn condition(&mut self, _: ComponentId, transition: usize, holds: bool) {
        self.0.push((transition, holds));
    }
}

#[test]
fn a_condition_holds_if_it_found_something() {
    let (mut tree, mut probe) = (Team::new(), Conditions::default());
    tree.tick_with(at(0), &mut probe);
    tree.get_mut::<Leg>().0 = Some(3);
    tree.tick_with(at(20), &mut probe);
    assert_eq!(probe.0, [(0, false), (0, true)]);
}

#[test]
fn the_description_says_what_is_carried() {
    let node = &Team::GRAPH.nodes[0];
    let carried: Vec<_> = node.transitions.iter().map(|one| (one.name, one.carries)).collect();
    let expected = [("found", Some("Kick")), ("found", Some("Kick")), ("again", Some("u8")), ("tired", None)];
    assert_eq!(carried, expected);
    assert_eq!([0, 1, 2].map(|state| node.takes(state)), [Some("u8"), Some("Kick"), None]);
    assert_eq!(node.states.iter().map(|state| state.before).collect::<Vec<_>>(), [Some("think"), Some("think"), None]);
    for drawing in [node.dot().to_string(), node.mermaid().to_string()] {
        assert!(drawing.contains("kick ← Kick"), "{drawing}");
        assert!(drawing.contains("think"), "{drawing}");
    }
}
