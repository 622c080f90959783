//! Tables of the measurements, and the claims about them.

pub mod claim;
pub mod figures;
pub mod table;
