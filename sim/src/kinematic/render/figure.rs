//! Solids and colours of robots.

use bica_motion::kinematics::{Segment, Skeleton};
use bica_motion::model::{Nao, RobotModel};
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
pub(crate) fn figure(robot: &Affine3A, skeleton: &Skeleton, colours: RobotColours) -> Vec<Solid> {
    let mut figure = below_the_head(robot, skeleton, colours);
    let part = Part { pose: *robot * skeleton.pose(Segment::Head) };
    figure.push(part.sphere([-0.005, 0.0, 0.06], 0.062, colours.shell));
    figure.push(part.tube([[0.045, 0.0, 0.062], [0.058, 0.0, 0.062]], [0.03, 0.016], colours.joint));
    for side in Side::BOTH {
        let out = |y: f32| [-0.005, side.sign() * y, 0.06];
        figure.push(part.tube([out(0.05), out(0.068)], [0.03, 0.022], colours.team));
    }
    figure
}

/// Returns the solids of a robot that its own cameras can show.
pub(crate) fn below_the_head(robot: &Affine3A, skeleton: &Skeleton, colours: RobotColours) -> Vec<Solid> {
    let part = |segment| Part { pose: *robot * skeleton.pose(segment) };
    let torso = part(Segment::Torso);
    let mut figure = vec![
        torso.tube([[0.0, 0.0, -0.02], [0.0, 0.0, 0.035]], [0.045, 0.05], colours.joint),
        torso.tube([[0.0, 0.0, 0.035], [0.0, 0.0, 0.065]], [0.056, 0.056], colours.team),
        torso.tube([[0.0, 0.0, 0.065], [-0.005, 0.0, 0.185]], [0.054, 0.052], colours.shell),
        torso.tube([[-0.01, 0.0, 0.185], [-0.01, 0.0, 0.21]], [0.03, 0.022], colours.joint),
    ];
    for side in Side::BOTH {
        let y = side.sign();
        figure.push(torso.tube([[0.0, 0.03 * y, 0.165], [0.0, 0.075 * y, 0.18]], [0.04, 0.03], colours.shell));
        figure.extend(arm(side, part, colours));
        figure.extend(leg(side, part, colours));
    }
    figure
}

fn arm(side: Side, part: impl Fn(Segment) -> Part, colours: RobotColours) -> [Solid; 4] {
    let elbow = [Nao::DIMENSIONS.upper_arm.x, side.sign() * Nao::DIMENSIONS.upper_arm.y, 0.0];
    [
        part(Segment::Shoulder(side)).sphere([0.0, 0.0, 0.0], 0.036, colours.team),
        part(Segment::Biceps(side)).tube([[0.02, 0.0, 0.0], elbow], [0.028, 0.024], colours.shell),
        part(Segment::Forearm(side)).tube([[0.0, 0.0, 0.0], [0.085, 0.0, 0.0]], [0.026, 0.022], colours.shell),
        part(Segment::Hand(side)).sphere([0.055, 0.0, 0.005], 0.022, colours.joint),
    ]
}

fn leg(side: Side, part: impl Fn(Segment) -> Part, colours: RobotColours) -> [Solid; 6] {
    let foot = part(Segment::Foot(side));
    let y = side.sign() * 0.0065;
    [
        part(Segment::Thigh(side)).tube(
            [[0.0, 0.0, 0.0], [0.0, 0.0, -Nao::DIMENSIONS.thigh]],
            [0.042, 0.034],
            colours.shell,
        ),
        part(Segment::Tibia(side)).sphere([0.0, 0.0, 0.0], 0.033, colours.joint),
        part(Segment::Tibia(side)).tube(
            [[0.0, 0.0, -0.01], [0.0, 0.0, -Nao::DIMENSIONS.tibia]],
            [0.036, 0.034],
            colours.shell,
        ),
        part(Segment::Ankle(side)).sphere([0.0, 0.0, 0.0], 0.03, colours.joint),
        foot.block([0.006, y, 0.018 - Nao::DIMENSIONS.foot_height], [0.058, 0.042, 0.018], colours.shell),
        foot.tube(
            [[0.058, y, -Nao::DIMENSIONS.foot_height], [0.058, y, 0.034 - Nao::DIMENSIONS.foot_height]],
            [0.042, 0.036],
            colours.team,
        ),
    ]
}

/// A rigid segment of the body, field frame.
struct Part {
    pose: Affine3A,
}

impl Part {
    fn at(&self, point: [f32; 3]) -> Vec3 {
        self.pose.transform_point3(point.into())
    }

    fn sphere(&self, centre: [f32; 3], radius: f32, colour: Pixel) -> Solid {
        Solid::Sphere { centre: self.at(centre), radius, colour }
    }

    fn tube(&self, ends: [[f32; 3]; 2], radii: [f32; 2], colour: Pixel) -> Solid {
        Solid::Tube { ends: ends.map(|end| self.at(end)), radii, colour }
    }

    fn block(&self, centre: [f32; 3], half: [f32; 3], colour: Pixel) -> Solid {
        let pose = self.pose * Affine3A::from_translation(centre.into());
        Solid::Block { pose, half: half.into(), colour }
    }
}

/// Returns the shadows under a robot's feet.
pub(crate) fn shadows(robot: &Affine3A, skeleton: &Skeleton) -> [Solid; 2] {
    Side::BOTH.map(|side| {
        let sole = *robot * skeleton.sole(side);
        let centre: Vec2 = sole.transform_point3(Vec3::new(0.02, 0.0, 0.0)).truncate();
        Solid::Shadow { centre, radius: 0.12, darkness: 0.45 }
    })
}
