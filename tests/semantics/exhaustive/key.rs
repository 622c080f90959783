//! Identity of a state: what decides about all coming cycles, packed into numbers.

use std::collections::HashSet;
use std::hash::{BuildHasherDefault, Hasher};

use super::model::Model;
use super::shape::{COMPONENTS, Link, Rate, Row, Shape};
use super::subject::Subject;

/// State of the engine, and of each component in the model with its links.
pub(crate) type Key = ([u64; COMPONENTS + 1], [u32; COMPONENTS]);

/// Set of states.
pub(crate) type Known = HashSet<Key, BuildHasherDefault<Multiplier>>;

/// Returns the identity of a state. `rows` are the links of the active components.
pub(crate) fn key<T: Subject>(shape: &Shape, tree: &T, model: &Model, rows: &[Row; COMPONENTS]) -> Key {
    let mut engine = [0; COMPONENTS + 1];
    engine.iter_mut().zip(tree.engine().relative_state()).for_each(|(place, value)| *place = value);
    for (value, rate) in engine[1..].iter_mut().zip(shape.rates) {
        if rate == Rate::Every {
            // The engine reads no grid.
            *value &= 0xFFFF;
        }
    }
    let component = |index: usize| {
        let memory = &model.components[index];
        let links = rows[index].iter().fold(0, |code, link| code << 2 | *link as u32);
        u32::from(memory.active) | (memory.hold as u32) << 1 | links << 8 | u32::from(model.since[index]) << 16
    };
    (engine, std::array::from_fn(component))
}

/// Fast hash of a few numbers; the default one, which withstands chosen input, would take most of the time of a test.
#[derive(Default)]
pub(crate) struct Multiplier(u64);

impl Hasher for Multiplier {
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(8) {
            let mut word = [0; 8];
            word[..chunk.len()].copy_from_slice(chunk);
            // The multiplier is 2^64 divided by the golden ratio, made odd.
            self.0 = (self.0.rotate_left(5) ^ u64::from_le_bytes(word)).wrapping_mul(0x9E37_79B9_7F4A_7C15);
        }
    }

    fn finish(&self) -> u64 {
        self.0 ^ self.0 >> 32
    }
}

const _: () = assert!(Link::Modulation as u32 <= 3, "a link takes two bits");
