//! What Copper's macros want to know.

fn main() {
    cu29_build::setup();
}
