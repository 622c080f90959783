//! Sockets of a player and of a `GameController`.

use std::collections::VecDeque;
use std::io;
use std::net::{Ipv4Addr, SocketAddr, SocketAddrV4, UdpSocket};

use bica_app::Failure;
use bica_motion::robot::Sensors;
use bica_player::referee::{Answer, Identity, Inbox, Received, TeamCommand, TeamSensors};
use socket2::{Domain, Socket, Type};

use super::team_network::TeamNetwork;

/// Largest number of packets that wait for a cycle; beyond it the oldest packets are dropped.
pub(super) const WAITING: usize = 16;
/// Largest number of datagrams that a cycle reads, so that a flood does not stop the robot.
const DATAGRAMS: usize = 256;
/// Size of the receive buffer, bytes: more than any valid datagram has.
const LONGEST: usize = 2048;

/// Opens a socket on a port of this computer, which other programs may use at the same time.
///
/// # Errors
/// If the port cannot be opened.
pub(super) fn open(port: u16) -> Result<UdpSocket, Failure> {
    let bound = || -> io::Result<UdpSocket> {
        let socket = Socket::new(Domain::IPV4, Type::DGRAM, None)?;
        socket.set_reuse_address(true)?;
        socket.set_broadcast(true)?;
        socket.set_nonblocking(true)?;
        socket.bind(&SocketAddrV4::new(Ipv4Addr::UNSPECIFIED, port).into())?;
        Ok(socket.into())
    };
    bound().map_err(|error| {
        Failure::new(
            format!("cannot receive on UDP port {port}: {error}"),
            "end the program that has it, or choose another port",
        )
    })
}

/// Calls `take` with each datagram that has arrived, at most 256, and the address of its sender.
pub(super) fn drain(socket: &UdpSocket, mut take: impl FnMut(&[u8], Ipv4Addr)) {
    let mut buffer = [0; LONGEST];
    for _ in 0..DATAGRAMS {
        match socket.recv_from(&mut buffer) {
            Ok((length, SocketAddr::V4(from))) => take(&buffer[..length], *from.ip()),
            Err(error) if error.kind() == io::ErrorKind::WouldBlock => return,
            // Other errors are ignored, for example that the receiver of the last message does not listen.
            _ => {}
        }
    }
}

/// Ports and addresses of a player.
#[derive(Clone, Copy, Debug)]
pub(super) struct Ports {
    /// The only accepted sender of control packets; `None` accepts any.
    pub(super) only: Option<Ipv4Addr>,
    /// Port of control packets.
    pub(super) control: u16,
    /// Port of the `GameController` for status messages.
    pub(super) answers: u16,
    /// Port of the messages of the own team.
    pub(super) team: u16,
    /// Address to which messages to the team are sent.
    pub(super) broadcast: Ipv4Addr,
}

/// Network of a player: receives control packets, sends status messages, and exchanges messages with its team.
pub(super) struct PlayerNetwork {
    socket: UdpSocket,
    team: TeamNetwork,
    me: Identity,
    inbox: Inbox,
    /// The only accepted sender; `None` accepts any.
    only: Option<Ipv4Addr>,
    return_port: u16,
    waiting: VecDeque<Received>,
    sent: u64,
}

impl PlayerNetwork {
    /// Opens the sockets of a player.
    ///
    /// # Errors
    /// If a port cannot be opened.
    pub(super) fn open(me: Identity, ports: &Ports) -> Result<Self, Failure> {
        let &Ports { only, answers, .. } = ports;
        let (socket, team, inbox) = (open(ports.control)?, TeamNetwork::open(me, ports)?, Inbox::new(me.team));
        Ok(Self { socket, team, me, inbox, only, return_port: answers, waiting: VecDeque::new(), sent: 0 })
    }

    /// Number of messages to the team that were sent, and of datagrams on its port that were refused.
    pub(super) fn team_counts(&self) -> (u64, u32) {
        (self.team.sent(), self.team.refused())
    }

    /// Number of datagrams that were not control packets for the team.
    pub(super) fn ignored(&self) -> u32 {
        self.inbox.ignored().total()
    }

    /// Number of status messages that were sent.
    pub(super) const fn sent(&self) -> u64 {
        self.sent
    }

    /// Adds what has arrived until `now`, µs, to the sensor values of a body.
    #[expect(clippy::large_types_passed_by_value, reason = "it becomes a part of the returned value")]
    pub(super) fn sensors<'a>(&mut self, now: u64, body: Sensors<'a>) -> TeamSensors<'a> {
        let (packet, heard) = (self.receive(now), self.team.receive(now));
        TeamSensors { body, me: self.me, packet, ignored: self.ignored(), heard, refused: self.team.refused() }
    }

    /// Sends what a command has for the network; what is lost is not sent again.
    pub(super) fn send(&mut self, command: &TeamCommand) {
        if let Some(answer) = &command.answer {
            self.answer(answer);
        }
        if let Some(message) = &command.message {
            self.team.send(message);
        }
    }

    /// Reads all datagrams that have arrived until `now`, µs, and returns the oldest waiting packet.
    fn receive(&mut self, now: u64) -> Option<Received> {
        let Self { socket, inbox, only, waiting, .. } = self;
        drain(socket, |datagram, source| {
            if only.is_some_and(|only| only != source) {
                return;
            }
            if let Some(control) = inbox.take(datagram) {
                waiting.push_back(Received { control, source: source.octets(), at_us: now });
            }
            if waiting.len() > WAITING {
                waiting.pop_front();
            }
        });
        waiting.pop_front()
    }

    fn answer(&mut self, answer: &Answer) {
        let to = SocketAddrV4::new(answer.to.into(), self.return_port);
        if self.socket.send_to(&answer.status.encode(), to).is_ok() {
            self.sent += 1;
        }
    }
}
