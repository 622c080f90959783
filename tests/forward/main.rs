//! What must hold of the forward as a whole, over games in the built-in world.

mod game;
mod latent;
mod lazy;
mod no_heap;
mod out;
mod replay;
mod search;
mod strained;
