//! Why a request from outside is refused.

use core::error::Error;
use core::fmt;

use super::ParamGroup;
use super::kind::Value;
use crate::action::Action;
use crate::graph::{Node, State};
use crate::modulation::Modulation;

/// A request that a tree refused; it changed nothing.
///
/// ```
/// use bica_core::refusal::{Reason, Refusal};
///
/// let refusal = Refusal { entry: 2, component: "FaceBall", name: "gain", reason: Reason::NotFinite };
/// assert_eq!(refusal.to_string(), "`FaceBall.gain`: the value is not finite");
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Refusal {
    /// Index of the setting in its batch, or of the argument of a modulation, that is refused.
    pub entry: usize,
    /// The component, or `world`; empty if the tree has no such component.
    pub component: &'static str,
    /// The parameter, the modulation, the action or its argument; empty if the component has no such one, or if several
    /// parameters are concerned.
    pub name: &'static str,
    /// The reason.
    pub reason: Reason,
}

/// The reason of a [`Refusal`].
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// The tree is not `tunable`.
    NotTunable,
    /// The tree has no such component.
    UnknownComponent {
        /// Its components.
        nodes: &'static [Node],
    },
    /// The component has no such parameter.
    UnknownParameter {
        /// Its parameters.
        params: &'static [ParamGroup],
    },
    /// The component has no such modulation.
    UnknownModulation {
        /// Its modulations.
        modulations: &'static [Modulation],
    },
    /// The component has no such state.
    UnknownState {
        /// Its states.
        states: &'static [State],
    },
    /// The world has no such action.
    UnknownAction {
        /// Its actions.
        actions: &'static [Action],
    },
    /// The modulation or action takes another number of arguments.
    ArgumentCount {
        /// Number of its arguments.
        expected: usize,
        /// Number of values.
        found: usize,
    },
    /// The value is of another kind.
    WrongKind {
        /// Name of the parameter's kind.
        expected: &'static str,
        /// Name of the value's kind.
        found: &'static str,
    },
    /// The number is infinite or NaN.
    NotFinite,
    /// The number is outside the range.
    OutOfRange {
        /// The number.
        value: Value,
        /// Smallest value.
        min: Value,
        /// Largest value.
        max: Value,
    },
    /// The enum has no variant of that index.
    UnknownVariant {
        /// Number of variants.
        count: usize,
    },
    /// The batch sets the parameter twice.
    Twice,
    /// The resulting values break the rule of their struct, which this text states.
    Rule(&'static str),
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.component, self.name) {
            ("", _) => write!(f, "entry {}: {}", self.entry, self.reason),
            (component, "") => write!(f, "`{component}`: {}", self.reason),
            (component, name) => write!(f, "`{component}.{name}`: {}", self.reason),
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match *self {
            Self::NotTunable => f.write_str("the tree is not `tunable`, its parameters are constants"),
            Self::UnknownComponent { nodes } => list(f, "component", &mut nodes.iter().map(|node| node.name)),
            Self::UnknownParameter { params } => {
                list(f, "parameter", &mut params.iter().flat_map(|group| group.params).map(|param| param.name))
            }
            Self::UnknownModulation { modulations } => {
                list(f, "modulation", &mut modulations.iter().map(|modulation| modulation.name))
            }
            Self::UnknownState { states } => list(f, "state", &mut states.iter().map(|state| state.name)),
            Self::UnknownAction { actions } => {
                list(f, "world action", &mut actions.iter().map(|action| action.call.name))
            }
            Self::ArgumentCount { expected, found } => write!(f, "{found} arguments, but it takes {expected}"),
            Self::WrongKind { expected, found } => {
                write!(f, "the value is of kind {found}, but {expected} is required")
            }
            Self::NotFinite => f.write_str("the value is not finite"),
            Self::OutOfRange { value, min, max } => write!(f, "{value} is outside {min}..={max}"),
            Self::UnknownVariant { count } => write!(f, "no such variant, there are {count}"),
            Self::Twice => f.write_str("set twice in one batch"),
            Self::Rule(rule) => f.write_str(rule),
        }
    }
}

/// Writes that there is none of this kind, and which there are.
fn list(f: &mut fmt::Formatter<'_>, kind: &str, names: &mut dyn Iterator<Item = &'static str>) -> fmt::Result {
    write!(f, "no such {kind}")?;
    let mut mark = "; there are: ";
    for name in names {
        write!(f, "{mark}{name}")?;
        mark = ", ";
    }
    Ok(())
}

impl Error for Refusal {}
