//! Requests in a recording.

use bica::runner::{OwnedRequest, Request};
use bica_wire::model::Description;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// A request to the running tree, or to the simulated world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum RequestRecord {
    /// The tree is changed.
    Tree(OwnedRequest),
    /// The simulated world is changed.
    World {
        /// Name of the change, such as `ball`.
        name: String,
        /// Its values, in the order and units that the world defines.
        values: Vec<f32>,
    },
    /// A request of which only the text is known. Such a run cannot be replayed.
    Unknown {
        /// The request, as text.
        text: String,
    },
}

impl From<&Request<'_>> for RequestRecord {
    fn from(request: &Request<'_>) -> Self {
        Self::Tree(OwnedRequest::from(*request))
    }
}

impl RequestRecord {
    /// Returns the request as text, with the names of the tree.
    #[must_use]
    pub fn describe(&self, tree: &Description) -> String {
        match self {
            Self::Tree(request) => tree.named(request.borrow()).to_string(),
            Self::Unknown { text } => text.clone(),
            Self::World { name, values } => {
                let values: Vec<_> = values.iter().map(f32::to_string).collect();
                format!("world {name}({})", values.join(", "))
            }
        }
    }
}
