//! Tests which components of the forward run. A separate program, so that it is built quickly after a change of a component.

#[path = "../forward/game.rs"]
mod game;
mod lazy;
