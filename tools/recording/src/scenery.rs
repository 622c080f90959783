//! Scenery of a world.

use bica::visual::{Scene, SceneItem, Shape};
use bica_link::decode;
use serde::{Deserialize, Serialize};

/// Object that does not move, such as the walls of a room.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Scenery {
    /// Name for people.
    pub name: String,
    /// Name of a type of [`bica::visual`].
    pub shape: String,
    /// The frame in which the value is given.
    pub frame: String,
    /// Red, green and blue; none: a tool chooses it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub colour: Option<[u8; 3]>,
    /// Width of lines, m; none: areas are filled.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub line_width: Option<f32>,
    /// The value, or a list of values.
    pub value: serde_json::Value,
}

impl Scenery {
    /// Returns the items that `show` shows, such as [`World::scenery`](bica::runner::World::scenery).
    pub(crate) fn of(show: impl FnOnce(&mut dyn Scene)) -> Vec<Self> {
        let mut items = Items(Vec::new());
        show(&mut items);
        items.0
    }
}

struct Items(Vec<Scenery>);

impl Scene for Items {
    fn show(&mut self, item: &SceneItem<'_>, value: &dyn Shape) {
        let mut bytes = Vec::new();
        if !value.encode(&mut |part| bytes.extend_from_slice(part)) {
            return;
        }
        let (name, shape, frame) = (item.name.to_owned(), value.name().to_owned(), item.frame.to_owned());
        // An item that cannot be decoded is omitted.
        if let Some(value) = decode(&value.schema().into(), &bytes) {
            let SceneItem { colour, line_width, .. } = *item;
            self.0.push(Scenery { name, shape, frame, colour, line_width, value });
        }
    }
}
