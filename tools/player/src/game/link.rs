//! Monitors of a game.

use bica::action::Action;
use bica_app::Failure;
use bica_link::{Address, LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_player::tunable::Forward;
use bica_sim::SpectatorView;
use bica_sim::referee::TimedEvent;
use bica_wire::message::Offers;

use crate::game::event::{self, EventRecord};
use crate::game::firmware::FirmwareCheck;
use crate::game::rules::Rules;

/// Address at which a game is served to monitors, and callback.
#[derive(Clone, Copy)]
pub struct ServeOptions<'a> {
    /// The address.
    pub address: &'a Address,
    /// Whether the address may be reached from other computers.
    pub anywhere: bool,
    /// Called once the server listens, with the address; its port is the one that the operating system chose if 0 was given.
    pub started: &'a dyn Fn(&str) -> Result<(), Failure>,
    /// Pauses the world and sets breakpoints, if the arguments request it; told whether the world can be paused.
    pub pause: &'a dyn Fn(bool, &mut LinkRequests) -> Result<(), Failure>,
}

/// Server of a game, if it is served.
pub(crate) struct GameLink(Option<LinkServer>);

/// Requests of an operator, if the game is served.
pub(crate) type LinkQueue = Option<LinkRequests>;

/// Observer for monitors, if the game is served.
pub(crate) type LinkView = Option<LinkObserver<Forward>>;

impl GameLink {
    /// Starts the server.
    pub(crate) fn start(
        options: Option<ServeOptions<'_>>,
        rules: &Rules,
        actions: &'static [Action],
        world: &dyn SpectatorView,
        can_pause: bool,
        firmware: &mut FirmwareCheck,
    ) -> Result<(Self, LinkQueue, LinkView), Failure> {
        let Some(ServeOptions { address, anywhere, started, pause }) = options else {
            return Ok((Self(None), None, None));
        };
        let defaults = ServerOptions::default();
        // A firmware image without the server for monitors has no operator: requests would make the commands of this
        // program differ from those of the image.
        let watch_only = firmware.is_watch_only()?;
        let offers = if can_pause { Offers::PAUSE } else { Offers::default() };
        let options = ServerOptions { anywhere, realtime: rules.realtime, watch_only, offers, actions, ..defaults };
        let (server, mut requests, observer) = LinkServer::start_in_world::<Forward>(address, options, world)?;
        pause(can_pause && !watch_only, &mut requests)?;
        started(server.address())?;
        let image = world.shared_image();
        let observer = observer.sharing_images(move |pixels| image.owner_of(pixels));
        Ok((Self(Some(server)), Some(requests), Some(observer)))
    }

    /// Sends an event of the referee to monitors.
    pub(crate) fn event(&self, event: &TimedEvent) {
        if let Some(server) = &self.0 {
            let EventRecord { event: kind, detail, .. } = EventRecord::from(event);
            if let Some(result) = event::result(event) {
                server.set_result(&result);
            }
            server.event(kind, &detail);
        }
    }
}
