//! The container format MCAP (<https://mcap.dev/spec>): a writer, and a reader that checks every length.
//!
//! This is an implementation of its own. The crate `mcap` with its compression (C code) doubles the time of a first build,
//! and a recorder needs to say when a chunk is on the disk and what remains of the file when the disk is full.

mod reader;
mod record;
mod writer;

pub use reader::{Item, Message, Reader};
pub use record::{ChannelRecord, SchemaRecord};
pub use writer::{Compression, Writer};
