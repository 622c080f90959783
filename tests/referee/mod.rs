//! Tests of `GameController` packets, and of robots that a referee commands.

mod game;
mod half;
mod machine;
mod scripted;
mod sender;
mod team;
mod vectors;
