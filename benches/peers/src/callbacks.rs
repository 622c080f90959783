//! Blackboard with callbacks: a hash map of named values, and the subscribers of each name.
//!
//! Messages were passed like this in the first design of the paper that this project follows. Publishing a value calls
//! its subscribers; a subscriber reads its other inputs by name.

use std::cell::{Cell, RefCell};
use std::collections::HashMap;

use crate::part::{MAX_INPUTS, OUTPUTS, Part, combine, mix};
use crate::subject::{CYCLE_US, Subject};

/// Value on the blackboard.
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// Unsigned integer.
    Whole(u64),
    /// Real number.
    Real(f64),
    /// Text.
    Text(String),
    /// List of values.
    List(Vec<Value>),
}

impl Value {
    /// Returns the integer, or 0 for another kind of value.
    #[must_use]
    pub fn whole(&self) -> u64 {
        if let Self::Whole(number) = self { *number } else { 0 }
    }
}

type Callback = Box<dyn Fn(&Blackboard, &Value)>;

/// Named values and their subscribers.
#[derive(Default)]
struct Blackboard {
    values: RefCell<HashMap<String, Value>>,
    callbacks: HashMap<String, Vec<Callback>>,
}

impl Blackboard {
    fn subscribe(&mut self, name: &str, callback: Callback) {
        self.callbacks.entry(name.to_owned()).or_default().push(callback);
    }

    fn publish(&self, name: &str, value: &Value) {
        if let Some(place) = self.values.borrow_mut().get_mut(name) {
            place.clone_from(value);
        }
        for callback in self.callbacks.get(name).into_iter().flatten() {
            callback(self, value);
        }
    }

    fn read(&self, name: &str) -> u64 {
        self.values.borrow().get(name).map_or(0, Value::whole)
    }
}

/// Component on the blackboard.
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

    /// Runs when the last input is published; the message contains that input.
    fn on_input(&self, board: &Blackboard, last: &Value) {
        let numbers: [u64; N] =
            core::array::from_fn(|at| if at + 1 == N { last.whole() } else { board.read(self.needs[at]) });
        board.publish(self.name, &Value::Whole(mix(self.salt, numbers)));
    }

    /// Runs at the start of a cycle, and reads all inputs.
    fn on_cycle(&self, board: &Blackboard, cycle: u64) {
        if cycle >= self.next.get() {
            self.next.set(cycle + self.every);
            board.publish(self.name, &Value::Whole(mix(self.salt, self.needs.map(|need| board.read(need)))));
        }
    }
}

const CYCLE: &str = "cycle";

fn add<const N: usize>(board: &mut Blackboard, part: &Part, parts: &[Part], by_input: bool) {
    let member = Member::<N>::new(part, parts);
    let (name, callback): (_, Callback) = match part.needs.last() {
        Some(&need) if by_input => (parts[need].name, Box::new(move |board, last| member.on_input(board, last))),
        _ => (CYCLE, Box::new(move |board, cycle| member.on_cycle(board, cycle.whole()))),
    };
    board.subscribe(name, callback);
}

/// Components around a blackboard.
pub struct Callbacks {
    board: Blackboard,
    outputs: Vec<&'static str>,
}

impl Callbacks {
    /// Creates the components. If all run in every cycle, each subscribes to its last input, otherwise to the cycle
    /// event.
    ///
    /// # Panics
    /// If a part has more than [`MAX_INPUTS`] inputs.
    #[must_use]
    pub fn new(parts: &[Part]) -> Self {
        let mut board = Blackboard::default();
        let by_input = parts.iter().all(|part| part.every == 1);
        let names = parts.iter().map(|part| part.name).chain([CYCLE]);
        board.values = RefCell::new(names.map(|name| (name.to_owned(), Value::Whole(1))).collect());
        for part in parts {
            match part.needs.len() {
                0 | 1 => add::<1>(&mut board, part, parts, by_input),
                2 => add::<2>(&mut board, part, parts, by_input),
                3 => add::<3>(&mut board, part, parts, by_input),
                6 => add::<6>(&mut board, part, parts, by_input),
                count => panic!("a component with {count} inputs is not supported; the maximum is {MAX_INPUTS}"),
            }
        }
        Self { board, outputs: outputs(parts) }
    }
}

/// Names of the values that form the result.
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
            _ => self.outputs.iter().fold(0, |sum, name| combine(sum, [self.board.read(name)])),
        }
    }
}
