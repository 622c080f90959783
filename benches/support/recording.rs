//! Cycles of a game that can be sensed again and again, without the world.

use bica::{Hold, Tree};
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Image, Sensors};
use bica_player::Forward;
use bica_player::perception::Localization;
use bica_sim::World;
use bica_sim::setup::{Frame, Setup, Start};
use glam::Vec2;

use crate::game::Game;

/// Cycles before a recording in which the forward finds the ball and begins to walk.
pub(crate) const WARM: usize = 90;
/// Cycles of a recording; 18 bring an image.
pub(crate) const CYCLES: usize = 60;

/// What a robot sensed in some cycles.
pub(crate) struct Recording(Vec<Moment>);

struct Moment {
    /// But the image.
    sensors: Sensors<'static>,
    picture: Option<Picture>,
}

/// An image that is kept.
pub(crate) struct Picture {
    pub(crate) camera: CameraId,
    pub(crate) width: u16,
    pub(crate) height: u16,
    pub(crate) yuyv: Vec<u8>,
}

impl Recording {
    /// The cycles of a game in which the robot walks towards a ball in front of a goal and others beside it, after
    /// some that are not kept; and the forward as it was after them. It wants to know its place all the time, so that
    /// everything that it can look for is looked for.
    pub(crate) fn of_game(frame: Frame, before: usize, cycles: usize) -> (Self, Box<Forward>) {
        let start = Start { robot: Pose2::new(0.6, 0.2, 0.0), ball: Vec2::new(1.8, 0.1) };
        let mut game = Game::new(&Setup { seed: 9, frame, robots: 2, start: Some(start), ..Setup::default() });
        game.robot.hold::<Localization>(Hold::Active);
        for _ in 0..before {
            game.cycle(&mut ());
        }
        let mut moments = Vec::with_capacity(cycles);
        for _ in 0..cycles {
            moments.push(Moment::of(&game.world.sensors()));
            game.cycle(&mut ());
        }
        (Self(moments), game.robot)
    }

    /// What was sensed, cycle by cycle.
    pub(crate) fn sensors(&self) -> impl Iterator<Item = Sensors<'_>> {
        self.0.iter().map(Moment::sensors)
    }
}

impl Picture {
    pub(crate) fn image(&self) -> Image<'_> {
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
