//! The description of a tree, received item by item.

use bica_wire::message::Value;
use serde::{Deserialize, Serialize};
use serde_json::json;

use crate::error::Error;

/// Description of a robot's tree.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Description {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Hash of the tree without doc comments, in hexadecimal digits.
    pub hash: String,
    /// Nominal rate of ticks, Hz.
    pub cycle_hz: f32,
    /// Longest time of one cycle, ms.
    pub budget_ms: Option<f32>,
    /// Whether parameters can be changed at run time.
    pub tunable: bool,
    /// The components.
    pub components: Vec<Component>,
}

/// A component.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct Component {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Declared rate, Hz; none: every cycle.
    pub hz: Option<f32>,
    /// Declared time budget of a run, µs.
    pub budget_us: Option<f32>,
    /// Whether it is the root.
    pub root: bool,
    /// Whether its state machine continues in the state in which it became latent.
    pub resume: bool,
    /// Activation links from this component.
    pub links: Vec<Link>,
    /// States.
    pub states: Vec<State>,
    /// Transitions.
    pub transitions: Vec<Transition>,
    /// Parameters.
    pub params: Vec<Param>,
    /// Information.
    pub info: Vec<Info>,
    /// Modulations.
    pub modulations: Vec<Modulation>,
}

/// An activation link.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Link {
    /// Index of the activated component.
    pub to: usize,
    /// True: modulation; false: requirement.
    pub modulation: bool,
    /// Index of the only state with this link.
    pub state: Option<usize>,
}

/// A state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct State {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Whether it is the initial state.
    pub initial: bool,
    /// Whether no transition leaves it on purpose.
    pub last: bool,
}

/// A transition.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Transition {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Index of the source state.
    pub from: usize,
    /// Index of the target state.
    pub to: usize,
    /// Shortest time in the source state, ms.
    pub after_ms: Option<u32>,
}

/// A parameter, or an argument of a modulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Param {
    /// Name of the struct that contains it; empty for an argument.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub group: String,
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Unit.
    pub unit: Option<String>,
    /// Kind and range.
    #[serde(flatten)]
    pub kind: Kind,
    /// Default value, as [`to_json`].
    pub default: serde_json::Value,
    /// Current value of a parameter.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub value: Option<serde_json::Value>,
}

/// Kind and range of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
#[serde(tag = "kind", rename_all = "lowercase")]
pub enum Kind {
    /// A finite number.
    F32 {
        /// Smallest value.
        min: f32,
        /// Largest value.
        max: f32,
        /// Step that a tool offers.
        step: Option<f32>,
    },
    /// A whole number.
    I32 {
        /// Smallest value.
        min: i32,
        /// Largest value.
        max: i32,
        /// Step that a tool offers.
        step: Option<i32>,
    },
    /// A whole number that is not negative.
    U32 {
        /// Smallest value.
        min: u32,
        /// Largest value.
        max: u32,
        /// Step that a tool offers.
        step: Option<u32>,
    },
    /// On or off.
    Bool,
    /// One variant of an enum.
    Choice {
        /// The variants.
        variants: Vec<Variant>,
    },
    /// A kind that this version of the protocol does not know.
    Unknown,
}

/// A variant of an enum.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Variant {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
}

/// An output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Info {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Unit.
    pub unit: Option<String>,
    /// Type of the value, as in the source text.
    #[serde(rename = "type")]
    pub type_name: String,
    /// Visual type and frames; none for what is not drawn.
    #[serde(flatten, default, skip_serializing_if = "Option::is_none")]
    pub placement: Option<Placement>,
}

/// Visual type and frames of an output.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Placement {
    /// Name of a type of [`bica::visual`].
    pub shape: String,
    /// The frame in which the value is given.
    pub frame: String,
    /// The frame whose place the value is.
    pub child: Option<String>,
}

impl From<bica::visual::Placement<'_>> for Placement {
    fn from(one: bica::visual::Placement<'_>) -> Self {
        Self { shape: one.shape.to_owned(), frame: one.frame.to_owned(), child: one.child.map(str::to_owned) }
    }
}

/// A modulation.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Modulation {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
    /// Arguments.
    pub arguments: Vec<Param>,
}

/// Returns a number in JSON with the digits of `f32`; `null` if it is not finite.
#[must_use]
pub fn number(value: f32) -> serde_json::Value {
    // The shortest decimal text of the f32, not the exact value of its f64.
    value.to_string().parse::<f64>().map_or(serde_json::Value::Null, |value| json!(value))
}

/// Returns a value in JSON; a variant by its name.
#[must_use]
pub fn to_json(value: Value, kind: &Kind) -> serde_json::Value {
    match (value, kind) {
        (Value::F32(value), _) => number(value),
        (Value::I32(value), _) => json!(value),
        (Value::U32(value), _) => json!(value),
        (Value::Bool(value), _) => json!(value),
        (Value::Choice(index), Kind::Choice { variants }) => {
            variants.get(index as usize).map_or_else(|| json!(index), |variant| json!(variant.name))
        }
        (Value::Choice(index), _) => json!(index),
    }
}

