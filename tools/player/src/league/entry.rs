//! Server, team and number of a player.

use std::path::Path;

use bica_app::Failure;

use super::client::{Address, Error, Server};

/// Largest number of a player.
const MAX_NUMBER: u32 = 99;

/// Server, team and number of a player, and options of its game.
#[derive(Clone, Debug, Default)]
pub(crate) struct Entry {
    /// Port of the players of a running server; `None` starts a server for each game.
    pub(crate) server: Option<Address>,
    /// Name of the team.
    pub(crate) team: String,
    /// Number of the player.
    pub(crate) number: u32,
    /// Whether a server that this program starts runs in real time.
    pub(crate) realtime: bool,
    /// Whether a second team plays, too.
    pub(crate) against: bool,
    /// Seed of the start.
    pub(crate) seed: u64,
}

impl Entry {
    /// Checks values that the server would reject without a reason.
    ///
    /// # Errors
    /// If the name of the team is empty or has spaces or parentheses, or the number is too large.
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

    /// Starts the server of a game, unless a running server is used.
    ///
    /// # Errors
    /// If the server cannot be started.
    pub(crate) fn start(&self) -> Result<Option<Server>, Error> {
        match self.server {
            Some(_) => Ok(None),
            None => Server::start(&Server::installed(Path::new(".")), self.realtime).map(Some),
        }
    }
}

/// Parses `HOST:PORT`, the port of the players. The port of the monitors is not used.
///
/// # Errors
/// If the text has another form.
pub(super) fn server(text: &str) -> Result<Address, String> {
    let (host, port) = text.rsplit_once(':').filter(|(host, _)| !host.is_empty()).ok_or("write it as HOST:PORT")?;
    let agents = port.parse().map_err(|_| format!("`{port}` is no port, which is a number from 1 to 65535"))?;
    Ok(Address { host: host.to_owned(), agents, monitors: 0 })
}

/// Converts an error of a server, with its remedy.
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
