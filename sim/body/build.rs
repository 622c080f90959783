//! Locates MuJoCo's library for the feature `mujoco`.

use std::env;
use std::path::Path;

mod rpath;

fn main() {
    rpath::set();
    if env::var_os("CARGO_FEATURE_MUJOCO").is_none() {
        return;
    }
    let folder = env::var(rpath::FOLDER).unwrap_or_default();
    println!("cargo::rerun-if-changed={folder}");
    if !Path::new(&folder).join("libmujoco.so").is_file() {
        println!("cargo::error=the feature `mujoco` needs MuJoCo's library, which is not in `{folder}`");
        println!("cargo::error=`cargo xtask mujoco` installs it");
    }
}
