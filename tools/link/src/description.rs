//! The description of a tree, received item by item.

use bica_wire::message::{GraphItem, ParamKind, Value};
use serde::Serialize;
use serde_json::json;

use crate::error::Error;

/// Description of a robot's tree.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
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
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Link {
    /// Index of the activated component.
    pub to: usize,
    /// True: modulation; false: requirement.
    pub modulation: bool,
    /// Index of the only state with this link.
    pub state: Option<usize>,
}

/// A state.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Param {
    /// Name of the struct that contains it; empty for an argument.
    #[serde(skip_serializing_if = "String::is_empty")]
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
    #[serde(skip_serializing_if = "Option::is_none")]
    pub value: Option<serde_json::Value>,
}

/// Kind and range of a parameter.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Variant {
    /// Name.
    pub name: String,
    /// Doc comment.
    pub doc: String,
}

/// An information.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
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
}

/// A modulation.
#[derive(Clone, Debug, PartialEq, Serialize)]
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
        let what = format!("`{text}` is no value of `{}`", self.name);
        Err(Error::Unknown { what, help: format!("it is {expected}") })
    }
}

impl Description {
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

    /// Finds an information by `Component.name`: the indices of the component and of the information.
    ///
    /// # Errors
    /// [`Error::Unknown`], with similar names.
    pub fn info(&self, path: &str) -> Result<(usize, usize), Error> {
        self.member(path, "information", |component| component.info.iter().map(|info| info.name.as_str()).collect())
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
            return Err(Error::Unknown { what: format!("`{path}` names no {what}"), help });
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
    let (a, b) = (a.to_lowercase(), b.to_lowercase());
    let mut row: Vec<usize> = (0..=b.chars().count()).collect();
    for (i, left) in a.chars().enumerate() {
        let mut diagonal = i;
        row[0] = i + 1;
        for (j, right) in b.chars().enumerate() {
            let cost = diagonal + usize::from(left != right);
            diagonal = row[j + 1];
            row[j + 1] = cost.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.chars().count()]
}

/// What the next doc comment belongs to.
#[derive(Clone, Copy)]
enum Last {
    Tree,
    Component(usize),
    State(usize),
    Transition(usize),
    Param(usize),
    ParamVariant(usize),
    Info(usize),
    Modulation(usize),
    Argument(usize),
    ArgumentVariant(usize),
    Link,
}

/// Builds a description from items.
pub(crate) struct Builder {
    description: Description,
    last: Last,
    items: u32,
}

impl Builder {
    pub(crate) fn new() -> Self {
        Self { description: Description::default(), last: Last::Tree, items: 0 }
    }

    /// Adds an item; returns the description after the last one.
    pub(crate) fn add(&mut self, item: &GraphItem<'_>) -> Result<Option<Description>, Error> {
        if let GraphItem::End { items } = *item {
            let complete = items == self.items;
            let description = std::mem::take(&mut self.description);
            *self = Self::new();
            return if complete { Ok(Some(description)) } else { Err(Error::Invalid("items are missing")) };
        }
        self.items += 1;
        self.put(item).ok_or(Error::Invalid("an item belongs to none before it"))?;
        Ok(None)
    }

    fn at(&mut self, component: u16) -> Option<&mut Component> {
        self.description.components.get_mut(usize::from(component))
    }

    fn put(&mut self, item: &GraphItem<'_>) -> Option<()> {
        match *item {
            GraphItem::End { .. } => {}
            GraphItem::Doc { text } => self.doc()?.push_str(text),
            GraphItem::Tree { name, cycle_hz, budget_ms, tunable, .. } => {
                let name = name.to_owned();
                self.description = Description { name, cycle_hz, budget_ms, tunable, ..Description::default() };
                (self.last, self.items) = (Last::Tree, 1);
            }
            GraphItem::Component { name, hz, budget_us, root, resume, .. } => {
                let name = name.to_owned();
                self.last = Last::Component(self.description.components.len());
                let component = Component { name, hz, budget_us, root, resume, ..Component::default() };
                self.description.components.push(component);
            }
            GraphItem::Link { from, to, modulation, state } => {
                let link = Link { to: to.into(), modulation, state: state.map(usize::from) };
                self.at(from)?.links.push(link);
                self.last = Last::Link;
            }
            GraphItem::State { component, name, initial, last, .. } => {
                self.at(component)?.states.push(State { name: name.to_owned(), doc: String::new(), initial, last });
                self.last = Last::State(component.into());
            }
            GraphItem::Transition { component, from, to, name, after_ms } => {
                let (name, from, to) = (name.to_owned(), from.into(), to.into());
                self.at(component)?.transitions.push(Transition { name, doc: String::new(), from, to, after_ms });
                self.last = Last::Transition(component.into());
            }
            GraphItem::Param { component, group, name, unit, kind, default, .. } => {
                self.at(component)?.params.push(param(group, name, unit, kind, default));
                self.last = Last::Param(component.into());
            }
            GraphItem::Variant { name } => self.variant(name)?,
            GraphItem::Info { component, name, unit, type_name, .. } => {
                let (name, unit, type_name) = (name.to_owned(), unit.map(str::to_owned), type_name.to_owned());
                self.at(component)?.info.push(Info { name, doc: String::new(), unit, type_name });
                self.last = Last::Info(component.into());
            }
            GraphItem::Modulation { component, name, .. } => {
                let (name, doc) = (name.to_owned(), String::new());
                self.at(component)?.modulations.push(Modulation { name, doc, arguments: Vec::new() });
                self.last = Last::Modulation(component.into());
            }
            GraphItem::Argument { name, unit, kind, default } => {
                let (Last::Modulation(of) | Last::Argument(of) | Last::ArgumentVariant(of)) = self.last else {
                    return None;
                };
                let arguments = &mut self.description.components.get_mut(of)?.modulations.last_mut()?.arguments;
                arguments.push(param("", name, unit, kind, default));
                self.last = Last::Argument(of);
            }
        }
        Some(())
    }

    /// Adds a variant to the last parameter or argument. Its default was an index until its variant is known.
    fn variant(&mut self, name: &str) -> Option<()> {
        let (param, last) = match self.last {
            Last::Param(of) | Last::ParamVariant(of) => {
                (self.description.components.get_mut(of)?.params.last_mut()?, Last::ParamVariant(of))
            }
            Last::Argument(of) | Last::ArgumentVariant(of) => {
                let modulation = self.description.components.get_mut(of)?.modulations.last_mut()?;
                (modulation.arguments.last_mut()?, Last::ArgumentVariant(of))
            }
            _ => return None,
        };
        let Kind::Choice { variants } = &mut param.kind else { return None };
        if param.default.as_u64() == Some(variants.len() as u64) {
            param.default = json!(name);
        }
        variants.push(Variant { name: name.to_owned(), doc: String::new() });
        self.last = last;
        Some(())
    }

    fn doc(&mut self) -> Option<&mut String> {
        let components = &mut self.description.components;
        Some(match self.last {
            Last::Tree => &mut self.description.doc,
            Last::Component(of) => &mut components.get_mut(of)?.doc,
            Last::State(of) => &mut components.get_mut(of)?.states.last_mut()?.doc,
            Last::Transition(of) => &mut components.get_mut(of)?.transitions.last_mut()?.doc,
            Last::Param(of) => &mut components.get_mut(of)?.params.last_mut()?.doc,
            Last::ParamVariant(of) => last_variant(components.get_mut(of)?.params.last_mut()?)?,
            Last::Info(of) => &mut components.get_mut(of)?.info.last_mut()?.doc,
            Last::Modulation(of) => &mut components.get_mut(of)?.modulations.last_mut()?.doc,
            Last::Argument(of) => &mut components.get_mut(of)?.modulations.last_mut()?.arguments.last_mut()?.doc,
            Last::ArgumentVariant(of) => {
                last_variant(components.get_mut(of)?.modulations.last_mut()?.arguments.last_mut()?)?
            }
            Last::Link => return None,
        })
    }
}

fn last_variant(param: &mut Param) -> Option<&mut String> {
    match &mut param.kind {
        Kind::Choice { variants } => Some(&mut variants.last_mut()?.doc),
        _ => None,
    }
}

fn param(group: &str, name: &str, unit: Option<&str>, kind: ParamKind, default: Value) -> Param {
    let kind = match kind {
        ParamKind::F32 { min, max, step } => Kind::F32 { min, max, step },
        ParamKind::I32 { min, max, step } => Kind::I32 { min, max, step },
        ParamKind::U32 { min, max, step } => Kind::U32 { min, max, step },
        ParamKind::Bool => Kind::Bool,
        ParamKind::Choice { .. } => Kind::Choice { variants: Vec::new() },
        ParamKind::Unknown => Kind::Unknown,
    };
    let default = to_json(default, &kind);
    Param {
        group: group.to_owned(),
        name: name.to_owned(),
        doc: String::new(),
        unit: unit.map(str::to_owned),
        kind,
        default,
        value: None,
    }
}
