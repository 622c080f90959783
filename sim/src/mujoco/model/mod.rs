//! The physical model: the robot of an MJCF file on a generated field.

pub(super) mod field;
pub(super) mod paint;
mod shadows;
#[cfg(test)]
mod tests;

use std::fmt::Write;

use bica_motion::joints::Joint;
use bica_motion::kinematics::Segment;
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::MujocoModel;
use bica_motion::robot::CameraId;
use bica_motion::side::Side;
use mujoco_rs::prelude::{MjModel, MjtObjBase};
use mujoco_rs::wrappers::mj_auxiliary::MjVfs;

use self::paint::Paint;
pub(crate) use self::shadows::SHADOWS;
use super::error::Error;
use super::physics::Physics;
use crate::camera::light::Light;
use crate::field::BALL_RADIUS;
use crate::layout::{Layout, OtherRobot};
use crate::random::{Random, Stream};
use crate::sensor_model::GRAVITY;
use crate::setup::Setup;

/// Time step of the physics, s.
pub(crate) const STEP: f32 = 0.002;

/// A model and the indices of its parts.
pub(crate) struct Model {
    pub(crate) physics: Box<MjModel>,
    /// Free joint of the torso.
    pub(crate) torso: FreeJoint,
    /// Free joint of the ball.
    pub(crate) ball: FreeJoint,
    pub(crate) drives: Vec<Drive>,
    /// Bodies of the feet, left first.
    pub(crate) feet: [usize; 2],
}

/// A joint with its motor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drive {
    pub(crate) joint: Joint,
    /// Address of the angle in the positions.
    pub(crate) position: usize,
    /// Index of the motor among the actuators.
    pub(crate) actuator: usize,
}

/// Addresses of a free joint.
#[derive(Clone, Copy, Debug)]
pub(crate) struct FreeJoint {
    /// In the positions: 3 of the position, 4 of the quaternion.
    pub(crate) position: usize,
    /// In the velocities: 3 linear, 3 angular.
    pub(crate) velocity: usize,
}

impl Model {
    /// Builds the model of a game.
    pub(crate) fn new<M: MujocoModel>(setup: &Setup, layout: &Layout, physics: &Physics) -> Result<Self, Error> {
        let failed = |error: &dyn std::fmt::Display| Error::Model(error.to_string());
        let mut files = MjVfs::new();
        files.add_from_buffer("robot.xml", M::ROBOT.as_bytes()).map_err(|error| failed(&error))?;
        files.add_from_buffer("world.xml", world::<M>(setup, layout).as_bytes()).map_err(|error| failed(&error))?;
        let model = MjModel::from_xml_vfs("world.xml", &files).map_err(|error| failed(&error))?;
        let mut model = Self::index::<M>(model)?;
        model.adjust(layout, physics)?;
        model.set_intrinsics::<M>(setup)?;
        Ok(model)
    }

    fn index<M: MujocoModel>(physics: MjModel) -> Result<Self, Error> {
        let free = |name| -> Result<FreeJoint, Error> {
            let joint = find(&physics, MjtObjBase::mjOBJ_JOINT, name)?;
            let (position, velocity) = (physics.jnt_qposadr()[joint], physics.jnt_dofadr()[joint]);
            Ok(FreeJoint { position: position as usize, velocity: velocity as usize })
        };
        let (torso, ball) = (free("Torso")?, free("Ball")?);
        let drive = |&joint: &Joint| -> Result<Drive, Error> {
            let name = joint_name::<M>(joint);
            let position = physics.jnt_qposadr()[find(&physics, MjtObjBase::mjOBJ_JOINT, &name)?] as usize;
            Ok(Drive { joint, position, actuator: find(&physics, MjtObjBase::mjOBJ_ACTUATOR, &name)? })
        };
        let drives = M::JOINTS.iter().map(drive).collect::<Result<_, _>>()?;
        let foot = |side| find(&physics, MjtObjBase::mjOBJ_BODY, &body_name(Segment::Foot(side)));
        let feet = [foot(Side::Left)?, foot(Side::Right)?];
        Ok(Self { physics: Box::new(physics), torso, ball, drives, feet })
    }

