//! Order of visits: that of the text.

use super::*;

links! {
    Parent(&Third, &mut Sixth, &First, &mut Fourth, &Second, &mut Fifth);
    First();
    Second();
    Third();
    Fourth();
    Fifth();
    Sixth();
}

activation_tree! {
    pub(crate) struct Siblings {
        root: Parent,
        cycle_hz: 100,
        components: [First, Second, Third, Fourth, Fifth, Sixth, Parent],
        crate: bica_core,
    }
}

#[test]
fn siblings_keep_the_signature_s_order() {
    let expected = ["Third", "First", "Second", "Parent", "Sixth", "Fourth", "Fifth"];
    assert_eq!(runs(&mut Siblings::new(), 0), expected);
}

/// Links of a state: those of its function, its entry hooks, its exit hooks, and the transitions that leave it.
pub(crate) struct Chooser;

#[component(crate = bica_core)]
impl Chooser {
    const fn new() -> Self {
        Self
    }

    #[transition(here -> there)]
    fn leaves(&self, _: &Fourth, _: &Sixth) -> bool {
        false
    }

    #[exit(here)]
    fn left(&mut self, _: &Third, _: &mut Second) {}

    #[entry(here)]
    fn entered(&mut self, _: &Fifth) {}

    #[state(initial)]
    fn here(&mut self, _: &mut First, _: &Sixth) {}

    #[state(last)]
    fn there(&mut self) {}
}

activation_tree! {
    pub(crate) struct Choosing {
        root: Chooser,
        cycle_hz: 100,
        components: [First, Second, Third, Fourth, Fifth, Sixth, Chooser],
        crate: bica_core,
    }
}

#[test]
fn siblings_of_a_state_keep_the_text_s_order() {
    let expected = ["Sixth", "Fifth", "Third", "Fourth", "Chooser", "First", "Second"];
    assert_eq!(runs(&mut Choosing::new(), 0), expected);
}
