//! All tests in one program, so that it is linked once and long tests run in parallel with the others.

mod forward;
mod motion;
mod referee;
mod semantics;
mod vision;
