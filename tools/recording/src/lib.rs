//! Recordings of a robot's runs as MCAP files.
//!
//! A run is an ordered log: the inputs of the tree (sensor values, requests, instants), its results (commands, active components,
//! states), and data for people (events, log lines, costs). The page `docs/recordings.md` describes the file for other programs.
//!
//! - [`Recorder`] is an observer of a [`Runner`](bica::runner::Runner). It copies the values of each cycle into a bounded
//!   queue; a thread of its own writes them.
//! - [`MonitorRecorder`] writes the data that a monitor has received from a robot behind a link.
//! - [`Recording`] reads a file cycle by cycle, also one that was cut off.
//! - [`replay()`] runs the code again and compares; [`rerun`] records the new course. [`Comparison`] finds the first difference.
//! - [`upgrade()`] converts files of the former format; [`repair`] mends and cuts files; [`RunParts`] joins the parts of a run, [`Robots`]
//!   the topics of several robots.
//! - [`play()`] shows a recording to monitors as if its robot ran.
//! - [`Topics`] are topics for viewers in the same file, with messages of [`ros`].
//!
//! Reading checks every length before it reserves memory, so a damaged file ends in an error.

mod blob;
mod cameras;
mod compare;
mod contents;
mod digest;
mod encode;
mod error;
mod figure;
mod header;
pub mod image_codec;
mod info;
mod join;
mod layout;
pub mod mcap;
mod merge;
mod message;
mod metadata;
mod monitor;
mod names;
mod outputs;
mod part;
mod play;
mod preview;
mod program;
mod recorder;
mod recording;
pub mod repair;
mod replay;
mod request;
pub mod ros;
mod scenery;
pub mod shape;
mod topics;
mod upgrade;
mod writer;

pub use bica_wire::Recordable;
pub use bica_wire::message::LogSource;
pub use blob::{BlobRecord, Coding, StoredBlob};
pub use cameras::Cameras;
pub use compare::{Comparison, Decision, Difference};
pub use digest::{Fnv, RunningFingerprint};
pub use error::Error;
pub use figure::Figure;
pub use header::{Ending, FORMAT, Header, ImagePolicy, MONITOR_FORMAT, MonitorInfo, SetUp, Topics};
pub use info::{ChannelInfo, Info, JobCounts};
pub use join::RunParts;
pub use layout::{content, write_content};
pub use merge::Robots;
pub use message::{Channel, ComponentCosts, Costs, HoldsRecord, LogLine, RunEvent, Tick, TreeRecord};
pub use metadata::checksum;
pub use monitor::MonitorRecorder;
pub use names::NameTable;
pub use outputs::{OutputRecord, OutputsRecord};
pub use part::{RunPart, Split};
pub use play::{PlayOptions, Played, play};
pub use preview::{Jpeg, jpeg};
pub use program::{Program, Start, processor};
pub use recorder::{Backpressure, Recorder, RecorderOptions, Report, Sink, Syncing, create, tree_record};
pub use recording::{BlobPlace, RecordedCycle, Recording, open};
pub use replay::{AfterGap, RepeatedWorld, ReplayOptions, ReplayReport, Subject, compare, replay, rerun};
pub use request::RequestRecord;
pub use scenery::Scenery;
pub use upgrade::upgrade;

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
