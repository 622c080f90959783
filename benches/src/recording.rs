//! Recorded sensor values of a game.

use bica::Hold;
use bica::runner::World;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Image, Sensors};
use bica_player::perception::Localization;
use bica_sim::setup::{Frame, Setup, Start};
use glam::Vec2;

use crate::game::{ForwardTree, new_game};

/// Number of cycles before a recording, in which the forward finds the ball and begins to walk.
pub const WARM: usize = 90;
/// Number of cycles of a recording; 18 of them have an image.
pub const CYCLES: usize = 60;

/// Sensor values of consecutive cycles.
pub struct Recording(Vec<RecordedCycle>);

struct RecordedCycle {
    /// Sensor values without the image.
    sensors: Sensors<'static>,
    image: Option<OwnedImage>,
}

/// Image with its own memory.
pub struct OwnedImage {
    /// Camera that took the image.
    pub camera: CameraId,
    /// Width, px.
    pub width: u16,
    /// Height, px.
    pub height: u16,
    /// Pixels, YUYV 4:2:2.
    pub yuyv: Vec<u8>,
}

impl Recording {
    /// Records `cycles` cycles of a game after the first `before`. The robot walks towards a ball in front of a goal, with other
    /// robots beside it. Localization is held active, so all detectors run. Returns the recording and the forward after the game.
    ///
    /// # Panics
    /// If the size of an image is not accepted.
    #[must_use]
    pub fn of_game<T: ForwardTree>(frame: Frame, before: usize, cycles: usize) -> (Self, Box<T>) {
        let start = Start { robot: Pose2::new(0.6, 0.2, 0.0), ball: Vec2::new(1.8, 0.1) };
        let mut game = new_game::<T>(&Setup { seed: 9, frame, robots: 2, start: Some(start), ..Setup::default() });
        game.robot_mut().of_mut::<Localization>().hold(Hold::Active);
        for _ in 0..before {
            game.cycle().expect("the image fits");
        }
        let mut recorded = Vec::with_capacity(cycles);
        for _ in 0..cycles {
            recorded.push(RecordedCycle::of(&World::<T>::sensors(game.world_mut())));
            game.cycle().expect("the image fits");
        }
        (Self(recorded), game.into_parts().0)
    }

    /// Returns the sensor values, cycle by cycle.
    pub fn sensors(&self) -> impl Iterator<Item = Sensors<'_>> {
        self.0.iter().map(RecordedCycle::sensors)
    }
}

impl OwnedImage {
    /// Borrows the image.
    #[must_use]
    pub fn image(&self) -> Image<'_> {
        Image { camera: self.camera, width: self.width, height: self.height, yuyv: &self.yuyv }
    }
}

impl RecordedCycle {
    fn of(sensors: &Sensors<'_>) -> Self {
        let image = sensors.image.map(|image| OwnedImage {
            camera: image.camera,
            width: image.width,
            height: image.height,
            yuyv: image.yuyv.to_vec(),
        });
        let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: _ } = *sensors;
        let sensors = Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: None };
        Self { sensors, image }
    }

    fn sensors(&self) -> Sensors<'_> {
        Sensors { image: self.image.as_ref().map(OwnedImage::image), ..self.sensors }
    }
}
