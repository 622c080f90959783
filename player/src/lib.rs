//! The forward.
