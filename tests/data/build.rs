//! Looks for the recorded images and exercises, and sets `cfg(shared_images)` and `cfg(shared_exercises)` if they exist.

use std::env;
use std::path::PathBuf;

fn main() {
    println!("cargo::rustc-check-cfg=cfg(shared_images, shared_exercises)");
    println!("cargo::rerun-if-env-changed=BICA_SHARED");
    println!("cargo::rerun-if-changed=data/build.rs");
    let beside = || PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default()).join("../../shared");
    let shared = env::var_os("BICA_SHARED").map_or_else(beside, PathBuf::from);
    let (images, exercises) = (shared.join("images"), shared.join("exercises/kinect"));
    println!("cargo::rustc-env=BICA_EXERCISES={}", exercises.display());
    if exercises.is_dir() {
        println!("cargo::rustc-cfg=shared_exercises");
    }
    println!("cargo::rustc-env=BICA_IMAGES={}", images.display());
    if images.is_dir() {
        // A missing path is not watched, because Cargo would then rebuild the tests each time.
        println!("cargo::rerun-if-changed={}", images.join("labels.csv").display());
        println!("cargo::rustc-cfg=shared_images");
    }
}
