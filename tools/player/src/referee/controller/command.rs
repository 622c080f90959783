//! Commands of the referee.

use std::str::{FromStr, SplitWhitespace};

use bica_player::referee::packet::{Penalty, PlayState, SetPlay};

/// Command of the referee.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(in crate::referee) enum Command {
    /// Sets the state; for ready with the team that kicks off.
    State(PlayState, Option<u8>),
    /// Stops the game, or resumes it.
    Stopped(bool),
    /// Gives a penalty to a player: team, number of the player, penalty.
    Penalty(u8, u8, Penalty),
    /// Begins a set play of a team.
    SetPlay(SetPlay, u8),
    /// Counts a goal for a team.
    Goal(u8),
    /// Sets the remaining time of the half, s.
    Clock(i16),
    /// Selects the first or the second half.
    FirstHalf(bool),
    /// Waits for a time, s, before the next command.
    Wait(f64),
    /// Prints the players that answer.
    Players,
    Quit,
}

/// Names of the penalties.
pub(super) const PENALTIES: [(&str, Penalty); 14] = [
    ("none", Penalty::None),
    ("illegal-positioning", Penalty::IllegalPositioning),
    ("motion-in-set", Penalty::MotionInSet),
    ("motion-in-stop", Penalty::MotionInStop),
    ("local-game-stuck", Penalty::LocalGameStuck),
    ("incapable", Penalty::Incapable),
    ("pick-up", Penalty::PickUp),
    ("ball-holding", Penalty::BallHolding),
    ("leaving-field", Penalty::LeavingField),
    ("arms-or-hands", Penalty::ArmsOrHands),
    ("pushing", Penalty::Pushing),
    ("cautioned", Penalty::Cautioned),
    ("sent-off", Penalty::SentOff),
    ("substitute", Penalty::Substitute),
];

/// Name of a penalty in a command.
pub(in crate::referee) fn penalty_name(penalty: Penalty) -> &'static str {
    PENALTIES.iter().find(|(_, known)| *known == penalty).map_or("incapable", |(name, _)| name)
}

/// Names of the set plays.
const SET_PLAYS: [(&str, SetPlay); 7] = [
    ("none", SetPlay::None),
    ("direct-free-kick", SetPlay::DirectFreeKick),
    ("indirect-free-kick", SetPlay::IndirectFreeKick),
    ("penalty-kick", SetPlay::PenaltyKick),
    ("throw-in", SetPlay::ThrowIn),
    ("goal-kick", SetPlay::GoalKick),
    ("corner-kick", SetPlay::CornerKick),
];

impl Command {
    /// Parses a line; `None` if it is empty or a comment, which begins with `#`.
    ///
    /// # Errors
    /// If it is not a command; the text names the expected input.
    pub(super) fn parse(line: &str) -> Result<Option<Self>, String> {
        let mut words = line.split('#').next().unwrap_or_default().split_whitespace();
        let Some(name) = words.next() else { return Ok(None) };
        let command = Self::with(name, &mut words)?;
        match words.next() {
            None => Ok(Some(command)),
            Some(word) => Err(format!("`{word}` does not belong to `{name}`; leave it out")),
        }
    }

    fn with(name: &str, words: &mut SplitWhitespace<'_>) -> Result<Self, String> {
        Ok(match name {
            "initial" => Self::State(PlayState::Initial, None),
            "ready" => Self::State(PlayState::Ready, words.next().map(|word| number(word, "a team")).transpose()?),
            "set" => Self::State(PlayState::Set, None),
            "playing" => Self::State(PlayState::Playing, None),
            "finished" => Self::State(PlayState::Finished, None),
            "stop" => Self::Stopped(true),
            "resume" => Self::Stopped(false),
            "penalty" => {
                let (team, player) = (next(words, "a team")?, next(words, "a player")?);
                if !(1..=20).contains(&player) {
                    return Err(format!("a player cannot have the number {player}; give 1 to 20"));
                }
                Self::Penalty(team, player, named(words, &PENALTIES)?)
            }
            "set-play" => Self::SetPlay(named(words, &SET_PLAYS)?, next(words, "a team")?),
            "goal" => Self::Goal(next(words, "a team")?),
            "clock" => Self::Clock(next(words, "seconds")?),
            "half" => Self::FirstHalf(match words.next() {
                Some("1") => true,
                Some("2") => false,
                _ => return Err("give the half as 1 or 2".to_owned()),
            }),
            "wait" => {
                let seconds: f64 = next(words, "seconds")?;
                if !(0.0..=3600.0).contains(&seconds) {
                    return Err("give a time from 0 to 3600 seconds".to_owned());
                }
                Self::Wait(seconds)
            }
            "players" => Self::Players,
            "quit" => Self::Quit,
            other => return Err(format!("there is no command `{other}`; `player referee --help` lists them")),
        })
    }
}

fn next<T: FromStr>(words: &mut SplitWhitespace<'_>, what: &str) -> Result<T, String> {
    number(words.next().ok_or_else(|| format!("a number is missing: {what}"))?, what)
}

fn number<T: FromStr>(word: &str, what: &str) -> Result<T, String> {
    word.parse().map_err(|_| format!("`{word}` is no number in its range: {what}"))
}

fn named<T: Copy, const N: usize>(words: &mut SplitWhitespace<'_>, names: &[(&str, T); N]) -> Result<T, String> {
    let word = words.next().unwrap_or_default();
    let found = names.iter().find(|(name, _)| *name == word);
    found.map(|(_, value)| *value).ok_or_else(|| {
        let known: Vec<&str> = names.iter().map(|(name, _)| *name).collect();
        format!("`{word}` is none of {}", known.join(", "))
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_commands_or_say_what_is_wrong() {
        for (line, command) in [
            ("ready 5", Command::State(PlayState::Ready, Some(5))),
            ("  set  # now", Command::State(PlayState::Set, None)),
            ("penalty 23 2 pick-up", Command::Penalty(23, 2, Penalty::PickUp)),
            ("set-play corner-kick 5", Command::SetPlay(SetPlay::CornerKick, 5)),
            ("half 2", Command::FirstHalf(false)),
            ("clock -3", Command::Clock(-3)),
            ("wait 2.5", Command::Wait(2.5)),
        ] {
            assert_eq!(Command::parse(line), Ok(Some(command)), "{line}");
        }
        assert_eq!((Command::parse(""), Command::parse("# set")), (Ok(None), Ok(None)));
        for (line, word) in [
            ("begin", "no command `begin`"),
            ("set now", "`now`"),
            ("ready x", "`x`"),
            ("goal", "missing"),
            ("goal 256", "`256`"),
            ("penalty 5 21 none", "21"),
            ("penalty 5 1 foul", "pick-up"),
            ("wait NaN", "0 to 3600"),
            ("half 3", "1 or 2"),
        ] {
            assert!(Command::parse(line).is_err_and(|text| text.contains(word)), "{line}");
        }
    }
}