impl Param {
    /// Parses a value of this parameter: a number, `true`, `false`, or the name of a variant.
    ///
    /// # Errors
    /// [`Error::Unknown`] if the text is no value of this kind. The range is checked by the robot.
    pub fn parse(&self, text: &str) -> Result<Value, Error> {
        let expected = match &self.kind {
            Kind::F32 { .. } => return text.parse().map(Value::F32).or_else(|_| self.wrong(text, "a number")),
            Kind::I32 { .. } => return text.parse().map(Value::I32).or_else(|_| self.wrong(text, "a whole number")),
            Kind::U32 { .. } => {
                return text.parse().map(Value::U32).or_else(|_| self.wrong(text, "a whole number, not negative"));
            }
            Kind::Bool => return text.parse().map(Value::Bool).or_else(|_| self.wrong(text, "true or false")),
            Kind::Choice { variants } => {
                if let Some(index) = variants.iter().position(|variant| variant.name == text) {
                    return Ok(Value::Choice(index as u32));
                }
                let names: Vec<_> = variants.iter().map(|variant| variant.name.as_str()).collect();
                format!("one of {}", names.join(", "))
            }
            Kind::Unknown => "set by a newer version of this program".to_owned(),
        };
        self.wrong(text, &expected)
    }

    fn wrong(&self, text: &str, expected: &str) -> Result<Value, Error> {
        let what = format!("`{text}` is not a value of `{}`", self.name);
        Err(Error::Unknown { what, help: format!("it is {expected}") })
    }
}

impl Description {
    /// Describes a tree of this program, as a robot with this tree would.
    ///
    /// # Errors
    /// [`Error::Invalid`] if the tree cannot be described.
    pub fn of(graph: &'static bica::Graph) -> Result<Self, Error> {
        let mut builder = crate::builder::Builder::new();
        for item in bica_wire::describe(graph) {
            if let Some(description) = builder.add(&item)? {
                return Ok(Self { hash: format!("{:016x}", bica::graph::hash(graph)), ..description });
            }
        }
        Err(Error::Invalid("the description has no end"))
    }

    /// Finds a component by name.
    ///
    /// # Errors
    /// [`Error::Unknown`], with similar names.
    pub fn component(&self, name: &str) -> Result<usize, Error> {
        find(name, "component", "the tree", self.components.iter().map(|component| component.name.as_str()))
    }

    /// Finds a parameter by `Component.name`: the indices of the component and of the parameter.
    ///
    /// # Errors
    /// [`Error::Unknown`], with similar names.
    pub fn param(&self, path: &str) -> Result<(usize, usize), Error> {
        self.member(path, "parameter", |component| component.params.iter().map(|param| param.name.as_str()).collect())
    }

    /// Finds an output by `Component.name`: the indices of component and output.
    ///
    /// # Errors
    /// [`Error::Unknown`], with similar names.
    pub fn info(&self, path: &str) -> Result<(usize, usize), Error> {
        self.member(path, "output", |component| component.info.iter().map(|info| info.name.as_str()).collect())
    }

    /// Finds a modulation by `Component.name`: the indices of the component and of the modulation.
    ///
    /// # Errors
    /// [`Error::Unknown`], with similar names.
    pub fn modulation(&self, path: &str) -> Result<(usize, usize), Error> {
        self.member(path, "modulation", |component| {
            component.modulations.iter().map(|modulation| modulation.name.as_str()).collect()
        })
    }

    fn member(
        &self,
        path: &str,
        what: &str,
        names: impl for<'a> Fn(&'a Component) -> Vec<&'a str>,
    ) -> Result<(usize, usize), Error> {
        let Some((component, name)) = path.split_once('.') else {
            let help = format!("write Component.{what}, as `player link ADDR describe` prints it");
            return Err(Error::Unknown { what: format!("`{path}` is not a name `Component.{what}`"), help });
        };
        let index = self.component(component)?;
        let names = names(&self.components[index]);
        Ok((index, find(name, what, &format!("`{component}`"), names.into_iter())?))
    }
}

fn find<'a>(name: &str, what: &str, of: &str, names: impl Iterator<Item = &'a str> + Clone) -> Result<usize, Error> {
    if let Some(index) = names.clone().position(|known| known == name) {
        return Ok(index);
    }
    let nearest = names.min_by_key(|known| distance(name, known));
    let help = nearest.map_or_else(|| "it has none".to_owned(), |nearest| format!("the nearest name is `{nearest}`"));
    Err(Error::Unknown { what: format!("{of} has no {what} `{name}`"), help })
}

/// Number of single-character edits between two names, ignoring case.
fn distance(a: &str, b: &str) -> usize {
    strsim::levenshtein(&a.to_lowercase(), &b.to_lowercase())
}
