//! Datagrams that are no message of the own team.

use core::fmt;

use super::codec::{MESSAGE_BYTES, VERSION};

/// Reason for which a datagram is refused.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// A length other than that of a message, in bytes.
    Length(usize),
    /// It begins with another header than `BICA`.
    Header([u8; 4]),
    /// Another version of the format.
    Version(u8),
    /// The checksum does not belong to the content.
    Checksum,
    /// A message of the team with this number.
    ForeignTeam(u8),
    /// The number of a player beyond 1 to 20.
    Player(u8),
    /// A message with the own number.
    OwnNumber,
    /// A field with a value that is not defined, not finite or out of range.
    Value(&'static str),
    /// A message that is not newer than the last one of its sender.
    Past,
}

impl Refusal {
    /// Number of kinds.
    pub const KINDS: usize = 9;

    const fn kind(self) -> usize {
        match self {
            Self::Length(_) => 0,
            Self::Header(_) => 1,
            Self::Version(_) => 2,
            Self::Checksum => 3,
            Self::ForeignTeam(_) => 4,
            Self::Player(_) => 5,
            Self::OwnNumber => 6,
            Self::Value(_) => 7,
            Self::Past => 8,
        }
    }
}

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "a team message has {MESSAGE_BYTES} bytes, not {length}"),
            Self::Header(header) => write!(f, "the header is {}, not BICA", header.escape_ascii()),
            Self::Version(version) => write!(f, "the version is {version}, not {VERSION}"),
            Self::Checksum => f.write_str("the checksum does not belong to the content"),
            Self::ForeignTeam(team) => write!(f, "the message is for team {team}"),
            Self::Player(player) => write!(f, "the number of a player is 1 to 20, not {player}"),
            Self::OwnNumber => f.write_str("another robot sends with the own number"),
            Self::Value(field) => write!(f, "the field {field} is not defined, not finite or out of range"),
            Self::Past => f.write_str("the sender's last message was newer"),
        }
    }
}

impl core::error::Error for Refusal {}

/// Numbers of refused datagrams, by their reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Refused([u32; Refusal::KINDS]);

impl Refused {
    /// Counts a datagram.
    pub const fn count(&mut self, why: Refusal) {
        let count = &mut self.0[why.kind()];
        *count = count.saturating_add(1);
    }

    /// Number of datagrams that were refused for a reason of this kind.
    #[must_use]
    pub const fn of(&self, why: Refusal) -> u32 {
        self.0[why.kind()]
    }

    /// Number of all refused datagrams.
    #[must_use]
    pub fn total(&self) -> u32 {
        self.0.iter().fold(0, |sum, count| sum.saturating_add(*count))
    }
}
