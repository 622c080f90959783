//! What the eyes see in one image.

use std::f32::consts::TAU;
use std::time::Instant;

use bica_field::{CrossingKind, FIELD, GoalColour};
use bica_motion::robot::{CameraId, Image};
use bica_vision::centre_circle::CentreCircle;
use bica_vision::crossings;
use bica_vision::frame::Frame;
use bica_vision::own_body::OwnBody;
use bica_vision::pipeline::{self, Detections};
use bica_vision::projection::Camera;
use bica_vision::robots::{self, Team};
use bica_vision::table::FullTable;
use glam::Vec2;
use serde::Serialize;

use super::colour_table::Palette;
use crate::camera_poses::Pose;
use bica_drawing::scene::Marks;

/// The camera that a NAO of 2009 looks through: files of poses are theirs.
const SEES: CameraId = CameraId::Bottom;

/// The detectors, with the colours and the ball that they look for.
pub struct Eyes {
    palette: Palette,
    /// Radius of the ball, m.
    radius: f32,
    detectors: pipeline::Pipeline<512, 512>,
}

/// An image for machines. Pixels: x right, y down, centre of the first pixel (0, 0).
#[derive(Clone, Debug, Serialize)]
pub struct Sighting {
    pub file: String,
    pub pose: Trust,
    pub ball: Option<Ball>,
    pub goals: Vec<Goal>,
    /// The corners of the line, from the left.
    pub field_boundary: Vec<[f32; 2]>,
    /// White lines: one end, the other end.
    pub lines: Vec<[f32; 4]>,
    pub robots: Vec<Robot>,
    /// Where lines cross; none without a trusted pose.
    pub crossings: Vec<Crossing>,
    /// The middle of the centre circle, m ahead and to the left; none without a trusted pose.
    pub circle: Option<[f32; 2]>,
    /// Time that the detectors took, ms.
    pub wall_ms: f64,
    /// The camera, if its pose is trusted.
    #[serde(skip)]
    pub camera: Option<Camera>,
    #[serde(skip)]
    pub marks: Marks,
}

/// What is known of the camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum Trust {
    /// Distances can be had.
    Trusted,
    /// There is a pose, but not one to rely on.
    Untrusted,
    /// There is no pose for this image.
    Missing,
}

/// A ball for machines.
#[derive(Clone, Debug, Serialize)]
pub struct Ball {
    pub x: f32,
    pub y: f32,
    pub radius: f32,
    pub confidence: f32,
    /// Where it lies, m ahead and to the left; none without a trusted pose.
    pub ground: Option<[f32; 2]>,
}

/// A goal for machines.
#[derive(Clone, Debug, Serialize)]
pub struct Goal {
    pub colour: &'static str,
    pub x0: f32,
    pub y0: f32,
    pub x1: f32,
    pub y1: f32,
    pub complete: bool,
    /// Where its middle is, m ahead and to the left; none without a trusted pose.
    pub ground: Option<[f32; 2]>,
}

/// Another robot for machines.
#[derive(Clone, Debug, Serialize)]
pub struct Robot {
    x0: f32,
    y0: f32,
    x1: f32,
    y1: f32,
    /// Its colour, if that shows.
    team: Option<&'static str>,
    /// Where it stands, m ahead and to the left; none without a trusted pose.
    ground: Option<[f32; 2]>,
}

/// A crossing of lines for machines.
#[derive(Clone, Debug, Serialize)]
pub struct Crossing {
    kind: &'static str,
    x: f32,
    y: f32,
    /// Where it is, m ahead and to the left.
    ground: [f32; 2],
}

impl Eyes {
    /// Opens them for a ball of `radius` metres.
    pub fn new(palette: Palette, radius: f32) -> Self {
        Self { palette, radius, detectors: pipeline::Pipeline::new(radius) }
    }

