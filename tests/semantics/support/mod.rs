//! What all rules share.

pub(crate) mod event;
pub(crate) mod model;
pub(crate) mod play;
pub(crate) mod rig;
pub(crate) mod script;
pub(crate) mod unit;
