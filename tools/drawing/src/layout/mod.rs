//! The layout of an activation tree: which component is where, and which way its links take.

pub mod kind;
pub mod layers;
pub mod place;
pub mod routes;
