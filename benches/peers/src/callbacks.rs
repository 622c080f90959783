//! A blackboard with call-backs: values under names in a hash map, and for each name those who want to hear of it.
//!
//! So messages passed in the first design of the paper that this project follows. Whoever publishes a value calls all who
//! listen; what else they need they look up by name.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;

use crate::part::{MOST, OUTPUTS, Part, mix};
use crate::subject::{CYCLE_US, Subject};

/// What can be written on the blackboard.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A whole number.
    Whole(u64),
    /// A real number.
    Real(f64),
    /// A text.
    Text(String),
    /// Several values.
    List(Vec<Value>),
}

impl Value {
    /// A whole number, or 0 for what is none.
    #[must_use]
    pub fn whole(&self) -> u64 {
        if let Self::Whole(number) = self { *number } else { 0 }
    }
}

type Listener = Box<dyn Fn(&Blackboard, &Value)>;

/// Values under names, and who listens to them.
#[derive(Default)]
struct Blackboard {
    values: RefCell<HashMap<String, Value>>,
    listeners: HashMap<String, Vec<Listener>>,
}

impl Blackboard {
    fn listen(&mut self, name: &str, listener: Listener) {
        self.listeners.entry(name.to_owned()).or_default().push(listener);
    }

    fn publish(&self, name: &str, value: &Value) {
        if let Some(place) = self.values.borrow_mut().get_mut(name) {
            place.clone_from(value);
        }
        for listener in self.listeners.get(name).into_iter().flatten() {
            listener(self, value);
        }
    }

    fn read(&self, name: &str) -> u64 {
        self.values.borrow().get(name).map_or(0, Value::whole)
    }
}

/// What a component on the blackboard remembers.
struct Member<const N: usize> {
    name: &'static str,
    salt: u64,
    needs: [&'static str; N],
    every: u64,
    next: Cell<u64>,
}

impl<const N: usize> Member<N> {
    fn new(part: &Part, parts: &[Part]) -> Self {
        let needs = core::array::from_fn(|at| part.needs.get(at).map_or(part.name, |&need| parts[need].name));
        Self { name: part.name, salt: part.salt, needs, every: part.every, next: Cell::new(0) }
    }

    /// On its last need: that comes with the message.
    fn on_need(&self, board: &Blackboard, last: &Value) {
        let numbers: [u64; N] =
            core::array::from_fn(|at| if at + 1 == N { last.whole() } else { board.read(self.needs[at]) });
        board.publish(self.name, &Value::Whole(mix(self.salt, numbers)));
    }

    /// On the beat of the cycles: it reads all that it needs.
    fn on_cycle(&self, board: &Blackboard, cycle: u64) {
        if cycle >= self.next.get() {
            self.next.set(cycle + self.every);
            board.publish(self.name, &Value::Whole(mix(self.salt, self.needs.map(|need| board.read(need)))));
        }
    }
}

const CYCLE: &str = "cycle";

fn join<const N: usize>(board: &mut Blackboard, part: &Part, parts: &[Part], by_need: bool) {
    let member = Member::<N>::new(part, parts);
    let (name, listener): (_, Listener) = match part.needs.last() {
        Some(&need) if by_need => (parts[need].name, Box::new(move |board, last| member.on_need(board, last))),
        _ => (CYCLE, Box::new(move |board, cycle| member.on_cycle(board, cycle.whole()))),
    };
    board.listen(name, listener);
}

/// Components around a blackboard.
pub struct Callbacks {
    board: Blackboard,
    outputs: Vec<&'static str>,
}

impl Callbacks {
    /// At rest. If all components run in every cycle, each listens to the last that it needs; else to the cycle's beat.
    ///
    /// # Panics
    /// If a part needs more than [`MOST`] others.
    #[must_use]
    pub fn new(parts: &[Part]) -> Self {
        let mut board = Blackboard::default();
        let by_need = parts.iter().all(|part| part.every == 1);
        let names = parts.iter().map(|part| part.name).chain([CYCLE]);
        board.values = RefCell::new(names.map(|name| (name.to_owned(), Value::Whole(1))).collect());
        for part in parts {
            match part.needs.len() {
                0 | 1 => join::<1>(&mut board, part, parts, by_need),
                2 => join::<2>(&mut board, part, parts, by_need),
                3 => join::<3>(&mut board, part, parts, by_need),
                6 => join::<6>(&mut board, part, parts, by_need),
                count => panic!("no component here needs {count} others; the most is {MOST}"),
            }
        }
        Self { board, outputs: outputs(parts) }
    }
}

/// The names of the numbers that make the result.
pub(crate) fn outputs(parts: &[Part]) -> Vec<&'static str> {
    let all = if parts.len() == 25 { &OUTPUTS[..] } else { &[parts.len() - 1] };
    all.iter().map(|&output| parts[output].name).collect()
}

impl Subject for Callbacks {
    fn cycle(&mut self, now: u64) {
        self.board.publish(CYCLE, &Value::Whole(now / CYCLE_US));
    }

    fn result(&self) -> u64 {
        match self.outputs[..] {
            [one] => self.board.read(one),
            _ => self.outputs.iter().fold(0, |sum, name| mix(sum, [self.board.read(name)])),
        }
    }
}
