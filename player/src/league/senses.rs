//! What a robot of the league senses, with directions and distances instead of images.

use bica::prelude::*;
use bica_motion::robot::Sensors;
use heapless::Vec;

/// What the robot senses in a cycle.
#[data]
#[derive(Clone, Debug)]
pub struct Senses<'a> {
    /// Joints and inertial unit, with the estimates of what the body does not measure; no image.
    pub body: Sensors<'a>,
    /// What the camera sees; `None` in cycles without a new view.
    pub view: Option<View>,
    /// Whether the robot may play.
    pub playing: bool,
}

/// Largest number of sights in a view.
pub const SIGHTS: usize = 48;

/// Something that the camera sees.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sight {
    /// What it is.
    pub object: Object,
    /// Vector from the camera, m: x along its axis, y to the left of the view, z up the view.
    pub at: [f32; 3],
}

/// Kind of a sight.
#[data]
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Object {
    /// The centre of the ball.
    Ball,
    /// A mark of the field, at this position in the field frame, m.
    Mark([f32; 3]),
    /// A foot of another player.
    Robot,
}

/// All that the camera sees at a moment.
pub type View = Vec<Sight, SIGHTS>;
