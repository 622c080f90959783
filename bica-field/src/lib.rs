//! Dimensions and markings of a robot soccer field.
//!
//! [`FieldDimensions`] contains the lengths of the rules, in millimetres. Its methods return the points and lengths
//! that programs need, in metres. All methods are `const`, so a constant field has no cost at run time.
//!
//! *Field frame*: origin at the centre mark, x towards the attacked goal, y to the left, z up. The field is symmetric to
//! both axes, so a point in the quarter of positive coordinates stands for four.
//!
//! ```
//! use bica_field::{FieldDimensions, GoalColour, SPL_2009};
//! use glam::Vec2;
//!
//! // The corner where side line and goal line meet.
//! assert_eq!(SPL_2009.field_corner(), Vec2::new(3.0, 2.0));
//! // The posts of the attacked goal, the left one first.
//! let [left, right] = SPL_2009.goal_posts(true);
//! assert_eq!(left - right, Vec2::new(0.0, SPL_2009.goal_width()));
//! assert_eq!(GoalColour::Yellow.other(), GoalColour::SkyBlue);
//!
//! // Another field.
//! const PRACTICE: FieldDimensions = FieldDimensions { field_length_mm: 4500, ..SPL_2009 };
//! assert_eq!(PRACTICE.field_corner().x, 2.25);
//! ```

#![no_std]

mod crossing;
mod dimensions;
mod goal;
mod league;
mod lines;

pub use crossing::{Crossing, CrossingKind};
pub use dimensions::{FIELD, FieldDimensions, SPL_2009};
pub use goal::GoalColour;
pub use league::{SSIM_2026, league_mark};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
