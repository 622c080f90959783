//! Loop of the command `referee`.

use std::fs;
use std::io;
use std::net::{Ipv4Addr, SocketAddrV4, UdpSocket};
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;
use std::time::{Duration, Instant};

use bica_app::{Console, Failure, Outcome, interrupt};
use bica_player::referee::packet::{CONTROL_BYTES, Control, Status, Version};

use super::args::RefereeCommand;
use super::command::Command;
use super::game::Game;
use super::players::Players;
use crate::referee::network::{drain, open};

/// Time between two polls of commands and messages.
const BETWEEN: Duration = Duration::from_millis(10);

/// Sends packets according to the commands, and prints the players that answer.
pub(crate) fn run(args: &RefereeCommand) -> Result<Outcome, Failure> {
    let console = Console::new(false);
    let commands = Commands::open(args)?;
    let network = Network { socket: open(args.return_port)?, to: SocketAddrV4::new(args.to, args.control_port) };
    let mut loop_ = Loop { console, game: game(args), players: Players::default(), commands, network, wait: 0.0 };
    let start = Instant::now();
    loop {
        let now = start.elapsed().as_secs_f64();
        if interrupt::requested() {
            return Ok(Outcome::Interrupted);
        }
        if !loop_.step(now)? || args.seconds.is_some_and(|limit| now >= limit) {
            return Ok(Outcome::Success);
        }
        thread::sleep(BETWEEN);
    }
}

fn game(args: &RefereeCommand) -> Game {
    Game::new(args.teams, args.players, Version::of(args.packets).unwrap_or_default(), args.delay)
}

/// Socket of the `GameController`.
struct Network {
    socket: UdpSocket,
    to: SocketAddrV4,
}

impl Network {
    fn send(&self, control: &Control) -> Result<(), Failure> {
        let mut out = [0; CONTROL_BYTES];
        let datagram =
            control.encode(&mut out).map_err(|error| Failure::new(error.to_string(), "choose another penalty"))?;
        self.socket.send_to(datagram, self.to).map(drop).map_err(|error| {
            Failure::new(
                format!("cannot send to {}: {error}", self.to),
                "give another address with --to, or is the network down?",
            )
        })
    }
}

/// Source of the commands: the terminal or a script.
enum Commands {
    Script(std::vec::IntoIter<Command>),
    Terminal(Receiver<String>),
}

impl Commands {
    fn open(args: &RefereeCommand) -> Result<Self, Failure> {
        let Some(path) = &args.script else {
            let (lines, terminal) = mpsc::channel();
            // The thread ends with the program, because a read of the terminal cannot be interrupted.
            thread::spawn(move || io::stdin().lines().map_while(Result::ok).try_for_each(|line| lines.send(line)));
            return Ok(Self::Terminal(terminal));
        };
        let text = fs::read_to_string(path)
            .map_err(|error| Failure::of_path("read", path, &error, "give a file with a command in each line"))?;
        let mut commands = Vec::new();
        for (index, line) in text.lines().enumerate() {
            let wrong = |what| Failure::new(format!("{}:{}: {what}", path.display(), index + 1), "correct this line");
            commands.extend(Command::parse(line).map_err(wrong)?);
        }
        Ok(Self::Script(commands.into_iter()))
    }

    /// Returns the next command; `Ok(None)` if there is none yet, `Err` with a message if the line is invalid.
    fn next(&mut self) -> Result<Option<Command>, String> {
        match self {
            Self::Script(commands) => Ok(Some(commands.next().unwrap_or(Command::Quit))),
            Self::Terminal(lines) => match lines.try_recv() {
                Ok(line) => Command::parse(&line),
                Err(TryRecvError::Empty) => Ok(None),
                Err(TryRecvError::Disconnected) => Ok(Some(Command::Quit)),
            },
        }
    }
}

struct Loop {
    console: Console,
    game: Game,
    players: Players,
    commands: Commands,
    network: Network,
    /// Time at which the next command may be read, s.
    wait: f64,
}

impl Loop {
    /// Runs one step; returns whether the loop continues.
    fn step(&mut self, now: f64) -> Result<bool, Failure> {
        while now >= self.wait {
            match self.commands.next() {
                Ok(None) => break,
                Ok(Some(Command::Quit)) => return Ok(false),
                Ok(Some(command)) => self.execute(command, now)?,
                Err(what) => self.console.print(&what)?,
            }
        }
        if let Some(control) = self.game.advance(now) {
            self.network.send(&control)?;
        }
        let (mut lines, players) = (Vec::new(), &mut self.players);
        drain(&self.network.socket, |datagram, from: Ipv4Addr| {
            if let Ok(status) = Status::parse(datagram) {
                lines.extend(players.take(status, from, now));
            }
        });
        lines.extend(players.silent(now));
        lines.iter().try_for_each(|line| self.console.print(line))?;
        Ok(true)
    }

    fn execute(&mut self, command: Command, now: f64) -> Result<(), Failure> {
        match command {
            Command::Wait(seconds) => {
                self.wait = now + seconds;
                Ok(())
            }
            Command::Players => self.players.lines(now).iter().try_for_each(|line| self.console.print(line)),
            command => match self.game.execute(command) {
                Ok(()) => self.console.print(&self.game.line()),
                Err(what) => self.console.print(&what),
            },
        }
    }
}
