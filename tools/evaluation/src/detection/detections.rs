//! Detections in one image.

use std::f32::consts::TAU;
use std::time::Instant;

use crate::pictures::Marks;
use bica_field::{CrossingKind, FIELD, GoalColour};
use bica_motion::model::NAO;
use bica_motion::robot::{CameraId, Image};
use bica_vision::centre_circle::CentreCircle;
use bica_vision::crossings;
use bica_vision::frame::Frame;
use bica_vision::own_body::OwnBody;
use bica_vision::pipeline;
use bica_vision::projection::Camera;
use bica_vision::robots::{self, Team};
use bica_vision::table::FullTable;
use glam::Vec2;
use serde::Serialize;

use super::colour_table::ColourTable;
use crate::camera_poses::Pose;

/// Camera of the recordings with poses, a NAO of 2009; its image shows parts of the body.
const CAMERA: CameraId = CameraId::Bottom;

/// All detectors, with the colour table and the ball size.
#[derive(Debug)]
pub struct Detectors {
    colours: ColourTable,
    /// Radius of the ball, m.
    radius: f32,
    pipeline: pipeline::Pipeline<512, 512>,
}

/// Detections in an image. Pixels: x right, y down, the centre of the first pixel is (0, 0).
#[derive(Clone, Debug, Serialize)]
pub struct Detections {
    /// Name of the image.
    pub file: String,
    /// Availability of the camera pose.
    pub pose: PoseTrust,
    /// The ball.
    pub ball: Option<Ball>,
    /// Detected goals.
    pub goals: Vec<Goal>,
    /// Corners of the field boundary, from left to right.
    #[serde(rename = "field_end")]
    pub field_boundary: Vec<[f32; 2]>,
    /// White lines: `[x0, y0, x1, y1]` from end to end.
    pub lines: Vec<[f32; 4]>,
    /// Other robots.
    pub robots: Vec<Robot>,
    /// Crossings of lines; none without a trusted pose.
    pub crossings: Vec<Crossing>,
    /// Centre of the centre circle, m ahead and to the left; none without a trusted pose.
    pub circle: Option<[f32; 2]>,
    /// Computing time of the detectors, ms.
    pub wall_ms: f64,
    /// Camera, if its pose is trusted.
    #[serde(skip)]
    pub camera: Option<Camera>,
    /// The same detections for a picture.
    #[serde(skip)]
    pub marks: Marks,
}

/// Camera pose of an image.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum PoseTrust {
    /// There is a pose that is accurate enough for distances.
    Trusted,
    /// There is a pose, but it is not accurate enough for distances.
    Untrusted,
    /// There is no pose.
    Missing,
}

/// Detected ball, px.
#[derive(Clone, Debug, Serialize)]
pub struct Ball {
    /// Centre.
    pub x: f32,
    /// Centre.
    pub y: f32,
    /// Radius.
    pub radius: f32,
    /// Confidence, 0 to 1.
    pub confidence: f32,
    /// Position, m ahead and to the left; none without a trusted pose.
    pub ground: Option<[f32; 2]>,
}

/// Detected goal with its bounding box, px.
#[derive(Clone, Debug, Serialize)]
pub struct Goal {
    /// `yellow` or `blue`.
    pub colour: &'static str,
    /// Left edge.
    pub x0: f32,
    /// Upper edge.
    pub y0: f32,
    /// Right edge.
    pub x1: f32,
    /// Lower edge.
    pub y1: f32,
    /// Whether both posts were found.
    pub complete: bool,
    /// Position of its centre, m ahead and to the left; none without a trusted pose.
    pub ground: Option<[f32; 2]>,
}

/// Detected robot with its bounding box, px.
#[derive(Clone, Debug, Serialize)]
pub struct Robot {
    x0: f32,
    y0: f32,
    x1: f32,
    y1: f32,
    /// Colour of its team, if visible.
    team: Option<&'static str>,
    /// Position, m ahead and to the left; none without a trusted pose.
    ground: Option<[f32; 2]>,
}

/// Detected crossing of lines, px.
#[derive(Clone, Debug, Serialize)]
pub struct Crossing {
    kind: &'static str,
    x: f32,
    y: f32,
    /// Position, m ahead and to the left.
    ground: [f32; 2],
}

impl Detectors {
    /// Detectors for a ball of `radius` metres.
    #[must_use]
    pub fn new(colours: ColourTable, radius: f32) -> Self {
        Self { colours, radius, pipeline: pipeline::Pipeline::new(radius) }
    }

    /// Runs the detectors on an image.
    ///
    /// # Errors
    /// If the image has a size that the detectors cannot process.
    pub fn detect(&mut self, file: &str, image: &Image<'_>, pose: Option<&Pose>) -> Result<Detections, String> {
        let frame = Frame::from_image(image).map_err(|error| error.to_string())?;
        let trusted = pose.filter(|pose| pose.trusted);
        let camera = trusted.map(|pose| pose.camera(frame.width().into(), frame.height().into()));
        let camera = camera.as_ref();
        let began = Instant::now();
        let own = camera.map_or(OwnBody::NONE, |camera| OwnBody::standing(NAO, camera, CAMERA));
        let seen = match &self.colours {
            ColourTable::Compact(table) => self.pipeline.detect_with_body(&frame, &**table, camera, &own),
            ColourTable::Full(cells) => {
                self.pipeline.detect_with_body(&frame, &FullTable::from(&**cells), camera, &own)
            }
        };
        let wall_ms = 1e3 * began.elapsed().as_secs_f64();
        let mut detections = self.collect(file, pose, camera, seen, wall_ms);
        detections.marks.own = own;
        Ok(detections)
    }

    fn collect(
        &self,
        file: &str,
        pose: Option<&Pose>,
        camera: Option<&Camera>,
        seen: pipeline::Detections,
        wall_ms: f64,
    ) -> Detections {
        let pipeline::Detections { boundary: end, ball, goals, lines, robots, markings } = seen;
        let goals: Vec<_> = [goals.yellow, goals.blue].into_iter().flatten().collect();
        Detections {
            file: file.to_owned(),
            pose: match pose {
                None => PoseTrust::Missing,
                Some(pose) if pose.trusted => PoseTrust::Trusted,
                Some(_) => PoseTrust::Untrusted,
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

/// Points on the centre circle in the image, px, in order.
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
