//! Every message of the macros: what was found, what is required, and the remedy.

pub(crate) use self::component::*;
pub(crate) use self::params::*;
pub(crate) use self::shared::*;
pub(crate) use self::tree::*;

mod component;
mod params;
mod shared;
mod tree;
