//! What a world shows on the map beside the outputs of its robot.

use bica::info::Information;
use bica::visual::Visual;
use serde::Serialize;
use serde_json::Value;

/// A part of a scenery, or something of the true state.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Drawn {
    /// Name for people.
    pub name: &'static str,
    /// Name of a type of [`bica::visual`].
    pub shape: &'static str,
    /// The frame in which the value is given.
    pub frame: &'static str,
    /// The frame whose true place the value is.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub child: Option<&'static str>,
    /// The value, or a list of values.
    pub value: Value,
    /// Colour, `#rrggbb`; none: that of the page for the true state.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub colour: Option<&'static str>,
    /// Width of its lines, m; none: it is filled, or the page chooses.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line_width: Option<f32>,
}

impl Drawn {
    /// Describes a value.
    ///
    /// # Panics
    /// If the value cannot be written as JSON.
    #[must_use]
    pub fn new<V: Visual + Information>(name: &'static str, frame: &'static str, value: &V) -> Self {
        let value = serde_json::to_value(value).expect("a visual type can be written as JSON");
        Self { name, shape: V::NAME, frame, child: None, value, colour: None, line_width: None }
    }
}
