//! Requests with names instead of indices.

use core::fmt;
use std::borrow::ToOwned;
use std::format;
use std::string::String;
use std::vec::Vec;

use bica_core::{ComponentId, Hold, Setting, Value};
use bica_runner::{OwnedRequest, Request};
use serde::{Deserialize, Serialize};

use super::{Description, Invalid, Modulation, Param, Plain};

/// A request with the names of components, parameters, modulations, actions and variants: its form in text and JSON.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "type", rename_all = "snake_case", deny_unknown_fields)]
pub enum NamedRequest {
    /// Holds a component active or latent, or releases it.
    Hold {
        /// Component.
        component: String,
        /// Hold; by the tree releases it.
        hold: Hold,
    },
    /// Changes the rate of a component.
    Rate {
        /// Component.
        component: String,
        /// Runs per second; none: the declared rate.
        #[serde(default)]
        hz: Option<f32>,
    },
    /// Sets parameters: all, or none if one is refused.
    Set {
        /// The settings.
        settings: Vec<NamedSetting>,
    },
    /// Calls a modulation.
    Modulate {
        /// Component.
        component: String,
        /// Modulation.
        modulation: String,
        /// One value for each argument.
        arguments: Vec<Plain>,
    },
    /// Performs an action of the simulated world.
    World {
        /// Action.
        action: String,
        /// One value for each argument.
        arguments: Vec<Plain>,
    },
    /// Makes a state machine go to a state.
    Go {
        /// Component.
        component: String,
        /// State.
        state: String,
    },
}

/// A parameter and its new value.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct NamedSetting {
    /// Component.
    pub component: String,
    /// Parameter.
    pub param: String,
    /// Value.
    pub value: Plain,
}

impl Description {
    /// Looks up the names in a request, and checks its values.
    ///
    /// # Errors
    /// If a name is unknown, or a value does not fit.
    pub fn request(&self, request: &NamedRequest) -> Result<OwnedRequest, Invalid> {
        let id = |name: &str| self.component(name).map(ComponentId::new);
        Ok(match request {
            NamedRequest::Hold { component, hold } => OwnedRequest::Hold { component: id(component)?, hold: *hold },
            NamedRequest::Rate { component, hz } => self.rate(component, *hz)?,
            NamedRequest::Set { settings } => {
                let one = |(entry, setting)| self.setting(setting).map_err(|invalid| invalid.at(entry));
                OwnedRequest::Params(settings.iter().enumerate().map(one).collect::<Result<_, _>>()?)
            }
            NamedRequest::Modulate { component, modulation, arguments } => {
                let path = format!("{component}.{modulation}");
                let (component, index) = self.modulation(&path)?;
                let arguments = values_of(&path, &self.components[component].modulations[index], arguments)?;
                let component = ComponentId::new(component);
                OwnedRequest::Modulate { component, modulation: index as u16, arguments }
            }
            NamedRequest::World { action, arguments } => {
                let index = self.action(action)?;
                let arguments = values_of(action, &self.actions[index], arguments)?;
                OwnedRequest::World { action: index as u16, arguments }
            }
            NamedRequest::Go { component, state } => {
                let (component, state) = self.machine_state(&format!("{component}.{state}"))?;
                OwnedRequest::Go { component: ComponentId::new(component), state: state as u16 }
            }
        })
    }

    /// Finds the parameter of a setting, and checks its value.
    ///
    /// # Errors
    /// If a name is unknown, or the value does not fit.
    pub fn setting(&self, NamedSetting { component, param, value }: &NamedSetting) -> Result<Setting, Invalid> {
        let path = format!("{component}.{param}");
        let (component, index) = self.param(&path)?;
        let value = self.components[component].params[index].value_of(value);
        let value = value.map_err(|invalid| invalid.within(&format!("`{path}`")))?;
        Ok(Setting::new(ComponentId::new(component), index as u16, value))
    }

    fn rate(&self, component: &str, hz: Option<f32>) -> Result<OwnedRequest, Invalid> {
        let index = self.component(component)?;
        let most = self.components[index].hz.unwrap_or(self.cycle_hz);
        if let Some(hz) = hz.filter(|hz| !(*hz > 0.0 && *hz <= most)) {
            let help = format!("choose more than 0 and at most {most} Hz, or the declared rate");
            return Err(Invalid::new(format!("the rate {hz} Hz is outside its range"), help));
        }
        Ok(OwnedRequest::Rate { component: ComponentId::new(index), hz })
    }

    /// Returns the calls of all stops. They need no lease.
    pub fn stops(&self) -> impl Iterator<Item = OwnedRequest> {
        self.components.iter().enumerate().flat_map(|(index, component)| {
            let stops = (0..).zip(&component.modulations).filter(|(_, one)| one.stops);
            stops.map(move |(modulation, _)| OwnedRequest::Modulate {
                component: ComponentId::new(index),
                modulation,
                arguments: Vec::new(),
            })
        })
    }

    /// Returns whether a request calls a stop.
    #[must_use]
    pub fn is_stop(&self, request: Request<'_>) -> bool {
        self.stops().any(|stop| stop.borrow() == request)
    }

    /// Returns the effective values in the answer to a request as JSON contains them.
    #[must_use]
    pub fn plain_values(&self, request: Request<'_>, values: &[Value]) -> Vec<Plain> {
        let param = |entry: usize| {
            let Request::Params(settings) = request else { return None };
            let setting = settings.get(entry)?;
            self.components.get(setting.component.index())?.params.get(usize::from(setting.index))
        };
        let one = |(entry, &value): (usize, &Value)| param(entry).map_or_else(|| value.into(), |one| one.plain(value));
        values.iter().enumerate().map(one).collect()
    }

