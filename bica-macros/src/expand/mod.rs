//! From checked models to code.

pub(crate) mod actions;
pub(crate) mod component;
pub(crate) mod params;
pub(crate) mod quoting;
pub(crate) mod tree;
