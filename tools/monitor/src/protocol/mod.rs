//! Messages between the page and the server, over one WebSocket.
//!
//! Text frames are JSON objects with the field `type`; binary frames are [`images`](binary). Times are µs of the robot's time, or
//! of a recording's time, since the start of its clock. A component, output, parameter, modulation, state or transition is given by
//! its index in the [description](bica_link::Description) of the session.
//!
//! A message from the page has an `id`, chosen by the page; the server answers each with one [`ToPage::Answer`] with the same `id`.
//! Everything else that the server sends is state: a page that missed a message is up to date again after the next one of the same
//! kind.

mod arrange;
pub mod binary;
mod breakpoint;
mod compiler;
mod from_page;
mod limits;
mod open;
mod session;
mod source_file;
mod source_request;
mod state;
mod to_page;
mod watch;
mod world;

pub use arrange::Arrange;
pub use breakpoint::{Breakpoint, Hit, Reached};
pub use compiler::{Build, BuildState, Check, CheckState, CodeLevel, CodeMessage};
pub use from_page::{FromPage, Request};
pub use limits::{LIMITS, Limits};
pub use open::Open;
pub use session::{Capabilities, Connection, Control, RecordingState, SessionInfo, SessionKind};
pub use source_file::{
    ChangedBy, Drawn, FileState, PlacedNote, SourceChange, SourceComponent, SourceFile, SourceState, SourceTable,
    SourceUse, StatePosition,
};
pub use source_request::{MovedState, SourcePlace, SourceRequest};
pub use state::{Bar, ComponentCost, ComponentNow, Condition, Conditions, Costs, Job, Moment, OutputSample, Row};
pub use to_page::{Failed, ToPage};
pub use watch::{Watch, WatchImages, WatchOutput};
pub use world::{World, WorldOption};

/// Version of the protocol. A page of another version reloads itself.
pub const VERSION: u32 = 1;

/// Identifier of a session: a robot, a simulated world or a recording that the server shows.
pub type SessionId = u32;
