//! Jobs on threads, in the idle time and in replays, against the tree that runs them itself.
#![cfg(feature = "std")]

use std::convert::Infallible;
use std::hint::black_box;
use std::time::Duration;
use std::{panic, thread};

use bica_core::work::{WorkSlot, slot};
use bica_core::{ComponentId, Hold, Instant, JobEnd, Probe, Tree, Work};
use bica_macros::{activation_tree, component};
use bica_runner::workers::{HeldJobs, Pace, Workers};
use bica_runner::{IdleTime, Jobs, Observer, Robot, Runner};

/// Message of the panics that the test causes.
const EXPECTED: &str = "a job panics in the test";

/// Numbers that look random and depend on the first one alone.
#[derive(Clone)]
struct Random(u64);

impl Random {
    fn below(&mut self, end: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % end
    }
}

macro_rules! planner {
    ($name:ident, $child:ty) => {
        struct $name {
            sum: u64,
            /// State of the next job, and whether it shall panic.
            next: Option<(u64, bool)>,
        }

        #[component(crate = bica_core)]
        impl $name {
            const fn new() -> Self {
                Self { sum: 0, next: None }
            }

            /// Takes a time that depends on the number.
            #[work(takes_ms = 37)]
            fn plan(number: u64, panics: bool) -> u64 {
                assert!(!panics, "{EXPECTED}");
                (0..number % 5000).fold(number, |sum, one| black_box(sum ^ one).wrapping_mul(31))
            }

            fn step(&mut self, work: &mut Work<Self>, child: &mut $child) {
                if let Some(result) = work.result() {
                    self.sum = self.sum.wrapping_mul(31).wrapping_add(result);
                }
                if let Some((number, panics)) = self.next.take() {
                    work.begin(number ^ self.sum, panics);
                }
            }
        }
    };
}

planner!(Upper, Lower);
planner!(Lower, Leaf);

struct Leaf;

#[component(crate = bica_core)]
impl Leaf {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    struct Planners { root: Upper, cycle_hz: 100, components: [Upper, Lower, Leaf], crate: bica_core }
}

/// What happens before a cycle.
#[derive(Clone, Copy)]
struct Inputs {
    upper: Option<(u64, bool)>,
    lower: Option<(u64, bool)>,
    hold: Option<(usize, Hold)>,
}

impl Inputs {
    fn random(random: &mut Random, panics: bool) -> Self {
        let mut job = || (random.below(4) == 0).then(|| (random.below(1 << 30), panics && random.below(9) == 0));
        let (upper, lower) = (job(), job());
        let hold = match random.below(12) {
            0 => Some(Hold::Latent),
            1 | 2 => Some(Hold::Tree),
            3 => Some(Hold::Active),
            _ => None,
        };
        Self { upper, lower, hold: hold.map(|hold| (random.below(2) as usize, hold)) }
    }
}

impl Robot for Planners {
    type Sensors<'a> = Inputs;
    type Command = [u64; 2];
    type Error = Infallible;

    fn sense(&mut self, inputs: &Inputs) -> Result<(), Infallible> {
        self.get_mut::<Upper>().next = inputs.upper.or(self.get::<Upper>().next);
        self.get_mut::<Lower>().next = inputs.lower.or(self.get::<Lower>().next);
        Ok(())
    }

    fn act(&mut self) -> [u64; 2] {
        [self.get::<Upper>().sum, self.get::<Lower>().sum]
    }
}

/// Jobs that ended: cycle, component, and how.
#[derive(Default)]
struct Ends {
    cycle: u64,
    begun: usize,
    ended: Vec<(u64, ComponentId, JobEnd)>,
}

impl Probe for Ends {
    fn cycle_end(&mut self) {
        self.cycle += 1;
    }

    fn work_begun(&mut self, _: ComponentId, _: Instant) {
        self.begun += 1;
    }

    fn work_ended(&mut self, component: ComponentId, end: JobEnd) {
        self.ended.push((self.cycle, component, end));
    }
}

impl Observer<Planners> for Ends {}

