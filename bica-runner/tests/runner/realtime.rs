//! Real-time loops on the clock of this computer. Only bounds that hold on a busy computer are asserted.
#![cfg(all(feature = "std", feature = "embassy"))]

use std::thread;
use std::time::{self, Duration};

use bica_core::{Instant, Probe};
use bica_macros::{activation_tree, component};
use bica_runner::realtime::Stop;
use bica_runner::{Observer, Overrun, OverrunPolicy, Robot, RunError, Runner, Schedule, World};

struct Idle;

#[component(crate = bica_core)]
impl Idle {
    const fn new() -> Self {
        Self
    }
}

activation_tree! {
    struct Sloth { root: Idle, cycle_hz: 100, components: [Idle], crate: bica_core }
}

/// Robot that rejects the sensor value `true`.
impl Robot for Sloth {
    type Sensors<'a> = bool;
    type Command = ();
    type Error = &'static str;

    fn sense(&mut self, refused: &bool) -> Result<(), &'static str> {
        if *refused { Err("refused") } else { Ok(()) }
    }

    fn act(&mut self) {}
}

/// World with one slow cycle.
struct Slow {
    cycle: u64,
    late: Option<u64>,
    refused: Option<u64>,
}

impl World<Sloth> for Slow {
    fn now(&self) -> Instant {
        Instant::from_millis(self.cycle)
    }

    fn sensors(&mut self) -> bool {
        self.refused == Some(self.cycle)
    }

    fn act(&mut self, (): &()) {
        if self.late == Some(self.cycle) {
            thread::sleep(Duration::from_millis(45));
        }
        self.cycle += 1;
    }
}

#[derive(Default)]
struct Overruns(Vec<Overrun>);

impl Probe for Overruns {}

impl Observer<Sloth> for Overruns {
    fn overrun(&mut self, overrun: &Overrun) {
        self.0.push(*overrun);
    }
}

fn runner(late: Option<u64>, refused: Option<u64>) -> Runner<Box<Sloth>, Slow, (), Overruns> {
    Runner::new(Box::new(Sloth::new()), Slow { cycle: 0, late, refused }).with_observer(Overruns::default())
}

#[test]
fn the_loop_keeps_its_rate_and_counts_the_overrun() {
    let (mut runner, mut schedule) = (runner(Some(3), None), Schedule::new(100.0, OverrunPolicy::Skip));
    let began = time::Instant::now();
    let ran: Result<(), RunError<&str>> = runner.run(&mut schedule, &Stop::new(), |runner| runner.world().cycle < 20);
    assert_eq!(ran, Ok(()));
    assert!(began.elapsed() >= Duration::from_millis(190), "20 cycles at 100 Hz are not faster: {schedule}");
    assert_eq!(schedule.execution.count(), 20);
    assert!(schedule.overruns >= 1 && schedule.skipped >= 3, "{schedule}");
    assert_eq!(runner.observer().0.len() as u64, schedule.overruns);
}

#[test]
fn a_raised_stop_flag_ends_the_loop_after_the_cycle() {
    let (mut runner, mut schedule, stop) =
        (runner(None, None), Schedule::new(1000.0, OverrunPolicy::Skip), Stop::new());
    let flag = stop.clone();
    let ran = runner.run(&mut schedule, &stop, move |runner| {
        if runner.world().cycle == 4 {
            flag.stop();
        }
        true
    });
    assert_eq!((ran, runner.world().cycle), (Ok(()), 5));
}

#[test]
fn aborts_and_rejections_end_the_loop() {
    let (mut slow, mut schedule) = (runner(Some(2), None), Schedule::new(100.0, OverrunPolicy::Abort));
    let ran = slow.run(&mut schedule, &Stop::new(), |_| true);
    assert!(matches!(ran, Err(RunError::Overrun(_))), "{ran:?}");
    let mut refusing = runner(None, Some(2));
    let ran = refusing.run(&mut Schedule::new(1000.0, OverrunPolicy::Skip), &Stop::new(), |_| true);
    assert_eq!((ran, refusing.world().cycle), (Err(RunError::Sense("refused")), 2));
}

#[test]
fn the_embassy_loop_keeps_its_rate() {
    let (mut runner, mut schedule) = (runner(None, Some(20)), Schedule::new(200.0, OverrunPolicy::Skip));
    let began = time::Instant::now();
    let error = embassy_futures::block_on(runner.run_async(&mut schedule));
    assert_eq!(error, RunError::Sense("refused"));
    assert_eq!(runner.world().cycle, 20);
    assert!(began.elapsed() >= Duration::from_millis(95), "20 periods at 200 Hz: {schedule}");
}
