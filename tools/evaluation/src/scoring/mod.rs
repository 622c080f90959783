//! Detections compared with labels.

mod goals;
mod tally;

use bica_app::{Console, Failure};
use bica_vision::projection::Camera;
use glam::Vec2;
use serde::Serialize;

use crate::camera_poses::Pose;
use crate::detection::{Ball, Detections};
use crate::labels::{self, Label, Labels};
use goals::Goals;
use tally::{Errors, Percentiles, Share};

/// Width of the images to which the horizon in pose files refers, px.
const HORIZON_WIDTH: usize = 320;
const HORIZON_HEIGHT: usize = 240;
/// Column of that horizon, px.
const HORIZON_COLUMN: f32 = 159.5;
/// Largest relative difference between two measurements of a distance that count as equal.
const SAME_DISTANCE: f32 = 0.12;

/// Score of detections, image by image.
#[derive(Debug)]
pub struct Score {
    labels: Labels,
    /// Radius of the ball, m.
    radius: f32,
    figures: Figures,
    centre: Errors,
    distance: Errors,
    horizon: Errors,
}

/// Figures of a score. A detected ball is correct if its distance from a labelled orange ball is at most 3 px, or half
/// the radius if that is more.
#[derive(Debug, Default, Serialize)]
struct Figures {
    /// Number of images with labels.
    labelled: usize,
    /// Images with a full orange ball; good if a correct ball is detected.
    recall: Share,
    /// Detected balls; good if correct.
    precision: Share,
    /// Balls detected in images with a full ball; good if correct.
    near: Share,
    /// Error of the centre of the balls in images with a full ball, px.
    centre_px: Percentiles,
    missed: Vec<String>,
    wrong: Vec<String>,
    goals: Goals,
    /// Correct balls; good if their distances by projection and by radius differ by at most 12 %.
    same_distance: Share,
    /// Relative difference of these distances.
    distance: Percentiles,
    /// Difference between the row of the horizon computed from the pose and the row in the file, px.
    horizon_px: Percentiles,
}

/// Recall and precision of one kind of object.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScoreRow {
    /// `ball`, `goal` or `partial goal`.
    pub object: &'static str,
    /// Fraction of the labelled objects that were detected; `None` without labelled objects.
    pub recall: Option<f32>,
    /// Fraction of the detections that are correct; `None` without detections.
    pub precision: Option<f32>,
    /// Number of images that show such an object.
    pub images: usize,
    /// Images in which the object was missed.
    pub missed: Vec<String>,
    /// Images with a wrong detection.
    pub wrong: Vec<String>,
}

#[derive(Serialize)]
struct Line<'a> {
    score: &'a Figures,
}

impl Score {
    /// Creates a score without images, for a ball of `radius` metres.
    #[must_use]
    pub fn new(labels: Labels, radius: f32) -> Self {
        let errors = Errors::default;
        Self { labels, radius, figures: Figures::default(), centre: errors(), distance: errors(), horizon: errors() }
    }

    /// Compares an image with its label, if it has one.
    pub fn count(&mut self, seen: &Detections, pose: Option<&Pose>) {
        if let Some((pose, row)) = pose.and_then(|pose| Some((pose, pose.horizon?))) {
            let by_pose = pose.camera(HORIZON_WIDTH, HORIZON_HEIGHT).horizon(HORIZON_COLUMN);
            self.horizon.note(by_pose.map_or(f32::INFINITY, |by_pose| (by_pose - row).abs()));
        }
        let Some(label) = self.labels.get(&seen.file).cloned() else { return };
        self.figures.labelled += 1;
        self.figures.goals.count(seen, label.goal.as_ref());
        self.count_ball(seen, &label);
    }

