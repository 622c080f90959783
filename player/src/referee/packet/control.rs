//! Control packets: from the `GameController` to all players.

use bica::prelude::*;
use core::fmt;

use super::bytes::{Reader, Writer};
use super::values::{GamePhase, PlayState, SetPlay, Version};
use super::{Mismatch, Penalty};

/// Largest length of a control packet, bytes.
pub const CONTROL_BYTES: usize = 198;

/// Number of players of a team in a packet.
pub const PLAYERS: usize = 20;

const HEADER: [u8; 4] = *b"RGme";
const TRUE_STATE: [u8; 4] = *b"RGTD";
/// Kicking team of a packet in which no team kicks.
const NO_TEAM: u8 = 255;

/// A player in a packet.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PlayerInfo {
    /// Penalty.
    pub penalty: Penalty,
    /// Time until the penalty may end, s; the operator ends it, so it can be 0 while the penalty stands.
    pub seconds: u8,
    /// Number of warnings; 0 in version 20, which does not have them.
    pub warnings: u8,
    /// Number of cautions.
    pub cautions: u8,
}

/// A team in a packet.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Team {
    /// Number of the team.
    pub number: u8,
    /// Colour of the field players' shirts: 0 blue, 1 red, 2 yellow, 3 black, 4 white, 5 green, 6 orange, 7 purple, 8 brown, 9 grey.
    pub field_colour: u8,
    /// Colour of the goalkeeper's shirt.
    pub keeper_colour: u8,
    /// Number of the goalkeeper, from 1.
    pub goalkeeper: u8,
    /// Number of goals.
    pub score: u8,
    /// Number of the shot in a penalty shoot-out.
    pub penalty_shot: u8,
    /// Results of the shots in a penalty shoot-out, one bit each.
    pub single_shots: u16,
    /// Number of messages that the team may still send.
    pub message_budget: u16,
    /// The players, whose numbers are 1 to 20.
    pub players: [PlayerInfo; PLAYERS],
}

/// A control packet.
#[data]
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Control {
    /// Version of its format.
    pub version: Version,
    /// Number of the packet, which begins anew after 255.
    pub number: u8,
    /// Number of players of a team on the field.
    pub players_per_team: u8,
    /// Size class of the competition: 0 small, 1 middle, 2 large.
    pub competition: u8,
    /// Whether the game is stopped; the state may be playing.
    pub stopped: bool,
    /// Part of the match.
    pub game_phase: GamePhase,
    /// State that is shown.
    pub state: PlayState,
    /// Set play.
    pub set_play: SetPlay,
    /// Whether it is the first half.
    pub first_half: bool,
    /// Number of the team that kicks; `None` if there is none.
    pub kicking_team: Option<u8>,
    /// Remaining time of the half, s; negative in overtime.
    pub seconds_remaining: i16,
    /// Time of the state ready, of a kick-off or of a set play that remains, s; 0 without one.
    pub secondary_seconds: i16,
    /// Both teams. Their order changes during a match.
    pub teams: [Team; 2],
}

/// A penalty that the version of a packet has no number for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct UncodedPenalty(
    /// The penalty.
    pub Penalty,
    /// The version.
    pub Version,
);

impl fmt::Display for UncodedPenalty {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self(penalty, version) = self;
        write!(f, "version {} has no penalty {penalty:?}; choose another penalty or version", version.number())
    }
}

impl core::error::Error for UncodedPenalty {}

impl Control {
    /// Reads a packet.
    ///
    /// # Errors
    /// If the datagram is no control packet of a known version with the length of that version, or a field has no value that is
    /// defined. An undefined penalty is [`Penalty::Other`].
    pub fn parse(datagram: &[u8]) -> Result<Self, Mismatch> {
        let (&header, rest) = datagram.split_first_chunk().ok_or(Mismatch::Short(datagram.len()))?;
        match header {
            HEADER => {}
            TRUE_STATE => return Err(Mismatch::TrueState),
            other => return Err(Mismatch::Header(other)),
        }
        let (&number, rest) = rest.split_first().ok_or(Mismatch::Short(datagram.len()))?;
        let version = Version::of(number).ok_or(Mismatch::Version(number))?;
        if datagram.len() != version.bytes() {
            return Err(Mismatch::Length(version, datagram.len()));
        }
        Self::read(version, &mut Reader(rest))
    }

    fn read(version: Version, bytes: &mut Reader<'_>) -> Result<Self, Mismatch> {
        Ok(Self {
            version,
            number: bytes.byte(),
            players_per_team: bytes.byte(),
            competition: bytes.byte(),
            stopped: flag("stopped", bytes.byte())?,
            game_phase: GamePhase::read(bytes.byte())?,
            state: PlayState::read(bytes.byte())?,
            set_play: SetPlay::read(bytes.byte())?,
            first_half: flag("first half", bytes.byte())?,
            kicking_team: Some(bytes.byte()).filter(|team| *team != NO_TEAM),
            seconds_remaining: i16::from_le_bytes(bytes.take()),
            secondary_seconds: i16::from_le_bytes(bytes.take()),
            teams: [Team::read(version, bytes), Team::read(version, bytes)],
        })
    }

