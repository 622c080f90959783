//! What was seen against what is there.

mod goals;
mod tally;

use bica_vision::projection::Camera;
use glam::Vec2;
use serde::Serialize;

use crate::camera_poses::Pose;
use crate::detection::{Ball, Sighting};
use crate::labels::{self, Label, Labels};
use bica_console::Console;
use bica_console::Failure;
use goals::Goals;
use tally::{Errors, Share, Spread};

/// The width of images for which files of poses have the horizon.
const HORIZON_WIDTH: usize = 320;
const HORIZON_HEIGHT: usize = 240;
/// The column in which they have it.
const HORIZON_COLUMN: f32 = 159.5;
/// By how much two ways to measure a distance may differ.
const SAME_DISTANCE: f32 = 0.12;

/// Compares image by image.
pub struct Score {
    labels: Labels,
    /// Radius of the ball, m.
    radius: f32,
    sum: Sum,
    centre: Errors,
    distance: Errors,
    horizon: Errors,
}

/// How much was right. A ball is right within 3 px, or half its radius if that is more, of an orange one.
#[derive(Debug, Default, Serialize)]
struct Sum {
    /// Images with labels.
    labelled: usize,
    /// Images with a full orange ball in which an orange ball was seen where one is.
    recall: Share,
    /// Balls that were seen where one is, of all that were seen.
    precision: Share,
    /// Balls that were seen in images with a full one, and are within 3 px or half the radius.
    near: Share,
    /// Distance of the centres, px, of balls in images with a full one.
    centre_px: Spread,
    missed: Vec<String>,
    wrong: Vec<String>,
    goals: Goals,
    /// Distances by projection that differ by at most 12 % from those by the radius.
    same_distance: Share,
    /// Differences of these distances, as a part.
    distance: Spread,
    /// Between the row of the horizon by the pose and the one in the file, px.
    horizon_px: Spread,
}

#[derive(Serialize)]
struct Line<'a> {
    score: &'a Sum,
}

impl Score {
    /// Nothing compared yet; `radius` of the ball in metres.
    pub fn new(labels: Labels, radius: f32) -> Self {
        let errors = Errors::default;
        Self { labels, radius, sum: Sum::default(), centre: errors(), distance: errors(), horizon: errors() }
    }

    /// Compares an image with its label, if it has one.
    pub fn count(&mut self, seen: &Sighting, pose: Option<&Pose>) {
        if let Some((pose, row)) = pose.and_then(|pose| Some((pose, pose.horizon?))) {
            let by_pose = pose.camera(HORIZON_WIDTH, HORIZON_HEIGHT).horizon(HORIZON_COLUMN);
            self.horizon.note(by_pose.map_or(f32::INFINITY, |by_pose| (by_pose - row).abs()));
        }
        let Some(label) = self.labels.get(&seen.file).cloned() else { return };
        self.sum.labelled += 1;
        self.sum.goals.count(seen, label.goal.as_ref());
        self.count_ball(seen, &label);
    }

    fn count_ball(&mut self, seen: &Sighting, label: &Label) {
        let found = seen.ball.as_ref().and_then(|ball| nearest(ball, label));
        let is_right = found.is_some_and(|(_, error, allowed)| error <= allowed);
        if label.balls.iter().any(|ball| ball.orange && ball.full) {
            self.sum.recall.count(is_right);
            self.sum.missed.extend((!is_right).then(|| seen.file.clone()));
            if let Some((_, error, _)) = found {
                self.sum.near.count(is_right);
                self.centre.note(error);
            }
        }
        if let Some(ball) = &seen.ball {
            self.sum.precision.count(is_right);
            self.sum.wrong.extend((!is_right).then(|| format!("{} ({:.0}, {:.0})", seen.file, ball.x, ball.y)));
            if let Some(camera) = seen.camera.as_ref().filter(|_| is_right) {
                let error = distance_error(ball, camera, self.radius);
                self.sum.same_distance.count(error <= SAME_DISTANCE);
                self.distance.note(error);
            }
        }
    }

    /// Tells how much was right.
    pub fn tell(&mut self, console: Console) -> Result<(), Failure> {
        self.sum.centre_px = self.centre.spread();
        self.sum.distance = self.distance.spread();
        self.sum.horizon_px = self.horizon.spread();
        let sum = &self.sum;
        let list = |names: &[String]| names.join(", ");
        let rows = [
            ("labelled", format!("{} images", sum.labelled)),
            ("ball recall", format!("{}  {}", sum.recall, list(&sum.missed))),
            ("  precision", format!("{}  {}", sum.precision, list(&sum.wrong))),
            ("  centre", sum.centre_px.words(1.0, "px")),
            ("  near", format!("{} within 3 px or half the radius", sum.near)),
            ("goals", format!("{}  {}", sum.goals.complete, list(&sum.goals.missed))),
            ("  partial", format!("{}  {}", sum.goals.partial, list(&sum.goals.missed_partial))),
            ("  none there", format!("{}  {}", sum.goals.without, list(&sum.goals.wrong))),
            ("distance", sum.distance.words(100.0, "%")),
            ("  near", format!("{} within 12 %", sum.same_distance)),
            ("horizon", sum.horizon_px.words(1.0, "px")),
        ];
        console.print("")?;
        rows.iter().try_for_each(|(name, words)| console.print_row(name, words.trim_end()))?;
        console.print_json_line(&Line { score: sum })
    }
}

/// The orange ball nearest to a seen one, how far it is, and how far it may be; px.
fn nearest<'a>(ball: &Ball, label: &'a Label) -> Option<(&'a labels::Ball, f32, f32)> {
    let orange = label.balls.iter().filter(|ball| ball.orange);
    let far = |label: &'a labels::Ball| (label, label.centre.distance(Vec2::new(ball.x, ball.y)), near(label));
    orange.map(far).min_by(|a, b| a.1.total_cmp(&b.1))
}

fn near(label: &labels::Ball) -> f32 {
    (0.5 * label.radius).max(3.0)
}

/// By how much the distance of the ball by projection to the ground differs from that by its radius, as a part.
fn distance_error(ball: &Ball, camera: &Camera, radius: f32) -> f32 {
    let centre = Vec2::new(ball.x, ball.y);
    let by_pose = camera.ground(centre, radius).map(|at| at.extend(radius).distance(camera.pose().translation.into()));
    let by_size = camera.distance_by_radius(centre, ball.radius, radius);
    by_pose.zip(by_size).map_or(f32::INFINITY, |(pose, size)| (pose / size - 1.0).abs())
}
