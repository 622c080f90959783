//! Sessions at the level of [`jmanager::sessions::Manager`], with pages that are programs.

mod ball;
mod breakpoints;
mod colours;
mod page;
mod recorded;
mod robot;
mod world;
