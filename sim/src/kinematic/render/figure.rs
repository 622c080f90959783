//! Solids and colours of robots.

use bica_motion::kinematics::{SEGMENTS, Segment, Skeleton};
use bica_motion::model::simulation::{Disc, Figure, Paint, Part, SimulatedModel, Solid as Shape};
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};

use super::solid::Solid;
use crate::camera::canvas::Pixel;
use crate::camera::palette::{self, Palette};
use bica_body::transform::level_pose;
use bica_field::GoalColour;

/// Colours of a robot's parts.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RobotColours {
    shell: Pixel,
    joint: Pixel,
    team: Pixel,
}

impl RobotColours {
    /// Returns the colours of the team that defends a goal: red for yellow, blue for sky-blue (rules of 2009).
    pub(crate) fn of_defender(goal: GoalColour, palette: &Palette) -> Self {
        let team = match goal {
            GoalColour::Yellow => palette::RED_TEAM,
            GoalColour::SkyBlue => palette::BLUE_TEAM,
        };
        let [shell, joint, team] = [palette::SHELL, palette::JOINT, team].map(|colour| palette.pixel(colour));
        Self { shell, joint, team }
    }
}

/// A robot in a posture at a place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct PosedRobot {
    figure: &'static Figure,
    /// Robot frame in the field frame.
    pub(crate) robot: Affine3A,
    /// Segments in the order of [`Segment::ALL`](bica_motion::kinematics::Segment::ALL), field frame.
    segments: [Affine3A; SEGMENTS],
    /// Soles in the field frame, left first.
    soles: [Affine3A; 2],
}

impl PosedRobot {
    /// Returns a robot with this pose of the robot frame in the field frame.
    pub(crate) fn new(model: &'static SimulatedModel, robot: Affine3A, skeleton: &Skeleton) -> Self {
        let segments = Segment::ALL.map(|segment| robot * skeleton.pose(segment));
        let soles = Side::BOTH.map(|side| robot * skeleton.sole(side));
        Self { figure: model.figure, robot, segments, soles }
    }

    /// Returns a robot that stands on the ground.
    pub(crate) fn standing(model: &'static SimulatedModel, at: &Pose2) -> Self {
        let skeleton = Skeleton::of(model, &model.stand);
        let sole = skeleton.sole(Side::Left);
        let robot = level_pose(at) * Affine3A::from_translation(Vec3::new(0.0, 0.0, -sole.translation.z));
        Self::new(model, robot, &skeleton)
    }

    /// Returns all solids, field frame.
    pub(crate) fn solids(&self, colours: RobotColours) -> Vec<Solid> {
        let mut solids = self.below_the_head(colours);
        solids.extend(self.figure.head.iter().map(|part| self.solid(part, colours)));
        solids
    }

    /// Returns the solids that the robot's own cameras can show, field frame.
    pub(crate) fn below_the_head(&self, colours: RobotColours) -> Vec<Solid> {
        let Figure { trunk, side, .. } = self.figure;
        let right = side.iter().map(Part::mirrored);
        let parts = trunk.iter().chain(*side).copied().chain(right);
        parts.map(|part| self.solid(&part, colours)).collect()
    }

    /// Converts a part to the field frame.
    fn solid(&self, &Part(segment, paint, solid): &Part, colours: RobotColours) -> Solid {
        let pose = self.segments[segment.index()];
        let at = |point: [f32; 3]| pose.transform_point3(point.into());
        let colour = match paint {
            Paint::Shell => colours.shell,
            Paint::Joint => colours.joint,
            Paint::Team => colours.team,
        };
        match solid {
            Shape::Sphere(centre, radius) => Solid::Sphere { centre: at(centre), radius, colour },
            Shape::Tube(ends, radii) => Solid::Tube { ends: ends.map(at), radii, colour },
            Shape::Block(centre, half) => {
                Solid::Block { pose: pose * Affine3A::from_translation(centre.into()), half: half.into(), colour }
            }
        }
    }

    /// Returns the shadows under the feet.
    pub(crate) fn shadows(&self) -> [Solid; 2] {
        let Disc { ahead, radius } = self.figure.foot_shadow;
        self.soles.map(|sole| {
            let centre: Vec2 = sole.transform_point3(Vec3::new(ahead, 0.0, 0.0)).truncate();
            Solid::Shadow { centre, radius, darkness: 0.45 }
        })
    }
}
