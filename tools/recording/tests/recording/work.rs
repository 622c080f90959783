//! Work beside the loop in recordings and replays.

use std::convert::Infallible;
use std::thread;
use std::time::Duration;

use bica::Instant;
use bica::prelude::*;
use bica::runner::workers::{Pace, Workers};
use bica_recording::{
    Header, ImagePolicy, Info, Recorder, RecorderOptions, ReplayOptions, RequestRecord, SetUp, Subject, replay,
};

use crate::replay::Temporary;
use crate::support::{Disk, cycles};

/// Begins a job as soon as one has ended.
pub(crate) struct Planner {
    sum: u64,
}

#[component]
impl Planner {
    const fn new() -> Self {
        Self { sum: 0 }
    }

    /// Takes a time that no replay knows.
    #[work(takes_ms = 20)]
    fn search(from: u64) -> u64 {
        assert_ne!(from % 7, 3, "no path");
        thread::sleep(Duration::from_micros(from % 3000));
        from.wrapping_mul(31).wrapping_add(7) % 9973
    }

    fn step(&mut self, work: &mut Work<Self>) {
        self.sum += work.result().unwrap_or_default();
        if work.is_idle() {
            self.sum += 1;
            work.begin(self.sum);
        }
    }
}

activation_tree! {
    pub(crate) struct Planning { root: Planner, cycle_hz: 100, components: [Planner] }
}

impl Robot for Planning {
    type Sensors<'a> = ();
    type Command = u64;
    type Error = Infallible;

    fn sense(&mut self, (): &()) -> Result<(), Infallible> {
        Ok(())
    }

    fn act(&mut self) -> u64 {
        self.get::<Planner>().sum
    }
}

/// Runs the planner, recorded.
fn recorded(pace: Pace) -> Vec<u8> {
    let disk = Disk::default();
    let header = Header::new(&Planning::GRAPH, SetUp::default(), ImagePolicy::All).of_robot(&Planning::new());
    let recorder = Recorder::start(disk.clone(), &header, RecorderOptions::default(), |_| {}).expect("memory");
    let runner = Runner::new(Box::new(Planning::new()), ()).with_observer(recorder);
    let mut runner = runner.with_jobs(Workers::new(2, pace));
    for cycle in 0..400 {
        let now = Instant::from_millis(10 * cycle);
        runner.sense(now, &()).expect("never refused");
        runner.think(now);
        if pace == Pace::RealTime {
            thread::sleep(Duration::from_micros(300));
        }
    }
    assert_eq!(runner.into_parts().3.finish("").reason, None);
    disk.contents()
}

#[test]
fn a_replay_has_each_result_in_its_recorded_cycle() {
    for pace in [Pace::RealTime, Pace::Simulated] {
        let file = Temporary::new(&format!("work-{pace:?}.mcap"), &recorded(pace));
        let subject = |_: &Header, _| Ok(Subject { robot: Box::new(Planning::new()), world: None });
        let report = replay::<Planning>(&ReplayOptions::whole(&file.0), subject, |_| true).expect("a recording");
        assert!(report.equal && report.cycles == 400, "{pace:?}: {:?}", report.first_difference);
    }
}

#[test]
fn a_recording_tells_begins_and_ends_of_jobs() {
    let bytes = recorded(Pace::Simulated);
    let (cycles, _) = cycles(&bytes[..]);
    let begun = &cycles.iter().find(|cycle| !cycle.events.is_empty()).expect("a job has begun").events[0];
    assert_eq!((&*begun.kind, &*begun.detail), ("work", "Planner.search has begun, due in 20 ms"));
    let component = Planning::id::<Planner>();
    let is_end = |request: &RequestRecord, end| *request == RequestRecord::Ended { component, end };
    assert!(cycles[2].requests.iter().any(|request| is_end(request, bica::JobEnd::OnTime)));
    let count =
        |end| cycles.iter().flat_map(|cycle| &cycle.requests).filter(|request| is_end(request, end)).count() as u64;
    let jobs = Info::read(&bytes[..]).expect("a recording").jobs;
    let counts = jobs["Planner.search"];
    assert!(jobs.len() == 1 && count(bica::JobEnd::Failed) > 0);
    let begun = cycles.iter().map(|cycle| cycle.events.len() as u64).sum();
    let expected = [begun, count(bica::JobEnd::OnTime), count(bica::JobEnd::Late), count(bica::JobEnd::Failed)];
    assert_eq!([counts.begun, counts.on_time, counts.late, counts.failed], expected);
}
