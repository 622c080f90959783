//! The built-in world, seen from outside.
#![expect(clippy::float_cmp, reason = "what must be exact is compared exactly")]

mod determinism;
mod falling;
mod kicking;
mod seeing;
mod sensing;
mod support;
mod walking;
