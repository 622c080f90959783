//! Blackboard with channels: each component has an input queue, and publishes through the queue of the blackboard.
//!
//! The blackboard keeps the last value of each name in a hash map and forwards it to the subscribers. All components
//! run in one thread, in the best order, so no message waits and no thread is woken. This is the lower bound of the
//! cost of such a design.

use std::collections::HashMap;
use std::rc::Rc;
use std::sync::mpsc::{Receiver, Sender, channel};

use crate::callbacks::{Value, outputs};
use crate::part::{MAX_INPUTS, Part, combine, work};
use crate::subject::{CYCLE_US, Subject};

struct Message {
    name: Rc<str>,
    value: Value,
}

struct Blackboard {
    inbox: Receiver<Message>,
    topics: HashMap<Rc<str>, Topic>,
}

struct Topic {
    value: Value,
    subscribers: Vec<Sender<Message>>,
}

impl Blackboard {
    /// Stores and forwards the messages in the queue.
    fn deliver(&mut self) {
        while let Ok(Message { name, value }) = self.inbox.try_recv() {
            if let Some(topic) = self.topics.get_mut(&name) {
                for subscriber in &topic.subscribers {
                    // A subscriber that was dropped needs no message.
                    _ = subscriber.send(Message { name: name.clone(), value: value.clone() });
                }
                topic.value = value;
            }
        }
    }
}

struct Member {
    name: Rc<str>,
    salt: u64,
    every: u64,
    next: u64,
    inbox: Receiver<Message>,
    outbox: Sender<Message>,
    /// Names and last values of the inputs.
    needs: Vec<(Rc<str>, u64)>,
}

impl Member {
    fn poll(&mut self, cycle: u64) {
        while let Ok(message) = self.inbox.try_recv() {
            if let Some((_, number)) = self.needs.iter_mut().find(|(name, _)| *name == message.name) {
                *number = message.value.whole();
            }
        }
        if cycle >= self.next {
            self.next = cycle + self.every;
            let number = work(self.needs.iter().fold(self.salt, |sum, &(_, need)| combine(sum, [need])));
            // The blackboard lives as long as its components.
            _ = self.outbox.send(Message { name: self.name.clone(), value: Value::Whole(number) });
        }
    }
}

/// Components around a blackboard with queues.
pub struct Channels {
    board: Blackboard,
    members: Vec<Member>,
    outputs: Vec<&'static str>,
}

impl Channels {
    /// Creates the components. Each subscribes to its inputs; one without inputs subscribes to its own value.
    ///
    /// # Panics
    /// If a part has more than [`MAX_INPUTS`] inputs.
    #[must_use]
    pub fn new(parts: &[Part]) -> Self {
        let (outbox, inbox) = channel();
        let names: Vec<Rc<str>> = parts.iter().map(|part| part.name.into()).collect();
        let topic = |name: &Rc<str>| (name.clone(), Topic { value: Value::Whole(1), subscribers: Vec::new() });
        let mut board = Blackboard { inbox, topics: names.iter().map(topic).collect() };
        let mut members = Vec::new();
        for (at, part) in parts.iter().enumerate() {
            assert!(part.needs.len() <= MAX_INPUTS, "`{}` has more than {MAX_INPUTS} inputs", part.name);
            let needs = if part.needs.is_empty() { vec![at] } else { part.needs.to_vec() };
            let (post, inbox) = channel();
            for &need in &needs {
                if let Some(topic) = board.topics.get_mut(&names[need]) {
                    topic.subscribers.push(post.clone());
                }
            }
            let needs = needs.into_iter().map(|need| (names[need].clone(), 1)).collect();
            let (name, outbox) = (names[at].clone(), outbox.clone());
            members.push(Member { name, salt: part.salt, every: part.every, next: 0, inbox, outbox, needs });
        }
        Self { board, members, outputs: outputs(parts) }
    }
}

impl Subject for Channels {
    fn cycle(&mut self, now: u64) {
        for member in &mut self.members {
            member.poll(now / CYCLE_US);
            self.board.deliver();
        }
    }

    fn result(&self) -> u64 {
        let read = |name: &str| self.board.topics.get(name).map_or(0, |topic| topic.value.whole());
        match self.outputs[..] {
            [one] => read(one),
            _ => self.outputs.iter().fold(0, |sum, name| combine(sum, [read(name)])),
        }
    }
}
