//! What a page can show.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// What to show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
#[expect(missing_docs, reason = "the fields are explained at their variants")]
pub enum Open {
    /// A world in this process: one of [`Hello`](super::ToPage::Hello), with texts of its options.
    World {
        world: String,
        seed: u64,
        #[serde(default)]
        options: BTreeMap<String, String>,
    },
    /// A robot: `tcp://HOST:PORT` or `serial:DEVICE[@BAUD]`.
    Robot { address: String },
    /// The images of the folder of labelled images: one in each second. They have no tree.
    Images {},
    /// A recording in the recordings folder, by its name there.
    Recording { name: String },
}
