//! Unusual forms that are valid. Each file compiles and does what it says.

mod names;
mod numbers;
mod places;
mod signatures;
mod trees;
