//! Drawings for tools: activation trees, the field, camera images with what was recognised in them.

pub mod camera;
pub mod canvas;
pub mod field_map;
pub mod layout;
pub mod palette;
pub mod png;
pub mod polar;
pub mod scene;
mod shapes;
pub mod sheet;
pub mod svg;
pub mod text;
pub mod tree_view;
