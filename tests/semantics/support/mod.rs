//! Shared parts of the tests of all rules.

pub(crate) mod event;
pub(crate) mod model;
pub(crate) mod play;
pub(crate) mod script;
pub(crate) mod test_tree;
pub(crate) mod unit;
