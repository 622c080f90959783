//! What a page can show.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};

/// What to show.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "snake_case", deny_unknown_fields)]
pub enum Open {
    /// A world in this process: one of [`Hello`](super::ToPage::Hello).
    World {
        /// Name of the world.
        world: String,
        /// Seed.
        seed: u64,
        /// Texts of its options.
        #[serde(default)]
        options: BTreeMap<String, String>,
    },
    /// A robot: `tcp://HOST:PORT` or `serial:DEVICE[@BAUD]`.
    Robot {
        /// Address.
        address: String,
    },
    /// The images of the folder of labelled images: one in each second. They have no tree.
    Images {},
    /// A recording in the recordings folder.
    Recording {
        /// File name without folder.
        name: String,
    },
}
