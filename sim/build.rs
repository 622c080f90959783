//! Search path of MuJoCo's library for the feature `mujoco`.

#[path = "body/rpath.rs"]
mod rpath;

fn main() {
    println!("cargo::rerun-if-changed=body/rpath.rs");
    rpath::set();
}