    /// Returns the request with names; an index that the tree does not have is shown as a number.
    #[must_use]
    pub fn named(&self, request: Request<'_>) -> NamedRequest {
        match request {
            Request::Hold { component, hold } => NamedRequest::Hold { component: self.name(component), hold },
            Request::Rate { component, hz } => NamedRequest::Rate { component: self.name(component), hz },
            Request::Params(settings) => {
                NamedRequest::Set { settings: settings.iter().map(|setting| self.named_setting(*setting)).collect() }
            }
            Request::Modulate { component, modulation, arguments } => {
                let owner = self.components.get(component.index());
                let called = owner.and_then(|owner| owner.modulations.get(usize::from(modulation)));
                let (modulation, arguments) = named_call(called, modulation, arguments);
                NamedRequest::Modulate { component: self.name(component), modulation, arguments }
            }
            Request::World { action, arguments } => {
                let (action, arguments) = named_call(self.actions.get(usize::from(action)), action, arguments);
                NamedRequest::World { action, arguments }
            }
            Request::Go { component, state } => {
                let owner = self.components.get(component.index());
                let name = owner.and_then(|owner| owner.states.get(usize::from(state))).map(|state| state.name.clone());
                NamedRequest::Go { component: self.name(component), state: name.unwrap_or_else(|| format!("{state}")) }
            }
        }
    }

    fn named_setting(&self, Setting { component, index, value }: Setting) -> NamedSetting {
        let owner = self.components.get(component.index());
        let param = owner.and_then(|owner| owner.params.get(usize::from(index)));
        NamedSetting {
            component: self.name(component),
            param: param.map_or_else(|| format!("{index}"), |param| param.name.clone()),
            value: param.map_or_else(|| value.into(), |param| param.plain(value)),
        }
    }

    fn name(&self, component: ComponentId) -> String {
        let found = self.components.get(component.index());
        found.map_or_else(|| format!("{component}"), |component| component.name.clone())
    }
}

/// Returns the values of the arguments of a modulation or action, which `path` names.
fn values_of(path: &str, Modulation { arguments, .. }: &Modulation, values: &[Plain]) -> Result<Vec<Value>, Invalid> {
    if arguments.len() != values.len() {
        let names: Vec<_> = arguments.iter().map(|argument| argument.name.as_str()).collect();
        let what = format!("`{path}` takes {} arguments, found {}", arguments.len(), values.len());
        return Err(Invalid::new(what, format!("give these: {}", names.join(", "))));
    }
    let one = |(entry, (argument, value)): (usize, (&Param, &Plain))| {
        argument.value_of(value).map_err(|invalid| invalid.at(entry))
    };
    arguments.iter().zip(values).enumerate().map(one).collect()
}

/// Returns the name of the modulation or action with an index, and the plain forms of its argument values.
fn named_call(called: Option<&Modulation>, index: u16, values: &[Value]) -> (String, Vec<Plain>) {
    let argument = |index: usize| called.and_then(|called| called.arguments.get(index));
    let one = |(index, &value): (usize, &Value)| {
        argument(index).map_or_else(|| value.into(), |argument| argument.plain(value))
    };
    let name = called.map_or_else(|| format!("{index}"), |called| called.name.clone());
    (name, values.iter().enumerate().map(one).collect())
}

impl NamedSetting {
    /// Reads an assignment `Component.name=value`.
    ///
    /// # Errors
    /// If the text is no assignment.
    pub fn parse(text: &str) -> Result<Self, Invalid> {
        let parts = text.split_once('=').and_then(|(path, value)| Some((path.split_once('.')?, value)));
        let Some(((component, param), value)) = parts else {
            let what = format!("`{text}` is not an assignment");
            return Err(Invalid::new(what, "write it as `Component.name=value`, as `Drive.speed=0.9`"));
        };
        let (component, param) = (component.trim().to_owned(), param.trim().to_owned());
        Ok(Self { component, param, value: Plain::Name(value.trim().to_owned()) })
    }
}

impl fmt::Display for NamedSetting {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}.{}={}", self.component, self.param, self.value)
    }
}

/// A line for people: `hold Player latent`, `set FaceBall.gain=0.9`.
impl fmt::Display for NamedRequest {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Hold { component, hold: Hold::Tree } => write!(f, "release {component}"),
            Self::Hold { component, hold: Hold::Active } => write!(f, "hold {component} active"),
            Self::Hold { component, hold: Hold::Latent } => write!(f, "hold {component} latent"),
            Self::Rate { component, hz: Some(hz) } => write!(f, "rate {component} {hz} Hz"),
            Self::Rate { component, hz: None } => write!(f, "rate {component} as declared"),
            Self::Set { settings } => {
                f.write_str("set")?;
                settings.iter().try_for_each(|setting| write!(f, " {setting}"))
            }
            Self::Modulate { component, modulation, arguments } => {
                write!(f, "call {component}.{modulation}")?;
                write_values(f, arguments)
            }
            Self::World { action, arguments } => {
                write!(f, "act {action}")?;
                write_values(f, arguments)
            }
            Self::Go { component, state } => write!(f, "go {component} {state}"),
        }
    }
}

/// `(0.5, true)`
fn write_values(f: &mut fmt::Formatter<'_>, values: &[Plain]) -> fmt::Result {
    let mut before = "(";
    for value in values {
        write!(f, "{before}{value}")?;
        before = ", ";
    }
    f.write_str(if values.is_empty() { "()" } else { ")" })
}
