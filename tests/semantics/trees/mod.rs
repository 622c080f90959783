//! Test trees.

pub(crate) mod carried;
pub(crate) mod diamond;
pub(crate) mod generic;
pub(crate) mod modulated;
pub(crate) mod results;
pub(crate) mod resume;
pub(crate) mod roles;
pub(crate) mod swap;
pub(crate) mod timers;
pub(crate) mod works;
pub(crate) mod writers;
