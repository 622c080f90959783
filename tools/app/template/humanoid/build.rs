//! Search path of MuJoCo's library at run time, for the feature `mujoco`.

use std::env;

fn main() {
    println!("cargo::rerun-if-env-changed=MUJOCO_DYNAMIC_LINK_DIR");
    if let (Some(_), Ok(folder)) = (
        env::var_os("CARGO_FEATURE_MUJOCO"),
        env::var("MUJOCO_DYNAMIC_LINK_DIR"),
    ) {
        println!("cargo::rustc-link-arg=-Wl,-rpath,{folder}");
    }
}
