//! Sessions at the level of [`jmanager::sessions::Manager`], with pages that are programs.

mod page;
mod world;
