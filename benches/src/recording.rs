//! Recorded sensor values of a game.

use bica::runner::World;
use bica::{Hold, Tree};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Image, Sensors};
use bica_player::Forward;
use bica_player::perception::Localization;
use bica_sim::setup::{Frame, Setup, Start};
use glam::Vec2;

use crate::game::new_game;

/// Cycles before a recording, in which the forward finds the ball and begins to walk.
pub const WARM: usize = 90;
/// Cycles of a recording; 18 bring an image.
pub const CYCLES: usize = 60;

/// The sensor values of some cycles.
pub struct Recording(Vec<Moment>);

struct Moment {
    /// Without the image.
    sensors: Sensors<'static>,
    picture: Option<Picture>,
}

/// An image with its own memory.
pub struct Picture {
    /// The camera that took it.
    pub camera: CameraId,
    /// Pixels.
    pub width: u16,
    /// Pixels.
    pub height: u16,
    /// YUYV 4:2:2.
    pub yuyv: Vec<u8>,
}

impl Recording {
    /// Records `cycles` of a game after the first `before`, in which the robot walks towards a ball in front of a goal with other
    /// robots beside it. Returns the recording and the forward after the game. Localization is held active, so that all
    /// detectors run.
    ///
    /// # Panics
    /// If an image does not fit.
    #[must_use]
    pub fn of_game(frame: Frame, before: usize, cycles: usize) -> (Self, Box<Forward>) {
        let start = Start { robot: Pose2::new(0.6, 0.2, 0.0), ball: Vec2::new(1.8, 0.1) };
        let mut game = new_game(&Setup { seed: 9, frame, robots: 2, start: Some(start), ..Setup::default() });
        game.robot_mut().hold::<Localization>(Hold::Active);
        for _ in 0..before {
            game.cycle().expect("the image fits");
        }
        let mut moments = Vec::with_capacity(cycles);
        for _ in 0..cycles {
            moments.push(Moment::of(&World::<Forward>::sensors(game.world_mut())));
            game.cycle().expect("the image fits");
        }
        (Self(moments), game.into_parts().0)
    }

    /// The sensor values, cycle by cycle.
    pub fn sensors(&self) -> impl Iterator<Item = Sensors<'_>> {
        self.0.iter().map(Moment::sensors)
    }
}

impl Picture {
    /// The image.
    #[must_use]
    pub fn image(&self) -> Image<'_> {
        Image { camera: self.camera, width: self.width, height: self.height, yuyv: &self.yuyv }
    }
}

impl Moment {
    fn of(sensors: &Sensors<'_>) -> Self {
        let picture = sensors.image.map(|image| Picture {
            camera: image.camera,
            width: image.width,
            height: image.height,
            yuyv: image.yuyv.to_vec(),
        });
        let Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: _ } = *sensors;
        let sensors = Sensors { angles, temperatures, currents, inertial, left_foot, right_foot, buttons, image: None };
        Self { sensors, picture }
    }

    fn sensors(&self) -> Sensors<'_> {
        Sensors { image: self.picture.as_ref().map(Picture::image), ..self.sensors }
    }
}
