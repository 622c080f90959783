//! Datagrams that are no control packets for a team.

use core::fmt;

use super::Version;

/// Reason for which a datagram is ignored.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Mismatch {
    /// The datagram has no room for a header and a version; its length in bytes.
    Short(usize),
    /// It begins with `RGTD`: the true state of the game, which is for monitors only.
    TrueState,
    /// It begins with another header than `RGme`.
    Header([u8; 4]),
    /// A version that is neither 19 nor 20.
    Version(u8),
    /// A length that is not that of its version, in bytes.
    Length(Version, usize),
    /// A field has a value that its version does not define.
    Value(&'static str, u8),
    /// The own team is not one of the two, whose numbers these are.
    ForeignTeams([u8; 2]),
}

impl Mismatch {
    /// Number of kinds.
    pub const KINDS: usize = 7;

    const fn kind(self) -> usize {
        match self {
            Self::Short(_) => 0,
            Self::TrueState => 1,
            Self::Header(_) => 2,
            Self::Version(_) => 3,
            Self::Length(..) => 4,
            Self::Value(..) => 5,
            Self::ForeignTeams(_) => 6,
        }
    }
}

impl fmt::Display for Mismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Short(length) => write!(f, "a datagram of {length} bytes has no header"),
            Self::TrueState => f.write_str("a packet with the true state is for monitors"),
            Self::Header(header) => write!(f, "the header is {}, not RGme", header.escape_ascii()),
            Self::Version(version) => write!(f, "the version is {version}; 19 and 20 are known"),
            Self::Length(version, length) => {
                write!(f, "a packet of version {} has {} bytes, not {length}", version.number(), version.bytes())
            }
            Self::Value(field, value) => write!(f, "the field {field} cannot be {value}"),
            Self::ForeignTeams([first, second]) => write!(f, "the packet is for teams {first} and {second}"),
        }
    }
}

impl core::error::Error for Mismatch {}

/// Numbers of ignored datagrams, by their reason.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ignored([u32; Mismatch::KINDS]);

impl Ignored {
    /// Counts a datagram.
    pub const fn count(&mut self, why: Mismatch) {
        let count = &mut self.0[why.kind()];
        *count = count.saturating_add(1);
    }

    /// Number of datagrams that were ignored for a reason of this kind.
    #[must_use]
    pub const fn of(&self, why: Mismatch) -> u32 {
        self.0[why.kind()]
    }

    /// Number of all ignored datagrams.
    #[must_use]
    pub fn total(&self) -> u32 {
        self.0.iter().fold(0, |sum, count| sum.saturating_add(*count))
    }
}
