//! Requests in a recording.

use bica::params::{self, Setting};
use bica::runner::{OwnedRequest, Request};
use bica::{ComponentId, Hold};
use bica_wire::message::Value;
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
        /// 0: released, 1: active, 2: latent.
        hold: u8,
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
        settings: Vec<SettingRecord>,
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
    /// The ball of the simulated world is placed, at rest.
    Ball {
        /// Position along the field, to the attacked goal, m.
        x: f32,
        /// Position across the field, to the left, m.
        y: f32,
    },
}

/// A parameter and its new value.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct SettingRecord {
    /// Index of the component.
    pub component: u16,
    /// Index of the parameter in the component.
    pub index: u16,
    /// The value.
    pub value: Value,
}

impl From<&Request<'_>> for RequestRecord {
    fn from(request: &Request<'_>) -> Self {
        Self::of(request).unwrap_or_else(|| Self::Unknown { text: format!("{request:?}") })
    }
}

impl RequestRecord {
    fn of(request: &Request<'_>) -> Option<Self> {
        let number = |component: ComponentId| component.index() as u16;
        Some(match *request {
            Request::Hold { component, hold } => {
                let hold = match hold {
                    Hold::Tree => 0,
                    Hold::Active => 1,
                    Hold::Latent => 2,
                };
                Self::Hold { component: number(component), hold }
            }
            Request::Rate { component, hz } => Self::Rate { component: number(component), hz },
            Request::Params(batch) => Self::Params { settings: batch.iter().map(setting).collect::<Option<_>>()? },
            Request::Modulate { component, index, arguments } => Self::Modulate {
                component: number(component),
                index: index as u16,
                arguments: arguments.iter().map(|&value| Value::of(value)).collect::<Option<_>>()?,
            },
            _ => return None,
        })
    }

    /// Returns the request for a tree; none if it is one to the world, or if this program does not know it.
    #[must_use]
    pub fn to_request(&self) -> Option<OwnedRequest> {
        let component = |index: u16| ComponentId::new(index.into());
        Some(match self {
            Self::Hold { component: index, hold } => {
                let hold = [Hold::Tree, Hold::Active, Hold::Latent].get(usize::from(*hold)).copied()?;
                OwnedRequest::Hold { component: component(*index), hold }
            }
            Self::Rate { component: index, hz } => OwnedRequest::Rate { component: component(*index), hz: *hz },
            Self::Params { settings } => OwnedRequest::Params(settings.iter().map(SettingRecord::setting).collect()),
            Self::Modulate { component: owner, index, arguments } => OwnedRequest::Modulate {
                component: component(*owner),
                index: usize::from(*index),
                arguments: arguments.iter().map(|value| params::Value::from(*value)).collect(),
            },
            Self::Unknown { .. } | Self::Ball { .. } => return None,
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
            Self::Hold { component, hold: 0 } => format!("release {}", name(component)),
            Self::Hold { component, hold: 1 } => format!("hold {} active", name(component)),
            Self::Hold { component, .. } => format!("hold {} latent", name(component)),
            Self::Rate { component, hz } => format!("rate of {} {hz} Hz", name(component)),
            Self::Params { settings } => {
                let one = |setting: &SettingRecord| tree.describe_setting(setting);
                format!("set {}", settings.iter().map(one).collect::<Vec<_>>().join(" "))
            }
            Self::Modulate { component, index, arguments } => {
                let called = info(component).and_then(|component| component.modulations.get(usize::from(*index)));
                let called = called.map_or_else(|| format!("modulation {index}"), Clone::clone);
                let arguments: Vec<_> = arguments.iter().map(|value| params::Value::from(*value).to_string()).collect();
                format!("modulate {}.{called}({})", name(component), arguments.join(", "))
            }
            Self::Unknown { text } => text.clone(),
            Self::Ball { x, y } => format!("ball at {x}, {y} m"),
        }
    }
}

fn setting(setting: &Setting) -> Option<SettingRecord> {
    let Setting { component, index, value } = *setting;
    Some(SettingRecord { component: component.index() as u16, index, value: Value::of(value)? })
}

impl SettingRecord {
    fn setting(&self) -> Setting {
        let Self { component, index, value } = *self;
        Setting::new(ComponentId::new(component.into()), index, value.into())
    }
}

impl TreeInfo {
    fn describe_setting(&self, setting: &SettingRecord) -> String {
        let SettingRecord { component, index, value } = setting;
        let owner = self.components.get(usize::from(*component));
        let parameter = owner.and_then(|owner| owner.parameters.get(usize::from(*index)));
        let value = match (value, parameter) {
            (Value::Choice(variant), Some(parameter)) if (*variant as usize) < parameter.variants.len() => {
                parameter.variants[*variant as usize].clone()
            }
            _ => params::Value::from(*value).to_string(),
        };
        match (owner, parameter) {
            (Some(owner), Some(parameter)) => format!("{}.{}={value}", owner.name, parameter.name),
            _ => format!("parameter {index} of component {component}={value}"),
        }
    }
}
