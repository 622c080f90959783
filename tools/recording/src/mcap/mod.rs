//! The container format MCAP (<https://mcap.dev/spec>): a writer, and a reader that checks every length.
//!
//! ARCHITECTURE.md gives the reason why this is not the crate `mcap`.

mod reader;
mod record;
mod writer;

/// Largest record and largest chunk of a file, bytes: a writer refuses what a reader would refuse.
pub(crate) const MAX_RECORD: u64 = 64 << 20;

pub(crate) use reader::find_intact;
pub use reader::{Item, Message, Reader};
pub use record::{ChannelRecord, SchemaRecord};
pub use writer::{Compression, Writer};
