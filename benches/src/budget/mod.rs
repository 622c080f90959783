//! The judgement of the budget report.

pub mod lanes;
pub mod spread;
pub mod verdict;
