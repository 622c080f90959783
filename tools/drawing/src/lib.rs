//! Drawings for tools: activation trees as SVG and in pictures, a map of the field, and camera images with detections.
//!
//! Coordinates of pictures are pixels: x right, y down.

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
mod svg;
pub mod text;
pub mod tree_view;

pub use svg::svg;
