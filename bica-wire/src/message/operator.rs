//! Requests of an operator.

pub use bica_core::modulation::MAX_ARGUMENTS;
use bica_core::params::{Setting, Value};
use heapless::Vec;
use postcard_schema::Schema;
use serde::{Deserialize, Serialize};

/// Largest number of settings in one batch.
pub const MAX_BATCH: usize = 32;

/// An action on the lease, which makes one monitor the operator. Only its owner may send requests.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum LeaseAction {
    /// Takes the lease if nobody owns it.
    Acquire,
    /// Takes the lease, also from its owner. Programs send this only when a person asks for it.
    Take,
    /// Keeps the lease with this number, which ends the operator's silence. On a new connection it continues the lease,
    /// if the owner's connection has ended.
    Keep {
        /// Number of the lease, which only its owner knows.
        lease: u64,
    },
    /// Gives the lease with this number back. What its owner requested ends, except parameters.
    Return {
        /// Number of the lease.
        lease: u64,
    },
}

/// The lease, sent to every monitor when it attaches and whenever the lease changes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub struct LeaseState {
    /// Number of the lease, for its owner; 0 for others.
    pub lease: u64,
    /// Whether somebody owns it.
    pub owned: bool,
    /// Whether the receiver of this message owns it.
    pub yours: bool,
    /// The robot's time, µs; the expiry of requests is counted from it.
    pub time_us: u64,
}

/// A request of the operator.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Request {
    /// Number that the answer repeats.
    pub number: u32,
    /// Number of the operator's lease.
    pub lease: u64,
    /// Robot's time after which the request is refused, µs; `u64::MAX`: never.
    pub expires_us: u64,
    /// What is requested.
    pub change: Change,
}

/// A change between two cycles. It is stored in the message, because there is no heap.
pub type Change = bica_runner::Change<Vec<Setting, MAX_BATCH>, Vec<Value, MAX_ARGUMENTS>>;

/// The answer to a [`Request`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub struct Answer<'a> {
    /// Number of the request.
    pub number: u32,
    /// Number of the first cycle that ran with the change, or of the next cycle if it was refused.
    pub cycle: u64,
    /// Number of the cycle that was next when the request arrived.
    pub arrived: u64,
    /// The result.
    #[serde(borrow)]
    pub result: AnswerResult<'a>,
}

/// The result of a [`Request`].
#[expect(clippy::large_enum_variant, reason = "there is no heap to box the values in")]
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, Schema)]
pub enum AnswerResult<'a> {
    /// The change is in force.
    Done {
        /// Effective values, read back from the tree: of the parameters in the order of the batch, or the rate in Hz.
        values: Vec<Value, MAX_BATCH>,
    },
    /// Nothing changed.
    Refused {
        /// The reason, for programs.
        code: RefusalCode,
        /// Index of the setting or argument that is refused.
        entry: u16,
        /// The reason, for people; at most [`MAX_TEXT_BYTES`](super::MAX_TEXT_BYTES). Empty if the code says all.
        text: &'a str,
    },
}

/// Reason for which a request is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, Schema)]
pub enum RefusalCode {
    /// The request has the number of a lease that its sender does not own.
    NoLease,
    /// The request came after its expiry.
    Expired,
    /// The tree refused the change.
    Tree,
    /// The robot's program accepts no requests.
    Unsupported,
    /// There is no simulated world, or it refused the change.
    World,
}

impl RefusalCode {
    /// Returns the cause and, if there is one, the remedy.
    #[must_use]
    pub const fn text(self) -> &'static str {
        match self {
            Self::NoLease => "the sender does not own the lease, or sent the number of an older one: acquire it first",
            Self::Expired => "the request came after its expiry: send it again",
            Self::Tree => "the tree refused the change",
            Self::Unsupported => "the robot's program accepts no requests, monitors may only watch",
            Self::World => "the robot is not in a simulated world",
        }
    }
}
