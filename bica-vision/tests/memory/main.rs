//! Perceptual memory: things that stand, balls that rest and roll, and what should be visible.

mod ball;
mod noise;
mod place;
mod several;
mod sight;
