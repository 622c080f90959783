//! Least squares: offsets with which detected lines lie on those of the field.

use bica_motion::joints::Joints;
use bica_motion::pose::Pose2;
use bica_motion::robot::CameraId;
use bica_vision::lines::Line;
use bica_vision::projection::Camera;
use glam::Vec2;
use nalgebra::{SMatrix, SVector};

use super::field_lines::FieldLine;
use super::offsets::{ANGLES, Offsets};

/// Distance of an error that counts no further, px in an image 320 px wide.
const LIMIT: f32 = 10.0;
/// Largest error of a point that is on its line, px in an image 320 px wide.
const ON_LINE: f32 = 2.0;
/// Farthest point that is used, m.
const FARTHEST: f32 = 4.5;
/// Distance of the points on a detected line, px in an image 320 px wide.
const STEP: f32 = 8.0;
/// Largest angle between a detected line and its line of the field, rad.
const SKEW: f32 = 0.35;
/// Standard deviation of the angles before a measurement, rad: it settles what the images leave open.
const PRIOR: f32 = 0.05;
/// Angles at which the search begins, rad: tilt, then roll and pan.
const TILTS: [f32; 5] = [-0.07, -0.035, 0.0, 0.035, 0.07];
const TURNS: [f32; 3] = [-0.05, 0.0, 0.05];
/// Number of starts that are followed, and of steps of each.
const STARTS: usize = 3;
const STEPS: usize = 25;
/// Difference of an angle for derivatives, rad.
const DIFFERENCE: f32 = 1e-3;

/// Lines of one image.
#[derive(Clone, Debug)]
pub struct View {
    /// Source of the image.
    pub camera: CameraId,
    /// Its size, px.
    pub size: (u16, u16),
    /// Measured joint angles, rad.
    pub angles: Joints,
    /// Detected lines, px.
    pub lines: Vec<Line>,
}

/// How well detected lines lie on those of the field.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Residual {
    /// Root mean square of the distances of points from their lines, px in an image 320 px wide; each counts at most 10.
    pub rms: f32,
    /// Share of the points at most 2 px away from their lines, 0 to 1.
    pub on_line: f32,
}

/// Line with the line of the field that it shows.
struct Pair<'a> {
    view: &'a View,
    seen: &'a Line,
    /// `None`: no line of the field is near, or has this direction.
    line: Option<FieldLine>,
}

/// Fit of offsets to the views of a robot that stands at a known pose.
pub(super) struct Fit<'a> {
    views: &'a [View],
    pose: Pose2,
    lines: Vec<FieldLine>,
}

impl<'a> Fit<'a> {
    /// `pose`: the ground frame between the robot's feet in the field frame.
    pub(super) fn new(views: &'a [View], pose: Pose2) -> Self {
        Self { views, pose, lines: FieldLine::all() }
    }

    /// Returns the offsets with the least error.
    pub(super) fn solve(&self) -> Offsets {
        let turns = TURNS.into_iter().flat_map(|roll| TURNS.map(|pan| (roll, pan)));
        let starts = turns.flat_map(|(roll, pan)| TILTS.map(|tilt| [roll, tilt, pan]));
        let mut starts: Vec<_> = starts.map(|angles| Offsets::new(angles, angles, [0.0; 2])).collect();
        starts.sort_by(|one, other| self.residual(one).rms.total_cmp(&self.residual(other).rms));
        let solved = starts.into_iter().take(STARTS).map(|start| (0..STEPS).fold(start, |at, _| self.step(&at)));
        let best = solved.min_by(|one, other| self.residual(one).rms.total_cmp(&self.residual(other).rms));
        best.unwrap_or_default()
    }

    /// Returns how well the lines fit with these offsets.
    pub(super) fn residual(&self, offsets: &Offsets) -> Residual {
        let errors = self.pairs(offsets).into_iter().flat_map(|pair| self.errors(&pair, offsets));
        let errors: Vec<f32> = errors.map(|error| error.map_or(LIMIT, |error| error.abs().min(LIMIT))).collect();
        let count = errors.len().max(1) as f32;
        let on_line = errors.iter().filter(|error| **error <= ON_LINE).count() as f32;
        let squares: f32 = errors.iter().map(|error| error * error).sum();
        Residual { rms: (squares / count).sqrt(), on_line: on_line / count }
    }

