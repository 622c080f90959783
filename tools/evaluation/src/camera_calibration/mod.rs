//! Calibration of the cameras of a NAO: the angles of the cameras in the head, and the lean of the body, from field lines.
//!
//! A robot that stands at a known pose moves its head. The angles are those with which the detected lines lie on the lines of the field:
//! least squares over the images, with the robust weights of Tukey.

mod field_lines;
mod fit;
mod offsets;

use bica_motion::joints::Joint;
use bica_motion::pose::Pose2;
use bica_motion::robot::{CameraId, Sensors};
use bica_vision::colour::Classify;
use bica_vision::field_boundary::FieldBoundary;
use bica_vision::frame::Frame;
use bica_vision::lines::{self, Line};

use fit::Fit;
pub use fit::{Residual, View};
pub use offsets::Offsets;

/// Least number of images with lines.
const MIN_IMAGES: usize = 15;
/// Least number of images of a camera that is calibrated.
const MIN_OF_CAMERA: usize = 5;
/// Least range of the head's yaw, rad: with less of it, body and cameras cannot be told apart.
const MIN_TURN: f32 = 0.4;
/// Shortest line that is used, as a share of the width of the image.
const SHORTEST: f32 = 0.08;
/// Least share of the points that must be on lines after a calibration, and largest plausible angle, rad.
const MIN_ON_LINE: f32 = 0.6;
const MAX_ANGLE: f32 = 0.15;

/// Result of a calibration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Calibrated {
    /// The estimated angles.
    pub offsets: Offsets,
    /// Number of images of each camera, top first; a camera without images keeps the angles of its data sheet.
    pub images: [usize; 2],
    /// Errors without and with the offsets.
    pub before: Residual,
    /// The same with the offsets.
    pub after: Residual,
}

/// Detects the lines in the image of a cycle; `None` without an image that can be used, or without lines.
#[must_use]
pub fn view(sensors: &Sensors<'_>, colours: &impl Classify) -> Option<View> {
    let image = sensors.image?;
    let frame = Frame::from_image(&image).ok()?;
    let boundary = FieldBoundary::find(&frame, colours);
    let is_long = |line: &Line| line.length() >= SHORTEST * f32::from(image.width);
    let lines: Vec<_> = lines::find(&frame, colours, &boundary, None).into_iter().filter(is_long).collect();
    let size = (image.width, image.height);
    (!lines.is_empty()).then_some(View { camera: image.camera, size, angles: sensors.angles, lines })
}

/// Estimates the offsets of a NAO that stood with the middle of its feet at `pose` of the field.
///
/// # Errors
/// Why the views do not determine them, with the remedy.
pub fn calibrate(mut views: Vec<View>, pose: Pose2) -> Result<Calibrated, (String, &'static str)> {
    let of = |views: &[View], camera| views.iter().filter(|view| view.camera == camera).count();
    for camera in [CameraId::Top, CameraId::Bottom] {
        if of(&views, camera) < MIN_OF_CAMERA {
            views.retain(|view| view.camera != camera);
        }
    }
    let images = [CameraId::Top, CameraId::Bottom].map(|camera| of(&views, camera));
    if views.len() < MIN_IMAGES {
        let what = format!("{} images show lines, and {MIN_IMAGES} are needed", views.len());
        return Err((what, "let the robot look longer at the lines, and give the colours of the hall with --profile"));
    }
    let yaws = views.iter().map(|view| view.angles[Joint::HeadYaw]);
    let (least, most) = yaws.fold((f32::MAX, f32::MIN), |(least, most), yaw| (least.min(yaw), most.max(yaw)));
    if most - least < MIN_TURN {
        let what =
            format!("the head turned by {:.2} rad while lines were in view, and {MIN_TURN} are needed", most - least);
        return Err((what, "let the head look to both sides: body and cameras cannot be told apart otherwise"));
    }
    let fit = Fit::new(&views, pose);
    let offsets = fit.solve();
    let (before, after) = (fit.residual(&Offsets::default()), fit.residual(&offsets));
    if after.on_line < MIN_ON_LINE || offsets.0.amax() > MAX_ANGLE {
        let what = format!("only {:.0} % of the points are on lines with the best angles", 100.0 * after.on_line);
        let what = if after.on_line < MIN_ON_LINE {
            what
        } else {
            format!("the best angles reach {:.2} rad", offsets.0.amax())
        };
        return Err((what, "check --pose, and that the robot stood still there: x and y in m, the heading in rad"));
    }
    Ok(Calibrated { offsets, images, before, after })
}

