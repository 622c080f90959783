//! Bars of the activation timeline.

use super::History;
use crate::protocol::{Bar, Row};

/// Bars of one component under construction.
struct Drawing {
    bars: Vec<Bar>,
    /// Whether the last bar is made of several short ones.
    merged: bool,
    /// Begin and state of the open bar.
    open: Option<(u64, Option<u16>)>,
    resolution: u64,
}

impl Drawing {
    fn close(&mut self, until: u64) {
        let Some((from, state)) = self.open.take() else { return };
        let is_short = until - from < self.resolution;
        if let Some(last) = self.bars.last_mut() {
            let gap = from - last.1;
            let last_is_short = self.merged || last.1 - last.0 < self.resolution;
            let is_same = last.2 == state && gap > 0;
            if gap < self.resolution && ((is_short && last_is_short) || is_same) {
                self.merged = is_short && last_is_short;
                last.1 = until;
                last.2 = last.2.filter(|_| last.2 == state);
                return;
            }
        }
        self.merged = false;
        self.bars.push(Bar(from, until, state));
    }
}

impl History {
    /// Returns a row for each component, with the bars that overlap an interval. Bars and gaps shorter than the resolution are
    /// merged. No bar covers a time in which nothing was received.
    pub(crate) fn rows(&self, from_us: u64, until_us: u64, resolution_us: u64) -> Vec<Row> {
        let (first, last) = self.span();
        let (begin, end) = (from_us.max(first), until_us.min(last).max(from_us.max(first)));
        let mut rows: Vec<Drawing> = self
            .states
            .base()
            .iter()
            .map(|base| Drawing {
                bars: Vec::new(),
                merged: false,
                open: base.state.active.then_some((begin, base.state.state)),
                resolution: resolution_us,
            })
            .collect();
        let mut gaps = self.states.gaps().filter(|gap| gap.1 > begin && gap.0 < end).peekable();
        let is_between = |row: &mut Drawing, &(from, until): &(u64, u64)| {
            let state = row.open.map(|(_, state)| state);
            row.close(from.max(begin));
            row.open = state.filter(|_| until <= end).map(|state| (until, state));
        };
        for change in self.states.changes().filter(|change| change.visible) {
            if change.time_us > end {
                break;
            }
            while let Some(gap) = gaps.next_if(|gap| gap.1 <= change.time_us) {
                for row in &mut rows {
                    is_between(row, gap);
                }
            }
            let row = &mut rows[usize::from(change.component)];
            let time = change.time_us.max(begin);
            if change.time_us > begin {
                row.close(time);
            }
            row.open = change.now.state.active.then_some((time, change.now.state.state));
        }
        for gap in gaps {
            for row in &mut rows {
                is_between(row, gap);
            }
        }
        let finish = |(component, mut row): (usize, Drawing)| {
            row.close(end);
            row.bars.retain(|bar| bar.1 > bar.0);
            let overruns = self.overruns(component, begin, end, resolution_us);
            Row { component, bars: row.bars, overruns, jobs: Vec::new() }
        };
        rows.into_iter().enumerate().map(finish).collect()
    }

    /// Returns the times of overruns of a component in an interval, at most one for each `resolution_us`.
    fn overruns(&self, component: usize, from_us: u64, until_us: u64, resolution_us: u64) -> Vec<u64> {
        let mut times: Vec<u64> = Vec::new();
        for &(time, _) in self.overruns.between(from_us, until_us).filter(|(_, of)| usize::from(*of) == component) {
            if times.last().is_none_or(|last| time - last >= resolution_us) {
                times.push(time);
            }
        }
        times
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Limits, free};
    use super::*;

    /// History of one component, from `(active, state)` in each ms.
    fn history(states: &[(bool, u16)], ring_us: Option<u64>) -> History {
        let mut history = History::new(Limits { ring_us, output_bytes: 1000, image_bytes: 1000 }, 1);
        for (index, &(active, state)) in states.iter().enumerate() {
            let one = std::iter::once(free(active, Some(state)));
            history.states.push(index as u64 * 1000, index as u64, one);
            history.evict();
        }
        history
    }

