//! The status message: from a player to the `GameController`.

use bica::prelude::*;
use core::fmt;

use super::PLAYERS;
use super::bytes::{Reader, Writer};

/// Length of a status message, bytes.
pub const STATUS_BYTES: usize = 32;

const HEADER: [u8; 4] = *b"RGrt";
const VERSION: u8 = 4;
/// Age of a ball that was never seen.
const NEVER_SEEN: f32 = -1.0;
/// Millimetres of a metre.
const MILLIMETRES: f32 = 1000.0;
/// Largest coordinate, m: beyond every field, so that all values that are sent are finite.
const FAR: f32 = 100.0;

/// The ball as a player knows it.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BallReport {
    /// Time since it was seen, s; 0 or more.
    pub age: f32,
    /// Position, m: forward and left of the robot.
    pub at: [f32; 2],
}

/// What a player tells the `GameController`, at 0.5 to 2 Hz.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Status {
    /// Number of the player, 1 to 20.
    pub player: u8,
    /// Number of its team.
    pub team: u8,
    /// Whether it lies or falls.
    pub fallen: bool,
    /// Its pose in the field frame, x towards the other team's goal: x and y, m, and heading, rad.
    pub pose: [f32; 3],
    /// The ball; `None` if it was never seen.
    pub ball: Option<BallReport>,
}

/// Reason for which a datagram is no status message: those of the `GameController`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StatusMismatch {
    /// A length other than 32 bytes.
    Length(usize),
    /// A header other than `RGrt`.
    Header([u8; 4]),
    /// A version other than 4.
    Version(u8),
    /// The number of a player beyond 1 to 20.
    Player(u8),
    /// A flag that is neither 0 nor 1.
    Fallen(u8),
    /// A number that is not finite.
    NotFinite,
}

impl fmt::Display for StatusMismatch {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Length(length) => write!(f, "a status message has {STATUS_BYTES} bytes, not {length}"),
            Self::Header(header) => write!(f, "the header is {}, not RGrt", header.escape_ascii()),
            Self::Version(version) => write!(f, "the version is {version}, not {VERSION}"),
            Self::Player(player) => write!(f, "the number of a player is 1 to {PLAYERS}, not {player}"),
            Self::Fallen(flag) => write!(f, "the flag `fallen` is 0 or 1, not {flag}"),
            Self::NotFinite => f.write_str("a number is not finite"),
        }
    }
}

impl core::error::Error for StatusMismatch {}

impl Status {
    /// Encodes the message. A coordinate that is not finite is sent as 0, and one beyond 100 m as 100 m.
    #[must_use]
    pub fn encode(&self) -> [u8; STATUS_BYTES] {
        let mut out = [0; STATUS_BYTES];
        let mut bytes = Writer::new(&mut out);
        bytes.put(&HEADER);
        bytes.put(&[VERSION, self.player, self.team, self.fallen.into()]);
        let [x, y, heading] = self.pose;
        let (age, [forward, left]) =
            self.ball.map_or((NEVER_SEEN, [0.0; 2]), |ball| (finite(ball.age).max(0.0), ball.at));
        for value in [millimetres(x), millimetres(y), finite(heading), age, millimetres(forward), millimetres(left)] {
            bytes.put(&value.to_le_bytes());
        }
        out
    }

    /// Reads a message, as the `GameController` does.
    ///
    /// # Errors
    /// If the `GameController` ignores such a datagram.
    pub fn parse(datagram: &[u8]) -> Result<Self, StatusMismatch> {
        let bytes: &[u8; STATUS_BYTES] = datagram.try_into().map_err(|_| StatusMismatch::Length(datagram.len()))?;
        let mut bytes = Reader(bytes);
        let (header, [version, player, team, fallen]) = (bytes.take(), bytes.take());
        match () {
            () if header != HEADER => return Err(StatusMismatch::Header(header)),
            () if version != VERSION => return Err(StatusMismatch::Version(version)),
            () if !(1..=PLAYERS).contains(&usize::from(player)) => return Err(StatusMismatch::Player(player)),
            () if fallen > 1 => return Err(StatusMismatch::Fallen(fallen)),
            () => {}
        }
        let numbers = [(); 6].map(|()| f32::from_le_bytes(bytes.take()));
        if numbers.iter().any(|number| !number.is_finite()) {
            return Err(StatusMismatch::NotFinite);
        }
        let [x, y, heading, age, forward, left] = numbers;
        let at = [forward / MILLIMETRES, left / MILLIMETRES];
        let ball = (age >= 0.0).then_some(BallReport { age, at });
        Ok(Self { player, team, fallen: fallen == 1, pose: [x / MILLIMETRES, y / MILLIMETRES, heading], ball })
    }
}

fn millimetres(metres: f32) -> f32 {
    finite(metres).clamp(-FAR, FAR) * MILLIMETRES
}

const fn finite(value: f32) -> f32 {
    if value.is_finite() { value } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_are_sent_are_finite() {
        for odd in [f32::NAN, f32::INFINITY, f32::NEG_INFINITY, f32::MAX, f32::MIN] {
            let ball = Some(BallReport { age: odd, at: [odd; 2] });
            let status = Status { player: 1, pose: [odd; 3], ball, ..Status::default() };
            assert!(Status::parse(&status.encode()).is_ok(), "{odd}");
        }
    }

    #[test]
    fn messages_that_would_be_ignored_are_refused() {
        let sent = Status { player: 20, team: 5, ..Status::default() }.encode();
        assert_eq!(Status::parse(&sent).map(|status| (status.player, status.team, status.ball)), Ok((20, 5, None)));
        let changed = |index: usize, value| {
            let mut bytes = sent;
            bytes[index] = value;
            Status::parse(&bytes)
        };
        assert_eq!(changed(0, b'r'), Err(StatusMismatch::Header(*b"rGrt")));
        assert_eq!(changed(4, 3), Err(StatusMismatch::Version(3)));
        assert_eq!(changed(5, 0), Err(StatusMismatch::Player(0)));
        assert_eq!(changed(5, 21), Err(StatusMismatch::Player(21)));
        assert_eq!(changed(7, 2), Err(StatusMismatch::Fallen(2)));
        let mut infinite = sent;
        infinite[8..12].copy_from_slice(&f32::INFINITY.to_le_bytes());
        assert_eq!(Status::parse(&infinite), Err(StatusMismatch::NotFinite));
        for length in (0..64).filter(|length| *length != STATUS_BYTES) {
            assert_eq!(Status::parse(&[0; 64][..length]), Err(StatusMismatch::Length(length)));
        }
    }
}
