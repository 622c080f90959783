//! All cases, ready to be measured.

pub mod case;
pub mod cases;
pub mod slow;
