//! The bounded exchange between the loop and the thread that distributes.

use std::collections::VecDeque;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError, TryLockError};
use std::time::Duration;

use super::connection::Connection;
use super::cycle_data::CycleData;
use super::outbox::Message;
use super::picture::Picture;
use super::watcher::Watcher;

/// Largest number of messages that wait. Those to whom more are sent are disconnected.
const MAX_MESSAGES: usize = 1 << 16;
/// Largest number of cycles whose data waits; the oldest is dropped.
const MAX_DATA: usize = 8;
/// Number of cycles whose data wakes the distributor, in a loop that is faster than [`POLL`].
const WAKE_DATA: usize = MAX_DATA / 2;
/// Number of messages that wake the distributor.
const WAKE_MESSAGES: usize = 256;
/// Time between two looks of the distributor: waking it in each cycle would cost the loop a call of the
/// operating system, which takes longer than everything else.
const POLL: Duration = Duration::from_millis(2);
/// Number of looks without a result after which it sleeps until the loop wakes it.
const POLLS: u32 = 16;

/// Receiver of a message.
#[derive(Debug)]
pub(super) enum Recipient {
    One(Arc<Connection>),
    All,
}

/// The newest image for the distributor, with the monitors at that time.
#[derive(Clone, Debug)]
pub(super) struct Shot {
    pub(super) watchers: Arc<[Watcher]>,
    pub(super) picture: Picture,
}

/// What one thread hands to the other. Its memory is used again.
#[derive(Debug, Default)]
pub(super) struct Outgoing {
    pub(super) messages: VecDeque<(Recipient, Message)>,
    /// Data of cycles, the oldest first.
    pub(super) data: VecDeque<CycleData>,
    /// The newest image.
    pub(super) shot: Option<Shot>,
    /// Data that was distributed or dropped.
    spare: Vec<CycleData>,
}

impl Outgoing {
    /// Returns data to be filled.
    pub(super) fn unused_data(&mut self) -> CycleData {
        self.spare.pop().unwrap_or_default()
    }

    /// Adds data of a cycle, unless there is nothing to send.
    pub(super) fn add_data(&mut self, data: CycleData) {
        if data.is_empty() { self.spare.push(data) } else { self.data.push_back(data) }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.messages.is_empty() && self.data.is_empty() && self.shot.is_none()
    }

    /// Drops the oldest data if there is too much.
    fn limit_data(&mut self) {
        while self.data.len() > MAX_DATA {
            self.spare.extend(self.data.pop_front());
        }
    }
}

/// The exchange. Its lock is held for moves of pointers only.
#[derive(Debug, Default)]
pub(super) struct Exchange {
    state: Mutex<State>,
    filled: Condvar,
}

#[derive(Debug, Default)]
struct State {
    waiting: Outgoing,
    /// How the distributor waits.
    sleep: Sleep,
    closed: bool,
}

/// Waiting of the distributor.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
enum Sleep {
    #[default]
    Awake,
    /// It looks again soon.
    Short,
    /// Only a wake-up ends it.
    Long,
}

impl Exchange {
    /// Hands everything over, unless the distributor uses the exchange in this instant; then it stays with the caller. For the
    /// loop, which never waits. Calls `overflow` with the connections of messages that find no room.
    pub(super) fn offer(&self, outgoing: &mut Outgoing, mut overflow: impl FnMut(&Connection)) {
        outgoing.limit_data();
        let mut state = match self.state.try_lock() {
            Ok(state) => state,
            Err(TryLockError::Poisoned(poisoned)) => poisoned.into_inner(),
            Err(TryLockError::WouldBlock) => return,
        };
        if state.waiting.messages.len() + outgoing.messages.len() > MAX_MESSAGES {
            for (recipient, _) in outgoing.messages.drain(..) {
                if let Recipient::One(connection) = recipient {
                    overflow(&connection);
                }
            }
        }
        let waiting = &mut state.waiting;
        waiting.messages.append(&mut outgoing.messages);
        waiting.data.append(&mut outgoing.data);
        if let Some(shot) = outgoing.shot.take() {
            waiting.shot = Some(shot);
        }
        waiting.limit_data();
        outgoing.spare.append(&mut waiting.spare);
        let is_much = waiting.data.len() >= WAKE_DATA || waiting.messages.len() >= WAKE_MESSAGES;
        if is_much || state.sleep == Sleep::Long {
            self.wake(state);
        }
    }

    /// Adds a message to all monitors.
    pub(super) fn push_to_all(&self, message: Message) {
        let mut state = self.lock();
        if state.waiting.messages.len() < MAX_MESSAGES {
            state.waiting.messages.push_back((Recipient::All, message));
        }
        self.wake(state);
    }

