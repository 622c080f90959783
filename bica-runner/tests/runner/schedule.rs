//! Deadlines and overruns of real-time loops.

use bica_core::{Duration, Instant};
use bica_runner::{Overrun, OverrunPolicy, Schedule};

fn at(us: u64) -> Instant {
    Instant::from_micros(us)
}

/// Runs a cycle at its deadline with this execution time; returns the deadline and the overrun.
fn cycle(schedule: &mut Schedule, now: &mut u64, us: u64) -> (u64, Option<Overrun>) {
    let due = schedule.deadline(at(*now)).as_micros();
    *now = due.max(*now);
    schedule.begin(at(*now));
    *now += us;
    (due, schedule.end(at(*now)))
}

#[test]
fn deadlines_do_not_drift() {
    let (mut schedule, mut now) = (Schedule::new(30.0, OverrunPolicy::Skip), 1000);
    let last = (0..=108_000).map(|_| cycle(&mut schedule, &mut now, 10).0).last();
    assert_eq!(last, Some(1000 + 3_600_000_000), "108,000 periods are an hour");
    assert_eq!((schedule.overruns, schedule.skipped), (0, 0));
}

#[test]
fn a_late_cycle_skips_whole_periods() {
    let (mut schedule, mut now) = (Schedule::new(100.0, OverrunPolicy::Skip), 0);
    assert_eq!(cycle(&mut schedule, &mut now, 10_000), (0, None), "the cycle ends when the next one is due");
    let late = |us, skipped| Some(Overrun { late: Duration::from_micros(us), skipped });
    assert_eq!(cycle(&mut schedule, &mut now, 12_000), (10_000, late(2000, 0)));
    assert_eq!(cycle(&mut schedule, &mut now, 33_000), (20_000, late(25_000, 2)));
    assert_eq!(cycle(&mut schedule, &mut now, 100), (50_000, None));
    assert_eq!(cycle(&mut schedule, &mut now, 100), (60_000, None), "the grid is kept");
    assert_eq!((schedule.overruns, schedule.skipped, schedule.execution.count()), (2, 2, 5));
    assert_eq!(schedule.jitter.max(), Duration::from_micros(5000), "55 ms after the deadline at 50 ms");
}

#[test]
fn policy_shift_begins_a_new_grid() {
    let (mut schedule, mut now) = (Schedule::new(100.0, OverrunPolicy::Shift), 0);
    assert!(cycle(&mut schedule, &mut now, 13_000).1.is_some());
    assert_eq!(cycle(&mut schedule, &mut now, 100), (13_000, None));
    assert_eq!(cycle(&mut schedule, &mut now, 100), (23_000, None));
}

#[test]
fn a_rate_is_limited_to_its_bounds() {
    for (hz, period) in [(0.0, 1_000_000_000), (-3.0, 1_000_000_000), (1e9, 1), (f32::INFINITY, 1)] {
        let mut schedule = Schedule::new(hz, OverrunPolicy::Skip);
        let mut now = 0;
        cycle(&mut schedule, &mut now, 0);
        assert_eq!(cycle(&mut schedule, &mut now, 0).0, period, "{hz} Hz");
    }
}

/// The loops of a computer, of embassy and of the firmware have this rule.
#[test]
fn after_a_stall_there_is_no_burst_of_cycles() {
    let stall = 2_000_000;
    let counts = ["in a cycle", "between two cycles", "while waiting"].map(|place| {
        let (mut schedule, mut now) = (Schedule::new(100.0, OverrunPolicy::Skip), 0);
        cycle(&mut schedule, &mut now, if place == "in a cycle" { stall } else { 100 });
        if place == "between two cycles" {
            now += stall;
        } else if place == "while waiting" {
            schedule.deadline(at(now));
            now += stall;
            schedule.begin(at(now));
            schedule.end(at(now));
        }
        let end = now + 100_000;
        (0..1000).take_while(|_| cycle(&mut schedule, &mut now, 100).0 < end && now < end).count()
    });
    assert_eq!(counts, [10; 3]);
}
