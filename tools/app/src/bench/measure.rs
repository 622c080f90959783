//! Times of the components and phases in each cycle of a run.

use std::fmt;
use std::time::Instant as Clock;

use bica::check::CAPACITY;
use bica::runner::{Cycle, Observer, Robot, Runner, World};
use bica::stopwatch::Spent;
use bica::{Instant, Probe, Stopwatch};

use crate::console::Failure;
use crate::world::Robots;

/// Phases of a cycle: writing the sensor values, reading the command, and the chain from sensing to acting.
pub(super) const PHASES: [&str; 3] = ["sensing", "acting", "the whole chain"];
/// Time of a component that did not run in a cycle.
const NOT_RUN: u32 = u32::MAX;

/// Times of a run's channels: its components, then its phases, ns.
#[derive(Debug)]
pub(super) struct Times {
    channels: Vec<&'static str>,
    /// Minima over the repetitions, cycle by cycle.
    minima: Vec<u32>,
    /// Largest time of each channel in any repetition.
    pub(super) ever: Vec<u32>,
}

impl Times {
    pub(super) fn new(channels: Vec<&'static str>, times: Vec<u32>) -> Self {
        let mut ever = vec![0; channels.len()];
        for cycle in times.chunks(channels.len()) {
            for (ever, time) in ever.iter_mut().zip(cycle).filter(|(_, time)| **time != NOT_RUN) {
                *ever = (*ever).max(*time);
            }
        }
        Self { channels, minima: times, ever }
    }

    /// Replaces each time by the minimum of it and that of another repetition.
    ///
    /// # Errors
    /// If the repetitions did not run the same components in the same cycles; the text names the first difference.
    pub(super) fn merge(&mut self, other: &Self) -> Result<(), String> {
        let differs = |(one, other): (&u32, &u32)| (*one == NOT_RUN) != (*other == NOT_RUN);
        if let Some(place) = self.minima.iter().zip(&other.minima).position(differs) {
            let (cycle, channel) = (place / self.channels.len(), self.channels[place % self.channels.len()]);
            return Err(format!("`{channel}` ran in cycle {cycle} of one repetition and not of another"));
        }
        let [one, two] = [self, other].map(|times| times.minima.len() / times.channels.len());
        if one != two {
            return Err(format!("one repetition has {one} cycles, another one {two}"));
        }
        self.minima.iter_mut().zip(&other.minima).for_each(|(one, other)| *one = (*one).min(*other));
        self.ever.iter_mut().zip(&other.ever).for_each(|(one, other)| *one = (*one).max(*other));
        Ok(())
    }

    /// Returns the minima of a channel in the cycles in which it ran, ns.
    pub(super) fn of(&self, channel: usize) -> impl Iterator<Item = u32> {
        let all = self.minima.iter().skip(channel).step_by(self.channels.len());
        all.copied().filter(|time| *time != NOT_RUN)
    }
}

/// Runs a robot until its aim, the end of the world, or a time limit, s.
pub(super) fn run<R: Robot<Error: fmt::Display>>(
    world: Box<dyn World<R>>,
    Robots { make, is_done }: Robots<R>,
    seconds: f64,
) -> Result<Times, Failure> {
    let began = Clock::now();
    let watch: Stopwatch<_, CAPACITY> = Stopwatch::new(|| began.elapsed().as_nanos() as u64);
    let nodes = const { &R::GRAPH }.nodes;
    let end = world.now() + bica::Duration::from_micros((seconds * 1e6) as u64);
    let mut runner = Runner::new(make(), world).with_observer((Phases::new(), watch));
    let (mut times, mut before) = (Vec::new(), vec![Spent::default(); nodes.len()]);
    while !is_done.is_some_and(|is_done| is_done(runner.robot()))
        && !runner.world().is_over()
        && runner.world().now() < end
    {
        runner.cycle().map_err(|error| {
            Failure::new(format!("the robot rejected sensor values: {error}"), "choose another --world or --option")
        })?;
        let (phases, watch) = runner.observer();
        for (before, now) in before.iter_mut().zip(watch.spent()) {
            times.push(if now.runs > before.runs { nanoseconds(now.total - before.total) } else { NOT_RUN });
            *before = *now;
        }
        times.extend(phases.times);
    }
    Ok(Times::new(nodes.iter().map(|node| node.name).chain(PHASES).collect(), times))
}

fn nanoseconds(time: impl TryInto<u32>) -> u32 {
    time.try_into().map_or(NOT_RUN - 1, |time| time.min(NOT_RUN - 1))
}

/// Stopwatch of the phases of a cycle.
struct Phases {
    /// Times of [`PHASES`], ns.
    times: [u32; PHASES.len()],
    began: Clock,
    tick_end: Clock,
}

impl Phases {
    fn new() -> Self {
        let now = Clock::now();
        Self { times: [NOT_RUN; PHASES.len()], began: now, tick_end: now }
    }
}

impl Probe for Phases {
    fn cycle_end(&mut self) {
        self.tick_end = Clock::now();
    }
}

impl<R: Robot> Observer<R> for Phases {
    fn sensing(&mut self, _now: Instant, _sensors: &R::Sensors<'_>) {
        self.began = Clock::now();
    }

    fn sensed(&mut self) {
        self.times[0] = nanoseconds(self.began.elapsed().as_nanos());
    }

    fn acted(&mut self, _cycle: &Cycle<'_, R>) {
        let now = Clock::now();
        self.times[1] = nanoseconds((now - self.tick_end).as_nanos());
        self.times[2] = nanoseconds((now - self.began).as_nanos());
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn minimum_of_each_run_counts() {
        let mut times = Times::new(vec!["A", "B"], vec![5, NOT_RUN, 7, 1]);
        times.merge(&Times::new(vec!["A", "B"], vec![4, NOT_RUN, 9, 3])).expect("the same runs");
        assert_eq!(times.of(0).collect::<Vec<_>>(), [4, 7]);
        assert_eq!(times.of(1).collect::<Vec<_>>(), [1]);
        assert_eq!(times.ever, [9, 3]);
    }

    #[test]
    fn repetitions_that_differ_are_refused() {
        let mut times = Times::new(vec!["A", "B"], vec![5, NOT_RUN, 7, 1]);
        let other = times.merge(&Times::new(vec!["A", "B"], vec![5, 1, 7, 1])).expect_err("another run of B");
        assert!(other.contains("`B` ran in cycle 0"), "{other}");
        let shorter = times.merge(&Times::new(vec!["A", "B"], vec![5, NOT_RUN])).expect_err("fewer cycles");
        assert!(shorter.contains("2 cycles, another one 1"), "{shorter}");
    }
}
