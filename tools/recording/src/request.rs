//! Requests in a recording.

use bica::runner::{OwnedRequest, Request};
use bica::{ComponentId, JobEnd, Value};
use bica_link::JobEvent;
use bica_wire::model::{Description, Modulation, NamedRequest};
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// An input of the running tree beside its sensor values: a request to it or to the simulated world, or the end of a job.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum RequestRecord {
    /// The tree is changed.
    Tree(OwnedRequest),
    /// The simulated world is changed.
    World {
        /// Name of the action.
        name: String,
        /// One value for each argument.
        values: Vec<Value>,
    },
    /// A job of a component has ended; its result is there in this cycle.
    Ended {
        /// The component.
        component: ComponentId,
        /// How it ended.
        end: JobEnd,
    },
}

impl RequestRecord {
    /// Creates the record of a request to a robot, or to its world with these actions.
    #[must_use]
    pub fn new(request: Request<'_>, actions: &[Modulation]) -> Self {
        match request {
            Request::World { action, arguments } => {
                let action = actions.get(usize::from(action)).map(|action| action.name.clone());
                Self::World { name: action.unwrap_or_default(), values: arguments.to_vec() }
            }
            request => Self::Tree(OwnedRequest::from(request)),
        }
    }

    /// Returns the request as text, with the names of the tree.
    #[must_use]
    pub fn describe(&self, tree: &Description) -> String {
        match self {
            Self::Tree(request) => tree.named(request.borrow()).to_string(),
            Self::Ended { component, end } => JobEvent::Ended(*end).detail(&work_name(tree, *component)),
            Self::World { name, values } => {
                let arguments = tree.action(name).map_or(&[][..], |index| &tree.actions[index].arguments);
                let plain = |(index, &value): (usize, &Value)| {
                    arguments.get(index).map_or_else(|| value.into(), |argument| argument.plain(value))
                };
                let arguments = values.iter().enumerate().map(plain).collect();
                NamedRequest::World { action: name.clone(), arguments }.to_string()
            }
        }
    }
}

/// Name of a component's function that runs beside the loop: `Planner.search`.
pub(crate) fn work_name(tree: &Description, component: ComponentId) -> String {
    let component = tree.components.get(component.index());
    let work = component.and_then(|component| Some(format!("{}.{}", component.name, component.work.as_ref()?.name)));
    work.unwrap_or_default()
}
