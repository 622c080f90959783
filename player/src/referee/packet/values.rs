//! Values of control packets: versions, states, set plays.

use bica::prelude::*;

use super::{CONTROL_BYTES, Mismatch};

/// Version of a control packet.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Version {
    /// 198 bytes.
    V19,
    /// 158 bytes: players have no warnings, and penalties other numbers.
    #[default]
    V20,
}

impl Version {
    /// Returns the version with a number.
    #[must_use]
    pub const fn of(number: u8) -> Option<Self> {
        match number {
            19 => Some(Self::V19),
            20 => Some(Self::V20),
            _ => None,
        }
    }

    /// Its number.
    #[must_use]
    pub const fn number(self) -> u8 {
        match self {
            Self::V19 => 19,
            Self::V20 => 20,
        }
    }

    /// Length of its packets, bytes.
    #[must_use]
    pub const fn bytes(self) -> usize {
        match self {
            Self::V19 => CONTROL_BYTES,
            Self::V20 => 158,
        }
    }
}

/// Declares an enum whose variants have the numbers 0, 1, 2, … in a packet.
macro_rules! numbered {
    ($(#[$doc:meta])* $name:ident, $field:literal: $first:ident $(#[$first_doc:meta])*, $($(#[$variant_doc:meta])* $variant:ident),+) => {
        $(#[$doc])*
        #[data]
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ParamEnum)]
        pub enum $name {
            $(#[$first_doc])*
            #[default]
            $first,
            $($(#[$variant_doc])* $variant,)+
        }

        impl $name {
            /// All values, in the order of their numbers in a packet.
            pub const ALL: &'static [Self] = &[Self::$first, $(Self::$variant),+];

            pub(super) fn read(number: u8) -> Result<Self, Mismatch> {
                Self::ALL.get(usize::from(number)).copied().ok_or(Mismatch::Value($field, number))
            }
        }
    };
}

numbered!(
    /// Part of a match.
    GamePhase, "game phase":
    Normal /** A half. */,
    /// Penalty shoot-out.
    Shootout,
    /// Extra time.
    ExtraTime,
    /// Time-out.
    TimeOut
);

numbered!(
    /// State of the game as it is shown: a game that plays may still be shown as set, for 10 s at most.
    PlayState, "state":
    Initial /** Before a half. */,
    /// Players walk to their places.
    Ready,
    /// Players stand at their places.
    Set,
    /// The ball is, or may be, in play.
    Playing,
    /// After a half.
    Finished
);

numbered!(
    /// Set play.
    SetPlay, "set play":
    None /** None, or a kick-off. */,
    /// Direct free kick.
    DirectFreeKick,
    /// Indirect free kick.
    IndirectFreeKick,
    /// Penalty kick.
    PenaltyKick,
    /// Throw-in.
    ThrowIn,
    /// Goal kick.
    GoalKick,
    /// Corner kick.
    CornerKick
);
