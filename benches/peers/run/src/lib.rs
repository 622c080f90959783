//! All ways to do all works, ready to be measured.

pub mod cases;
pub mod slow;
pub mod trial;
