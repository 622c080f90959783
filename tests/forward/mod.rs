//! Properties of the whole forward in games in the kinematic world.

mod blind;
mod by_hand;
mod frames;
mod game;
mod holds;
mod motor_load;
mod no_heap;
mod out;
mod perception_parameters;
mod search;
mod tuned;
