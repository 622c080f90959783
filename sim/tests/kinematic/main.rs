//! Tests of the kinematic simulator through its public interface.
#![expect(clippy::float_cmp, reason = "values that must be exact are compared exactly")]

mod determinism;
mod falling;
mod kicking;
mod placing;
mod seeing;
mod sensing;
mod shooting;
mod support;
mod walking;
