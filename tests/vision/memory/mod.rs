//! Perceptual memory: static objects, resting and rolling balls, and predicted visibility.

mod ball;
mod multi_target;
mod noise;
mod single_target;
mod tuning;
mod visibility;
