//! Parameters of the search for the ball.

use bica::prelude::*;
use bica_motion::robot::CameraId;
use glam::Vec2;
use libm::{atan2f, fabsf};

/// Glances of a scan in sequence: the band, and how far to the first side the head turns, −2 to 2.
///
/// Three overlapping bands; each ahead, then on the first side, then on the other one.
pub(super) const GLANCES: [(Band, i8); 13] = [
    (Band::Near, 0),
    (Band::Feet, 0),
    (Band::Far, 0),
    (Band::Far, 1),
    (Band::Feet, 1),
    (Band::Near, 1),
    (Band::Near, 2),
    (Band::Far, 2),
    (Band::Far, -1),
    (Band::Feet, -1),
    (Band::Near, -1),
    (Band::Near, -2),
    (Band::Far, -2),
];

/// Band of the field that a glance shows.
#[derive(Clone, Copy)]
pub(super) enum Band {
    /// Before the feet, by the bottom camera.
    Feet,
    /// Up to 2 m, by the bottom camera.
    Near,
    /// Beyond, by the top camera.
    Far,
}

/// How the robot searches for the ball.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct Search {
    /// Duration of the search at the remembered position: the head motion and some images.
    #[param(default = 1.0, range = 0.0..=5.0, unit = "s", step = 0.1)]
    pub recall_time: f32,
    /// Least confidence in the remembered position for a search there, 0 to 1.
    #[param(default = 0.1, range = 0.0..=1.0, step = 0.05)]
    pub min_confidence: f32,
    /// Duration of the stop in each direction: two images and the motors' dead time.
    #[param(default = 0.12, range = 0.0..=2.0, unit = "s", step = 0.01)]
    pub rest_time: f32,
    /// Head pan of the inner glances to each side.
    #[param(default = 0.85, range = 0.1..=2.0, unit = "rad", step = 0.05)]
    pub inner_pan: f32,
    /// Head pan of the outer glances to each side.
    #[param(default = 1.7, range = 0.1..=2.0, unit = "rad", step = 0.05)]
    pub outer_pan: f32,
    /// Head tilt, down, with which the bottom camera shows the ground before the feet.
    #[param(default = 0.35, range = -0.5..=0.5, unit = "rad", step = 0.01)]
    pub feet_tilt: f32,
    /// Head tilt, down, with which the bottom camera shows the ground up to 2 m.
    #[param(default = -0.1, range = -0.5..=0.5, unit = "rad", step = 0.01)]
    pub near_tilt: f32,
    /// Head tilt, down, with which the top camera shows the field beyond.
    #[param(default = 0.0, range = -0.5..=0.5, unit = "rad", step = 0.01)]
    pub far_tilt: f32,
    /// Turning speed of the body after a scan without result. A turn takes 3.9 s.
    #[param(default = 0.8, range = 0.2..=1.5, unit = "rad/s", step = 0.05)]
    pub turn_speed: f32,
    /// Number of half turns at one place: scans before and after one are a full circle.
    #[param(default = 1, range = 0..=20)]
    pub turns: u32,
    /// Distance at which the ball is seen: the field is searched from places of which one is so near to each point.
    #[param(default = 2.4, range = 1.0..=10.0, unit = "m", step = 0.1)]
    pub view_distance: f32,
    /// Free path ahead with which the robot begins to walk to another place.
    #[param(default = 1.25, range = 0.25..=2.5, unit = "m", step = 0.25)]
    pub free_path: f32,
    /// Free path ahead below which it ends its walk.
    #[param(default = 0.8, range = 0.25..=2.5, unit = "m", step = 0.05)]
    pub blocked_path: f32,
    /// Head tilt, down, with which the top camera shows the ground from 0.8 m to the horizon.
    #[param(default = 0.25, range = 0.0..=0.5, unit = "rad", step = 0.01)]
    pub path_tilt: f32,
    /// Walking speed to another place.
    #[param(default = 0.2, range = 0.05..=0.4, unit = "m/s", step = 0.01)]
    pub walk_speed: f32,
    /// Distance to another place while the robot does not know where on the field it is.
    #[param(default = 1.0, range = 0.2..=5.0, unit = "m", step = 0.1)]
    pub walk_distance: f32,
}

impl Search {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.blocked_path <= self.free_path {
            Ok(())
        } else {
            Err("`blocked_path` must not be above `free_path`: the walk would end as it begins")
        }
    }

    /// Time, s, to turn to a place in the ground frame, m, and to walk there.
    pub(super) fn time_to(&self, at: Vec2) -> f32 {
        fabsf(atan2f(at.y, at.x)) / self.turn_speed + at.length() / self.walk_speed
    }

    /// Camera, head pan and head tilt, rad, of a glance with this first side (1 left, −1 right).
    pub(super) fn direction(&self, (band, way): (Band, i8), side: f32) -> (CameraId, f32, f32) {
        let pan = match way.unsigned_abs() {
            0 => 0.0,
            1 => self.inner_pan,
            _ => self.outer_pan,
        };
        let (camera, tilt) = match band {
            Band::Feet => (CameraId::Bottom, self.feet_tilt),
            Band::Near => (CameraId::Bottom, self.near_tilt),
            Band::Far => (CameraId::Top, self.far_tilt),
        };
        (camera, if way < 0 { -pan * side } else { pan * side }, tilt)
    }
}
