//! Pictures of soccer: camera images with detections.

pub mod camera;
mod marks;
pub mod palette;

pub use marks::Marks;
