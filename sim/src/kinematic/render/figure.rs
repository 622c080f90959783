//! Solids and colours of robots.

use bica_motion::kinematics::Skeleton;
use bica_motion::model::simulation::{Disc, Figure, Paint, Part, SimulatedModel, Solid as Shape};
use bica_motion::side::Side;
use glam::{Affine3A, Vec2, Vec3};

use super::solid::Solid;
use crate::camera::canvas::Pixel;
use crate::camera::palette::{self, Palette};
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

/// Returns the solids of a robot with the robot frame at a pose in the field frame.
pub(crate) fn figure<M: SimulatedModel>(robot: &Affine3A, skeleton: &Skeleton<M>, colours: RobotColours) -> Vec<Solid> {
    let mut figure = below_the_head(robot, skeleton, colours);
    figure.extend(M::FIGURE.head.iter().map(|part| placed(part, robot, skeleton, colours)));
    figure
}

/// Returns the solids of a robot that its own cameras can show.
pub(crate) fn below_the_head<M: SimulatedModel>(
    robot: &Affine3A,
    skeleton: &Skeleton<M>,
    colours: RobotColours,
) -> Vec<Solid> {
    let Figure { trunk, side, .. } = M::FIGURE;
    let right = side.iter().map(Part::mirrored);
    let parts = trunk.iter().chain(*side).copied().chain(right);
    parts.map(|part| placed(&part, robot, skeleton, colours)).collect()
}

/// Converts a part to the field frame.
fn placed<M: SimulatedModel>(part: &Part, robot: &Affine3A, skeleton: &Skeleton<M>, colours: RobotColours) -> Solid {
    let pose = *robot * skeleton.pose(part.segment);
    let at = |point: [f32; 3]| pose.transform_point3(point.into());
    let colour = match part.paint {
        Paint::Shell => colours.shell,
        Paint::Joint => colours.joint,
        Paint::Team => colours.team,
    };
    match part.solid {
        Shape::Sphere(centre, radius) => Solid::Sphere { centre: at(centre), radius, colour },
        Shape::Tube(ends, radii) => Solid::Tube { ends: ends.map(at), radii, colour },
        Shape::Block(centre, half) => {
            Solid::Block { pose: pose * Affine3A::from_translation(centre.into()), half: half.into(), colour }
        }
    }
}

/// Returns the shadows under a robot's feet.
pub(crate) fn shadows<M: SimulatedModel>(robot: &Affine3A, skeleton: &Skeleton<M>) -> [Solid; 2] {
    let Disc { ahead, radius } = M::FIGURE.foot_shadow;
    Side::BOTH.map(|side| {
        let sole = *robot * skeleton.sole(side);
        let centre: Vec2 = sole.transform_point3(Vec3::new(ahead, 0.0, 0.0)).truncate();
        Solid::Shadow { centre, radius, darkness: 0.45 }
    })
}
