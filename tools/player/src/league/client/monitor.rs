//! Connection of a monitor of the game.

use std::io::{self, Read};
use std::net::TcpStream;
use std::thread;

use bica_motion::pose::Pose2;
use glam::Vec2;

use super::error::Error;
use super::frame;
use super::server::Address;

/// Connection that places ball and players. The messages of the server, which contain the whole scene, are read and dropped.
#[derive(Debug)]
pub(crate) struct Monitor {
    stream: TcpStream,
}

impl Monitor {
    /// Connects to the server.
    ///
    /// # Errors
    /// If the server cannot be reached.
    pub(crate) fn connect(address: &Address) -> Result<Self, Error> {
        let stream = TcpStream::connect((&*address.host, address.monitors))?;
        let reader = stream.try_clone()?;
        // The server stops when its messages fill the buffers of the connection.
        thread::spawn(move || drain(reader));
        Ok(Self { stream })
    }

    /// Puts the ball at a position on the field, m, at rest.
    ///
    /// # Errors
    /// If the connection is broken.
    pub(crate) fn place_ball(&mut self, Vec2 { x, y }: Vec2, radius: f32) -> Result<(), Error> {
        frame::write(&mut self.stream, &format!("(ball (pos {x:.4} {y:.4} {radius:.4})(vel 0 0 0))"))
    }

    /// Puts a player of the left team, which joined first, at a pose on the field, with x towards the goal that it
    /// attacks. Its torso is at the given height, m, and all joints are at zero.
    ///
    /// # Errors
    /// If the connection is broken.
    pub(crate) fn place_player(&mut self, number: u32, at: Pose2, height: f32) -> Result<(), Error> {
        let Vec2 { x, y } = at.position;
        let pose = format!("{x:.4} {y:.4} {height:.4} {:.3}", at.heading.to_degrees());
        frame::write(&mut self.stream, &format!("(agent (unum {number})(team Left)(move {pose}))"))
    }

    /// Gives the left team the kick-off: for 15 s nobody else may touch the ball.
    ///
    /// # Errors
    /// If the connection is broken.
    #[cfg(test)]
    pub(crate) fn kick_off(&mut self) -> Result<(), Error> {
        frame::write(&mut self.stream, "(kickOff Left)")
    }

    /// Continues the game with the ball where it lies. Before a kick-off, a goal counts from then on.
    ///
    /// # Errors
    /// If the connection is broken.
    pub(crate) fn drop_ball(&mut self) -> Result<(), Error> {
        frame::write(&mut self.stream, "(dropBall)")
    }
}

impl Drop for Monitor {
    fn drop(&mut self) {
        // The reader has its own handle, which would keep the connection open without this. An error means that the
        // connection is already broken.
        _ = self.stream.shutdown(std::net::Shutdown::Both);
    }
}

fn drain(mut stream: TcpStream) {
    // The copy ends with the connection.
    _ = io::copy(&mut stream.by_ref(), &mut io::sink());
}
