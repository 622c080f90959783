//! Sets the environment variable that Copper's macros read.

fn main() {
    cu29_build::setup();
}