#[cfg(test)]
mod tests {
    use bica_field::FIELD;
    use bica_motion::model::NAO;
    use glam::Vec2;

    use super::field_lines::FieldLine;
    use super::*;

    /// On the penalty mark, facing the goal.
    const POSE: Pose2 = Pose2::new(FIELD.penalty_mark(), 0.0, 0.0);

    /// Straight part of a line of the field that a camera sees within 4 m, px.
    fn seen(offsets: &Offsets, view: &View, line: &FieldLine) -> Option<Line> {
        let FieldLine::Straight(from, to) = *line else { return None };
        let camera = offsets.camera(view.camera, &view.angles, view.size);
        let size = Vec2::new(view.size.0.into(), view.size.1.into());
        let pixel = |index: i16| {
            let place = from.lerp(to, f32::from(index) / 500.0) - POSE.position;
            let pixel = camera.pixel(place.extend(0.0)).filter(|_| place.length() < 4.0)?;
            (pixel.cmpge(Vec2::ZERO).all() && pixel.cmplt(size).all()).then_some(pixel)
        };
        let pixels: Vec<Vec2> = (0..=500).filter_map(pixel).collect();
        // Half a pixel of noise, of either sign.
        let noise = Vec2::splat(if pixels.len().is_multiple_of(2) { 0.5 } else { -0.5 });
        let line = Line { from: *pixels.first()? + noise, to: *pixels.last()? - noise };
        (line.length() > 30.0).then_some(line)
    }

    /// What a robot with these offsets sees when it moves its head from `-turn` to `turn` rad.
    fn views(offsets: &Offsets, turn: f32) -> Vec<View> {
        let mut views = Vec::new();
        for camera in [CameraId::Top, CameraId::Bottom] {
            for (yaw, pitch) in (-4..=4_i8).flat_map(|yaw| [-0.5, -0.2, 0.1].map(|pitch| (yaw, pitch))) {
                let mut angles = NAO.stand;
                (angles[Joint::HeadYaw], angles[Joint::HeadPitch]) = (f32::from(yaw) * turn / 4.0, pitch);
                let mut view = View { camera, size: (320, 240), angles, lines: Vec::new() };
                view.lines = FieldLine::all().iter().filter_map(|line| seen(offsets, &view, line)).collect();
                views.push(view);
            }
        }
        views.retain(|view| !view.lines.is_empty());
        views
    }

    #[test]
    fn angles_of_both_cameras_and_the_body_are_found() {
        for sign in [1.0, -1.0] {
            let [top, bottom, body] = [[0.04, 0.05, -0.035], [-0.03, 0.04, 0.045], [0.035, 0.03, 0.0]];
            let signed = |angles: [f32; 3]| angles.map(|angle| sign * angle);
            let [roll, pitch, _] = signed(body);
            let offsets = Offsets::new(signed(top), signed(bottom), [roll, pitch]);
            let found = calibrate(views(&offsets, 1.2), POSE).expect("a calibration");
            let error = (found.offsets.0 - offsets.0).amax();
            assert!(error < 0.3_f32.to_radians(), "{error} rad: {found:?}");
            assert!(found.after.rms < 1.0 && found.before.rms > 3.0 && found.after.on_line > 0.95, "{found:?}");
        }
    }

    #[test]
    fn what_determines_nothing_is_refused() {
        let exact = Offsets::default();
        let all = views(&exact, 1.2);
        let off = Pose2::new(0.5, 0.4, 0.5);
        let few = all.iter().take(MIN_IMAGES - 1).cloned().collect();
        for (views, pose, why) in [
            (Vec::new(), POSE, "0 images"),
            (few, POSE, "images show lines"),
            (views(&exact, 0.1), POSE, "the head turned"),
            (all, off, "the best angles"),
        ] {
            assert!(calibrate(views, pose).is_err_and(|(what, _)| what.contains(why)), "{why}");
        }
    }
}
