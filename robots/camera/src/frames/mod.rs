//! Camera images from the robot's side, over a socket of their own.
//!
//! A thread reads them, so that no image delays the answer to a sensor map. Of each camera only the newest images are kept.

mod header;
mod images;
mod mailbox;
mod source;

pub use header::Header;
pub(crate) use images::Socket;
pub use mailbox::Frame;
