//! Overruns of budgets in the log.

use std::convert::Infallible;
use std::thread;
use std::time::Duration;

use bica::Instant;
use bica::prelude::*;
use bica::runner::{Robot, Runner};
use bica_recording::{Backpressure, Header, ImagePolicy, Recorder, RecorderOptions, SetUp};

use crate::support::{Disk, cycles};

/// Takes longer than its budget.
pub(crate) struct Slow;

#[component(budget_us = 100)]
impl Slow {
    const fn new() -> Self {
        Self
    }

    fn step(&mut self) {
        thread::sleep(Duration::from_millis(1));
    }
}

activation_tree! {
    pub(crate) struct SlowTree { root: Slow, cycle_hz: 100, components: [Slow] }
}

impl Robot for SlowTree {
    type Sensors<'a> = ();
    type Command = ();
    type Error = Infallible;

    fn sense(&mut self, (): &()) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) {}
}

#[test]
fn overruns_of_a_second_are_one_line_of_the_log() {
    let disk = Disk::default();
    let header = Header::new(&SlowTree::GRAPH, SetUp::default(), ImagePolicy::None).of_robot(&SlowTree::new());
    let options = RecorderOptions { backpressure: Backpressure::Drop, ..RecorderOptions::default() };
    let recorder = Recorder::start(disk.clone(), &header, options, |_| {}).expect("memory");
    let mut runner = Runner::new(Box::new(SlowTree::new()), ()).with_observer(recorder.measuring(&SlowTree::GRAPH));
    for cycle in 0..150 {
        let now = Instant::from_millis(10 * cycle);
        runner.sense(now, &()).expect("never refused");
        runner.think(now);
    }
    assert_eq!(runner.into_parts().3.finish("the end").reason, None);
    let lines: Vec<_> = cycles(&disk.contents()[..]).0.into_iter().flat_map(|cycle| cycle.log).collect();
    let [first, second] = &lines[..] else { panic!("{lines:?}") };
    assert!(first.text.starts_with("`Slow` took ") && first.text.ends_with(" µs, its budget is 100 µs"), "{lines:?}");
    assert!(second.text.ends_with("; 99 more since the last line"), "{lines:?}");
}
