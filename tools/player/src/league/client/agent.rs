//! Connection of a player.

use std::io::ErrorKind;
use std::net::TcpStream;
use std::time::Duration;

use bica_motion::joints::Joints;
use bica_motion::pose::Pose2;
use glam::Vec2;

use super::action;
use super::body::Body;
use super::error::Error;
use super::frame;
use super::perception::Perception;
use super::server::Address;

/// Longest time to wait for a message. The server removes a player that is silent for 5 s; a new player takes it up to a second.
const PATIENCE: Duration = Duration::from_secs(30);

/// A player in the server.
///
/// In each cycle the server waits for one message of each player: after each perception, exactly one action must be sent.
#[derive(Debug)]
pub(crate) struct Agent {
    stream: TcpStream,
    message: String,
    body: &'static Body,
}

impl Agent {
    /// Lets a player join a team. The first team attacks the right goal, the second one the left goal.
    ///
    /// # Errors
    /// If the server cannot be reached, or does not accept team or number.
    pub(crate) fn join(
        body: &'static Body,
        address: &Address,
        team: &str,
        number: u32,
    ) -> Result<(Self, Perception), Error> {
        if team.is_empty() || team.contains([' ', '(', ')']) {
            return Err(Error::Message("a team's name has no spaces and no parentheses"));
        }
        let stream = TcpStream::connect((&*address.host, address.agents))?;
        stream.set_nodelay(true)?;
        stream.set_read_timeout(Some(PATIENCE))?;
        let mut agent = Self { stream, message: String::new(), body };
        frame::write(&mut agent.stream, &format!("(init {} {team} {number})", body.server_name))?;
        let first = agent.sense().map_err(|error| match error {
            Error::Connection(error) if error.kind() == ErrorKind::UnexpectedEof => Error::Refused,
            error => error,
        })?;
        Ok((agent, first))
    }

    /// Waits for the perception of the next cycle.
    ///
    /// # Errors
    /// If the connection is broken, or the message cannot be parsed.
    pub(crate) fn sense(&mut self) -> Result<Perception, Error> {
        frame::read(&mut self.stream, &mut self.message)?;
        Perception::parse(&self.message)
    }

    /// Moves the joints to their targets, rad, with a stiffness from 0 to 1, until the next action.
    ///
    /// # Errors
    /// If the connection is broken.
    pub(crate) fn act(&mut self, targets: &Joints, stiffness: &Joints) -> Result<(), Error> {
        frame::write(&mut self.stream, &action::motors(self.body, targets, stiffness))
    }

    /// Acts like [`act`](Self::act), and requests a pose in the own half, with x towards the attacked goal. The server
    /// grants it before a kick-off and after a goal; all joints are at zero then.
    ///
    /// # Errors
    /// If the connection is broken.
    pub(crate) fn place(&mut self, at: Pose2, targets: &Joints, stiffness: &Joints) -> Result<(), Error> {
        let (Vec2 { x, y }, heading) = (at.position, at.heading.to_degrees());
        let motors = action::motors(self.body, targets, stiffness);
        frame::write(&mut self.stream, &format!("(beam {x:.3} {y:.3} {heading:.3}){motors}"))
    }
}