    fn count_ball(&mut self, seen: &Detections, label: &Label) {
        let found = seen.ball.as_ref().and_then(|ball| nearest(ball, label));
        let is_right = found.is_some_and(|(_, error, allowed)| error <= allowed);
        if label.balls.iter().any(|ball| ball.orange && ball.full) {
            self.figures.recall.count(is_right);
            self.figures.missed.extend((!is_right).then(|| seen.file.clone()));
            if let Some((_, error, _)) = found {
                self.figures.near.count(is_right);
                self.centre.note(error);
            }
        }
        if let Some(ball) = &seen.ball {
            self.figures.precision.count(is_right);
            self.figures.wrong.extend((!is_right).then(|| format!("{} ({:.0}, {:.0})", seen.file, ball.x, ball.y)));
            if let Some(camera) = seen.camera.as_ref().filter(|_| is_right) {
                let error = distance_error(ball, camera, self.radius);
                self.figures.same_distance.count(error <= SAME_DISTANCE);
                self.distance.note(error);
            }
        }
    }

    /// Returns recall and precision of balls and goals.
    #[must_use]
    pub fn rows(&self) -> [ScoreRow; 3] {
        let Figures { recall, precision, missed, wrong, goals, .. } = &self.figures;
        let row = |object, recall: &Share, precision: Option<f32>, missed: &[String], wrong: &[String]| ScoreRow {
            object,
            recall: recall.ratio(),
            precision,
            images: recall.of,
            missed: missed.to_vec(),
            wrong: wrong.to_vec(),
        };
        // A goal of the wrong colour, or a detection in an image without a goal, is wrong.
        let found = goals.complete.good + goals.partial.good;
        let of_goals = Share { of: found + goals.wrong.len(), good: found }.ratio();
        [
            row("ball", recall, precision.ratio(), missed, wrong),
            row("goal", &goals.complete, of_goals, &goals.missed, &goals.wrong),
            row("partial goal", &goals.partial, of_goals, &goals.missed_partial, &[]),
        ]
    }

    /// Prints the figures.
    ///
    /// # Errors
    /// If the output cannot be written.
    pub fn print(&mut self, console: Console) -> Result<(), Failure> {
        self.figures.centre_px = self.centre.spread();
        self.figures.distance = self.distance.spread();
        self.figures.horizon_px = self.horizon.spread();
        let figures = &self.figures;
        let list = |names: &[String]| names.join(", ");
        let rows = [
            ("labelled", format!("{} images", figures.labelled)),
            ("ball recall", format!("{}  {}", figures.recall, list(&figures.missed))),
            ("  precision", format!("{}  {}", figures.precision, list(&figures.wrong))),
            ("  centre", figures.centre_px.text(1.0, "px")),
            ("  near", format!("{} within 3 px or half the radius", figures.near)),
            ("goals", format!("{}  {}", figures.goals.complete, list(&figures.goals.missed))),
            ("  partial", format!("{}  {}", figures.goals.partial, list(&figures.goals.missed_partial))),
            ("  absent", format!("{}  {}", figures.goals.without, list(&figures.goals.wrong))),
            ("distance", figures.distance.text(100.0, "%")),
            ("  near", format!("{} within 12 %", figures.same_distance)),
            ("horizon", figures.horizon_px.text(1.0, "px")),
        ];
        console.print("")?;
        rows.iter().try_for_each(|(name, words)| console.print_row(name, words.trim_end()))?;
        console.print_json_line(&Line { score: figures })
    }
}

/// Labelled orange ball nearest to a detected ball, its distance, and the largest allowed distance, px.
fn nearest<'a>(ball: &Ball, label: &'a Label) -> Option<(&'a labels::Ball, f32, f32)> {
    let orange = label.balls.iter().filter(|ball| ball.orange);
    let far = |label: &'a labels::Ball| (label, label.centre.distance(Vec2::new(ball.x, ball.y)), near(label));
    orange.map(far).min_by(|a, b| a.1.total_cmp(&b.1))
}

fn near(label: &labels::Ball) -> f32 {
    (0.5 * label.radius).max(3.0)
}

/// Relative difference between the ball's distances by projection and by radius.
fn distance_error(ball: &Ball, camera: &Camera, radius: f32) -> f32 {
    let centre = Vec2::new(ball.x, ball.y);
    let by_pose = camera.ground(centre, radius).map(|at| at.extend(radius).distance(camera.pose().translation.into()));
    let by_size = camera.distance_by_radius(centre, ball.radius, radius);
    by_pose.zip(by_size).map_or(f32::INFINITY, |(pose, size)| (pose / size - 1.0).abs())
}
