//! Monitors of a game.

use bica::runner::{Cycle, Observer, Overrun, Request, Requests};
use bica::{Instant, Probe, Refusal};
use bica_console::Failure;
use bica_link::{Address, LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_motion::robot::Sensors;
use bica_player::tunable::Forward;
use bica_sim::referee::TimedEvent;

use crate::event::EventRecord;
use crate::rules::Rules;

/// Level of an information in the log of a link.
const INFORMATION: u8 = 2;

/// Where and how a game is served to monitors.
#[derive(Clone, Copy)]
pub struct ServeOptions<'a> {
    /// The address.
    pub address: &'a Address,
    /// Whether the address may be reached from other computers.
    pub anywhere: bool,
    /// Called with the address once the server listens, with the port that the operating system chose for port 0.
    pub started: &'a dyn Fn(&str) -> Result<(), Failure>,
}

/// Server of a game, if it is served.
pub(crate) struct GameLink(Option<LinkServer>);

/// Requests of an operator, if the game is served.
pub(crate) struct LinkQueue(Option<LinkRequests>);

/// Observer for monitors, if the game is served.
pub(crate) struct LinkView(Option<LinkObserver<Forward>>);

impl GameLink {
    /// Starts the server.
    pub(crate) fn start(
        options: Option<ServeOptions<'_>>,
        rules: &Rules,
    ) -> Result<(Self, LinkQueue, LinkView), Failure> {
        let Some(ServeOptions { address, anywhere, started }) = options else {
            return Ok((Self(None), LinkQueue(None), LinkView(None)));
        };
        let defaults = ServerOptions::default();
        // A firmware image has no operator: requests would make this program's commands differ from the image's.
        let watch_only = rules.firmware.is_some();
        let options = ServerOptions { anywhere, realtime: rules.realtime, watch_only, ..defaults };
        let (server, requests, observer) =
            LinkServer::start(address, options).map_err(|error| Failure::new(error.to_string(), error.help()))?;
        started(server.address())?;
        let observer = observer.counting_images(|sensors: &Sensors<'_>| sensors.image.is_some());
        Ok((Self(Some(server)), LinkQueue(Some(requests)), LinkView(Some(observer))))
    }

    /// Sends an event of the referee to monitors.
    pub(crate) fn event(&self, event: &TimedEvent) {
        if let Some(server) = &self.0 {
            let EventRecord { event: kind, detail, .. } = EventRecord::from(event);
            let separator = if detail.is_empty() { "" } else { ", " };
            server.log(INFORMATION, &format!("referee: {kind}{separator}{detail}"));
        }
    }
}

impl Requests for LinkQueue {
    fn next(&mut self, now: Instant) -> Option<Request<'_>> {
        self.0.as_mut()?.next(now)
    }

    fn answered(&mut self, now: Instant, result: Result<(), Refusal>) {
        if let Some(requests) = &mut self.0 {
            requests.answered(now, result);
        }
    }
}

impl Probe for LinkView {}

impl Observer<Forward> for LinkView {
    fn sensing(&mut self, now: Instant, sensors: &Sensors<'_>) {
        if let Some(observer) = &mut self.0 {
            observer.sensing(now, sensors);
        }
    }

    fn acted(&mut self, cycle: &Cycle<'_, Forward>) {
        if let Some(observer) = &mut self.0 {
            observer.acted(cycle);
        }
    }

    fn requests_applied(&mut self, now: Instant, robot: &Forward) {
        if let Some(observer) = &mut self.0 {
            observer.requests_applied(now, robot);
        }
    }

    fn overrun(&mut self, overrun: &Overrun) {
        if let Some(observer) = &mut self.0 {
            Observer::<Forward>::overrun(observer, overrun);
        }
    }
}
