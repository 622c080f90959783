//! Scene that draws a field and a robot at the poses of another world.

use std::fmt::Write;

use bica_body::mujoco::{FreeJoint, Humanoid, Model, Physics, write};
use bica_field::{FieldDimensions, GoalColour};
use bica_motion::joints::Joints;
use bica_motion::kinematics::{Segment, Skeleton};
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::pose::Pose2;
use bica_motion::side::Side;
use glam::{Affine3A, Quat, Vec2, Vec3, Vec3A};

use super::Error;
use super::model::field;
use super::model::paint::{BACKGROUND, Paint};
use super::renderer::Renderer;
use super::spectator::{picture, renderer, scene};
use crate::camera::light::Light;
use crate::random::{Random, Stream};
use crate::spectator::{Picture, RenderError, SpectatorCamera};

/// Distance of the surface of a segment from its origin, m, for a robot on the ground.
const SEGMENT_RADIUS: f32 = 0.06;
/// Index of the lamps among the mocap bodies.
const LAMP: usize = 0;

/// Draws a robot and a ball on a field from outside, for a world that has no pictures. Nothing is simulated.
pub struct Stage {
    model: &'static SimulatedModel,
    robot: Humanoid,
    ball: FreeJoint,
    /// Radius of the ball, m.
    ball_radius: f32,
    renderer: Renderer,
    size: (usize, usize),
}

/// Poses of the robot and the ball in a picture.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// Pose of the ground between the feet, field frame.
    pub at: Pose2,
    /// Roll and pitch of the torso, rad.
    pub tilt: (f32, f32),
    /// Joint angles, rad.
    pub angles: &'a Joints,
    /// Centre of the ball on the ground, field frame, m.
    pub ball: Vec2,
}

impl Stage {
    /// A stage for pictures of a size, pixels.
    ///
    /// # Errors
    ///
    /// If MuJoCo rejects the model, or no renderer is available.
    pub fn new(
        model: &'static SimulatedModel,
        field: &FieldDimensions,
        width: usize,
        height: usize,
    ) -> Result<Self, Error> {
        let physics = Physics::of(model);
        let built = Model::new(model, &xml(field), &physics)?;
        let ball = FreeJoint::find(&built.physics, "Ball")?;
        let renderer = renderer(&built.physics, width, height).map_err(|error| Error::Camera(error.to_string()))?;
        let robot = Humanoid::new(model, built, Pose2::ORIGIN, Random::new(0, Stream::Sensors), &physics, |_| {});
        Ok(Self { model, robot, ball, ball_radius: field.ball_radius(), renderer, size: (width, height) })
    }

    /// Draws a picture.
    ///
    /// # Errors
    ///
    /// If the renderer fails.
    pub fn draw(&mut self, shown: &Shown<'_>, camera: &SpectatorCamera) -> Result<Picture, RenderError> {
        self.robot.place(&robot(self.model, shown), shown.angles);
        let data = self.robot.data_mut();
        let ball = [shown.ball.x, shown.ball.y, self.ball_radius, 1.0, 0.0, 0.0, 0.0];
        write(&mut data.qpos_mut()[self.ball.position..], &ball);
        write(&mut data.mocap_pos_mut()[LAMP], &camera.target.to_array());
        picture(&mut self.renderer, data, camera, self.size)
    }
}

/// Returns the pose of the robot frame, field frame: the lowest part of the robot lies on the ground.
fn robot(model: &'static SimulatedModel, shown: &Shown<'_>) -> Affine3A {
    let skeleton = Skeleton::of(model, shown.angles);
    let (roll, pitch) = shown.tilt;
    let level = Quat::from_rotation_y(pitch) * Quat::from_rotation_x(roll);
    let soles = Side::BOTH.map(|side| level * skeleton.sole(side).translation);
    let lowest_segment = Segment::ALL.map(|segment| (level * skeleton.pose(segment).translation).z - SEGMENT_RADIUS);
    let lowest = soles.map(|sole| sole.z).into_iter().chain(lowest_segment).fold(0.0, f32::min);
    let turn = Quat::from_rotation_z(shown.at.heading);
    let middle: Vec3A = 0.5 * (soles[0] + soles[1]);
    let above = turn * Vec3::new(-middle.x, -middle.y, -lowest);
    Affine3A::from_rotation_translation(turn * level, shown.at.position.extend(0.0) + above)
}

/// Writes the model: the robot of its MJCF file, a field, and a ball.
fn xml(of: &FieldDimensions) -> String {
    let mut xml = String::from("<mujoco model=\"stage\">\n<include file=\"robot.xml\"/>\n");
    scene::render_options(&mut xml);
    let _ = writeln!(xml, "<asset>\n{BACKGROUND}");
    Paint::attacking(GoalColour::Yellow).write(&mut xml);
    xml.push_str("</asset>\n<worldbody>\n");
    scene::lamps(&mut xml, &Light::new(&mut Random::new(0, Stream::Hall)));
    field::write(&mut xml, of);
    let _ = writeln!(
        xml,
        "<body name=\"Ball\"><freejoint name=\"Ball\"/><geom type=\"sphere\" size=\"{}\" mass=\"0.4\" material=\"ball\"/></body>",
        of.ball_radius()
    );
    xml.push_str("</worldbody>\n</mujoco>\n");
    xml
}

#[cfg(test)]
mod tests {
    use bica_field::SSIM_2026;
    use bica_motion::model::simulation::T1;

    use super::*;

    /// Centroid of the pixels with the colour of the robot's team, pixels.
    fn team(picture: &Picture) -> Vec2 {
        let blue = |rgb: &[u8; 3]| rgb[2] > 100 && rgb[0] < 60;
        let at = |i: usize| Vec2::new((i % picture.width) as f32, (i / picture.width) as f32);
        let found: Vec<Vec2> = (0..picture.rgb.len()).filter(|i| blue(&picture.rgb[*i])).map(at).collect();
        assert!(found.len() > 20, "{} pixels", found.len());
        found.iter().sum::<Vec2>() / found.len() as f32
    }

    #[test]
    fn a_robot_is_drawn_where_it_is() {
        let mut stage = Stage::new(T1, &SSIM_2026, 160, 120).expect("a renderer");
        let camera = SpectatorCamera { eye: Vec3::new(15.0, 0.0, 1.0), target: Vec3::new(20.0, 0.0, 0.6) };
        let mut draw = |y: f32, pitch: f32| {
            let at = Pose2::new(20.0, y, 0.0);
            let shown = Shown { at, tilt: (0.0, pitch), angles: &T1.stand, ball: Vec2::new(18.0, 1.0) };
            team(&stage.draw(&shown, &camera).expect("a picture"))
        };
        let [middle, left, lying] = [draw(0.0, 0.0), draw(1.0, 0.0), draw(0.0, 1.5)];
        assert!((middle.x - 80.0).abs() < 3.0, "{middle}");
        // One metre at a distance of 5 m, with 45° for the height of 120 pixels.
        assert!((middle.x - left.x - 29.0).abs() < 3.0, "{left}");
        assert!(lying.y > middle.y + 5.0, "{lying} below {middle}");
    }
}
