//! Measured times and their comparison with the declared budgets.

pub mod limits;
pub mod measurements;
pub mod quantiles;
