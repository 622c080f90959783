//! Monitors of a game.

use std::time::Duration;

use bica::action::Action;
use bica_app::Failure;
use bica_field::GoalColour;
use bica_link::{Address, LinkImage, LinkObserver, LinkRequests, LinkServer, ServerOptions};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Sensors};
use bica_player::tunable::Forward;
use bica_sim::referee::{Event, TimedEvent};
use bica_sim::{Referee, SharedImage};
use bica_wire::message::{MAX_OTHERS, Offers, Truth};

use crate::game::event::EventRecord;
use crate::game::firmware::FirmwareCheck;
use crate::game::rules::Rules;

/// Level of informative lines in the log of a link.
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
pub(crate) type LinkQueue = Option<LinkRequests>;

/// Observer for monitors, if the game is served.
pub(crate) type LinkView = Option<LinkObserver<Forward>>;

impl GameLink {
    /// Starts the server.
    pub(crate) fn start(
        options: Option<ServeOptions<'_>>,
        rules: &Rules,
        actions: &'static [Action],
        image: SharedImage,
        can_pause: bool,
        firmware: &mut FirmwareCheck,
    ) -> Result<(Self, LinkQueue, LinkView), Failure> {
        let Some(ServeOptions { address, anywhere, started }) = options else {
            return Ok((Self(None), None, None));
        };
        let defaults = ServerOptions::default();
        // A firmware image without the server for monitors has no operator: requests would make this program's commands differ
        // from the image's.
        let watch_only = firmware.is_watch_only()?;
        let pause = if can_pause { Offers::PAUSE } else { Offers::default() };
        let offers = Offers::TRUTH.with(Offers::IMAGES).with(pause);
        let options = ServerOptions { anywhere, realtime: rules.realtime, watch_only, offers, actions, ..defaults };
        let (server, requests, observer) = LinkServer::start::<Forward>(address, options)?;
        started(server.address())?;
        let observer = observer.with_images(image_of).sharing_images(move |pixels| image.owner_of(pixels));
        Ok((Self(Some(server)), Some(requests), Some(observer)))
    }

    /// Sends an event of the referee to monitors.
    pub(crate) fn event(&self, event: &TimedEvent) {
        if let Some(server) = &self.0 {
            let EventRecord { event: kind, mut detail, t } = EventRecord::from(event);
            if matches!(event.event, Event::Goal | Event::OwnGoal) {
                detail = format!("at {t:.2} s");
            }
            let separator = if detail.is_empty() { "" } else { ", " };
            server.log(INFORMATION, &format!("referee: {kind}{separator}{detail}"));
        }
    }
}

/// Returns the image in sensor values.
fn image_of<'a>(sensors: &'a Sensors<'_>) -> Option<LinkImage<'a>> {
    sensors.image.as_ref().map(|image| LinkImage {
        bottom_camera: image.camera == CameraId::Bottom,
        width: image.width,
        height: image.height,
        yuyv: image.yuyv,
    })
}

/// Sends the true state after a cycle to monitors that watch it.
pub(crate) fn send_truth(view: &LinkView, cycle: Duration, referee: &Referee, start: Pose2) {
    let Some(observer) = view.as_ref().filter(|observer| observer.wants_truth()) else { return };
    let pose = |pose: Pose2| [pose.position.x, pose.position.y, pose.heading];
    observer.truth(|| Truth {
        time_us: cycle.as_micros() as u64,
        robot: pose(referee.robot()),
        ball: referee.ball().into(),
        others: referee.others().iter().map(|other| other.position.into()).take(MAX_OTHERS).collect(),
        start: pose(start),
        attacks_blue: referee.attacks() == GoalColour::SkyBlue,
    });
}
