//! Pictures of a game.

pub(crate) mod field_map;
pub(crate) mod sheet;
pub(crate) mod state;
