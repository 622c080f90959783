//! Search path of MuJoCo's library for the feature `mujoco`.

#[path = "../../sim/body/rpath.rs"]
mod rpath;

fn main() {
    println!("cargo::rerun-if-changed=../../sim/body/rpath.rs");
    rpath::set();
}
