//! Assembly of scenery and true state from their parts.

use bica_wire::message::{SceneContent, SceneDeclaration, SceneKind, ScenePart};
use postcard_schema::schema::owned::OwnedNamedType;
use serde::Serialize;
use serde_json::Value;

use crate::schema::decode;

/// Largest size of the declarations or values of a scene, bytes.
const MAX_SCENE: usize = 1 << 22;

/// Item of the scenery or of the true state of a world.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Shown {
    /// Name for people.
    pub name: String,
    /// Name of a type of [`bica::visual`].
    pub shape: String,
    /// The frame in which the value is given.
    pub frame: String,
    /// The frame whose true place the value gives.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub child: Option<String>,
    /// The value, or a list of values; null if there is none.
    pub value: Value,
    /// Colour, `#rrggbb`; none: a tool chooses it.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub colour: Option<String>,
    /// Width of lines, m; none: areas are filled, and a tool chooses the width of lines.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub line_width: Option<f32>,
}

/// True state of a simulated world.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Truth {
    /// Instant of the cycle after which it was read, µs.
    pub time_us: u64,
    /// The items.
    pub items: Vec<Shown>,
}

impl Truth {
    /// Returns the value of an item.
    #[must_use]
    pub fn value(&self, name: &str) -> Option<&Value> {
        self.items.iter().find(|item| item.name == name).map(|item| &item.value)
    }
}

/// The scenes of a robot's world.
#[derive(Debug, Default)]
pub(super) struct Scenes {
    scenery: SceneParts,
    truth: SceneParts,
}

impl Scenes {
    /// Adds a part; returns time and items if values are complete.
    pub(super) fn add(&mut self, part: &ScenePart<'_>) -> Option<(u64, Vec<Shown>)> {
        let scene = match part.scene {
            SceneKind::Scenery => &mut self.scenery,
            SceneKind::Truth => &mut self.truth,
        };
        scene.add(part)
    }
}

#[derive(Debug, Default)]
struct SceneParts {
    /// Number of the declarations.
    number: u32,
    /// Items without values, each with the schema of its value.
    declared: Vec<(Shown, OwnedNamedType)>,
    bytes: Vec<u8>,
}

impl SceneParts {
    fn add(&mut self, part: &ScenePart<'_>) -> Option<(u64, Vec<Shown>)> {
        if self.bytes.len() + part.bytes.len() <= MAX_SCENE {
            self.bytes.extend_from_slice(part.bytes);
        }
        if !part.last {
            return None;
        }
        let bytes = std::mem::take(&mut self.bytes);
        match part.content {
            SceneContent::Declarations => {
                (self.number, self.declared) = (part.number, declarations(&bytes).unwrap_or_default());
                None
            }
            SceneContent::Values { time_us } if part.number == self.number => {
                self.values(&bytes).map(|items| (time_us, items))
            }
            SceneContent::Values { .. } => None,
        }
    }

    fn values(&self, mut bytes: &[u8]) -> Option<Vec<Shown>> {
        let mut items = Vec::with_capacity(self.declared.len());
        for (item, schema) in &self.declared {
            let (value, rest) = postcard::take_from_bytes::<&[u8]>(bytes).ok()?;
            items.push(Shown { value: decode(schema, value)?, ..item.clone() });
            bytes = rest;
        }
        Some(items)
    }
}

fn declarations(mut bytes: &[u8]) -> Option<Vec<(Shown, OwnedNamedType)>> {
    let mut declared = Vec::new();
    while !bytes.is_empty() {
        let (SceneDeclaration { item, shape, schema }, rest) = postcard::take_from_bytes(bytes).ok()?;
        let text = |text: &str| text.to_owned();
        let shown = Shown {
            name: text(item.name),
            shape: text(shape),
            frame: text(item.frame),
            child: item.child.map(text),
            value: Value::Null,
            colour: item.colour.map(|[red, green, blue]| format!("#{red:02x}{green:02x}{blue:02x}")),
            line_width: item.line_width,
        };
        declared.push((shown, postcard::from_bytes(schema).ok()?));
        bytes = rest;
    }
    Some(declared)
}