    /// Sets the parameters that differ between games.
    fn adjust(&mut self, layout: &Layout, physics: &Physics) -> Result<(), Error> {
        for sole in ["LSole", "RSole"] {
            let id = find(&self.physics, MjtObjBase::mjOBJ_GEOM, sole)?;
            self.physics.geom_friction_mut()[id][0] = physics.friction.into();
        }
        let ball = find(&self.physics, MjtObjBase::mjOBJ_GEOM, "Ball")?;
        self.physics.geom_friction_mut()[ball][2] = rolling_friction(layout.rolling_deceleration).into();
        let team = find(&self.physics, MjtObjBase::mjOBJ_MATERIAL, "team")?;
        self.physics.mat_rgba_mut()[team] = paint::team(layout).extend(1.0).to_array();
        Ok(())
    }

    /// Sets the intrinsic parameters of both cameras from the pinhole model. There the centre of the first pixel is at
    /// 0, in MuJoCo its edge is.
    fn set_intrinsics<M: MujocoModel>(&mut self, setup: &Setup) -> Result<(), Error> {
        let (width, height) = setup.frame.size();
        let (width, height) = (width as f32, height as f32);
        for id in [CameraId::Top, CameraId::Bottom] {
            let camera = find(&self.physics, MjtObjBase::mjOBJ_CAMERA, &format!("{id:?}"))?;
            let focal = M::DIMENSIONS.camera(id).focal;
            self.physics.cam_sensorsize_mut()[camera] = [width, height];
            self.physics.cam_intrinsic_mut()[camera] = [focal.x * width, focal.y * height, -0.5, -0.5];
        }
        Ok(())
    }
}

/// Returns MuJoCo's coefficient of rolling friction, m, at which the ball decelerates by `rolling_deceleration`, m/s².
///
/// The coefficient is the lever arm of the normal force. A solid ball with moment of inertia 2/5 m r² decelerates by 5/7 of
/// torque / (m r).
fn rolling_friction(rolling_deceleration: f32) -> f32 {
    1.4 * rolling_deceleration * BALL_RADIUS / GRAVITY
}

/// Finds an element of the model by its name.
pub(crate) fn find(model: &MjModel, kind: MjtObjBase, name: &str) -> Result<usize, Error> {
    model.name_to_id(kind, name).ok_or_else(|| Error::Model(format!("it has no element `{name}`")))
}

/// Returns the name of a joint and its motor, for example `LKneePitch`.
pub(crate) fn joint_name<M: RobotModel>(joint: Joint) -> String {
    let own = match joint {
        _ if M::LEG.shares_hip_yaw() => None,
        Joint::LEFT_HIP_YAW => Some("LHipYaw"),
        Joint::RIGHT_HIP_YAW => Some("RHipYaw"),
        Joint::WAIST_YAW => Some("WaistYaw"),
        _ => None,
    };
    own.map_or_else(|| format!("{joint:?}"), ToOwned::to_owned)
}

/// Returns the name of a segment's body, for example `LFoot`.
pub(crate) fn body_name(segment: Segment) -> String {
    let name = format!("{segment:?}");
    // Debug output of a paired segment: `Foot(Left)`.
    name.split_once('(').map(|(part, side)| format!("{}{part}", &side[..1])).unwrap_or(name)
}

/// Generates the XML of the world, which includes the robot.
fn world<M: MujocoModel>(setup: &Setup, layout: &Layout) -> String {
    let light = Light::new(&mut Random::new(setup.seed, Stream::Hall));
    let paint = Paint::of(layout);
    let mut xml = String::from("<mujoco model=\"field\">\n<include file=\"robot.xml\"/>\n");
    xml.push_str(paint::RENDER_OPTIONS);
    let _ = writeln!(xml, "<asset>\n{}", paint::BACKGROUND);
    paint.write(&mut xml);
    xml.push_str("</asset>\n<worldbody>\n");
    paint::lamps(&mut xml, light);
    shadows::write::<M>(&mut xml);
    field::write(&mut xml);
    for other in &layout.others {
        bystander::<M>(&mut xml, other);
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

/// Writes a robot that stands still.
fn bystander<M: MujocoModel>(xml: &mut String, other: &OtherRobot) {
    let (at, heading) = (other.pose.position, other.pose.heading);
    let geoms = paint::in_team_colour(M::BYSTANDER, other.teammate);
    let _ = writeln!(xml, "<body pos=\"{} {} 0\" euler=\"0 0 {heading}\">\n{geoms}</body>", at.x, at.y);
}
