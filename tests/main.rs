//! Tests in one program: it is linked once, and long tests run in parallel with all others.

mod forward;
mod motion;
mod referee;
mod semantics;
mod vision;
