//! Motion of a humanoid robot: joints, kinematics, head, walk, kicks, get-up, odometry, fall detection, health.
//!
//! Plain algorithms without a framework, `no_std` and without `alloc`. They take the robot as a type parameter, see [`model`]; the
//! default is the NAO. Metres, radians, seconds, newtons; x forward, y left, z up. The *robot* frame has its origin midway between
//! the hip joints; the *ground* frame lies on the ground between the feet (see [`kinematics::ground_from_robot`]).
//!
//! ```
//! use bica_motion::joints::Joint;
//! use bica_motion::model::NAO;
//! use bica_motion::robot::FootPressure;
//! use bica_motion::walk::{Feedback, Phase, Velocity, Walk};
//!
//! let foot = FootPressure { front_left: 26.0, ..FootPressure::default() };
//! let feedback = Feedback { left_foot: foot, right_foot: foot, ..Feedback::default() };
//! let mut walk = Walk::new(NAO, &NAO.kinematic_profile.gait);
//! let stand = walk.step(Velocity::ZERO, &feedback, 0.01).joints(NAO);
//! for _ in 0..100 {
//!     let targets = walk.step(Velocity::new(0.2, 0.0, 0.0), &feedback, 0.01).joints(NAO);
//!     assert!(targets.within_limits(NAO));
//! }
//! assert_eq!(walk.phase(), Phase::Walking);
//! assert!(stand[Joint::LKneePitch] > 0.0);
//! ```
#![no_std]

pub mod bounds;
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
mod limits;
mod message;
pub mod model;
pub mod odometry;
pub mod pose;
pub mod robot;
pub mod segment;
pub mod senses;
pub mod side;
pub mod stiffness;
pub mod velocity;
pub mod walk;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
