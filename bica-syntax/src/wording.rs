//! Every message of the macros: what was found, what is required, and the remedy.

/// Messages about a text in their parentheses: `name(text) = "message";`.
macro_rules! messages {
    ($($name:ident($($part:ident),*) = $message:literal;)*) => {
        $(pub(crate) fn $name($($part: &str),*) -> String { format!($message) })*
    };
}

mod component;
mod params;
mod shared;
mod tree;

pub(crate) use self::component::*;
pub(crate) use self::params::*;
pub(crate) use self::shared::*;
pub(crate) use self::tree::*;
