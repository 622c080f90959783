//! The program of a robot that is neither a humanoid nor plays soccer: the wall follower.

#[cfg(target_os = "linux")]
mod jobs;
mod link;
mod logs;
#[cfg(all(unix, feature = "monitor"))]
mod monitor;
mod new;
mod page;
mod process;
mod recordings;
mod runs;
#[expect(dead_code, reason = "`main` is called in the example only")]
#[path = "../../../../examples/wall_follower/main.rs"]
mod wall_follower;
