//! Pictures of soccer: camera images with detections.

pub mod camera;
mod marks;
pub mod palette;

pub use marks::Marks;

use std::fs;
use std::path::Path;

use bica_app::Failure;

/// Creates a folder for pictures, and its parents.
///
/// # Errors
/// If the folder cannot be created.
pub fn make_folder(folder: &Path) -> Result<(), Failure> {
    let help = "name a folder that can be made, or written to, with --pictures";
    fs::create_dir_all(folder).map_err(|error| Failure::of_path("make the folder", folder, &error, help))
}
