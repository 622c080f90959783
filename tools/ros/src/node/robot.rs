//! The robot behind its link.

use std::time::{Duration, Instant};

use bica_link::{Client, Error};
use bica_wire::model::NamedRequest;
use ros2_client::Gid;

use super::operator::Operator;
use super::parameters::result;
use super::pending::Pending;

/// Shortest time between two lines of the log about refusals.
const REPORT_AFTER: Duration = Duration::from_secs(1);

/// The robot, and those who may command it.
pub(super) struct Robot {
    pub(super) link: Client,
    /// Whether its time is that of a simulation.
    pub(super) simulated: bool,
    pub(super) operator: Operator,
    pub(super) pending: Pending,
    /// A refusal that the log does not have yet, and when the last one was noted.
    pub(super) warning: Option<String>,
    pub(super) reported: Option<Instant>,
}

impl Robot {
    /// Sends a request for a client that waits for the answer, or notes why it is refused.
    pub(super) fn request(
        &mut self,
        id: Gid,
        request: Result<NamedRequest, String>,
        place: (u64, usize),
    ) -> Result<(), Error> {
        let sent = match request {
            Ok(request) => self.send(id, &request)?,
            Err(reason) => Err(reason),
        };
        match sent {
            Ok(number) => self.pending.requested(number, place),
            Err(reason) => self.pending.put(place, result(Err(reason))),
        }
        Ok(())
    }

    /// Sends a request for a client that has the lease; returns its number, or why it is refused.
    pub(super) fn send(&mut self, id: Gid, request: &NamedRequest) -> Result<Result<u32, String>, Error> {
        let allowed = self.operator.check(&mut self.link, id);
        let found = allowed.and_then(|()| {
            let found = self.link.description().request(request);
            found.map_err(|invalid| format!("{}; {}", invalid.what, invalid.help))
        });
        Ok(match found.map(|request| self.link.send_request(request.borrow())) {
            Ok(Ok(number)) => Ok(number),
            Ok(Err(Error::Unknown(invalid))) => Err(format!("{}; {}", invalid.what, invalid.help)),
            Ok(Err(error)) => return Err(error),
            Err(reason) => Err(reason),
        })
    }

    /// Notes a refusal of which nobody else hears, for the log: the first one of a second.
    pub(super) fn report<T>(&mut self, done: Result<T, String>) {
        let Err(reason) = done else { return };
        if self.reported.is_none_or(|last| last.elapsed() > REPORT_AFTER) {
            self.reported = Some(Instant::now());
            self.warning = Some(reason);
        }
    }
}
