//! Measured times and their comparison with the declared budgets.

pub mod measurements;
pub mod quantiles;
pub mod limits;
