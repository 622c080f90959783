//! Statements of `docs/semantics.md` that no other test shows.

use super::*;

/// What functions wrote, in order.
#[derive(Default)]
pub(crate) struct Log(Vec<&'static str>);

#[component(crate = bica_core)]
impl Log {
    const fn new() -> Self {
        Self(Vec::new())
    }
}

#[derive(Default)]
pub(crate) struct Again {
    pub(crate) on: bool,
    pub(crate) both: bool,
}

#[component(crate = bica_core)]
impl Again {
    const fn new() -> Self {
        Self { on: false, both: false }
    }

    #[state(initial)]
    fn skipped(&mut self, log: &mut Log) {
        log.0.push("skipped");
    }

    #[state]
    fn turning(&mut self, log: &mut Log) {
        log.0.push("turning");
    }

    #[state(last)]
    fn done(&mut self, log: &mut Log) {
        log.0.push("done");
    }

    #[transition(skipped -> turning)]
    fn at_once(&self) -> bool {
        true
    }

    #[transition(turning -> turning, after_ms = 20)]
    fn anew(&self) -> bool {
        self.on
    }

    #[transition(turning -> done)]
    fn first(&self) -> bool {
        self.both
    }

    #[transition(turning -> skipped)]
    fn second(&self) -> bool {
        self.both
    }

    #[entry(turning)]
    fn enter(&mut self, log: &mut Log) {
        log.0.push("enter");
    }

    #[exit(turning)]
    fn leave(&mut self, log: &mut Log) {
        log.0.push("leave");
    }
}

activation_tree! {
    pub(crate) struct Machine { root: Again, cycle_hz: 100, components: [Again, Log], crate: bica_core }
}

fn log_of(tree: &mut Machine, ms: u64) -> Vec<&'static str> {
    tree.get_mut::<Log>().0.clear();
    tree.tick(at(ms));
    tree.get::<Log>().0.clone()
}

#[test]
fn an_initial_state_left_at_once_never_runs() {
    let mut tree = Machine::new();
    assert_eq!(log_of(&mut tree, 0), ["enter", "turning"]);
}

#[test]
fn a_self_transition_leaves_enters_and_restarts_time() {
    let mut tree = Machine::new();
    tree.get_mut::<Again>().on = true;
    let logs = [0, 10, 20, 30, 40].map(|ms| log_of(&mut tree, ms).join(" "));
    assert_eq!(logs, ["enter turning", "turning", "leave enter turning", "turning", "leave enter turning"]);
}

#[test]
fn of_two_true_transitions_the_first_is_taken() {
    let mut tree = Machine::new();
    tree.tick(at(0));
    tree.get_mut::<Again>().both = true;
    assert_eq!(log_of(&mut tree, 10), ["leave", "done"]);
    // A last state runs like any other.
    assert_eq!(log_of(&mut tree, 20), ["done"]);
}

/// Adds what was requested since its last run.
pub(crate) struct Motor {
    requested: i32,
    done: Vec<i32>,
}

#[component(writers = first, crate = bica_core)]
impl Motor {
    const fn new() -> Self {
        Self { requested: 0, done: Vec::new() }
    }

    fn step(&mut self) {
        self.done.push(self.requested);
    }
}

/// Generates components that write a number to another one.
macro_rules! writers {
    ($($name:ident: $number:literal to $to:ident;)*) => {$(
        pub(crate) struct $name;

        #[component(crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self
            }

            fn step(&mut self, to: &mut $to) {
                to.requested = $number;
            }
        }
    )*};
}

writers! {
    One: 1 to Motor;
    Two: 2 to Motor;
    Five: 5 to Late;
    Six: 6 to Late;
}

links! {
    Both(&mut One, &mut Two);
    Three(&Four, &mut Five, &mut Six);
}

activation_tree! {
    pub(crate) struct Writers { root: Both, cycle_hz: 100, components: [Both, One, Two, Motor], crate: bica_core }
}

#[test]
fn a_child_of_two_writers_runs_after_the_first() {
    let mut tree = Writers::new();
    for ms in [0, 10, 20] {
        tree.tick(at(ms));
    }
    assert_eq!(tree.get::<Motor>().done, [1, 1, 1], "the second value comes too late in each cycle");
    assert_eq!(tree.get::<Motor>().requested, 2, "and is what others read afterwards");
}

/// As [`Motor`], but the last writer counts.
pub(crate) struct Late {
    requested: i32,
    done: Vec<i32>,
}

#[component(writers = last, crate = bica_core)]
impl Late {
    const fn new() -> Self {
        Self { requested: 0, done: Vec::new() }
    }

    fn step(&mut self, motor: &mut Motor) {
        self.done.push(self.requested);
        motor.requested = 10 * self.requested;
    }
}

/// Writes, and reads the value of the cycle before.
pub(crate) struct Four {
    seen: Vec<usize>,
}

#[component(crate = bica_core)]
impl Four {
    const fn new() -> Self {
        Self { seen: Vec::new() }
    }

    fn step(&mut self, late: &Late) {
        self.seen.push(late.done.len());
    }
}

activation_tree! {
    pub(crate) struct LastWriter {
        root: Three,
        cycle_hz: 100,
        components: [Motor, Late, Four, Five, Six, Three],
        crate: bica_core,
    }
}

#[test]
fn with_writers_last_a_child_runs_at_the_end() {
    let mut tree = LastWriter::new();
    (0..4).for_each(|cycle| tree.tick(at(10 * cycle)));
    assert_eq!(tree.get::<Late>().done, [6, 6, 6, 6]);
    assert_eq!(tree.get::<Four>().seen, [0, 1, 2, 3], "a reader finds the values of the cycle before");
    assert_eq!(tree.get::<Motor>().done, [60, 60, 60, 60], "what it activates follows it");
    // The first writer counts while the second one is latent.
    tree.of_mut::<Six>().hold(Hold::Latent);
    tree.tick(at(40));
    assert_eq!(tree.get::<Late>().done.last(), Some(&5));
    // A held writer is one of the cycle, too.
    tree.of_mut::<Five>().hold(Hold::Latent);
    tree.of_mut::<Six>().hold(Hold::Active);
    tree.tick(at(50));
    assert_eq!(tree.get::<Late>().done.last(), Some(&6));
}

#[test]
fn a_latent_component_can_be_written_and_keeps_it() {
    let mut tree = Writers::new();
    tree.of_mut::<Two>().hold(Hold::Latent);
    tree.of_mut::<One>().hold(Hold::Latent);
    tree.tick(at(0));
    tree.get_mut::<Motor>().requested = 7;
    tree.tick(at(10));
    assert_eq!((tree.of::<Motor>().is_active(), tree.get::<Motor>().requested), (false, 7));
    tree.of_mut::<Two>().hold(Hold::Tree);
    tree.tick(at(20));
    assert_eq!(tree.get::<Motor>().done, [2], "its activator wrote before its first run");
}
