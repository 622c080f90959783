//! The program `player`, run as people and scripts run it.
#![cfg(feature = "program")]

mod arguments;
mod calibrate;
mod ending;
mod firmware;
mod games;
mod graph;
mod mujoco;
mod pictures;
mod run;
mod scene;
mod schema;
mod see;
mod watch;
