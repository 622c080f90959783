//! Perceptual memory: things that stand, balls that rest and roll, and what should be visible.

mod ball;
mod multi_target;
mod noise;
mod single_target;
mod visibility;
