//! The robot behind its link.

use std::time::{Duration, Instant};

use bica_link::{Client, Error};
use bica_wire::model::NamedRequest;
use ros2_client::Gid;

use super::operator::Operator;
use super::pending::{Pending, result};

/// Shortest time between two lines of the log about refusals.
const REPORT_AFTER: Duration = Duration::from_secs(1);

/// The robot, and the permission to command it.
pub(super) struct Robot {
    pub(super) link: Client,
    /// Whether its time is that of a simulation.
    pub(super) simulated: bool,
    pub(super) operator: Operator,
    pub(super) pending: Pending,
    /// A refusal that is not yet in the log, and the time of the last one.
    pub(super) warning: Option<String>,
    pub(super) reported: Option<Instant>,
}

impl Robot {
    /// Sends a request for a client that waits for the answer. If it is refused at once, the reason becomes the answer.
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

    /// Sends a request of a client that has the lease, or a stop; returns its number, or the reason for the refusal.
    pub(super) fn send(&mut self, id: Gid, request: &NamedRequest) -> Result<Result<u32, String>, Error> {
        let found = self.link.description().request(request);
        let found = found.map_err(|invalid| format!("{}; {}", invalid.what, invalid.help)).and_then(|request| {
            let is_stop = self.link.description().is_stop(request.borrow());
            if is_stop { Ok(request) } else { self.operator.check(&mut self.link, id).map(|()| request) }
        });
        Ok(match found.map(|request| self.link.send_request(request.borrow())) {
            Ok(Ok(number)) => Ok(number),
            Ok(Err(Error::Unknown(invalid))) => Err(format!("{}; {}", invalid.what, invalid.help)),
            Ok(Err(error)) => return Err(error),
            Err(reason) => Err(reason),
        })
    }

    /// Stops the robot, which needs no lease; returns the numbers of the requests.
    pub(super) fn stop(&mut self) -> Result<Vec<u32>, Error> {
        let stops: Vec<_> = self.link.description().stops().collect();
        stops.iter().map(|stop| self.link.send_request(stop.borrow())).collect()
    }

    /// Stores a refusal that no answer reports for the log, at most one per second.
    pub(super) fn report<T>(&mut self, done: Result<T, String>) {
        let Err(reason) = done else { return };
        if self.reported.is_none_or(|last| last.elapsed() > REPORT_AFTER) {
            self.reported = Some(Instant::now());
            self.warning = Some(reason);
        }
    }
}
