//! Sources at the level of [`bica_monitor::sessions::Manager`], with pages that are programs.

mod compiler;
mod defaults;
mod disk;
mod edits;
mod faults;
mod view;
