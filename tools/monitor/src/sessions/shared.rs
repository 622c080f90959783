//! What the manager and a session's thread change.

use std::collections::BTreeSet;
use std::path::PathBuf;
use std::sync::Arc;
use std::time::Instant;

use bica_drawing::layout::Kind;
use bica_link::{Description, Shown, decode_output};
use bica_wire::message::Offers;
use serde_json::Value;

use super::breakpoint_target::BreakpointTarget;
use super::history::History;
use super::recorded_images::Recorded;
use super::watches::Watching;
use crate::pages::PageId;
use crate::protocol::{Capabilities, Connection, RecordingState};

/// Who operates a session.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Operator {
    /// Nobody.
    #[default]
    Nobody,
    /// A page.
    Page(PageId),
    /// Another monitor of the robot.
    Other,
}

/// Part of a session that its thread and the manager change.
#[derive(Default)]
pub(super) struct Shared {
    pub(super) connection: Connection,
    pub(super) note: String,
    /// How the run ended; empty before.
    pub(super) result: String,
    pub(super) seed: Option<u64>,
    pub(super) can: Capabilities,
    /// What the robot's program sends, of a connected session.
    pub(super) offers: Offers,
    pub(super) recording: RecordingState,
    /// File with the run of a world.
    pub(super) recording_file: PathBuf,
    /// Number of times that everything remembered was forgotten.
    pub(super) epoch: u64,
    pub(super) operator: Operator,
    /// Whether a simulated world is paused.
    pub(super) paused: bool,
    /// Whether the rules of a world of this process have ended its run.
    pub(super) is_over: bool,
    pub(super) description: Option<Arc<Description>>,
    /// The description with the parameters at the beginning of the run.
    pub(super) begun: Option<Arc<Description>>,
    pub(super) kinds: Vec<Kind>,
    /// What does not move in the world.
    pub(super) scenery: Vec<Shown>,
    pub(super) history: History,
    /// File and images of a recording.
    pub(super) recorded: Recorded,
    pub(super) watching: Watching,
    pub(super) breakpoints: Vec<BreakpointTarget>,
    /// Breakpoints of the session before this one, and its tree.
    pub(super) inherited: Option<(Arc<Description>, Vec<BreakpointTarget>)>,
    /// Pages that know the tree.
    pub(super) described: BTreeSet<PageId>,
    pub(super) images_taken: u64,
    pub(super) overruns: u64,
    /// When the last cycle was received.
    pub(super) received: Option<Instant>,
}

impl Shared {
    /// Returns a value of an output as JSON; null if it is too large, or its schema is not known.
    pub(super) fn decode(&self, component: usize, output: usize, value: &[u8]) -> Value {
        let tree = self.description.as_ref();
        tree.and_then(|tree| decode_output(tree, component, output, value)).unwrap_or_default()
    }
}
