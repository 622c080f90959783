//! Events of the referee, as JSON and as text.

use bica_app::Style;
use bica_motion::fall::Direction;
use bica_motion::side::Side;
use bica_recording::RunEvent;
use bica_sim::referee::{Event, TimedEvent};
use serde::Serialize;

/// Event of a game, for JSON.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct EventRecord {
    /// Time, s.
    pub t: f64,
    /// Kind: `goal`, `own_goal`, `touch`, `kick`, `ball_out`, `ball_placed`, `fall`, `got_up` or `collision`.
    pub event: &'static str,
    /// Details, as text.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub detail: String,
}

impl From<&TimedEvent> for EventRecord {
    fn from(event: &TimedEvent) -> Self {
        let (kind, detail) = match event.event {
            Event::Goal => ("goal", String::new()),
            Event::OwnGoal => ("own_goal", String::new()),
            Event::Touch { foot } => ("touch", side(foot).to_owned()),
            Event::Kick { foot, speed } => ("kick", format!("{} {speed:.2} m/s", side(foot))),
            Event::BallOut => ("ball_out", String::new()),
            Event::BallPlaced { at } => ("ball_placed", format!("{:.2} {:.2}", at.x, at.y)),
            Event::Fall(fall) => ("fall", direction(fall).to_owned()),
            Event::GotUp => ("got_up", String::new()),
            Event::Collision => ("collision", String::new()),
        };
        Self { t: event.at.as_secs_f64(), event: kind, detail }
    }
}

/// Returns the text of an event that ends a game; `None` for other events.
pub(crate) fn result(event: &TimedEvent) -> Option<String> {
    let name = match event.event {
        Event::Goal => "Goal",
        Event::OwnGoal => "Own goal",
        _ => return None,
    };
    Some(format!("{name} at {:.2} s", event.at.as_secs_f64()))
}

/// Converts an event for a recording.
pub(crate) fn recorded(event: &TimedEvent) -> RunEvent {
    let EventRecord { event: kind, detail, .. } = EventRecord::from(event);
    RunEvent { at_ns: event.at.as_nanos() as u64, kind: kind.to_owned(), detail }
}

/// Returns the text of an event and its emphasis.
pub(crate) fn describe(event: &Event) -> (Style, String) {
    match event {
        Event::Goal => (Style::Good, "GOAL".to_owned()),
        Event::OwnGoal => (Style::Bad, "own goal".to_owned()),
        Event::Touch { foot } => (Style::Faint, format!("the {} foot touches the ball", side(*foot))),
        Event::Kick { foot, speed } => {
            (Style::Strong, format!("the {} foot kicks the ball at {speed:.1} m/s", side(*foot)))
        }
        Event::BallOut => (Style::Bad, "the ball is out".to_owned()),
        Event::BallPlaced { at } => (Style::Plain, format!("the ball is placed at {:.2}, {:.2}", at.x, at.y)),
        Event::Fall(fall) => (Style::Bad, format!("the robot falls {}", direction(*fall))),
        Event::GotUp => (Style::Strong, "the robot has got up".to_owned()),
        Event::Collision => (Style::Bad, "the robot collides".to_owned()),
    }
}

const fn side(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}

const fn direction(fall: Direction) -> &'static str {
    match fall {
        Direction::Front => "forward",
        Direction::Back => "backward",
        Direction::Left => "to the left",
        Direction::Right => "to the right",
    }
}
