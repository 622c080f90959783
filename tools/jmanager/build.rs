//! Search path of MuJoCo's library for the feature `mujoco`.

#[path = "../../sim/rpath.rs"]
mod rpath;

fn main() {
    println!("cargo::rerun-if-changed=../../sim/rpath.rs");
    rpath::set();
}
