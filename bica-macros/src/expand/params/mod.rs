//! The code of a struct of parameters, and of an enum that is a parameter.

mod choice;
pub(crate) mod describe;
mod group;

pub(crate) use choice::{choice, choice_stub};
pub(crate) use group::{params, stub};
