//! The link between a running robot and its monitors.
//!
//! - [`LinkServer`] accepts monitors over TCP or a serial line, or in this process. Two parts of it run in the loop, a
//!   [`Runner`](bica::runner::Runner): [`LinkRequests`] is the source of requests, [`LinkObserver`] the observer. Neither
//!   ever waits for a monitor or a thread.
//! - [`Client`] attaches to a server, describes the tree, watches, requests changes, and connects again after a cut.
//!
//! The messages and packets are those of [`bica_wire`]; the page `docs/link.md` describes the protocol.
//!
//! # Rules
//!
//! - Attaching and watching change nothing. Outputs are read, and costs are measured, only while somebody watches them.
//! - One monitor at a time is the operator: it owns the lease. It loses the lease by giving it back, by another one's
//!   [`Take`](bica_wire::message::LeaseAction::Take), or by 3 s of silence. When a lease ends, the holds and rates that were
//!   requested under it end; parameters stay.
//! - A request is applied only if its connection is still open, its lease is the current one and it has not expired; a stop
//!   needs none of these. Requests that a cut connection left in a queue are dropped.

mod address;
mod client;
mod cost_meter;
mod error;
mod frame;
mod image;
mod job;
mod memory;
mod pending;
mod schema;
mod server;
mod stream;
mod waker;

pub use address::Address;
pub use bica_wire::model::{
    Component, Description, Invalid, Kind, Link, Modulation, NamedRequest, NamedSetting, Output, Param, Placement,
    Plain, State, Transition, Variant, Variants,
};
pub use client::{Answered, Client, ClientOptions, Costs, Event, Shown, Snapshot, Truth, happened};
pub use cost_meter::{ComponentTime, CostMeter};
pub use error::Error;
pub use image::Image;
pub use job::{JOB, JobEvent};
pub use memory::Memory;
pub use pending::Pending;
pub use schema::{decode, decode_exactly, decode_message, decode_output};
pub use server::{LinkObserver, LinkRequests, LinkServer, LinkShow, LinkStats, MAX_MONITORS, ServerOptions};
pub use waker::{Waker, Wakeups, waker};

#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;
