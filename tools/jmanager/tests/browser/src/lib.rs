//! A server, a browser, and a page whose controls are found by role and name.

mod driver;
mod element;
mod page;
mod robot;
mod server;

pub use page::Page;
pub use robot::{Robot, player, restrict_to};
pub use server::{Server, processor_seconds, target};
