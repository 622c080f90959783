//! Detections as one line of JSON.

use serde::Serialize;

use super::{Ball, Crossing, Detections, Goal, Robot};

/// Detections in an image. Pixels: x right, y down, the centre of the first pixel is (0, 0).
#[derive(Debug, Serialize)]
pub(super) struct JsonLine<'a> {
    file: &'a str,
    ball: Option<&'a Ball>,
    goals: Vec<GoalBox<'a>>,
    #[serde(rename = "field_end")]
    field_boundary: &'a [[f32; 2]],
    lines: &'a [[f32; 4]],
    robots: &'a [Robot],
    crossings: &'a [Crossing],
    circle: Option<[f32; 2]>,
    ms: f64,
}

/// Bounding box of a goal.
#[derive(Debug, Serialize)]
struct GoalBox<'a> {
    colour: &'a str,
    x0: f32,
    y0: f32,
    x1: f32,
    y1: f32,
    complete: bool,
}

impl<'a> JsonLine<'a> {
    pub(super) fn new(seen: &'a Detections) -> Self {
        let frame = |goal: &'a Goal| {
            let &Goal { colour, x0, y0, x1, y1, complete, .. } = goal;
            GoalBox { colour, x0, y0, x1, y1, complete }
        };
        Self {
            file: &seen.file,
            ball: seen.ball.as_ref(),
            goals: seen.goals.iter().map(frame).collect(),
            field_boundary: &seen.field_boundary,
            lines: &seen.lines,
            robots: &seen.robots,
            crossings: &seen.crossings,
            circle: seen.circle,
            ms: seen.wall_ms,
        }
    }
}
