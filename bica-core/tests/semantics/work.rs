//! Work beside the loop, in simulated time.

use std::panic::{AssertUnwindSafe, catch_unwind};

use bica_core::work::{self, WorkSlot};
use bica_core::{Hold, Instant, JobEnd, Probe, Tree, Work};
use bica_macros::{activation_tree, component};

/// Squares what the world writes, 25 ms later.
pub(crate) struct Planner {
    wanted: Option<u32>,
    found: Vec<u32>,
    idle: bool,
}

#[component(crate = bica_core)]
impl Planner {
    pub(crate) const fn new() -> Self {
        Self { wanted: None, found: Vec::new(), idle: true }
    }

    /// Squares a number.
    #[work(takes_ms = 25)]
    fn square(number: u32, more: (u32,)) -> u32 {
        assert_ne!(number, 13, "it cannot be computed");
        number * number + more.0
    }

    fn step(&mut self, work: &mut Work<Self>) {
        self.found.extend(work.result());
        self.idle = work.is_idle();
        if let Some(number) = self.wanted.take() {
            work.begin(number, (1,));
        }
    }
}

/// Counts down in slices.
pub(crate) struct Counter {
    from: u32,
    done: bool,
}

#[component(crate = bica_core, hz = 50)]
impl Counter {
    pub(crate) const fn new() -> Self {
        Self { from: 0, done: false }
    }

    #[work(takes_ms = 30, slices)]
    fn count(left: &mut u32) -> Option<&'static str> {
        *left -= 1;
        assert_ne!(*left, 100, "a slice panics");
        (*left == 0).then_some("zero")
    }

    #[state(initial)]
    fn wait(&mut self, _planner: &Planner, work: &mut Work<Self>) {
        self.done |= work.result().is_some();
        if self.from > 0 && work.is_idle() {
            work.begin(core::mem::take(&mut self.from));
        }
    }

    #[state(last)]
    fn end(&mut self) {}

    #[transition(wait -> end)]
    fn never(&self) -> bool {
        false
    }
}

activation_tree! {
    pub(crate) struct Both { root: Counter, cycle_hz: 100, components: [Counter, Planner], crate: bica_core }
}

fn tick(tree: &mut Both, ms: u64) {
    tree.tick(Instant::from_millis(ms));
}

fn begun() -> Both {
    let mut tree = Both::new();
    tree.get_mut::<Planner>().wanted = Some(3);
    tick(&mut tree, 0);
    tree
}

#[test]
fn a_result_is_there_in_the_first_cycle_when_due() {
    let mut tree = begun();
    for ms in [10, 20, 24] {
        tick(&mut tree, ms);
        assert!(tree.get::<Planner>().found.is_empty() && !tree.get::<Planner>().idle);
    }
    tick(&mut tree, 25);
    assert_eq!((&tree.get::<Planner>().found[..], tree.get::<Planner>().idle), (&[10][..], true));
}

#[test]
fn a_second_job_replaces_the_first() {
    let mut tree = begun();
    tree.get_mut::<Planner>().wanted = Some(4);
    (1..6).for_each(|cycle| tick(&mut tree, 10 * cycle));
    assert_eq!(tree.get::<Planner>().found, [17]);
}

#[test]
fn a_latent_component_drops_its_job() {
    let mut tree = begun();
    tree.of_mut::<Planner>().hold(Hold::Latent);
    tick(&mut tree, 10);
    tree.of_mut::<Planner>().hold(Hold::Tree);
    (2..9).for_each(|cycle| tick(&mut tree, 10 * cycle));
    assert!(tree.get::<Planner>().found.is_empty() && tree.get::<Planner>().idle);
}

#[test]
fn a_result_waits_for_the_next_run() {
    let mut tree = begun();
    tree.rate_mut::<Planner>().set(10.0);
    (1..10).for_each(|cycle| tick(&mut tree, 10 * cycle));
    assert!(tree.get::<Planner>().found.is_empty());
    tick(&mut tree, 100);
    assert_eq!(tree.get::<Planner>().found, [10]);
}

/// Ends of jobs.
#[derive(Default)]
struct Ends(Vec<(u64, JobEnd)>, Vec<Instant>, u64);

impl Probe for Ends {
    fn cycle_begin(&mut self, now: Instant) {
        self.2 = now.as_millis();
    }

    fn work_begun(&mut self, _: bica_core::ComponentId, due: Instant) {
        self.1.push(due);
    }

    fn work_ended(&mut self, _: bica_core::ComponentId, end: JobEnd) {
        self.0.push((self.2, end));
    }
}

