//! Lets the program find MuJoCo's library when it runs, if it is built with the feature `mujoco`.

use std::env;

const FOLDER: &str = "MUJOCO_DYNAMIC_LINK_DIR";

fn main() {
    println!("cargo::rerun-if-env-changed={FOLDER}");
    if let (Some(_), Ok(folder)) = (env::var_os("CARGO_FEATURE_MUJOCO"), env::var(FOLDER)) {
        println!("cargo::rustc-link-arg=-Wl,-rpath,{folder}");
    }
}
