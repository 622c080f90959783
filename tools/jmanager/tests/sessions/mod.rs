//! Sessions at the level of [`bica_monitor::sessions::Manager`], with pages that are programs.

mod ball;
mod breakpoints;
mod colours;
mod coming;
mod kept_robot;
mod lamp;
pub(crate) mod page;
mod paused;
mod recorded;
mod returned;
mod robot;
pub(crate) mod world;
