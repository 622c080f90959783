//! Penalties of players.

use bica::prelude::*;

use super::Version;

/// Reason for which a player must stand still or leave the field. Its number in a packet depends on the version.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Penalty {
    /// The player may play.
    #[default]
    None,
    /// The player was where it must not be, as in the centre circle before the other team's kick-off.
    IllegalPositioning,
    /// It moved while the state was set.
    MotionInSet,
    /// It moved while the game was stopped; only in version 20.
    MotionInStop,
    /// The game was stuck near it.
    LocalGameStuck,
    /// It cannot play.
    Incapable,
    /// Its team asked to take it off the field.
    PickUp,
    /// It held the ball.
    BallHolding,
    /// It left the field.
    LeavingField,
    /// It touched the ball with an arm or a hand.
    ArmsOrHands,
    /// It pushed another robot.
    Pushing,
    /// It got a caution; only in version 20.
    Cautioned,
    /// It was sent off for the rest of the game.
    SentOff,
    /// It is not on the field.
    Substitute,
    /// A number that this version does not define.
    Other(u8),
}

/// Penalties by their number in version 19.
const OF_VERSION_19: &[Penalty] = &[
    Penalty::None,
    Penalty::IllegalPositioning,
    Penalty::MotionInSet,
    Penalty::LocalGameStuck,
    Penalty::Incapable,
    Penalty::PickUp,
    Penalty::BallHolding,
    Penalty::LeavingField,
    Penalty::ArmsOrHands,
    Penalty::Pushing,
    Penalty::SentOff,
    Penalty::Substitute,
];

/// Penalties by their number in version 20.
const OF_VERSION_20: &[Penalty] = &[
    Penalty::None,
    Penalty::IllegalPositioning,
    Penalty::MotionInSet,
    Penalty::MotionInStop,
    Penalty::LocalGameStuck,
    Penalty::Incapable,
    Penalty::PickUp,
    Penalty::BallHolding,
    Penalty::LeavingField,
    Penalty::ArmsOrHands,
    Penalty::Pushing,
    Penalty::Cautioned,
    Penalty::SentOff,
    Penalty::Substitute,
];

impl Penalty {
    /// Returns the penalty with a number.
    #[must_use]
    pub fn of(version: Version, number: u8) -> Self {
        table(version).get(usize::from(number)).copied().unwrap_or(Self::Other(number))
    }

    /// Returns its number; `None` if the version does not have it.
    #[must_use]
    pub fn number(self, version: Version) -> Option<u8> {
        match self {
            Self::Other(number) => Some(number),
            known => table(version).iter().position(|penalty| *penalty == known).map(|index| index as u8),
        }
    }
}

const fn table(version: Version) -> &'static [Penalty] {
    match version {
        Version::V19 => OF_VERSION_19,
        Version::V20 => OF_VERSION_20,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn each_number_is_that_of_its_penalty() {
        for version in [Version::V19, Version::V20] {
            for number in 0..=u8::MAX {
                assert_eq!(Penalty::of(version, number).number(version), Some(number));
            }
        }
        // By the header file of the GameController.
        for (penalty, numbers) in [
            (Penalty::MotionInSet, [Some(2), Some(2)]),
            (Penalty::MotionInStop, [None, Some(3)]),
            (Penalty::LocalGameStuck, [Some(3), Some(4)]),
            (Penalty::PickUp, [Some(5), Some(6)]),
            (Penalty::BallHolding, [Some(6), Some(7)]),
            (Penalty::LeavingField, [Some(7), Some(8)]),
            (Penalty::Pushing, [Some(9), Some(10)]),
            (Penalty::Cautioned, [None, Some(11)]),
            (Penalty::Substitute, [Some(11), Some(13)]),
        ] {
            assert_eq!([Version::V19, Version::V20].map(|version| penalty.number(version)), numbers, "{penalty:?}");
        }
    }
}
