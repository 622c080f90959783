//! Ages of components: `&Age<C>`.

use super::*;
use bica_core::Age;

pub(crate) struct Eye;

/// It takes no `&Time`, so that only its age makes the tree record its runs.
#[component(hz = 10, crate = bica_core)]
impl Eye {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self) {}
}

/// Notes the age of its activator.
pub(crate) struct Lamp {
    reader: Option<Duration>,
}

#[component(crate = bica_core)]
impl Lamp {
    const fn new() -> Self {
        Self { reader: None }
    }

    fn step(&mut self, reader: &Age<Reader>) {
        self.reader = reader.since_run();
    }
}

/// Notes the ages of the eye, which is linked before or after it, and of the lamp.
#[derive(Default)]
pub(crate) struct Reader {
    ages: Vec<Option<u64>>,
    is_new: bool,
    lamp: Option<Duration>,
}

impl Reader {
    fn note(&mut self, eye: &Age<Eye>) {
        self.ages.push(eye.since_run().map(|age| age.as_millis()));
        self.is_new = eye.is_within(Duration::from_millis(30));
    }
}

#[component(crate = bica_core)]
impl Reader {
    #[state(initial)]
    fn reads(&mut self, _: &Eye, eye: &Age<Eye>, lamp: &Age<Lamp>) {
        self.note(eye);
        self.lamp = lamp.since_run();
    }

    #[state]
    fn writes(&mut self, _: &mut Eye, eye: &Age<Eye>) {
        self.note(eye);
    }

    #[state(last)]
    fn lights(&mut self, _: &mut Lamp, eye: &Age<Eye>, lamp: &Age<Lamp>) {
        self.note(eye);
        self.lamp = lamp.since_run();
    }

    #[transition(reads -> writes, after_ms = 200)]
    fn later(&self, eye: &Age<Eye>) -> bool {
        eye.is_within(Duration::from_millis(0))
    }

    #[transition(writes -> lights, after_ms = 200)]
    fn latest(&self) -> bool {
        true
    }
}

activation_tree! {
    pub(crate) struct Ages {
        root: Reader,
        cycle_hz: 50,
        components: [Reader = Reader { ages: Vec::new(), is_new: false, lamp: None }, Eye, Lamp],
        crate: bica_core,
    }
}

fn ages(tree: &mut Ages, ms: impl Iterator<Item = u64>) -> Vec<Option<u64>> {
    ms.for_each(|ms| tree.tick(at(ms)));
    std::mem::take(&mut tree.get_mut::<Reader>().ages)
}

#[test]
fn an_age_is_the_time_since_the_last_run() {
    let mut tree = Ages::new();
    let read = ages(&mut tree, (0..200).step_by(20));
    assert_eq!(read, [0, 20, 40, 60, 80, 0, 20, 40, 60, 80].map(Some));
    assert_eq!(tree.get::<Reader>().lamp, None, "it never ran");
    // The eye is now visited after its reader, but not in the cycle of the transition, whose condition read it.
    let written = ages(&mut tree, (200..400).step_by(20));
    assert_eq!(written, [0, 20, 40, 60, 80, 100, 20, 40, 60, 80].map(Some));
}

#[test]
fn an_age_grows_while_a_component_is_latent() {
    let mut tree = Ages::new();
    tree.tick(at(0));
    tree.of_mut::<Eye>().hold(Hold::Latent);
    let held = ages(&mut tree, (20..120).step_by(20));
    assert_eq!(held, [0, 20, 40, 60, 80, 100].map(Some));
    assert!(!tree.get::<Reader>().is_new);
    tree.of_mut::<Eye>().hold(Hold::Tree);
    assert_eq!(ages(&mut tree, [120].into_iter()), [Some(0)]);
    assert!(tree.get::<Reader>().is_new);
    tree.rate_mut::<Eye>().set(0.0);
    assert_eq!(ages(&mut tree, [1140].into_iter()), [Some(1020)], "at rest");
}

#[test]
fn a_modulated_child_finds_that_its_activator_ran() {
    let mut tree = Ages::new();
    ages(&mut tree, (0..=440).step_by(20));
    assert_eq!(tree.get::<Lamp>().reader, Some(Duration::from_ticks(0)));
}

#[test]
fn an_age_survives_the_end_of_a_state() {
    let mut tree = Ages::new();
    ages(&mut tree, (0..=400).step_by(20));
    assert_eq!(tree.of::<Reader>().state_name(), Some("lights"));
    assert_eq!(ages(&mut tree, [420, 10_000].into_iter()), [Some(120), Some(9700)]);
    assert_eq!(tree.get::<Reader>().lamp, Some(Duration::from_millis(9580)));
}
