//! The shape of a tree, and the enumeration of all shapes.

/// Number of components of the largest tree.
pub(crate) const COMPONENTS: usize = 4;

/// Number of states of the largest machine.
pub(crate) const STATES: usize = 3;

/// Link of a component, in one of its states, to another component.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(crate) enum Link {
    None,
    Requirement,
    Modulation,
}

pub(crate) const LINKS: [Link; 3] = [Link::None, Link::Requirement, Link::Modulation];

/// Rate of a component.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Rate {
    /// Every cycle; the component declares no rate.
    Every,
    /// Every second cycle, as declared.
    Half,
    /// Every third cycle; the component declares half of the cycle rate and is set to a third.
    Third,
    /// In every second cycle; the component declares no rate and is set to half the cycle rate.
    HalfUndeclared,
}

pub(crate) const RATES: [Rate; 4] = [Rate::Every, Rate::Half, Rate::Third, Rate::HalfUndeclared];

impl Rate {
    pub(crate) fn is_declared(self) -> bool {
        matches!(self, Self::Half | Self::Third)
    }

    /// Returns the rate that is set before the first tick.
    pub(crate) fn requested(self) -> Option<f32> {
        match self {
            Self::Third => Some(100.0 / 3.0),
            Self::HalfUndeclared => Some(50.0),
            Self::Every | Self::Half => None,
        }
    }

    /// Returns the number of cycles from one run to the next.
    pub(crate) fn cycles(self) -> u8 {
        match self {
            Self::Every => 1,
            Self::Half | Self::HalfUndeclared => 2,
            Self::Third => 3,
        }
    }
}

/// Links of a component in one state, by the index of the other component.
pub(crate) type Row = [Link; COMPONENTS];

/// Shape of a tree. Component 0 is the root; links lead from lower to higher indices.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Shape {
    /// Number of components.
    pub(crate) len: usize,
    /// Number of states of each component.
    pub(crate) states: [usize; COMPONENTS],
    /// Links of each component in each state.
    pub(crate) links: [[Row; STATES]; COMPONENTS],
    pub(crate) rates: [Rate; COMPONENTS],
}

pub(crate) const NO_LINKS: Row = [Link::None; COMPONENTS];

impl Shape {
    /// Components with these rates and no links.
    pub(crate) fn of_rates(len: usize, rates: [Rate; COMPONENTS]) -> Self {
        Self { len, states: [1; COMPONENTS], links: [[NO_LINKS; STATES]; COMPONENTS], rates }
    }

    /// Whether a chain of links leads from the root to each component.
    fn is_reachable(&self) -> bool {
        let mut reached = [true, false, false, false];
        for from in 0..self.len {
            for row in &self.links[from][..self.states[from]] {
                for to in from + 1..self.len {
                    reached[to] |= reached[from] && row[to] != Link::None;
                }
            }
        }
        reached[..self.len].iter().all(|&reached| reached)
    }
}

/// Calls `each` for every shape of `len` components with these numbers of states in which all components are reachable
/// from the root. Shapes that differ only in the order of the states after the initial one are passed once. All
/// components run in every cycle.
pub(crate) fn shapes(len: usize, states: [usize; COMPONENTS], each: &mut impl FnMut(Shape)) {
    let shape = Shape { states, ..Shape::of_rates(len, [Rate::Every; COMPONENTS]) };
    fill(shape, 0, 0, each);
}

/// Fills the rows, beginning with `state` of `component`.
fn fill(shape: Shape, component: usize, state: usize, each: &mut impl FnMut(Shape)) {
    if component == shape.len {
        if shape.is_reachable() {
            each(shape);
        }
        return;
    }
    if state == shape.states[component] {
        return fill(shape, component + 1, 0, each);
    }
    let places = shape.len - component - 1;
    for code in 0..3_usize.pow(places as u32) {
        // States after the initial one can be exchanged, so only sorted rows are used.
        if state == 2 && code < encoded(&shape, component, 1) {
            continue;
        }
        let mut shape = shape;
        for place in 0..places {
            shape.links[component][state][component + 1 + place] = LINKS[code / 3_usize.pow(place as u32) % 3];
        }
        fill(shape, component, state + 1, each);
    }
}

/// Returns the code of a row: the inverse of the decoding in `fill`.
fn encoded(shape: &Shape, component: usize, state: usize) -> usize {
    let row = &shape.links[component][state][component + 1..shape.len];
    row.iter().rev().fold(0, |code, link| 3 * code + LINKS.iter().position(|other| other == link).unwrap_or_default())
}
