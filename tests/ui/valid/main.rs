//! Unusual forms that are valid: they compile and behave like the usual ones.

mod limits;
mod names;
mod numbers;
mod places;
mod signatures;
mod trees;
