//! Sessions: worlds, robots behind a link, recordings.

mod breakpoints;
mod coming;
mod kept_beside;
mod kept_robot;
mod kept_world;
mod operated;
mod paused;
mod recorded;
mod returned;
mod robot;
pub(crate) mod world;
