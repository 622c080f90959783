//! Sources that a page can open.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// A source to open as a session.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Open {
    /// A world in this process: one of [`Hello`](super::ToPage::Hello), with values of its options as text.
    World {
        world: String,
        seed: u64,
        #[serde(default)]
        options: BTreeMap<String, String>,
    },
    /// A robot: `tcp://HOST:PORT` or `serial:DEVICE[@BAUD]`.
    Robot { address: String },
    /// The [image files](crate::program::ImageFiles) of the program, one for each second. The session has no tree.
    Images {},
    /// A recording in the recordings folder, by its name there.
    Recording { name: String },
}