/// Runs a random script; `before` is called before each cycle. Returns the commands and the jobs.
fn run<J: Jobs<Planners>>(
    jobs: J,
    cycles: u64,
    panics: bool,
    mut before: impl FnMut(&mut J, &Planners, u64),
) -> (Vec<[u64; 2]>, Ends) {
    let mut random = Random(7);
    let mut runner = Runner::new(Box::new(Planners::new()), ()).with_observer(Ends::default()).with_jobs(jobs);
    let mut commands = Vec::new();
    for cycle in 0..cycles {
        let now = Instant::from_millis(10 * cycle);
        let inputs = Inputs::random(&mut random, panics);
        if let Some((component, hold)) = inputs.hold {
            let component = ComponentId::new(component);
            runner.request(now, bica_runner::Request::Hold { component, hold }).expect("it can be held");
        }
        runner.sense(now, &inputs).expect("it is accepted");
        let (jobs, robot) = runner.jobs_mut();
        before(jobs, robot, cycle);
        commands.push(runner.think(now));
    }
    (commands, runner.into_parts().3)
}

/// Prints no panic that the test causes.
fn without_expected_panics() {
    let report = panic::take_hook();
    panic::set_hook(Box::new(move |info| {
        if info.payload_as_str() != Some(EXPECTED) {
            report(info);
        }
    }));
}

/// Compares runs on several numbers of threads with that of a tree that runs its jobs itself; returns the number of jobs.
fn compare_threads(cycles: u64) -> usize {
    without_expected_panics();
    let alone = run((), cycles, false, |(), _, _| {});
    let one = run(Workers::new(1, Pace::Simulated), cycles, true, |_, _, _| {});
    for threads in [1, 2, 4] {
        let simulated = run(Workers::new(threads, Pace::Simulated), cycles, false, |_, _, _| {});
        assert!(simulated.0 == alone.0 && simulated.1.ended == alone.1.ended, "{threads} threads");
        let panicking = run(Workers::new(threads, Pace::Simulated), cycles, true, |_, _, _| {});
        assert!(panicking.0 == one.0 && panicking.1.ended == one.1.ended, "{threads} threads");
    }
    let failed = one.1.ended.iter().filter(|(.., end)| *end == JobEnd::Failed).count();
    assert!(failed > 0 && one.1.ended.iter().all(|(.., end)| *end != JobEnd::Late), "{failed} failed");
    alone.1.begun
}

#[test]
fn simulated_runs_are_equal_on_any_number_of_threads() {
    assert!(compare_threads(2000) > 500);
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_ten_thousand_jobs_are_equal_on_all_threads() {
    assert!(compare_threads(40_000) > 10_000);
}

#[test]
fn a_run_in_real_time_is_repeated_from_its_ends() {
    without_expected_panics();
    let (commands, ends) =
        run(Workers::new(2, Pace::RealTime), 2000, true, |_, _, _| thread::sleep(Duration::from_micros(100)));
    assert!(ends.ended.len() > 50, "{} jobs ended", ends.ended.len());
    let mut recorded = ends.ended.iter().peekable();
    let again = run(HeldJobs::new(), 2000, true, |jobs, robot, cycle| {
        while let Some((_, component, _)) = recorded.next_if(|(at, ..)| *at == cycle) {
            assert!(jobs.end(robot, *component), "the component has no job");
        }
    });
    assert!(again.0 == commands && again.1.ended == ends.ended);
}

#[test]
fn idle_time_runs_jobs_only_between_cycles() {
    let mut runner = Runner::new(Box::new(Planners::new()), ()).with_observer(Ends::default()).with_jobs(IdleTime);
    runner.robot_mut().get_mut::<Upper>().next = Some((3, false));
    (0..9).for_each(|cycle| _ = runner.think(Instant::from_millis(10 * cycle)));
    assert!(runner.observer().ended.is_empty(), "no cycle runs the job");
    assert!(runner.idle() && !runner.idle());
    runner.think(Instant::from_millis(90));
    assert_eq!(runner.observer().ended, [(9, Planners::id::<Upper>(), JobEnd::Late)]);
    assert!(slot::<Planners, Upper>(runner.robot()).take().is_none());
}
