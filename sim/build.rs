//! Search path of MuJoCo's library for the feature `mujoco`.

// A link to that of `body/`: a package contains no file of another one.
mod rpath;

fn main() {
    println!("cargo::rerun-if-changed=rpath.rs");
    rpath::set();
}
