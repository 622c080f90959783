//! Functions of a component: their arguments are links.

use serde::{Deserialize, Serialize};

use super::{Name, Span};

/// A function.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Function {
    /// Its name.
    pub name: Name,
    /// Whole function with docs, attributes, and the comments directly above.
    pub span: Span,
    /// Its doc comment.
    pub docs: Docs,
    /// Text between the parentheses after the name.
    pub inputs: Span,
    /// Arguments beside `self`.
    pub arguments: Vec<Argument>,
    /// `T` of a condition that returns `Option<T>`, as written.
    pub carries: Option<Name>,
    /// Text between the braces; `None` if a brace is missing.
    pub body: Option<Span>,
}

impl Function {
    /// Returns the type of the found value that an entry hook takes from the transition that enters its state.
    #[must_use]
    pub fn takes(&self) -> Option<&str> {
        self.arguments
            .iter()
            .find_map(|argument| if let Input::Found { of } = &argument.input { Some(of.as_str()) } else { None })
    }

    /// Returns the ages and outcomes of others for which it asks: `age of Goal`.
    pub fn asks(&self) -> impl Iterator<Item = String> {
        self.arguments.iter().filter_map(|argument| match &argument.input {
            Input::Age { of } => Some(format!("age of {of}")),
            Input::Outcome { of } => Some(format!("outcome of {of}")),
            _ => None,
        })
    }

    /// Returns the links, in the order of the text.
    pub fn links(&self) -> impl Iterator<Item = (&Argument, LinkKind, &str)> {
        self.arguments.iter().filter_map(|argument| match &argument.input {
            Input::Link { kind, child } => Some((argument, *kind, child.as_str())),
            _ => None,
        })
    }
}

/// A doc comment.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Docs {
    /// Lines without comment marks and common indentation, joined by line breaks.
    pub text: String,
    /// Span from the first to the last line; `None` without a doc comment.
    pub span: Option<Span>,
    /// Whether it consists of `///` lines only.
    pub plain: bool,
}

/// An argument.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Argument {
    /// The pattern before the colon.
    pub name: Name,
    /// Whole argument, without the comma.
    pub span: Span,
    /// Type as written.
    pub written: Name,
    /// Meaning.
    #[serde(flatten)]
    pub input: Input,
}

/// Meaning of an argument.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
#[serde(tag = "input", rename_all = "snake_case")]
pub enum Input {
    /// `&Child`, `&mut Child`, `&mut Rate<Child>`, `&impl Role`
    Link {
        /// Kind of the link.
        kind: LinkKind,
        /// Type of the child, `Eye<320, 240>`, or its role, `impl Ball`.
        child: String,
    },
    /// `&mut Rate<Self>`
    OwnRate,
    /// `&Age<Child>`, `&Age<impl Role>`
    Age {
        /// Type of the component, or its role.
        of: String,
    },
    /// `&Outcome<Child>`
    Outcome {
        /// Type of the child.
        of: String,
    },
    /// `&Time`
    Time,
    /// `&mut Work<Self>`
    Work,
    /// `&Tuned<Parameters>`
    Tuned {
        /// The struct of parameters.
        parameters: String,
    },
    /// `Found<T>` or `Option<Found<T>>`: the found value of the transition that enters the state.
    Found {
        /// Type of the value.
        of: String,
    },
    /// None of these: an argument of a modulation, or a mistake.
    Other,
}

/// Kind of a link.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum LinkKind {
    /// `&Child`: visited before, read.
    Requirement,
    /// `&mut Child`: written, visited after.
    Modulation,
    /// `&mut Rate<Child>`: its rate is written.
    Rate,
}
