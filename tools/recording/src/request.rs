//! Requests in a recording.

use bica::runner::{OwnedRequest, Request};
use bica::{ComponentId, Hold, Setting, Value};
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

use crate::header::TreeInfo;

/// A request to the running tree, or to the simulated world.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum RequestRecord {
    /// A component is held active, held latent, or released.
    Hold {
        /// Index of the component.
        component: u16,
        /// The hold; [`Hold::Tree`] releases the component.
        hold: Hold,
    },
    /// The rate of a component is modulated.
    Rate {
        /// Index of the component.
        component: u16,
        /// Runs per second.
        hz: f32,
    },
    /// Parameters are set.
    Params {
        /// All settings of the batch.
        settings: Vec<Setting>,
    },
    /// A modulation is called.
    Modulate {
        /// Index of the component.
        component: u16,
        /// Index of the modulation in the component.
        index: u16,
        /// One value for each argument.
        arguments: Vec<Value>,
    },
    /// A request that this version of the recorder does not know. Such a run cannot be replayed.
    Unknown {
        /// The request, as text.
        text: String,
    },
    /// The simulated world is changed.
    World {
        /// Name of the change, such as `ball`.
        name: String,
        /// Its values, in the order and units that the world defines.
        values: Vec<f32>,
    },
}

impl From<&Request<'_>> for RequestRecord {
    fn from(request: &Request<'_>) -> Self {
        let number = |component: ComponentId| component.index() as u16;
        match *request {
            Request::Hold { component, hold } => Self::Hold { component: number(component), hold },
            Request::Rate { component, hz } => Self::Rate { component: number(component), hz: hz.unwrap_or(f32::NAN) },
            Request::Params(batch) => Self::Params { settings: batch.to_vec() },
            Request::Modulate { component, modulation: index, arguments } => {
                Self::Modulate { component: number(component), index, arguments: arguments.to_vec() }
            }
        }
    }
}

impl RequestRecord {
    /// Returns the request for a tree; none if it is one to the world, or if this program does not know it.
    #[must_use]
    pub fn to_request(&self) -> Option<OwnedRequest> {
        let component = |index: u16| ComponentId::new(index.into());
        Some(match self {
            Self::Hold { component: index, hold } => OwnedRequest::Hold { component: component(*index), hold: *hold },
            Self::Rate { component: index, hz } => {
                OwnedRequest::Rate { component: component(*index), hz: (!hz.is_nan()).then_some(*hz) }
            }
            Self::Params { settings } => OwnedRequest::Params(settings.clone()),
            Self::Modulate { component: owner, index, arguments } => OwnedRequest::Modulate {
                component: component(*owner),
                modulation: *index,
                arguments: arguments.clone(),
            },
            Self::Unknown { .. } | Self::World { .. } => return None,
        })
    }

    /// Returns the request as text.
    #[must_use]
    pub fn describe(&self, tree: &TreeInfo) -> String {
        let info = |component: &u16| tree.components.get(usize::from(*component));
        let name = |component: &u16| {
            info(component).map_or_else(|| format!("component {component}"), |component| component.name.clone())
        };
        match self {
            Self::Hold { component, hold: Hold::Tree } => format!("release {}", name(component)),
            Self::Hold { component, hold: Hold::Active } => format!("hold {} active", name(component)),
            Self::Hold { component, hold: Hold::Latent } => format!("hold {} latent", name(component)),
            Self::Rate { component, hz } => format!("rate of {} {hz} Hz", name(component)),
            Self::Params { settings } => {
                let one = |setting: &Setting| tree.describe_setting(setting);
                format!("set {}", settings.iter().map(one).collect::<Vec<_>>().join(" "))
            }
            Self::Modulate { component, index, arguments } => {
                let called = info(component).and_then(|component| component.modulations.get(usize::from(*index)));
                let called = called.map_or_else(|| format!("modulation {index}"), Clone::clone);
                let arguments: Vec<_> = arguments.iter().map(Value::to_string).collect();
                format!("modulate {}.{called}({})", name(component), arguments.join(", "))
            }
            Self::Unknown { text } => text.clone(),
            Self::World { name, values } => {
                let values: Vec<_> = values.iter().map(f32::to_string).collect();
                format!("world {name}({})", values.join(", "))
            }
        }
    }
}

impl TreeInfo {
    fn describe_setting(&self, setting: &Setting) -> String {
        let Setting { component, index, value } = setting;
        let owner = self.components.get(component.index());
        let parameter = owner.and_then(|owner| owner.parameters.get(usize::from(*index)));
        let value = match (value, parameter) {
            (Value::Choice(variant), Some(parameter)) if (*variant as usize) < parameter.variants.len() => {
                parameter.variants[*variant as usize].clone()
            }
            _ => value.to_string(),
        };
        match (owner, parameter) {
            (Some(owner), Some(parameter)) => format!("{}.{}={value}", owner.name, parameter.name),
            _ => format!("parameter {index} of component {component}={value}"),
        }
    }
}
