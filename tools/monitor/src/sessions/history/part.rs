//! Parts of the history, cycle by cycle.

use super::{History, Told};
use crate::program::Image;
use crate::protocol::ComponentNow;

/// History of a cycle, and of the time since the previous one.
#[derive(Debug)]
pub(crate) struct CyclePart {
    /// Time, µs.
    pub(crate) time_us: u64,
    /// Number.
    pub(crate) cycle: u64,
    /// States of all components after it.
    pub(crate) states: Vec<ComponentNow>,
    /// Component, index and value in postcard's format of outputs that came or changed.
    pub(crate) outputs: Vec<(usize, usize, Box<[u8]>)>,
    /// Entries of the log.
    pub(crate) told: Vec<Told>,
    /// Images.
    pub(crate) images: Vec<Image>,
}

impl History {
    /// Returns at most `count` cycles after a time and up to another one, in the order of time. Without `after_us` they begin with
    /// the first cycle in memory, which then has all that was known before.
    pub(crate) fn part(&self, after_us: Option<u64>, until_us: u64, count: usize) -> Vec<CyclePart> {
        let ticks = self.states.ticks_after(after_us, until_us, count);
        let (Some(&(first, _)), Some(&(last, _))) = (ticks.first(), ticks.last()) else { return Vec::new() };
        let Some((_, _, mut states)) = self.states.at(first) else { return Vec::new() };
        let changes = self.states.changes().skip_while(|change| change.time_us <= first);
        let mut changes = changes.take_while(|change| change.time_us <= last).peekable();
        let mut outputs = self.outputs.part(after_us, last, until_us).into_iter().peekable();
        let mut told = self.told.between(after_us.map_or(0, |after| after + 1), last).peekable();
        let mut images = self.images.part(after_us, last).cloned().peekable();
        let cycle = |(time_us, cycle): (u64, u64)| {
            while let Some(change) = changes.next_if(|change| change.time_us <= time_us) {
                states[usize::from(change.component)] = change.now;
            }
            let outputs = std::iter::from_fn(|| outputs.next_if(|sample| sample.0 <= time_us));
            CyclePart {
                time_us,
                cycle,
                states: states.clone(),
                outputs: outputs.map(|(_, component, index, value)| (component, index, value)).collect(),
                told: std::iter::from_fn(|| told.next_if(|(time, _)| *time <= time_us))
                    .map(|(_, told)| told.clone())
                    .collect(),
                images: std::iter::from_fn(|| images.next_if(|image| image.time_us <= time_us)).collect(),
            }
        };
        ticks.into_iter().map(cycle).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Limits, free};
    use super::*;
    use bica_recording::RunEvent;

    /// History of 20 cycles of one component, which is active in every fourth cycle.
    fn history() -> History {
        let mut history = History::new(Limits { ring_us: None, output_bytes: 1000, image_bytes: 1000 }, 1);
        for cycle in 0..20 {
            let time_us = cycle * 1000;
            history.states.push(time_us, cycle, std::iter::once(free(cycle % 4 == 0, None)));
            // The value changes in cycle 10.
            history.outputs.push(0, 1, time_us, &[cycle as u8 / 10]);
            if cycle % 5 == 2 {
                let image = Image {
                    number: cycle as u32,
                    time_us,
                    camera: "".into(),
                    width: 2,
                    height: 1,
                    yuyv: vec![0; 4].into(),
                };
                history.images.push(image);
                let happened = RunEvent { at_ns: 0, kind: "goal".to_owned(), detail: String::new() };
                history.told.push(time_us - 1, Told::Event(happened));
            }
        }
        history
    }

    #[test]
    fn parts_of_any_size_are_everything_once() {
        let history = history();
        for size in [1, 3, 7, 100] {
            let (mut all, mut after) = (Vec::new(), None);
            loop {
                let part = history.part(after, 17_000, size);
                assert!(part.len() <= size);
                let Some(last) = part.last() else { break };
                after = Some(last.time_us);
                all.extend(part);
            }
            assert_eq!(all.iter().map(|one| one.cycle).collect::<Vec<_>>(), (0..=17).collect::<Vec<_>>());
            assert!(all.iter().all(|one| one.states[0].state.active == (one.cycle % 4 == 0)), "{size}");
            let with = |is: &dyn Fn(&CyclePart) -> bool| -> Vec<u64> {
                all.iter().filter(|one| is(one)).map(|one| one.cycle).collect()
            };
            assert_eq!(with(&|one| one.images.len() == 1), [2, 7, 12, 17], "{size}");
            assert_eq!(with(&|one| one.told.len() == 1), [2, 7, 12, 17], "{size}");
            let values: Vec<_> =
                all.iter().flat_map(|one| one.outputs.iter().map(|output| (one.cycle, &*output.2))).collect();
            assert_eq!(
                values,
                [(0, &[0][..]), (10, &[1]), (17, &[1])],
                "the last value is there until the end, {size}"
            );
        }
    }

    #[test]
    fn the_first_part_has_what_was_known_before_it() {
        let mut history = history();
        history.states.evict(5000);
        history.outputs.evict(5000);
        let part = history.part(None, u64::MAX, 1);
        assert_eq!((part[0].cycle, part[0].states[0].state.active), (5, false));
        assert_eq!(part[0].outputs.iter().map(|output| &*output.2).collect::<Vec<_>>(), [[0]]);
    }
}
