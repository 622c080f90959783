//! Packets of the `GameController`, by which a referee commands robots.

mod inbox;
pub mod packet;

pub use inbox::Inbox;
