//! The program `player`, started as a process.

mod arguments;
mod calibrate;
mod exit;
mod firmware;
mod games;
mod graph;
mod link;
mod mujoco;
mod params;
mod pictures;
mod process;
mod recordings;
mod schema;
mod see;
mod test_image;
mod watch;
