//! The forward in the simulation league: a Booster T1 or K1, which gets directions and distances of ball, marks and players instead of
//! images.
//!
//! Its senses are other components. They provide the roles that the behaviours ask for, so behaviours, motion and output are those of
//! every forward.

mod forward;
pub mod input;
pub mod perception;
mod provided;
pub mod senses;

pub use forward::Forward;

/// Field on which it plays.
pub const FIELD: &bica_field::FieldDimensions = &bica_field::SSIM_2026;

/// Values of the parameters of a T1 that differ from the NAO's, as a tune file.
pub const T1_PARAMETERS: &str = include_str!("t1.toml");

/// Those of a K1.
pub const K1_PARAMETERS: &str = include_str!("k1.toml");
