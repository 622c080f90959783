//! All cycles that can follow a state: transitions, and the links of the states that are entered.

use bica_core::Hold;

use super::model::Model;
use super::shape::{COMPONENTS, LINKS, Link, NO_LINKS, Row, STATES, Shape};

/// One cycle.
pub(crate) struct Choice {
    /// Links of each visited component as its visit begins.
    first: [Row; COMPONENTS],
    /// Links of each component that takes a transition, in the state that it enters.
    second: [Option<Row>; COMPONENTS],
}

impl Choice {
    /// Writes the links of the states that the cycle reads, and returns the state of each machine after its run.
    pub(crate) fn apply(&self, model: &Model, links: &mut [[Row; STATES]; COMPONENTS]) -> [u8; COMPONENTS] {
        std::array::from_fn(|index| {
            let memory = &model.components[index];
            let begins = if memory.active { memory.state.unwrap_or_default() } else { 0 };
            links[index][begins] = self.first[index];
            let ends = match self.second[index] {
                Some(row) => {
                    let other = (begins + 1) % STATES;
                    links[index][other] = row;
                    other
                }
                None => begins,
            };
            ends as u8
        })
    }

    /// Returns the links of each component that is active after the cycle.
    pub(crate) fn rows_after(&self, model: &Model) -> [Row; COMPONENTS] {
        std::array::from_fn(|index| {
            let is_active = model.components[index].active;
            if is_active { self.second[index].unwrap_or(self.first[index]) } else { NO_LINKS }
        })
    }
}

/// Calls `each` for every cycle that can follow a state. `rows` are the links of the active components.
pub(crate) fn each_choice(shape: &Shape, model: &Model, rows: &[Row; COMPONENTS], each: &mut dyn FnMut(&Choice)) {
    let choice = Choice { first: [NO_LINKS; COMPONENTS], second: [None; COMPONENTS] };
    let mut choices = Choices { shape, model, rows, choice, each };
    choices.choose(0, 1);
}

struct Choices<'a> {
    shape: &'a Shape,
    model: &'a Model,
    rows: &'a [Row; COMPONENTS],
    choice: Choice,
    each: &'a mut dyn FnMut(&Choice),
}

impl Choices<'_> {
    /// Chooses for the components from `index` on; `linked` has a bit for each component that is linked to in this cycle.
    ///
    /// Links lead to later components, so what visits a component is known when its turn comes.
    fn choose(&mut self, index: usize, linked: u8) {
        if index == self.shape.len {
            return (self.each)(&self.choice);
        }
        let memory = &self.model.components[index];
        let is_visited = match memory.hold {
            Hold::Tree => linked & 1 << index != 0,
            Hold::Active => true,
            Hold::Latent => false,
        };
        if !is_visited {
            return self.with(index, linked, NO_LINKS, None);
        }
        if memory.active {
            self.stay(index, linked, self.rows[index]);
            if self.model.since[index] + 1 >= self.shape.rates[index].cycles() {
                self.transitions(index, linked, self.rows[index]);
            }
            return;
        }
        for first in all_rows(self.shape.len, index) {
            self.stay(index, linked, first);
            // A transition prevents the modulations of the state that is left.
            if !first.contains(&Link::Modulation) {
                self.transitions(index, linked, first);
            }
        }
    }

    fn stay(&mut self, index: usize, linked: u8, row: Row) {
        self.with(index, linked | targets(row, true), row, None);
    }

    fn transitions(&mut self, index: usize, linked: u8, first: Row) {
        for second in all_rows(self.shape.len, index) {
            let reached = targets(first, false) | targets(second, true);
            self.with(index, linked | reached, first, Some(second));
        }
    }

    fn with(&mut self, index: usize, linked: u8, first: Row, second: Option<Row>) {
        (self.choice.first[index], self.choice.second[index]) = (first, second);
        self.choose(index + 1, linked);
    }
}

/// Returns a bit for each component that a row links to; modulations only on demand.
fn targets(row: Row, modulations: bool) -> u8 {
    let is_read = |link: Link| link == Link::Requirement || modulations && link == Link::Modulation;
    row.iter().enumerate().filter(|(_, link)| is_read(**link)).fold(0, |bits, (index, _)| bits | 1 << index)
}

/// Returns all rows of a component.
fn all_rows(len: usize, index: usize) -> impl Iterator<Item = Row> {
    let places = len - 1 - index;
    (0..3_usize.pow(places as u32)).map(move |mut code| {
        let mut row = NO_LINKS;
        for link in &mut row[index + 1..len] {
            *link = LINKS[code % 3];
            code /= 3;
        }
        row
    })
}
