//! One file for each rule.

mod active;
mod description;
mod hold;
mod machine;
mod modulation;
mod once;
mod order;
mod rate;
mod restart;
mod robust;
