//! Which components of the forward run. A program of its own, so that it is built soon after a change of a component.

#[path = "../forward/game.rs"]
mod game;
mod lazy;
