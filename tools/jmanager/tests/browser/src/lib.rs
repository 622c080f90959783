//! A server, a browser, and a page whose controls are found by role and name.
//!
//! All of it is for tests: each failure or timeout ends the test with a panic that names the cause.

mod driver;
mod element;
mod folder;
mod input;
mod page;
mod robot;
mod server;

pub use folder::{Folder, repository, target};
pub use page::Page;
pub use robot::{Referee, Robot, player, restrict_to};
pub use server::{Server, processor_seconds};
