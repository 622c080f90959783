//! Tests of `GameController` packets, and of robots that a referee commands.

mod half;
mod machine;
mod team;
mod vectors;
