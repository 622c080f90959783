//! Scenery and true state of a world, as its monitors receive them.
//!
//! Both are sent in the same way: first the declarations of all items, then their values. Neither is limited in size, so
//! each is sent in parts.

use bica_core::visual::SceneItem;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// Size of the bytes of a [`ScenePart`]; the last part may be shorter.
pub const SCENE_PART_BYTES: usize = 1024;

/// A part of declarations or values. The parts follow each other; a monitor puts them together until the last one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct ScenePart<'a> {
    /// Scenery or true state.
    pub scene: SceneKind,
    /// Number of the declarations, from 0; values belong to the declarations with the same number.
    pub number: u32,
    /// Content of the bytes.
    pub content: SceneContent,
    /// Whether it is the last part.
    pub last: bool,
    /// The bytes.
    pub bytes: &'a [u8],
}

/// Scenery or true state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum SceneKind {
    /// Objects that do not move: sent when a monitor attaches.
    Scenery,
    /// The true state of a simulated world: its declarations are sent when a monitor attaches and when they change, its values to
    /// the monitors that watch it. It goes from the simulator to monitors only; no message to a robot can contain it.
    Truth,
}

/// Content of the bytes of all parts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum SceneContent {
    /// A sequence of [`SceneDeclaration`]s in postcard's format.
    Declarations,
    /// A sequence of byte strings in postcard's format: the value of each item, in postcard's format too.
    Values {
        /// Instant of the cycle after which they were read, µs.
        time_us: u64,
    },
}

/// Declaration of an item.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct SceneDeclaration<'a> {
    /// The item.
    #[serde(borrow)]
    pub item: SceneItem<'a>,
    /// Name of its visual type.
    pub shape: &'a str,
    /// Schema of its value, `NamedType` of `postcard_schema`, in postcard's format.
    pub schema: &'a [u8],
}
