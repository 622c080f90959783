//! Requests about the time of a simulated world.

use bica_wire::message::{FromMonitorExtra, Offers, WorldChange, WorldRequest};

use super::{Answered, Client};
use crate::error::Error;

impl Client {
    /// Pauses, continues or steps a simulated world, as the operator, and waits for the answer.
    ///
    /// # Errors
    /// [`Error::NotOffered`], [`Error::Refused`], [`Error::Timeout`], [`Error::Disconnected`].
    pub fn change_world(&mut self, change: WorldChange) -> Result<Answered, Error> {
        self.require(Offers::PAUSE, "to stop its time")?;
        let number = self.send_world_with(change, self.lease().lease, self.expires_us())?;
        self.answer(number)
    }

    /// Sends a change of the world with the number of a lease and an expiry in the robot's time, µs, also to a robot that does
    /// not offer it; returns its number.
    ///
    /// # Errors
    /// [`Error::Disconnected`].
    pub fn send_world_with(&mut self, change: WorldChange, lease: u64, expires_us: u64) -> Result<u32, Error> {
        self.last_number = self.last_number.wrapping_add(1);
        let number = self.last_number;
        self.send_extra(FromMonitorExtra::World(WorldRequest { number, lease, expires_us, change }))?;
        Ok(number)
    }
}
