//! Results of generic children by any path, with conditions that carry something, and timers by paths.

use bica::prelude::*;

mod times {
    use bica::Params;

    /// Times.
    #[derive(Params)]
    pub(crate) struct Times {
        /// Pause.
        #[param(default = 20, range = 0..=9000, unit = "ms")]
        pub(super) r#pause: u32,
    }
}

pub(crate) struct Worker<T>(T);

#[component(resume)]
impl<T: Copy> Worker<T> {
    #[state(done, initial)]
    fn done(&mut self) {}
}

pub(crate) struct Boss {
    found: Option<u8>,
}

#[component]
impl Boss {
    const fn new() -> Self {
        Self { found: None }
    }

    #[transition(r#work -> rest, times = 3, when = done(self::Worker<u8>), after = times::Times::r#pause)]
    #[state(initial)]
    fn r#work(&mut self, worker: &mut Worker<u8>) {}

    #[state]
    fn rest(&mut self, worker: &Worker<u8>) {}

    #[transition(rest -> work, when = done(Worker<u8>))]
    fn found(&self, worker: &Worker<u8>) -> Option<u8> {
        Some(worker.0)
    }

    #[entry(work)]
    fn take(&mut self, found: Option<Found<u8>>) {
        self.found = found.map(|found| found.0);
    }
}

activation_tree! {
    struct Robot { root: Boss, cycle_hz: 100, components: [Boss, Worker<u8> = Worker(7)] }
}

#[test]
fn results_of_generic_children_are_asked() {
    let mut robot = Robot::new();
    let states = [0, 10, 20, 30, 40].map(|ms| {
        robot.tick(Instant::from_millis(ms));
        robot.of::<Boss>().state_name().expect("a machine")
    });
    // The child is read in `rest`: its result is there in the same cycle, but not where the state was entered.
    assert_eq!(states, ["work", "work", "rest", "work", "work"]);
    assert_eq!(robot.get::<Boss>().found, Some(7));
}
