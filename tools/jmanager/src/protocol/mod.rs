//! Messages between the page and the server, over one WebSocket.
//!
//! Text frames are JSON objects with the field `type`; binary frames are [`images`](binary). Times are µs of the robot's time, or of a
//! recording's time, since the start of its clock. A component, information, parameter, modulation, state or transition is its
//! index in the [description](bica_link::Description) of the session.
//!
//! A message from the page has an `id`, chosen by the page; the server answers each with one [`ToPage::Answer`] with the same
//! `id`. Everything else that the server sends is state: a page that missed some of it is right again after the next
//! message of the same kind.

pub mod binary;
mod from_page;
mod to_page;

pub use from_page::{FromPage, HoldKind, Open, Request, Setting, Watch, WatchImages, WatchInfo};
pub use to_page::{
    Bar, Capabilities, ComponentCost, ComponentNow, Condition, Connection, Control, Drawing, DrawnBox, DrawnLink,
    Failed, InfoSample, LogKind, LogLine, Moment, RecordingState, RobotPose, Row, SessionInfo, SessionKind, ToPage,
    Truth,
};

/// Version of the protocol: a page of another version reloads itself.
pub const VERSION: u32 = 1;

/// Identifier of a session: a robot, a simulated world or a recording that the server shows.
pub type SessionId = u32;
