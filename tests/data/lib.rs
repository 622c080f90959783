//! Recorded images and exercises for tests, and helpers for tests that run programs.
//!
//! The images are not part of the repository. They are in `../shared/images` beside it, or in `$BICA_SHARED/images`. If
//! they are missing, a test in [`images_test!`] is ignored, and the test harness counts and prints it:
//!
//! ```text
//! test ball_is_found ... ignored, needs recorded images in ../shared/images or $BICA_SHARED/images
//! ```
//!
//! ```ignore
//! bica_test_data::images_test! {
//!     fn ball_is_found() {
//!         let images = bica_test_data::images();
//!         assert!(images.join("labels.csv").is_file());
//!     }
//! }
//! ```
//!
//! The build of the tests decides whether the images exist. After adding them, set `BICA_SHARED` or run `cargo clean -p
//! bica-tests`.

pub mod peer;
pub mod process;
pub mod random;

use std::env;
use std::path::Path;

/// Returns the number of cases of a test whose cases take long: `few`, or `all` in CI, which sets `BICA_TEST_CASES`.
#[must_use]
pub fn cases<T>(few: T, all: T) -> T {
    if env::var_os("BICA_TEST_CASES").is_some() { all } else { few }
}

/// Folder of the recorded images; it may not exist.
#[must_use]
pub fn images() -> &'static Path {
    Path::new(env!("BICA_IMAGES"))
}

/// Folder of the recorded exercises; it may not exist.
#[must_use]
pub fn exercises() -> &'static Path {
    Path::new(env!("BICA_EXERCISES"))
}

/// Test that needs the recorded images. It is ignored, with the reason, if they are missing.
#[cfg(shared_images)]
#[macro_export]
macro_rules! images_test {
    ($($(#[$meta:meta])* fn $name:ident() $body:block)+) => {
        $($(#[$meta])* #[test] fn $name() $body)+
    };
}

/// Test that needs the recorded images. It is ignored, with the reason, if they are missing.
#[cfg(not(shared_images))]
#[macro_export]
macro_rules! images_test {
    ($($(#[$meta:meta])* fn $name:ident() $body:block)+) => {
        $($(#[$meta])* #[test] #[ignore = "needs recorded images in ../shared/images or $BICA_SHARED/images"] fn $name() $body)+
    };
}

/// Test that needs the recorded exercises. It is ignored, with the reason, if they are missing.
#[cfg(shared_exercises)]
#[macro_export]
macro_rules! exercises_test {
    ($($(#[$meta:meta])* fn $name:ident() $body:block)+) => {
        $($(#[$meta])* #[test] fn $name() $body)+
    };
}

/// Test that needs the recorded exercises. It is ignored, with the reason, if they are missing.
#[cfg(not(shared_exercises))]
#[macro_export]
macro_rules! exercises_test {
    ($($(#[$meta:meta])* fn $name:ident() $body:block)+) => {
        $($(#[$meta])* #[test] #[ignore = "needs recorded exercises in ../shared/exercises or $BICA_SHARED/exercises"] fn $name() $body)+
    };
}
