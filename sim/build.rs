//! Locates MuJoCo's library for the feature `mujoco` and sets the run-time search path of tests and examples.

use std::env;
use std::path::Path;

const FOLDER: &str = "MUJOCO_DYNAMIC_LINK_DIR";

fn main() {
    println!("cargo::rerun-if-env-changed={FOLDER}");
    if env::var_os("CARGO_FEATURE_MUJOCO").is_none() {
        return;
    }
    let folder = env::var(FOLDER).unwrap_or_default();
    println!("cargo::rerun-if-changed={folder}");
    if Path::new(&folder).join("libmujoco.so").is_file() {
        println!("cargo::rustc-link-arg=-Wl,-rpath,{folder}");
    } else {
        println!("cargo::error=the feature `mujoco` needs MuJoCo's library, which is not in `{folder}`");
        println!("cargo::error=`cargo xtask mujoco` installs it");
    }
}
