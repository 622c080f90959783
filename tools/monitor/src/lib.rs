//! Web monitor for the robots of a program.
//!
//! [`protocol`] declares the messages between the page and this server. [`sessions`] connects robots, simulated worlds and
//! recordings; [`web`] serves the page and its sockets. The page is in `page/`. A program adds its worlds and panels with
//! [`Program`](program::Program), and calls [`run`].

pub mod cli;
pub mod files;
mod open;
mod options;
mod pages;
pub mod program;
pub mod protocol;
mod run;
pub mod sessions;
mod source;
mod sources;
mod token;
pub mod web;

pub use run::run;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
