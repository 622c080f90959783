//! Tests of JManager in one program, which is linked once.

mod attacks;
mod sessions;
mod sources;