    /// Waits for messages or data and exchanges them with `received`, whose data is used again. Looks
    /// again [some times](POLLS), then waits until it is woken. Returns false after [`close`](Self::close), once everything was taken.
    pub(super) fn take(&self, received: &mut Outgoing) -> bool {
        received.spare.extend(received.data.drain(..));
        let mut polls = 0;
        let mut state = self.lock();
        while state.waiting.is_empty() {
            if state.closed {
                return false;
            }
            if polls < POLLS {
                polls += 1;
                state.sleep = Sleep::Short;
                state = self.filled.wait_timeout(state, POLL).unwrap_or_else(PoisonError::into_inner).0;
            } else {
                state.sleep = Sleep::Long;
                state = self.filled.wait(state).unwrap_or_else(PoisonError::into_inner);
            }
        }
        state.sleep = Sleep::Awake;
        std::mem::swap(&mut state.waiting.messages, &mut received.messages);
        std::mem::swap(&mut state.waiting.data, &mut received.data);
        received.shot = state.waiting.shot.take();
        state.waiting.spare.append(&mut received.spare);
        true
    }

    /// Ends the distributor.
    pub(super) fn close(&self) {
        let mut state = self.lock();
        state.closed = true;
        self.wake(state);
    }

    fn wake(&self, mut state: MutexGuard<'_, State>) {
        let sleep = std::mem::take(&mut state.sleep);
        drop(state);
        if sleep != Sleep::Awake {
            self.filled.notify_one();
        }
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use bica_wire::message::LogSource;

    use super::*;

    fn log(time_us: u64) -> (Recipient, Message) {
        (Recipient::All, Message::Log { time_us, level: 2, source: LogSource::Robot, text: "".into() })
    }

    fn times(outgoing: &Outgoing) -> Vec<u64> {
        let time = |(_, message): &(Recipient, Message)| match message {
            Message::Log { time_us, .. } => *time_us,
            _ => panic!("another message"),
        };
        outgoing.messages.iter().map(time).collect()
    }

    fn data(outgoing: &mut Outgoing, cycle: u64) -> CycleData {
        let mut data = outgoing.unused_data();
        data.begin(cycle);
        data
    }

    #[test]
    fn messages_are_kept_in_order_and_of_data_the_newest() {
        let (exchange, mut outgoing, mut received) = (Exchange::default(), Outgoing::default(), Outgoing::default());
        for cycle in 0..20 {
            outgoing.messages.push_back(log(cycle));
            let data = data(&mut outgoing, cycle);
            outgoing.data.push_back(data);
            exchange.offer(&mut outgoing, |_| panic!("there is room"));
            assert!(outgoing.is_empty());
        }
        assert!(exchange.take(&mut received));
        assert_eq!(times(&received), (0..20).collect::<Vec<_>>());
        let cycles: Vec<_> = received.data.iter().map(|data| data.cycle).collect();
        assert_eq!(cycles, (20 - MAX_DATA as u64..20).collect::<Vec<_>>());
    }

    #[test]
    fn what_the_exchange_cannot_take_stays_bounded_with_the_loop() {
        let (exchange, mut outgoing) = (Exchange::default(), Outgoing::default());
        let in_use = exchange.lock();
        for cycle in 0..20 {
            outgoing.messages.push_back(log(cycle));
            let data = data(&mut outgoing, cycle);
            outgoing.data.push_back(data);
            exchange.offer(&mut outgoing, |_| panic!("nothing was handed over"));
        }
        drop(in_use);
        assert_eq!((outgoing.messages.len(), outgoing.data.len()), (20, MAX_DATA));
        exchange.offer(&mut outgoing, |_| panic!("there is room"));
        let mut received = Outgoing::default();
        assert!(exchange.take(&mut received));
        assert_eq!((times(&received).len(), received.data.back().map(|data| data.cycle)), (20, Some(19)));
    }

    #[test]
    fn data_is_used_again() {
        let (exchange, mut outgoing, mut received) = (Exchange::default(), Outgoing::default(), Outgoing::default());
        for cycle in 0..100 {
            let data = data(&mut outgoing, cycle);
            outgoing.data.push_back(data);
            exchange.offer(&mut outgoing, |_| panic!("there is room"));
            assert!(exchange.take(&mut received));
        }
        let waiting = &exchange.lock().waiting;
        let spare = waiting.spare.len() + outgoing.spare.len() + received.spare.len();
        assert!(spare <= 3, "{spare} are spare");
    }

    #[test]
    fn everything_is_taken_before_the_end() {
        let (exchange, mut received) = (Exchange::default(), Outgoing::default());
        exchange.push_to_all(log(1).1);
        exchange.close();
        assert!(exchange.take(&mut received));
        assert_eq!(times(&received), [1]);
        received.messages.clear();
        assert!(!exchange.take(&mut received));
    }
}