    /// Looks at an image; says why if it is none for these eyes.
    pub fn look(&mut self, file: &str, image: &Image<'_>, pose: Option<&Pose>) -> Result<Sighting, String> {
        let frame = Frame::from_image(image).map_err(|error| error.to_string())?;
        let trusted = pose.filter(|pose| pose.trusted);
        let camera = trusted.map(|pose| pose.camera(frame.width().into(), frame.height().into()));
        let camera = camera.as_ref();
        let began = Instant::now();
        let own = camera.map_or(OwnBody::NONE, |camera| OwnBody::standing(camera, SEES));
        let seen = match &self.palette {
            Palette::Compact(table) => self.detectors.detect_with_body(&frame, &**table, camera, &own),
            Palette::Full(cells) => self.detectors.detect_with_body(&frame, &FullTable::from(&**cells), camera, &own),
        };
        let wall_ms = 1e3 * began.elapsed().as_secs_f64();
        let mut sighting = self.tell(file, pose, camera, seen, wall_ms);
        sighting.marks.own = own;
        Ok(sighting)
    }

    fn tell(
        &self,
        file: &str,
        pose: Option<&Pose>,
        camera: Option<&Camera>,
        seen: Detections,
        wall_ms: f64,
    ) -> Sighting {
        let Detections { end, ball, goals, lines, robots, markings } = seen;
        let goals: Vec<_> = [goals.yellow, goals.blue].into_iter().flatten().collect();
        Sighting {
            file: file.to_owned(),
            pose: match pose {
                None => Trust::Missing,
                Some(pose) if pose.trusted => Trust::Trusted,
                Some(_) => Trust::Untrusted,
            },
            ball: ball.map(|ball| Ball::new(&ball, camera, self.radius)),
            goals: goals.iter().map(|goal| Goal::new(goal, camera)).collect(),
            field_boundary: end.corners().iter().map(Vec2::to_array).collect(),
            lines: lines.iter().map(|line| [line.from.x, line.from.y, line.to.x, line.to.y]).collect(),
            robots: robots.iter().map(|robot| Robot::new(robot, camera)).collect(),
            crossings: markings.crossings.iter().map(Crossing::new).collect(),
            circle: markings.circle.map(|circle| circle.centre.to_array()),
            wall_ms,
            camera: camera.copied(),
            marks: Marks {
                ball,
                goals,
                field_boundary: end.corners().to_vec(),
                lines: lines.to_vec(),
                robots: robots.to_vec(),
                crossings: markings.crossings.to_vec(),
                circle: markings.circle.zip(camera).map_or(Vec::new(), |(circle, camera)| outline(&circle, camera)),
                own: OwnBody::NONE,
            },
        }
    }
}

impl Ball {
    fn new(ball: &bica_vision::ball::Ball, camera: Option<&Camera>, metres: f32) -> Self {
        let ground = camera.and_then(|camera| ball.ground(camera, metres)).map(|at| at.to_array());
        Self { x: ball.centre.x, y: ball.centre.y, radius: ball.radius, confidence: ball.confidence, ground }
    }
}

impl Crossing {
    fn new(crossing: &crossings::Crossing) -> Self {
        let kind = match crossing.kind {
            CrossingKind::L => "L",
            CrossingKind::T => "T",
            CrossingKind::X => "X",
        };
        Self { kind, x: crossing.at.x, y: crossing.at.y, ground: crossing.ground.position.to_array() }
    }
}

/// Points on a circle in the image, px, one after the other.
fn outline(circle: &CentreCircle, camera: &Camera) -> Vec<Vec2> {
    let points = (0..=72_u8)
        .map(|step| circle.centre + FIELD.centre_circle_radius() * Vec2::from_angle(f32::from(step) * TAU / 72.0));
    points.filter_map(|point| camera.pixel(point.extend(0.0))).collect()
}

impl Robot {
    fn new(robot: &robots::Robot, camera: Option<&Camera>) -> Self {
        let ground = camera.and_then(|camera| robot.ground(camera)).map(|at| at.to_array());
        let team = robot.team.map(|team| if team == Team::Red { "red" } else { "blue" });
        let (min, max) = (robot.min, robot.max);
        Self { x0: min.x, y0: min.y, x1: max.x, y1: max.y, team, ground }
    }
}

impl Goal {
    fn new(goal: &bica_vision::goal::Goal, camera: Option<&Camera>) -> Self {
        let colour = if goal.colour == GoalColour::Yellow { "yellow" } else { "blue" };
        let ground = camera.and_then(|camera| goal.ground(camera)).map(|at| at.to_array());
        let (min, max) = (goal.min, goal.max);
        Self { colour, x0: min.x, y0: min.y, x1: max.x, y1: max.y, complete: goal.is_complete(), ground }
    }
}
