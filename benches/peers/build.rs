//! Sets the environment variable that Copper's macros read.

fn main() {
    #[cfg(feature = "copper")]
    cu29_build::setup();
}
