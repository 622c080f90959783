//! Scenery and true state of a world, encoded for monitors.

use std::sync::Arc;

use bica::visual::{Scene, SceneItem, Shape};
use bica_wire::message::{SCENE_PART_BYTES, SceneContent, SceneDeclaration, SceneKind, ScenePart};
use bica_wire::{ToMonitorExtra, TooLarge};

/// Declarations and values of scenery or true state, in postcard's format.
#[derive(Debug, Default)]
pub(super) struct EncodedScene {
    pub(super) declarations: Vec<u8>,
    pub(super) values: Vec<u8>,
    /// Memory for a value.
    value: Vec<u8>,
}

impl EncodedScene {
    /// Encodes the items that `show` shows.
    pub(super) fn of(show: impl FnOnce(&mut dyn Scene)) -> Self {
        let mut scene = Self::default();
        show(&mut scene);
        scene
    }

    /// Appends an item; returns `None` if it cannot be encoded.
    fn append(&mut self, item: &SceneItem<'_>, value: &dyn Shape) -> Option<()> {
        self.value.clear();
        if !value.encode(&mut |part| self.value.extend_from_slice(part)) {
            return None;
        }
        let schema = postcard::to_stdvec(value.schema()).ok()?;
        let declaration = SceneDeclaration { item: *item, shape: value.name(), schema: &schema };
        let declaration = postcard::to_stdvec(&declaration).ok()?;
        let value = postcard::to_stdvec(&self.value[..]).ok()?;
        self.declarations.extend(declaration);
        self.values.extend(value);
        Some(())
    }
}

impl Scene for EncodedScene {
    fn show(&mut self, item: &SceneItem<'_>, value: &dyn Shape) {
        // An item that cannot be encoded is omitted, with its declaration.
        let _ = self.append(item, value);
    }
}

/// Declarations or values that are sent.
#[derive(Clone, Debug)]
pub(super) struct Sent {
    pub(super) scene: SceneKind,
    pub(super) number: u32,
    pub(super) content: SceneContent,
    pub(super) bytes: Arc<[u8]>,
}

impl Sent {
    /// Passes the messages on.
    pub(super) fn messages(
        &self,
        mut message: impl FnMut(&ToMonitorExtra<'_>) -> Result<(), TooLarge>,
    ) -> Result<(), TooLarge> {
        let Self { scene, number, content, ref bytes } = *self;
        let count = bytes.len().div_ceil(SCENE_PART_BYTES).max(1);
        (0..count).try_for_each(|index| {
            let (begin, last) = (index * SCENE_PART_BYTES, index + 1 == count);
            let end = bytes.len().min(begin + SCENE_PART_BYTES);
            message(&ToMonitorExtra::Scene(ScenePart { scene, number, content, last, bytes: &bytes[begin..end] }))
        })
    }
}

/// Scenery and true state of a world, as the loop sends them.
#[derive(Debug, Default)]
pub(super) struct WorldScenes {
    /// Declarations and values of the scenery; none without one.
    scenery: Vec<Sent>,
    /// The declarations of the true state that were announced last.
    truth: Option<Sent>,
}

impl WorldScenes {
    /// Returns the scenes of a world before its first cycle.
    pub(super) fn of_scenery(EncodedScene { declarations, values, .. }: EncodedScene) -> Self {
        let part =
            |content, bytes: Vec<u8>| Sent { scene: SceneKind::Scenery, number: 0, content, bytes: bytes.into() };
        let scenery = if values.is_empty() {
            Vec::new()
        } else {
            let content = SceneContent::Values { time_us: 0 };
            vec![part(SceneContent::Declarations, declarations), part(content, values)]
        };
        Self { scenery, truth: None }
    }

    /// Returns the scenes that a monitor receives when it attaches.
    pub(super) fn announced(&self) -> impl Iterator<Item = &Sent> {
        self.scenery.iter().chain(&self.truth)
    }

    /// Returns the true state at an instant, µs, and its declarations if they are new.
    pub(super) fn truth(&mut self, time_us: u64, encoded: EncodedScene) -> (Option<Sent>, Sent) {
        let EncodedScene { declarations, values, .. } = encoded;
        let (scene, content) = (SceneKind::Truth, SceneContent::Values { time_us });
        let is_known = self.truth.as_ref().is_some_and(|known| *known.bytes == *declarations);
        if !is_known {
            let number = self.truth.as_ref().map_or(0, |known| known.number.wrapping_add(1));
            let content = SceneContent::Declarations;
            self.truth = Some(Sent { scene, number, content, bytes: declarations.into() });
        }
        let number = self.truth.as_ref().map_or(0, |known| known.number);
        let new = self.truth.clone().filter(|_| !is_known);
        (new, Sent { scene, number, content, bytes: values.into() })
    }
}
