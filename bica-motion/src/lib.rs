//! A NAO's body: joints, kinematics, head, walk, kicks, odometry, falls.
//!
//! Plain algorithms without a framework, `no_std` and without `alloc`. Metres, radians, seconds, newtons; x forward,
//! y left, z up. The *robot* frame has its origin midway between the hip joints.
#![no_std]

pub mod dimensions;
pub mod fall;
pub mod feet;
pub mod getup;
pub mod head;
pub mod joints;
pub mod keyframes;
pub mod kick;
pub mod kinematics;
pub mod limbs;
pub mod limits;
pub mod masses;
pub mod odometry;
pub mod pose;
pub mod robot;
pub mod side;
pub mod speed;
pub mod stand;
pub mod walk;
