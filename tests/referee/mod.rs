//! Packets of the `GameController`, and robots that a referee commands.

mod half;
mod machine;
mod vectors;
