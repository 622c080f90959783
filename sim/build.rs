//! Search path of MuJoCo's library for the feature `mujoco`.

// A symbolic link to the file in `body/`, because a package must not contain a file of another one.
mod rpath;

fn main() {
    println!("cargo::rerun-if-changed=rpath.rs");
    rpath::set();
}
