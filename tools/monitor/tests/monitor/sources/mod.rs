//! Sources of components: edits, files, checks and builds.

mod compiler;
mod defaults;
mod disk;
mod edits;
mod faults;
mod view;
