//! Order of visits: each component once per cycle, required children before and modulated ones after.

use super::*;

/// Generates components that only have links.
macro_rules! links {
    ($($name:ident($($link:ty),*);)*) => {$(
        pub(crate) struct $name;

        #[component(crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self
            }

            fn step(&mut self $(, _: $link)*) {}
        }
    )*};
}

links! {
    Root(&Left, &Right, &mut After);
    Left(&Shared);
    Right(&Shared, &mut Moved);
    Shared();
    Moved();
    After(&Shared, &mut Moved);
}

activation_tree! {
    pub(crate) struct Diamond {
        root: Root,
        cycle_hz: 100,
        components: [After, Moved, Shared, Right, Left, Root],
        crate: bica_core,
    }
}

#[test]
fn required_run_before_and_modulated_after() {
    assert_eq!(runs(&mut Diamond::new(), 0), ["Shared", "Left", "Right", "Moved", "Root", "After"]);
}

#[test]
fn values_pass_within_a_cycle() {
    let mut tree = Chain::new();
    tree.get_mut::<Sensor>().truth = 7;
    tree.tick(at(0));
    assert_eq!(tree.get::<Motor>().moved_to, 14);
}

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

pub(crate) struct Sensor {
    truth: i32,
    seen: i32,
}

#[component(crate = bica_core)]
impl Sensor {
    const fn new() -> Self {
        Self { truth: 0, seen: 0 }
    }

    fn step(&mut self) {
        self.seen = self.truth;
    }
}

pub(crate) struct Motor {
    target: i32,
    moved_to: i32,
}

#[component(crate = bica_core)]
impl Motor {
    const fn new() -> Self {
        Self { target: 0, moved_to: 0 }
    }

    fn step(&mut self) {
        self.moved_to = self.target;
    }
}

pub(crate) struct Controller;

#[component(crate = bica_core)]
impl Controller {
    const fn new() -> Self {
        Self
    }

    fn step(&self, sensor: &Sensor, motor: &mut Motor) {
        motor.target = 2 * sensor.seen;
    }
}

activation_tree! {
    pub(crate) struct Chain {
        root: Controller,
        cycle_hz: 100,
        components: [Controller, Sensor, Motor],
        crate: bica_core,
    }
}
