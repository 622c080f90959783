//! Pictures of a game: the camera's image, the field, the tree.

pub(crate) mod camera;
pub(crate) mod canvas;
pub(crate) mod field;
pub(crate) mod palette;
pub(crate) mod png;
mod routes;
pub(crate) mod scene;
mod shapes;
pub(crate) mod sheet;
pub(crate) mod text;
pub(crate) mod tree;
