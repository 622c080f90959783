//! Search path of MuJoCo's library at run time, for build scripts. Cargo sets it only for the package that requests it.

use std::env;

/// Folder of MuJoCo's library.
pub(crate) const FOLDER: &str = "MUJOCO_DYNAMIC_LINK_DIR";

/// Sets the path for tests, examples and programs of this package if its feature `mujoco` is selected.
pub(crate) fn set() {
    println!("cargo::rerun-if-env-changed={FOLDER}");
    if let (Some(_), Ok(folder)) = (env::var_os("CARGO_FEATURE_MUJOCO"), env::var(FOLDER)) {
        println!("cargo::rustc-link-arg=-Wl,-rpath,{folder}");
    }
}
