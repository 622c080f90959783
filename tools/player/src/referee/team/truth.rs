//! The true state of a match, for judges.

use std::io::Write;
use std::path::Path;

use bica_app::Failure;
use bica_player::referee::Identity;
use bica_sim::match_field::MatchField;
use serde::Serialize;

/// Cycles between two lines: 20 lines a second.
const PERIOD: u64 = 5;
/// Longest wait of the world for a reader.
#[cfg(unix)]
const PATIENCE: std::time::Duration = std::time::Duration::from_millis(20);

/// Writes lines of JSON. The players do not read it.
pub(super) struct Truth(Option<Box<dyn Write>>);

/// A line.
#[derive(Serialize)]
struct Line {
    t: f64,
    robots: Vec<RobotTruth>,
    ball: [f32; 2],
}

/// A robot; its pose is in the frame of the field of its own team.
#[derive(Serialize)]
struct RobotTruth {
    team: u8,
    player: u8,
    x: f32,
    y: f32,
    theta: f32,
    fallen: bool,
}

impl Truth {
    /// Connects to a Unix stream socket; `None` writes nothing.
    ///
    /// # Errors
    /// If nobody listens there.
    #[cfg(unix)]
    pub(super) fn connect(path: Option<&Path>) -> Result<Self, Failure> {
        let Some(path) = path else { return Ok(Self(None)) };
        let stream = std::os::unix::net::UnixStream::connect(path).and_then(|stream| {
            stream.set_write_timeout(Some(PATIENCE))?;
            Ok(stream)
        });
        let stream = stream.map_err(|error| {
            let what = format!("cannot connect to the socket {}: {error}", path.display());
            Failure::new(what, "start the program that reads the true state before, or leave out --truth")
        })?;
        Ok(Self(Some(Box::new(stream))))
    }

    /// Returns an error with a path: this system has no Unix sockets.
    #[cfg(not(unix))]
    pub(super) fn connect(path: Option<&Path>) -> Result<Self, Failure> {
        match path {
            None => Ok(Self(None)),
            Some(_) => Err(Failure::new("--truth needs a Unix socket", "leave it out")),
        }
    }

    /// Writes a line in some cycles. A reader that has gone or does not read ends the output, not the match.
    pub(super) fn write(&mut self, cycle: u64, players: &[Identity], field: &MatchField) {
        let Some(out) = self.0.as_mut().filter(|_| cycle.is_multiple_of(PERIOD)) else { return };
        let robot = |(index, me): (usize, &Identity)| {
            let pose = field.truth(index).robot();
            let (x, y, theta) = (pose.position.x, pose.position.y, pose.heading);
            RobotTruth { team: me.team, player: me.player, x, y, theta, fallen: field.is_down(index) }
        };
        let line = Line {
            t: cycle as f64 * 0.01,
            robots: players.iter().enumerate().map(robot).collect(),
            ball: field.truth(0).ball().into(),
        };
        let text = serde_json::to_string(&line).map(|text| text + "\n");
        if text.map_err(std::io::Error::from).and_then(|text| out.write_all(text.as_bytes())).is_err() {
            self.0 = None;
        }
    }
}
