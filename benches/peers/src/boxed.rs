//! `Box<dyn Component>` in a list sorted by dependency: the usual late binding.

use crate::part::{self, MAX_INPUTS, Part, mix};
use crate::subject::{CYCLE_US, Subject};
use crate::timer::Timer;

/// Component of the list.
trait Component {
    /// Computes the component's number from the numbers of all; `own` is its previous one.
    fn step(&mut self, own: u64, numbers: &[u64]) -> u64;
}

struct Source {
    salt: u64,
}

impl Component for Source {
    fn step(&mut self, own: u64, _numbers: &[u64]) -> u64 {
        mix(self.salt, [own])
    }
}

struct Mix<const N: usize> {
    salt: u64,
    needs: [usize; N],
}

impl<const N: usize> Component for Mix<N> {
    fn step(&mut self, _own: u64, numbers: &[u64]) -> u64 {
        mix(self.salt, self.needs.map(|need| numbers[need]))
    }
}

/// # Panics
/// If the part has more than [`MAX_INPUTS`] inputs.
fn component(part: &Part) -> Box<dyn Component> {
    fn mixing<const N: usize>(part: &Part) -> Box<dyn Component> {
        Box::new(Mix::<N> { salt: part.salt, needs: core::array::from_fn(|at| part.needs[at]) })
    }
    match part.needs.len() {
        0 => Box::new(Source { salt: part.salt }),
        1 => mixing::<1>(part),
        2 => mixing::<2>(part),
        3 => mixing::<3>(part),
        6 => mixing::<6>(part),
        count => panic!("a component with {count} inputs is not supported; the maximum is {MAX_INPUTS}"),
    }
}

struct Entry {
    component: Box<dyn Component>,
    every: u64,
    next: u64,
}

/// List of components.
pub struct Boxed<T> {
    entries: Vec<Entry>,
    numbers: Vec<u64>,
    timer: T,
}

impl<T: Timer> Boxed<T> {
    /// Creates the components, with `timer` around each.
    #[must_use]
    pub fn new(parts: &[Part], timer: T) -> Self {
        let entry = |part: &Part| Entry { component: component(part), every: part.every, next: 0 };
        Self { entries: parts.iter().map(entry).collect(), numbers: vec![1; parts.len()], timer }
    }
}

impl<T: Timer> Subject for Boxed<T> {
    fn cycle(&mut self, now: u64) {
        let cycle = now / CYCLE_US;
        for (at, entry) in self.entries.iter_mut().enumerate() {
            if cycle >= entry.next {
                entry.next = cycle + entry.every;
                let numbers = &mut self.numbers;
                self.timer.time(at, || numbers[at] = entry.component.step(numbers[at], numbers));
            }
        }
    }

    fn result(&self) -> u64 {
        part::result(&self.numbers)
    }
}
