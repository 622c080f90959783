//! A NAO's body: joints, kinematics, head, walk, kicks, odometry, falls.
//!
//! Plain algorithms without a framework, `no_std` and without `alloc`. Metres, radians, seconds, newtons; x forward,
//! y left, z up. The *robot* frame has its origin midway between the hip joints; the *ground* frame lies on the ground
//! between the feet (see [`kinematics::ground_from_robot`]).
//!
//! ```
//! use bica_motion::{joints::Joint, walk::{Feedback, Parameters, Phase, Velocity, Walk}, robot::FootPressure};
//!
//! let on_both_feet = FootPressure { front_left: 26.0, ..FootPressure::default() };
//! let body = Feedback { left_foot: on_both_feet, right_foot: on_both_feet, ..Feedback::default() };
//! let mut walk = Walk::new(&Parameters::BUILT_IN);
//! let stand = walk.step(Velocity::ZERO, &body, 0.01).joints();
//! for _ in 0..100 {
//!     let targets = walk.step(Velocity::new(0.2, 0.0, 0.0), &body, 0.01).joints();
//!     assert!(targets.within_limits());
//! }
//! assert_eq!(walk.phase(), Phase::Walking);
//! assert!(stand[Joint::LKneePitch] > 0.0);
//! ```
#![no_std]

pub mod actuator;
pub mod bounds;
pub mod dimensions;
mod easing;
pub mod fall;
pub mod feet;
pub mod getup;
pub mod head;
pub mod health;
pub mod joints;
pub mod keyframes;
pub mod kick;
pub mod kinematics;
pub mod limbs;
pub mod limits;
pub mod masses;
mod motor_load;
pub mod odometry;
pub mod pose;
pub mod profile;
pub mod robot;
pub mod side;
pub mod speed;
pub mod stand;
pub mod walk;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
