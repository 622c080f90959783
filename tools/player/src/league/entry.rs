//! Where and as whom a robot plays.

use std::path::Path;

use bica_app::Failure;

use super::client::{Address, Error, Server};

/// Largest number of a player.
const MAX_NUMBER: u32 = 99;

/// Where and as whom a robot plays.
#[derive(Clone, Debug, Default)]
pub(crate) struct Entry {
    /// Port of the players of a running server; `None`: each game starts a server of its own.
    pub(crate) server: Option<Address>,
    /// Name of the team.
    pub(crate) team: String,
    /// Number of the player.
    pub(crate) number: u32,
    /// Whether an own server runs in real time.
    pub(crate) realtime: bool,
    /// Whether a second team plays, too.
    pub(crate) against: bool,
    /// Seed of the start.
    pub(crate) seed: u64,
}

impl Entry {
    /// Checks what the server would refuse without a reason.
    ///
    /// # Errors
    /// If the team has no name or one with spaces or parentheses, or the number is too large.
    pub(crate) fn check(&self) -> Result<(), Failure> {
        let wrong = |what: String, help| Err(Failure::new(what, help));
        if self.team.is_empty() || self.team.contains([' ', '(', ')']) {
            let what = format!("`{}` is no name of a team", self.team);
            return wrong(what, "give a --team without spaces and parentheses");
        }
        if self.number > MAX_NUMBER {
            let what = format!("a player cannot have the number {}", self.number);
            return wrong(what, "give a --number from 0 to 99");
        }
        if self.against && self.server.is_some() {
            let what =
                "--against starts a second team in a server of its own, and --server names another one".to_owned();
            return wrong(
                what,
                "leave one of them out; start this program twice to play with both teams in that server",
            );
        }
        Ok(())
    }

    /// Starts the server of a game, if it has its own.
    ///
    /// # Errors
    /// If it cannot be started.
    pub(crate) fn start(&self) -> Result<Option<Server>, Error> {
        match self.server {
            Some(_) => Ok(None),
            None => Server::start(&Server::installed(Path::new(".")), self.realtime).map(Some),
        }
    }
}

/// Parses `HOST:PORT`, the port of the players. Nobody connects to the port of the monitors.
///
/// # Errors
/// If the text has another form.
pub(super) fn server(text: &str) -> Result<Address, String> {
    let (host, port) = text.rsplit_once(':').filter(|(host, _)| !host.is_empty()).ok_or("write it as HOST:PORT")?;
    let agents = port.parse().map_err(|_| format!("`{port}` is no port, which is a number from 1 to 65535"))?;
    Ok(Address { host: host.to_owned(), agents, monitors: 0 })
}

/// Names what to do about an error of a server.
pub(crate) fn failure(error: &Error) -> Failure {
    let help = match error {
        Error::Start(..) => "`cargo xtask league` installs it; start this program in the workspace",
        Error::NotReady(_) => "see its output above; `cargo xtask league` installs it",
        Error::Connection(_) => {
            "the server has ended, or does not run at the address of --server; version 0.2.1 ends when a K1 touches the ball"
        }
        Error::Refused => "choose another --number or --team: a number is taken once, and a game has two teams",
        Error::Message(_) => "see docs/league.md",
    };
    Failure::new(error.to_string(), help)
}