#[test]
fn a_job_that_panics_unwinds_once_and_has_no_result() {
    let mut tree = Both::new();
    tree.get_mut::<Planner>().wanted = Some(13);
    (0..3).for_each(|cycle| tick(&mut tree, 10 * cycle));
    assert!(catch_unwind(AssertUnwindSafe(|| tick(&mut tree, 30))).is_err());
    assert!(tree.of::<Planner>().is_active());
    tree.get_mut::<Planner>().wanted = Some(2);
    (4..8).for_each(|cycle| tick(&mut tree, 10 * cycle));
    assert_eq!(tree.get::<Planner>().found, [5]);
}

#[test]
fn a_runner_decides_when_a_taken_job_ends() {
    let (mut tree, mut ends) = (begun(), Ends::default());
    let taken = work::slot::<Both, Planner>(&tree).take().expect("a job waits");
    assert_eq!(taken.due, Instant::from_millis(25));
    (1..5).for_each(|cycle| tree.tick_with(Instant::from_millis(10 * cycle), &mut ends));
    work::slot::<Both, Planner>(&tree).put(taken.ticket.wrapping_sub(1), Some(7));
    tree.tick_with(Instant::from_millis(50), &mut ends);
    work::slot::<Both, Planner>(&tree).put(taken.ticket, Some(8));
    tree.tick_with(Instant::from_millis(60), &mut ends);
    assert_eq!((ends.0, &tree.get::<Planner>().found[..]), (vec![(60, JobEnd::Late)], &[8][..]));
}

#[test]
fn slices_run_between_cycles_until_the_result() {
    let (mut tree, mut ends) = (Both::new(), Ends::default());
    tree.get_mut::<Counter>().from = 3;
    tree.tick_with(Instant::from_millis(0), &mut ends);
    let slice = |tree: &Both| work::slot::<Both, Counter>(tree).slice();
    work::slot::<Both, Counter>(&tree).claim();
    assert!(slice(&tree) && slice(&tree));
    tree.tick_with(Instant::from_millis(40), &mut ends);
    assert!(slice(&tree) && !slice(&tree));
    tree.tick_with(Instant::from_millis(60), &mut ends);
    assert!(tree.get::<Counter>().done);
    assert_eq!((ends.0, ends.1), (vec![(60, JobEnd::Late)], vec![Instant::from_millis(30)]));
}

#[test]
fn a_slice_that_panics_ends_the_job() {
    let (mut tree, mut ends) = (Both::new(), Ends::default());
    tree.get_mut::<Counter>().from = 102;
    tree.tick_with(Instant::from_millis(0), &mut ends);
    let slice = |tree: &Both| work::slot::<Both, Counter>(tree).slice();
    work::slot::<Both, Counter>(&tree).claim();
    assert!(slice(&tree) && catch_unwind(AssertUnwindSafe(|| slice(&tree))).is_err());
    assert!(slice(&tree) && !slice(&tree));
    tree.tick_with(Instant::from_millis(10), &mut ends);
    assert_eq!(ends.0, [(10, JobEnd::Failed)]);
}

/// A value that counts how often it is dropped.
#[derive(Clone)]
pub(crate) struct Counted(std::sync::Arc<()>);

pub(crate) struct Owner(Option<Counted>);

#[component(crate = bica_core)]
impl Owner {
    pub(crate) const fn new() -> Self {
        Self(None)
    }

    #[work(takes_ms = 10)]
    fn keep(value: Counted) -> Counted {
        value
    }

    fn step(&mut self, work: &mut Work<Self>) {
        if let Some(value) = self.0.take() {
            work.begin(value);
        }
    }
}

activation_tree! {
    pub(crate) struct Owning { root: Owner, cycle_hz: 100, components: [Owner], crate: bica_core }
}

#[test]
fn a_dropped_tree_drops_its_jobs_and_results() {
    for cycles in [1, 3] {
        let value = Counted(std::sync::Arc::new(()));
        let mut tree = Owning::new();
        tree.get_mut::<Owner>().0 = Some(value.clone());
        (0..cycles).for_each(|cycle| tree.tick(Instant::from_millis(10 * cycle)));
        assert_eq!(std::sync::Arc::strong_count(&value.0), 2);
        drop(tree);
        assert_eq!(std::sync::Arc::strong_count(&value.0), 1);
    }
}

#[test]
fn the_description_names_work_and_its_time() {
    let work = Both::GRAPH.nodes[1].work.expect("it has work");
    assert_eq!(
        (work.name, work.doc, work.takes_ms, work.slices, work.result),
        ("square", "Squares a number.", 25, false, "u32")
    );
    assert_eq!(Both::GRAPH.nodes[0].work.map(|work| (work.slices, work.result)), Some((true, "&'static str")));
}
