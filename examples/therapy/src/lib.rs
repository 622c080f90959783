//! A player of therapy sessions.
//!
//! - [`skeleton`]: the points of a person's body, from several detectors.
//! - [`exercise`]: counts repetitions and judges them against correct ones of the same person.
//! - [`body`]: components that move, sound and shine.
//! - [`input`]: components that keep what the robot receives.
//! - [`session`]: what a session does, step by step.
//! - [`robot`]: the activation tree, its sensors and its command.
//! - `record`: what is kept of a session.
//! - `page`: the panel of the therapist in the monitor.
//! - `room`: a simulated room with a person.
//! - `script`: the session language.
//! - `speech`: speech by `espeak-ng`, and sound.
//! - `judge`: judges recorded exercises.
//! - `cli`: the program.
//!
//! It is no medical device and makes no clinical claim; its stop is no certified safety function.
#![cfg_attr(not(any(feature = "host", test)), no_std)]

pub mod body;
#[cfg(feature = "host")]
pub mod cli;
pub mod exercise;
pub mod input;
#[cfg(feature = "host")]
pub mod judge;
#[cfg(feature = "monitor")]
pub mod page;
#[cfg(feature = "host")]
pub mod record;
pub mod robot;
#[cfg(feature = "host")]
pub mod room;
#[cfg(feature = "host")]
pub mod script;
pub mod session;
pub mod skeleton;
#[cfg(feature = "host")]
pub mod speech;
