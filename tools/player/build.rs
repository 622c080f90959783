//! Sets the link path of MuJoCo's library for the feature `mujoco`, and enables the tests that need a firmware image.

use std::env;

#[path = "../../sim/body/rpath.rs"]
mod rpath;

/// Path of the firmware image for the tests; `cargo xtask firmware` sets it.
const IMAGE: &str = "BICA_IMAGE";

fn main() {
    println!("cargo::rerun-if-changed=build.rs");
    println!("cargo::rerun-if-changed=../../sim/body/rpath.rs");
    rpath::set();
    println!("cargo::rustc-check-cfg=cfg(firmware_image)");
    println!("cargo::rerun-if-env-changed={IMAGE}");
    if env::var_os(IMAGE).is_some() {
        println!("cargo::rustc-cfg=firmware_image");
    }
}
