//! A state machine to lay out, and the result.

use serde::{Deserialize, Serialize};

use super::{Point, Rectangle};

/// Distances of a drawing that shows more or less of a machine, px.
#[derive(Clone, Copy, Debug)]
pub struct Look {
    /// Height of a lane.
    pub(super) lane: f64,
    /// Distance of lines in a gap.
    pub(super) apart: f64,
    /// White above the first and below the last lane.
    pub(super) above: f64,
    /// White between two states of a row.
    pub(super) gap: f64,
    /// Usual size of a state with its surroundings.
    pub(super) cell: (f64, f64),
    /// Least width that is kept for a name; `None` if no names are drawn.
    pub(super) name: Option<f64>,
}

/// All of a machine, names and conditions, names of states.
pub const LOOKS: [Look; 3] = [
    Look { lane: 32.0, apart: 10.0, above: 16.0, gap: 70.0, cell: (260.0, 230.0), name: Some(96.0) },
    Look { lane: 18.0, apart: 9.0, above: 11.0, gap: 60.0, cell: (220.0, 140.0), name: Some(0.0) },
    Look { lane: 8.0, apart: 6.0, above: 16.0, gap: 34.0, cell: (150.0, 86.0), name: None },
];

/// A transition from one state.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub struct Arrow {
    /// Name; arrows of one name to one state are a bundle, with one name in the drawing.
    pub name: String,
    /// Index of the state that it leaves; `None` for all.
    pub from: Option<usize>,
    /// Index of the state that it enters.
    pub to: usize,
    /// Width of the name in the drawing, px.
    pub width: f64,
}

/// The course of an arrow.
#[derive(Clone, Debug, PartialEq)]
pub struct Course {
    /// Corners of its line.
    pub points: Vec<Point>,
    /// Corners of the line from it to a name that stands beside it.
    pub leader: Vec<Point>,
    /// Middle of the name.
    pub label: Point,
    /// Index of the arrow of its bundle that has the name.
    pub owner: usize,
}

/// A laid-out machine.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Machine {
    /// States.
    pub boxes: Vec<Rectangle>,
    /// Courses of the arrows.
    pub courses: Vec<Course>,
    /// What it covers.
    pub area: Rectangle,
}
