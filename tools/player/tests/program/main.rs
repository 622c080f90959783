//! The program `player`, run as people and scripts run it.

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
