//! Detections in an image, for a picture.

use bica_vision::ball::Ball;
use bica_vision::crossings::Crossing;
use bica_vision::goal::Goal;
use bica_vision::lines::Line;
use bica_vision::own_body::OwnBody;
use bica_vision::robots::Robot;
use glam::Vec2;

/// Detections in an image, px; the centre of the first pixel is (0, 0).
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Marks {
    /// The ball.
    pub ball: Option<Ball>,
    /// Goals.
    pub goals: Vec<Goal>,
    /// Field boundary, from left to right.
    pub field_boundary: Vec<Vec2>,
    /// White lines.
    pub lines: Vec<Line>,
    /// Other robots.
    pub robots: Vec<Robot>,
    /// Crossings of lines.
    pub crossings: Vec<Crossing>,
    /// Points on the centre circle, in order.
    pub circle: Vec<Vec2>,
    /// The robot's own body.
    pub own: OwnBody,
}
