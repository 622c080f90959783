//! World of a replay: the stored sensor values, or the simulated world made again.

use bica::Instant;
use bica::runner::World;
use bica_motion::robot::{self, CameraId, Command};
use bica_player::tunable::Forward;
use bica_recording::{OwnedImage, RecordedCycle};
use bica_sim::{PlacementError, SpectatorView};
use bica_wire::message::Sensors as SensorsMessage;

/// World of a replay.
pub(super) enum ReplayWorld {
    /// The stored sensor values of a cycle.
    Stored(Box<RecordedCycle>),
    /// The world, made again from the rules.
    Simulated(Box<dyn SpectatorView>),
}

impl ReplayWorld {
    /// Places the ball as it was placed in the recorded run, m, field frame. Stored sensor values show it there already.
    ///
    /// # Errors
    /// If the world refuses it, as the repeated run is another one.
    pub(super) fn place_ball(&mut self, at: [f32; 2]) -> Result<(), PlacementError> {
        match self {
            Self::Stored(_) => Ok(()),
            Self::Simulated(world) => world.place_ball(at.into()),
        }
    }
}

impl World<Forward> for ReplayWorld {
    fn now(&self) -> Instant {
        match self {
            Self::Stored(cycle) => Instant::from_ticks(cycle.tick.instant),
            Self::Simulated(world) => World::<Forward>::now(world),
        }
    }

    fn sensors(&mut self) -> robot::Sensors<'_> {
        match self {
            Self::Stored(cycle) => {
                let image = cycle.image.as_ref();
                let sensors = cycle.sensors.as_ref().map(|sensors| sensors.to_sensors(None));
                let sensors = sensors.unwrap_or_else(nothing_measured);
                robot::Sensors { image: image.map(borrowed), ..sensors }
            }
            Self::Simulated(world) => World::<Forward>::sensors(world),
        }
    }

    fn act(&mut self, command: &Command) {
        if let Self::Simulated(world) = self {
            World::<Forward>::act(world, command);
        }
    }
}

fn borrowed(image: &OwnedImage) -> robot::Image<'_> {
    let camera = if image.bottom_camera { CameraId::Bottom } else { CameraId::Top };
    robot::Image { camera, width: image.width, height: image.height, yuyv: &image.yuyv }
}

/// Sensor values of a damaged recording whose cycle has none.
fn nothing_measured() -> robot::Sensors<'static> {
    let nothing = SensorsMessage {
        time_us: 0,
        angles: [f32::NAN; bica_motion::joints::JOINTS],
        temperatures: [f32::NAN; bica_motion::joints::JOINTS],
        currents: [f32::NAN; bica_motion::joints::JOINTS],
        inertial: [f32::NAN; 8],
        feet: [f32::NAN; 8],
        buttons: [false; 3],
        image: None,
    };
    nothing.to_sensors(None)
}
