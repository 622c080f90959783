//! Events that wait for the program.

use std::collections::{HashSet, VecDeque};

use super::event::{Answered, Event};

/// Number of events from which events that a newer one replaces are dropped.
const MAX_EVENTS: usize = 4096;
/// Maximum number of events that are kept then.
const ROOM_FROM: usize = MAX_EVENTS / 4 * 3;

/// Events that wait for the program, the oldest first. If there are too many, only the newest of each repeated report stays.
/// Answers are dropped last.
#[derive(Debug, Default)]
pub(super) struct Events(VecDeque<Event>);

/// Key of events of which a later one replaces an earlier one: kind, component, output.
type Key = (u8, usize, usize);

const fn key(event: &Event) -> Option<Key> {
    Some(match *event {
        Event::Snapshot(_) => (0, 0, 0),
        Event::Output { component, output, .. } => (1, component, output),
        Event::Params { component } => (2, component, 0),
        Event::Lease(_) => (3, 0, 0),
        Event::Conditions { component, .. } => (4, component, 0),
        Event::Costs(_) => (5, 0, 0),
        Event::Truth(_) => (6, 0, 0),
        Event::Image(_) => (7, 0, 0),
        Event::World(_) => (8, 0, 0),
        Event::Scenery(_) => (9, 0, 0),
        Event::Result(_) => (10, 0, 0),
        Event::Log(_)
        | Event::Answer(_)
        | Event::Taken(_)
        | Event::Reached(_)
        | Event::Requested { .. }
        | Event::Happened { .. } => return None,
    })
}

impl Events {
    pub(super) fn push(&mut self, event: Event) {
        if self.0.len() >= MAX_EVENTS {
            self.make_room();
        }
        self.0.push_back(event);
    }

    pub(super) fn pop(&mut self) -> Option<Event> {
        self.0.pop_front()
    }

    /// Takes the answer to a request.
    pub(super) fn take_answer(&mut self, number: u32) -> Option<Answered> {
        let found = self.0.iter().position(|event| matches!(event, Event::Answer(answer) if answer.number == number));
        match self.0.remove(found?) {
            Some(Event::Answer(answer)) => Some(answer),
            _ => None,
        }
    }

    fn make_room(&mut self) {
        let mut seen = HashSet::new();
        self.0.make_contiguous().reverse();
        self.0.retain(|event| key(event).is_none_or(|key| seen.insert(key)));
        self.0.make_contiguous().reverse();
        // A robot sends one answer for each request. The number of answers is bounded, too, because a hostile robot may send
        // more.
        let give_way: [fn(&Event) -> bool; 3] =
            [|event| matches!(event, Event::Log(_)), |event| !matches!(event, Event::Answer(_)), |_| true];
        for gives_way in give_way {
            let mut surplus = self.0.len().saturating_sub(ROOM_FROM);
            self.0.retain(|event| {
                let stays = surplus == 0 || !gives_way(event);
                surplus -= usize::from(!stays);
                stays
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use bica_wire::message::{LeaseState, LogLine, LogSource};

    use super::*;

    #[test]
    fn lease_answer_stays_among_many_events() {
        let mut events = Events::default();
        let output = |cycle, output| Event::Output { cycle, component: 0, output, value: None };
        let log = |time_us| Event::Log(LogLine { time_us, level: 2, source: LogSource::Robot, text: String::new() });
        let answer = Answered { number: 7, cycle: 0, arrived: 0, values: Vec::new(), refused: None };
        let first = [Event::Lease(LeaseState::default()), Event::Answer(answer), output(0, 1)];
        for event in first.clone() {
            events.push(event);
        }
        for cycle in 0..20_000 {
            events.push(if cycle % 2 == 0 { output(cycle, 0) } else { log(cycle) });
        }
        assert!(events.0.len() <= MAX_EVENTS, "{}", events.0.len());
        assert_eq!(events.0.iter().take(3).collect::<Vec<_>>(), first.iter().collect::<Vec<_>>());
        assert!(events.0.iter().rev().take(2).eq([&log(19_999), &output(19_998, 0)]));
        assert!(events.take_answer(7).is_some());
    }
}