    const COURSE: [(bool, u16); 8] =
        [(false, 0), (true, 0), (true, 0), (true, 1), (true, 1), (false, 1), (true, 1), (true, 1)];

    #[test]
    fn overruns_are_in_the_order_of_time() {
        let mut history = history(&COURSE, None);
        for (time_us, component) in [(5000, 0), (1000, 0), (3000, 1), (2000, 0)] {
            history.overruns.push(time_us, component);
        }
        assert_eq!(history.overruns(0, 0, 9000, 0), [1000, 2000, 5000]);
        assert_eq!(history.overruns(0, 1500, 4000, 0), [2000]);
    }

    #[test]
    fn bars_are_exact_to_the_cycle() {
        let history = history(&COURSE, None);
        let expected = [Bar(1000, 3000, Some(0)), Bar(3000, 5000, Some(1)), Bar(6000, 7000, Some(1))];
        assert_eq!(history.rows(0, 99_000, 0)[0].bars, expected);
        assert_eq!(history.rows(2000, 4000, 0)[0].bars, [Bar(2000, 3000, Some(0)), Bar(3000, 4000, Some(1))]);
    }

    #[test]
    fn no_bar_covers_a_time_in_which_nothing_was_received() {
        let mut history = history(&[(true, 0); 3], None);
        history.interrupt();
        for (time_us, active) in [(7000, true), (8000, true), (9000, false)] {
            history.states.push(time_us, time_us / 1000, std::iter::once(free(active, Some(0))));
        }
        assert_eq!(history.states.gaps().collect::<Vec<_>>(), [&(2000, 7000)]);
        let bars = |from, until| history.rows(from, until, 0)[0].bars.clone();
        assert_eq!(bars(0, 99_000), [Bar(0, 2000, Some(0)), Bar(7000, 9000, Some(0))]);
        // Intervals that begin or end in the gap, lie in it, or end before a change.
        assert_eq!(bars(4000, 8000), [Bar(7000, 8000, Some(0))]);
        assert_eq!(bars(1000, 5000), [Bar(1000, 2000, Some(0))]);
        assert_eq!(bars(3000, 5000), []);
        assert_eq!(history.states.at(5000).unwrap().0, 2000, "the last cycle before the gap");
        history.limits.ring_us = Some(1500);
        history.evict();
        assert_eq!(history.states.gaps().count(), 0);
    }

    #[test]
    fn a_state_that_changed_in_a_gap_begins_after_it() {
        let mut history = history(&[(true, 0); 3], None);
        history.interrupt();
        history.states.push(7000, 7, std::iter::once(free(true, Some(1))));
        history.states.push(8000, 8, std::iter::once(free(true, Some(1))));
        assert_eq!(history.rows(0, 99_000, 0)[0].bars, [Bar(0, 2000, Some(0)), Bar(7000, 8000, Some(1))]);
    }

    #[test]
    fn short_bars_and_gaps_are_merged() {
        let history = history(&COURSE, None);
        assert_eq!(history.rows(0, 99_000, 1500)[0].bars, [Bar(1000, 3000, Some(0)), Bar(3000, 7000, Some(1))]);
        assert_eq!(history.rows(0, 99_000, 10_000)[0].bars, [Bar(1000, 7000, None)]);
    }

    #[test]
    fn state_at_a_time_is_of_the_last_cycle_before() {
        let history = history(&COURSE, None);
        let (time, cycle, states) = history.states.at(3999).unwrap();
        assert_eq!((time, cycle, states[0].activity(), states[0].since_us), (3000, 3, (true, Some(1)), 3000));
        let (time, _, states) = history.states.at(5500).unwrap();
        assert_eq!((time, states[0].state.active, states[0].since_us), (5000, false, 5000));
    }

    #[test]
    fn a_ring_forgets_what_is_older_and_stays_exact() {
        let history = history(&COURSE, Some(3500));
        assert_eq!(history.span(), (4000, 7000));
        assert_eq!(history.rows(0, 99_000, 0)[0].bars, [Bar(4000, 5000, Some(1)), Bar(6000, 7000, Some(1))]);
        assert_eq!(history.states.at(4000).unwrap().2[0].state.state, Some(1));
    }
}
