//! What was measured, as a table, and what was promised of it.

pub mod claim;
pub mod figures;
pub mod table;
