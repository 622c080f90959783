//! Control of head and camera selection: keeps the ball in the middle of the image.

use bica::prelude::*;
use bica_motion::head::HeadAngles;
use bica_motion::robot::CameraId;
use libm::fabsf;

use crate::motion::Head;
use crate::output::CameraSelector;
use crate::perception::Bearing;
use crate::roles::Ball;

/// How head and camera follow the ball.
#[derive(Clone, Debug, PartialEq, Params)]
#[params(check = Self::is_ordered)]
pub struct Facing {
    /// Angle of the ball below the horizon above which the bottom camera is selected.
    #[param(default = 0.5, range = 0.0..=1.2, unit = "rad", step = 0.01)]
    pub near_angle: f32,
    /// Angle of the ball below the horizon below which the top camera is selected.
    #[param(default = 0.36, range = 0.0..=1.2, unit = "rad", step = 0.01)]
    pub far_angle: f32,
    /// Share of the error that the head corrects in a run.
    #[param(default = 0.7, range = 0.05..=1.0, step = 0.05)]
    pub gain: f32,
    /// Largest angle to the middle of the image at which the ball counts as centred.
    #[param(default = 0.15, range = 0.02..=0.4, unit = "rad", step = 0.01)]
    pub centred_tolerance: f32,
}

impl Facing {
    const fn is_ordered(&self) -> Result<(), &'static str> {
        if self.far_angle < self.near_angle {
            Ok(())
        } else {
            Err("`far_angle` must be below `near_angle`, so that the camera does not change in each run")
        }
    }

    /// The camera for a ball at this angle below the horizon, rad, after the camera `selected` before.
    fn camera(&self, selected: CameraId, down: f32) -> CameraId {
        match selected {
            CameraId::Top if down > self.near_angle => CameraId::Bottom,
            CameraId::Bottom if down < self.far_angle => CameraId::Top,
            _ => selected,
        }
    }
}

/// Keeps the ball in the middle of the image of the more suitable camera. While the ball is not seen, the head points to its
/// remembered position.
#[derive(Debug)]
pub struct FaceBall {
    centred: bool,
    /// Angles from the head to the ball, rad.
    error: HeadAngles,
}

#[component(hz = 30, budget_us = 5, writers = first)]
impl FaceBall {
    /// Creates the component with the ball not centred.
    #[must_use]
    pub const fn new() -> Self {
        Self { centred: false, error: HeadAngles::AHEAD }
    }

    #[start]
    fn begin(&mut self) {
        *self = Self::new();
    }

    fn step(&mut self, tuned: &Tuned<Facing>, ball: &impl Ball, head: &mut Head, camera: &mut CameraSelector) {
        let Some(Bearing { pan, down }) = ball.bearing() else {
            self.centred = false;
            return;
        };
        let before = camera.selected();
        camera.select(tuned.camera(before, down));
        let tilt = down - head.camera_tilt(camera.selected());
        let (from_pan, from_tilt) = (head.pan(), head.tilt());
        self.error = HeadAngles { yaw: pan - from_pan, pitch: tilt - from_tilt };
        let gain = if camera.selected() == before { tuned.gain } else { 1.0 };
        self.centred = ball.camera().is_some() && is_within(self.error, tuned.centred_tolerance);
        head.look_at(from_pan + gain * self.error.yaw, from_tilt + gain * self.error.pitch);
    }

    /// Whether the ball is in the middle of the newest image.
    #[output]
    #[must_use]
    pub const fn centred(&self) -> bool {
        self.centred
    }

    /// Angles from the direction of the selected camera to the ball in the last run in which its bearing was known.
    #[output(unit = "rad")]
    #[must_use]
    pub const fn error(&self) -> HeadAngles {
        self.error
    }
}

fn is_within(error: HeadAngles, tolerance: f32) -> bool {
    fabsf(error.yaw) < tolerance && fabsf(error.pitch) < tolerance
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn camera_switch_has_hysteresis() {
        let tuned = Facing { near_angle: 0.7, far_angle: 0.6, ..Facing::DEFAULT };
        for (selected, down, expected) in [
            (CameraId::Top, 0.69, CameraId::Top),
            (CameraId::Top, 0.71, CameraId::Bottom),
            (CameraId::Bottom, 0.61, CameraId::Bottom),
            (CameraId::Bottom, 0.59, CameraId::Top),
        ] {
            assert_eq!(tuned.camera(selected, down), expected, "{selected:?} {down}");
        }
    }

    #[test]
    fn angles_without_hysteresis_are_refused() {
        assert!(Facing::DEFAULT.check().is_ok());
        assert!(Facing { near_angle: 0.36, ..Facing::DEFAULT }.check().is_err());
    }
}
