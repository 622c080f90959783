//! Layered layout of an activation tree (after Sugiyama): layers, crossing reduction, coordinates, and the route of each link.

mod kind;
mod layers;
mod placement;
mod routes;

pub use kind::{Kind, kinds};
pub use layers::{Item, Layers, Segment};
pub use placement::{BOX_HEIGHT, BOX_WIDTH, Placement};
pub use routes::routes;
