//! Loop of the command `referee`.

use std::fs;
use std::io;
use std::net::{Ipv4Addr, SocketAddrV4, UdpSocket};
use std::sync::mpsc::{self, Receiver, TryRecvError};
use std::thread;
use std::time::Duration;

use bica::prelude::*;
use bica::runner::{Runner, World};
use bica_app::{Console, Failure, Outcome, interrupt};
use bica_link::{LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_player::referee::packet::{CONTROL_BYTES, Control, Status, Version};

use super::args::RefereeCommand;
use super::command::Command;
use super::component::{Match, Referee, seconds};
use super::game::Game;
use crate::referee::network::{drain, open};
use crate::referee::play::team_port;

/// Time between two polls of commands and messages.
const BETWEEN: Duration = Duration::from_millis(10);

/// Sends packets according to the commands of the terminal, a script or a monitor, and prints the players that answer.
pub(crate) fn run(args: &RefereeCommand) -> Result<Outcome, Failure> {
    let console = Console::new(false);
    let commands = Commands::open(args)?;
    let mut referee = Box::new(Match::new());
    referee.get_mut::<Referee>().begin(args.teams, game(args));
    let (_server, requests, view) = serve(args, console)?;
    let runner = Runner::new(referee, Network::open(args)?).with_requests(requests).with_observer(view);
    let mut loop_ = Loop { console, runner, commands, wait: 0.0 };
    loop {
        let now = loop_.runner.now();
        if interrupt::requested() {
            return Ok(Outcome::Interrupted);
        }
        if !loop_.step(seconds(now))? || args.seconds.is_some_and(|limit| seconds(now) >= limit) {
            return Ok(Outcome::Success);
        }
        thread::sleep(BETWEEN);
    }
}

type Served = (Option<LinkServer>, Option<LinkRequests>, Option<LinkObserver<Match>>);

/// Opens the link of `--serve`.
fn serve(args: &RefereeCommand, console: Console) -> Result<Served, Failure> {
    let Some(address) = &args.serve else { return Ok((None, None, None)) };
    let options = ServerOptions { anywhere: args.listen_anywhere, ..ServerOptions::default() };
    let (server, requests, view) = LinkServer::start(address, options)?;
    console.print_row("link", &format!("monitors attach at {}", server.address()))?;
    Ok((Some(server), Some(requests), Some(view)))
}

fn game(args: &RefereeCommand) -> Game {
    let mut game = Game::new(args.teams, args.players, Version::of(args.packets).unwrap_or_default(), args.delay);
    game.set_budget(args.budget);
    game
}

/// Sockets of the `GameController`, as the world of its tree.
struct Network {
    start: std::time::Instant,
    socket: UdpSocket,
    to: SocketAddrV4,
    /// Sockets on which the messages of the teams arrive, with the numbers of the teams.
    messages: Vec<(u8, UdpSocket)>,
    /// Why the last packet was not sent.
    failure: Option<Failure>,
}

impl World<Match> for Network {
    fn now(&self) -> Instant {
        Instant::from_micros(self.start.elapsed().as_micros() as u64)
    }

    fn sensors(&mut self) {}

    fn act(&mut self, control: &Option<Control>) {
        self.failure = control.as_ref().and_then(|control| self.send(control).err());
    }
}

impl Network {
    fn open(args: &RefereeCommand) -> Result<Self, Failure> {
        let messages = args.teams.map(|team| Ok((team, open(team_port(args.team_ports, team)?)?)));
        Ok(Self {
            start: std::time::Instant::now(),
            socket: open(args.return_port)?,
            to: SocketAddrV4::new(args.to, args.control_port),
            messages: messages.into_iter().collect::<Result<_, Failure>>()?,
            failure: None,
        })
    }

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

impl Network {
    /// Reads the status messages with their senders, and the team of each team message.
    fn receive(&self) -> (Vec<(Status, Ipv4Addr)>, Vec<u8>) {
        let (mut statuses, mut teams) = (Vec::new(), Vec::new());
        drain(&self.socket, |datagram, from| {
            statuses.extend(Status::parse(datagram).ok().map(|status| (status, from)));
        });
        for (team, socket) in &self.messages {
            drain(socket, |_, _| teams.push(*team));
        }
        (statuses, teams)
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
    runner: Runner<Box<Match>, Network, Option<LinkRequests>, Option<LinkObserver<Match>>>,
    commands: Commands,
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
        let Ok(_) = self.runner.cycle();
        if let Some(failure) = self.runner.world_mut().failure.take() {
            return Err(failure);
        }
        self.tell()?;
        self.receive(now).iter().try_for_each(|line| self.console.print(line))?;
        Ok(true)
    }

    fn execute(&mut self, command: Command, now: f64) -> Result<(), Failure> {
        let referee = self.runner.robot_mut().get_mut::<Referee>();
        match command {
            Command::Wait(seconds) => self.wait = now + seconds,
            Command::Players => {
                let lines = referee.players.lines(now);
                return lines.iter().try_for_each(|line| self.console.print(line));
            }
            command => referee.execute(command),
        }
        self.tell()
    }

    /// Prints what the last command did, whoever gave it.
    fn tell(&mut self) -> Result<(), Failure> {
        let Some(answer) = self.runner.robot_mut().get_mut::<Referee>().take_answer() else { return Ok(()) };
        self.console.print(&answer)
    }

    /// Takes what has arrived: status messages, and messages of the teams, which count against their budgets.
    fn receive(&mut self, now: f64) -> Vec<String> {
        let (statuses, messages) = self.runner.world().receive();
        let referee = self.runner.robot_mut().get_mut::<Referee>();
        for team in messages {
            referee.count_message(team);
        }
        let players = &mut referee.players;
        let mut lines: Vec<String> =
            statuses.into_iter().filter_map(|(status, from)| players.take(status, from, now)).collect();
        lines.extend(players.silent(now));
        lines
    }
}
