//! Camera images from the robot's side, over a socket of their own.
//!
//! A thread reads them, so that no image delays the answer to a sensor map. Of each camera only the newest images are kept.

mod header;
mod mailbox;
mod receiver;

pub use header::Header;
pub use mailbox::Frame;
pub(crate) use mailbox::Mailbox;
pub(crate) use receiver::Receiver;
