//! State of a session that its thread and the manager change.

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

/// Operator of a session.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(super) enum Operator {
    /// No operator.
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
    /// Result of the run; empty before its end.
    pub(super) result: String,
    pub(super) seed: Option<u64>,
    pub(super) can: Capabilities,
    /// Data and operations that the robot's program offers, in a connected session.
    pub(super) offers: Offers,
    pub(super) recording: RecordingState,
    /// File with the run of a world.
    pub(super) recording_file: PathBuf,
    /// Number of times that the history was cleared.
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
    /// Scenery of the world.
    pub(super) scenery: Vec<Shown>,
    pub(super) history: History,
    /// File and images of a recording.
    pub(super) recorded: Recorded,
    pub(super) watching: Watching,
    pub(super) breakpoints: Vec<BreakpointTarget>,
    /// Tree and breakpoints of the session that this one replaces, until its own tree is known.
    pub(super) inherited: Option<(Arc<Description>, Vec<BreakpointTarget>)>,
    /// Pages that know the tree.
    pub(super) described: BTreeSet<PageId>,
    pub(super) images_taken: u64,
    pub(super) overruns: u64,
    /// Instant at which the last cycle was received.
    pub(super) received: Option<Instant>,
}

impl Shared {
    /// Returns a value of an output as JSON; null if it is too large, or its schema is not known.
    pub(super) fn decode(&self, component: usize, output: usize, value: &[u8]) -> Value {
        let tree = self.description.as_ref();
        tree.and_then(|tree| decode_output(tree, component, output, value)).unwrap_or_default()
    }
}