    /// Writes the packet to the start of `out`; returns its bytes.
    ///
    /// # Errors
    /// If a penalty has no number in this version.
    pub fn encode<'a>(&self, out: &'a mut [u8; CONTROL_BYTES]) -> Result<&'a [u8], UncodedPenalty> {
        let mut bytes = Writer::new(out);
        bytes.put(&HEADER);
        bytes.put(&[self.version.number(), self.number, self.players_per_team, self.competition]);
        bytes.put(&[self.stopped.into(), self.game_phase as u8, self.state as u8, self.set_play as u8]);
        bytes.put(&[self.first_half.into(), self.kicking_team.unwrap_or(NO_TEAM)]);
        bytes.put(&self.seconds_remaining.to_le_bytes());
        bytes.put(&self.secondary_seconds.to_le_bytes());
        for team in &self.teams {
            team.write(self.version, &mut bytes)?;
        }
        let written = bytes.written();
        Ok(&out[..written])
    }

    /// Index of the team with a number; `None` if it is not one of the two.
    #[must_use]
    pub fn index(&self, team: u8) -> Option<usize> {
        self.teams.iter().position(|found| found.number == team)
    }
}

impl Team {
    fn read(version: Version, bytes: &mut Reader<'_>) -> Self {
        let [number, field_colour, keeper_colour, goalkeeper, score, penalty_shot] = bytes.take();
        let (single_shots, message_budget) = (u16::from_le_bytes(bytes.take()), u16::from_le_bytes(bytes.take()));
        let mut players = [PlayerInfo::default(); PLAYERS];
        for player in &mut players {
            let [penalty, seconds] = bytes.take();
            let warnings = if version == Version::V19 { bytes.byte() } else { 0 };
            let penalty = Penalty::of(version, penalty);
            *player = PlayerInfo { penalty, seconds, warnings, cautions: bytes.byte() };
        }
        Self {
            number,
            field_colour,
            keeper_colour,
            goalkeeper,
            score,
            penalty_shot,
            single_shots,
            message_budget,
            players,
        }
    }

    fn write(&self, version: Version, bytes: &mut Writer<'_>) -> Result<(), UncodedPenalty> {
        bytes.put(&[
            self.number,
            self.field_colour,
            self.keeper_colour,
            self.goalkeeper,
            self.score,
            self.penalty_shot,
        ]);
        bytes.put(&self.single_shots.to_le_bytes());
        bytes.put(&self.message_budget.to_le_bytes());
        for PlayerInfo { penalty, seconds, warnings, cautions } in self.players {
            bytes.put(&[penalty.number(version).ok_or(UncodedPenalty(penalty, version))?, seconds]);
            if version == Version::V19 {
                bytes.put(&[warnings]);
            }
            bytes.put(&[cautions]);
        }
        Ok(())
    }
}

fn flag(field: &'static str, value: u8) -> Result<bool, Mismatch> {
    match value {
        0 => Ok(false),
        1 => Ok(true),
        other => Err(Mismatch::Value(field, other)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn packet(version: Version, out: &mut [u8; CONTROL_BYTES]) -> &[u8] {
        let teams = [Team { number: 5, ..Team::default() }, Team { number: 23, ..Team::default() }];
        Control { version, teams, ..Control::default() }.encode(out).expect("no penalty")
    }

    #[test]
    fn only_the_length_of_the_version_is_accepted() {
        for version in [Version::V19, Version::V20] {
            let mut long = [0; 2 * CONTROL_BYTES];
            let length = packet(version, long.first_chunk_mut().expect("it is longer")).len();
            assert_eq!(length, version.bytes());
            for length in 0..long.len() {
                let expected = match length {
                    0..=4 => Err(Mismatch::Short(length)),
                    _ if length == version.bytes() => Ok(()),
                    _ => Err(Mismatch::Length(version, length)),
                };
                assert_eq!(Control::parse(&long[..length]).map(drop), expected);
            }
        }
    }

    #[test]
    fn other_headers_and_versions_are_refused() {
        let mut out = [0; CONTROL_BYTES];
        packet(Version::V19, &mut out);
        for index in 0..4 {
            let mut other = out;
            other[index] ^= 1;
            assert!(matches!(Control::parse(&other), Err(Mismatch::Header(_))));
        }
        for number in (0..=u8::MAX).filter(|number| !(19..=20).contains(number)) {
            out[4] = number;
            assert_eq!(Control::parse(&out), Err(Mismatch::Version(number)));
        }
        out[..4].copy_from_slice(&TRUE_STATE);
        assert_eq!(Control::parse(&out), Err(Mismatch::TrueState));
    }

    #[test]
    fn undefined_values_are_refused_with_their_field() {
        let mut out = [0; CONTROL_BYTES];
        packet(Version::V19, &mut out);
        for (index, largest, field) in
            [(8, 1, "stopped"), (9, 3, "game phase"), (10, 4, "state"), (11, 6, "set play"), (12, 1, "first half")]
        {
            for value in 0..=u8::MAX {
                let mut other = out;
                other[index] = value;
                let expected = if value <= largest { Ok(()) } else { Err(Mismatch::Value(field, value)) };
                assert_eq!(Control::parse(&other).map(drop), expected);
            }
        }
    }

    #[test]
    fn penalty_without_number_is_named() {
        let mut control = Control { version: Version::V19, ..Control::default() };
        control.teams[1].players[3].penalty = Penalty::Cautioned;
        let mut out = [0; CONTROL_BYTES];
        assert_eq!(control.encode(&mut out), Err(UncodedPenalty(Penalty::Cautioned, Version::V19)));
        assert!(Control { version: Version::V20, ..control }.encode(&mut out).is_ok());
    }
}
