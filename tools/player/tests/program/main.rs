//! Tests of the program `player`, started as a process.

mod arguments;
#[cfg(feature = "evaluation")]
mod calibrate;
#[cfg(feature = "evaluation")]
mod calibrate_camera;
mod exit;
mod firmware;
mod games;
mod graph;
mod link;
#[cfg(all(feature = "lola", unix))]
mod lola;
mod mujoco;
mod params;
#[cfg(feature = "evaluation")]
mod pictures;
mod process;
mod recordings;
#[cfg(feature = "referee")]
mod referee;
mod schema;
#[cfg(feature = "evaluation")]
mod see;
#[cfg(feature = "referee")]
mod team_links;
#[cfg(feature = "evaluation")]
mod test_image;
#[cfg(feature = "evaluation")]
mod watch;
