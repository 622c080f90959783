//! Link path of MuJoCo's library for the feature `mujoco`, and whether tests have a firmware image.

use std::env;

/// Folder of MuJoCo's library.
const FOLDER: &str = "MUJOCO_DYNAMIC_LINK_DIR";
/// Firmware image for the tests; `cargo xtask firmware` sets it.
const IMAGE: &str = "BICA_IMAGE";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-env-changed={FOLDER}");
    if let (Some(_), Ok(folder)) = (env::var_os("CARGO_FEATURE_MUJOCO"), env::var(FOLDER)) {
        println!("cargo::rustc-link-arg=-Wl,-rpath,{folder}");
    }
    println!("cargo::rustc-check-cfg=cfg(firmware_image)");
    println!("cargo::rerun-if-env-changed={IMAGE}");
    if env::var_os(IMAGE).is_some() {
        println!("cargo::rustc-cfg=firmware_image");
    }
}
