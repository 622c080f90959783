//! Who determines the time: the robot, or the answers to it.

use std::time::{Duration, Instant as Clock};

/// Time for which half of the answers are delayed while the pace is measured.
const DELAY: Duration = Duration::from_millis(6);
/// Number of intervals that are measured with the delay, and as many without.
const SAMPLES: usize = 24;
/// Rank of the interval that is compared, from the shortest. A busy computer makes intervals longer, never shorter, and a robot in step
/// takes longer for maps with images: a short interval is the robot's own.
const RANK: usize = SAMPLES / 8;
/// Time from a map of a robot in real time until its answer: the next one comes after 12 ms.
const ANSWER: Duration = Duration::from_millis(8);

/// Measurement of the robot's pace.
///
/// A robot in real time sends its maps whether or not they are answered. One in step, as a simulation is, waits for each answer, so that
/// its time does not depend on the speed of the computer. Some answers are delayed: the next map of a robot in step is late by this delay.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pace {
    is_real_time: bool,
    /// Number of maps in the measurement.
    count: u32,
    /// When the last of them came, and whether its answer was delayed.
    last: Option<(Clock, bool)>,
    /// Intervals after prompt answers, and after delayed ones.
    intervals: [Vec<Duration>; 2],
}

impl Pace {
    /// Notes that a map came before the last one was answered, as only a robot in real time sends it.
    pub(crate) const fn is_ahead(&mut self) {
        self.is_real_time = true;
    }

    /// Measures with a map that needs no prompt answer; returns for how long its answer waits.
    pub(crate) fn measure(&mut self, came: Clock) -> Option<Duration> {
        if let Some((last, was_delayed)) = self.last.take() {
            self.intervals[usize::from(was_delayed)].push(came - last);
            let are_enough = self.intervals.iter().all(|intervals| intervals.len() >= SAMPLES);
            self.is_real_time |= are_enough && self.is_unaffected();
        }
        if self.intervals.iter().all(|intervals| intervals.len() >= SAMPLES) {
            return None;
        }
        // The Thue-Morse sequence: as many delays as not, whatever the period in which the robot itself is slow.
        let is_delayed = self.count.count_ones() % 2 == 1;
        self.count += 1;
        self.last = Some((came, is_delayed));
        is_delayed.then_some(DELAY)
    }

    /// Whether the intervals after delayed answers are those after prompt ones.
    fn is_unaffected(&self) -> bool {
        let [prompt, delayed] = [0, 1].map(|kind: usize| {
            let mut intervals = self.intervals[kind].clone();
            intervals.sort_unstable();
            intervals[RANK]
        });
        delayed < prompt + DELAY / 2
    }

    /// Until when a map is answered that came at a time; `None`: a robot in step waits, and so it does before the pace is known.
    pub(crate) fn deadline(&self, came: Clock) -> Option<Clock> {
        self.is_real_time.then(|| came + ANSWER)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Measures a robot whose next map comes after an interval (ms) that depends on the number and the delay (ms) of the answer.
    fn is_real_time(interval: impl Fn(u64, u64) -> u64) -> bool {
        let (mut pace, mut now) = (Pace::default(), Clock::now());
        for number in 0..200 {
            assert_eq!(pace.deadline(now), None);
            let delay = pace.measure(now).unwrap_or_default().as_millis() as u64;
            if pace.deadline(now).is_some() {
                return true;
            }
            now += Duration::from_millis(interval(number, delay));
        }
        false
    }

    #[test]
    fn interval_without_the_delay_is_real_time() {
        assert!(is_real_time(|_, _| 12));
        assert!(is_real_time(|number, _| 10 + number * 7 % 5));
        assert!(is_real_time(|number, delay| if number.is_multiple_of(5) { 30 } else { delay.max(12) }));
    }

    #[test]
    fn interval_with_the_delay_is_in_step() {
        for period in 1..8 {
            // A robot that takes 20 ms for an image.
            assert!(!is_real_time(|number, delay| 1 + delay + if number.is_multiple_of(period) { 20 } else { 0 }));
        }
        // A busy computer.
        assert!(!is_real_time(|number, delay| 1 + delay + number * 7919 % 10));
    }

    #[test]
    fn early_map_is_real_time() {
        let mut pace = Pace::default();
        pace.is_ahead();
        let now = Clock::now();
        assert_eq!(pace.deadline(now), Some(now + ANSWER));
    }
}
