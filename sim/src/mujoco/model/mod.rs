//! The physical model: the robot of an MJCF file on a generated field.

pub(super) mod field;
pub(super) mod paint;
mod shadows;

use std::fmt::Write;

use bica_body::mujoco::{Error, FreeJoint, Model, Physics, find};
use bica_field::FIELD;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::robot::CameraId;
use mujoco_rs::prelude::{MjModel, MjtObjBase};

use self::paint::Paint;
pub(crate) use self::shadows::SHADOWS;
use crate::camera::light::Light;
use crate::field::BALL_RADIUS;
use crate::layout::{Layout, OtherRobot};
use crate::random::{Random, Stream};
use crate::setup::Setup;
use bica_body::sensor_model::GRAVITY;

/// Builds the model of a game, and finds its ball.
pub(crate) fn build(
    robot: &'static SimulatedModel,
    setup: &Setup,
    layout: &Layout,
    physics: &Physics,
) -> Result<(Model, FreeJoint), Error> {
    let mut model = Model::new(robot, &world(robot, setup, layout), physics)?;
    adjust(&mut model.physics, layout)?;
    set_intrinsics(robot, &mut model.physics, setup)?;
    let ball = FreeJoint::find(&model.physics, "Ball")?;
    Ok((model, ball))
}

/// Sets the parameters that differ between games.
fn adjust(model: &mut MjModel, layout: &Layout) -> Result<(), Error> {
    let ball = find(model, MjtObjBase::mjOBJ_GEOM, "Ball")?;
    model.geom_friction_mut()[ball][2] = rolling_friction(layout.rolling_deceleration).into();
    let team = find(model, MjtObjBase::mjOBJ_MATERIAL, "team")?;
    model.mat_rgba_mut()[team] = paint::team(layout).extend(1.0).to_array();
    Ok(())
}

/// Sets the intrinsic parameters of both cameras from the pinhole model. There the centre of the first pixel is at
/// 0, in MuJoCo its edge is.
fn set_intrinsics(robot: &'static SimulatedModel, model: &mut MjModel, setup: &Setup) -> Result<(), Error> {
    let (width, height) = setup.frame.size();
    let (width, height) = (width as f32, height as f32);
    for id in [CameraId::Top, CameraId::Bottom] {
        let camera = find(model, MjtObjBase::mjOBJ_CAMERA, &format!("{id:?}"))?;
        let focal = robot.dimensions.camera(id).focal;
        model.cam_sensorsize_mut()[camera] = [width, height];
        model.cam_intrinsic_mut()[camera] = [focal.x * width, focal.y * height, -0.5, -0.5];
    }
    Ok(())
}

/// Returns MuJoCo's coefficient of rolling friction, m, at which the ball decelerates by `rolling_deceleration`, m/s².
///
/// The coefficient is the lever arm of the normal force. A solid ball with moment of inertia 2/5 m r² decelerates by 5/7 of
/// torque / (m r).
fn rolling_friction(rolling_deceleration: f32) -> f32 {
    1.4 * rolling_deceleration * BALL_RADIUS / GRAVITY
}

/// Generates the XML of the world, which includes the robot.
fn world(model: &'static SimulatedModel, setup: &Setup, layout: &Layout) -> String {
    let light = Light::new(&mut Random::new(setup.seed, Stream::Hall));
    let paint = Paint::of(layout);
    let mut xml = String::from("<mujoco model=\"field\">\n<include file=\"robot.xml\"/>\n");
    xml.push_str(paint::RENDER_OPTIONS);
    let _ = writeln!(xml, "<asset>\n{}", paint::BACKGROUND);
    paint.write(&mut xml);
    xml.push_str("</asset>\n<worldbody>\n");
    paint::lamps(&mut xml, light);
    shadows::write(model, &mut xml);
    field::write(&mut xml, &FIELD);
    for other in &layout.others {
        bystander(model, &mut xml, other, layout.others_move);
    }
    let _ = writeln!(
        xml,
        "<body name=\"Ball\"><freejoint name=\"Ball\"/><geom name=\"Ball\" type=\"sphere\" size=\"{BALL_RADIUS}\" \
         mass=\"0.055\" material=\"ball\" contype=\"16\" conaffinity=\"45\" condim=\"6\" priority=\"2\" \
         friction=\"0.7 0.003 0.0016\" solref=\"0.01 0.25\"/></body>"
    );
    xml.push_str("</worldbody>\n</mujoco>\n");
    xml
}

/// Writes a robot that stands still, or that another world moves.
fn bystander(model: &'static SimulatedModel, xml: &mut String, other: &OtherRobot, moves: bool) {
    let (at, heading) = (other.pose.position, other.pose.heading);
    let geoms = paint::in_team_colour(model.mujoco.bystander, other.teammate);
    let _ =
        writeln!(xml, "<body mocap=\"{moves}\" pos=\"{} {} 0\" euler=\"0 0 {heading}\">\n{geoms}</body>", at.x, at.y);
}