    /// One step of Gauss and Newton, with weights that fall to zero at the limit (Tukey's biweight).
    fn step(&self, at: &Offsets) -> Offsets {
        let weight = PRIOR.powi(-2);
        let mut normal = SMatrix::<f32, ANGLES, ANGLES>::from_diagonal_element(weight);
        let mut gradient = at.0 * weight;
        let moved: Vec<Offsets> = (0..ANGLES)
            .map(|index| {
                let mut moved = *at;
                moved.0[index] += DIFFERENCE;
                moved
            })
            .collect();
        for pair in self.pairs(at).iter().filter(|pair| pair.line.is_some()) {
            let errors = self.errors(pair, at);
            let columns: Vec<_> = moved.iter().map(|moved| self.errors(pair, moved)).collect();
            for (point, error) in errors.iter().enumerate() {
                let Some(error) = error.filter(|error| error.abs() < LIMIT) else { continue };
                let row: Option<Vec<f32>> = columns.iter().map(|column| column[point]).collect();
                let Some(row) = row else { continue };
                let row = SVector::<f32, ANGLES>::from_iterator(row).map(|other| (other - error) / DIFFERENCE);
                let weight = (1.0 - (error / LIMIT).powi(2)).powi(2);
                normal += weight * row * row.transpose();
                gradient += weight * error * row;
            }
        }
        let change = normal.cholesky().map(|normal| normal.solve(&gradient)).unwrap_or_default();
        Offsets(at.0 - change)
    }

    /// Finds the line of the field for each detected line.
    fn pairs(&self, offsets: &Offsets) -> Vec<Pair<'a>> {
        let pair = |view: &'a View, seen: &'a Line| {
            let camera = offsets.camera(view.camera, &view.angles, view.size);
            let [from, to] = [seen.from, seen.to].map(|pixel| self.place(&camera, pixel));
            let line = from.zip(to).and_then(|(from, to)| self.nearest(from, to));
            Pair { view, seen, line }
        };
        self.views.iter().flat_map(|view| view.lines.iter().map(move |seen| pair(view, seen))).collect()
    }

    fn nearest(&self, from: Vec2, to: Vec2) -> Option<FieldLine> {
        let middle = from.midpoint(to);
        let direction = (to - from).normalize_or_zero();
        let is_along = |line: &&FieldLine| line.side(middle).1.dot(direction).abs() <= SKEW.sin();
        let far = |line: &FieldLine| [from, middle, to].map(|point| line.distance(point)).iter().sum::<f32>();
        self.lines.iter().filter(is_along).min_by(|one, other| far(one).total_cmp(&far(other))).copied()
    }

    /// Distances of the points of a detected line from its line of the field, px in an image 320 px wide; `None` for those that do not
    /// count.
    fn errors(&self, pair: &Pair<'_>, offsets: &Offsets) -> Vec<Option<f32>> {
        let Pair { view, seen, line } = pair;
        let camera = offsets.camera(view.camera, &view.angles, view.size);
        let scale = 320.0 / f32::from(view.size.0);
        let count = (scale * seen.length() / STEP) as u32 + 1;
        let across = (seen.to - seen.from).perp().normalize_or_zero();
        let error = |index| {
            let pixel = seen.from.lerp(seen.to, (index as f32 + 0.5) / count as f32);
            let (place, beside) = (self.place(&camera, pixel)?, self.place(&camera, pixel + across)?);
            let (distance, normal) = line.as_ref()?.side(place);
            let of_a_pixel = (beside - place).dot(normal);
            let error = scale * distance / of_a_pixel;
            error.is_finite().then_some(error)
        };
        (0..count).map(error).collect()
    }

    /// Place of a pixel on the ground, field frame, m.
    fn place(&self, camera: &Camera, pixel: Vec2) -> Option<Vec2> {
        let ground = camera.ground(pixel, 0.0).filter(|ground| ground.length() <= FARTHEST)?;
        Some(self.pose.place(ground))
    }
}
