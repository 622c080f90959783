//! The physical model: the robot of an MJCF file in a world of an application, and the indices of its parts.

use bica_motion::joints::Joint;
use bica_motion::kinematics::Segment;
use bica_motion::model::RobotModel;
use bica_motion::model::simulation::SimulatedModel;
use bica_motion::side::Side;
use mujoco_rs::prelude::{MjModel, MjtDisableBit, MjtObjBase};
use mujoco_rs::wrappers::mj_auxiliary::MjVfs;

use super::error::Error;
use super::physics::Physics;

/// Time step of the physics, s.
pub(crate) const STEP: f32 = 0.002;

/// MJCF of the floor, on which soles and bodies rest.
pub const FLOOR: &str = "<geom name=\"Floor\" type=\"plane\" size=\"0 0 1\" group=\"3\" contype=\"4\" conaffinity=\"3\" \
    friction=\"0.9 0.005 0.0001\"/>\n";

/// A model and the indices of its parts.
pub struct Model {
    /// The model of MuJoCo.
    pub physics: Box<MjModel>,
    /// Free joint of the torso.
    pub(crate) torso: FreeJoint,
    pub(crate) drives: Vec<Drive>,
    /// Bodies of the feet, left first.
    pub(crate) feet: [usize; 2],
}

/// Joint with its motor.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Drive {
    pub(crate) joint: Joint,
    /// Address of the angle in the positions.
    pub(crate) position: usize,
    /// Address of the speed in the velocities.
    pub(crate) velocity: usize,
    /// Velocity gain of the motor, Nm·s/rad; 0 if the damping of the joint is not that of the motor.
    pub(crate) velocity_gain: f32,
    /// Index of the motor among the actuators.
    pub(crate) actuator: usize,
}

/// Addresses of a free joint.
#[derive(Clone, Copy, Debug)]
pub struct FreeJoint {
    /// In the positions: 3 of the position, 4 of the quaternion.
    pub position: usize,
    /// In the velocities: 3 linear, 3 angular.
    pub velocity: usize,
}

impl Model {
    /// Builds the model of a world, an MJCF text that includes the robot as `robot.xml`, first.
    ///
    /// # Errors
    ///
    /// If a parameter of the physics is invalid, or MuJoCo rejects the text; the error contains the reason.
    pub fn new(model: &'static SimulatedModel, world: &str, physics: &Physics) -> Result<Self, Error> {
        physics.check()?;
        let failed = |error: &dyn std::fmt::Display| Error::Model(error.to_string());
        let mut files = MjVfs::new();
        files.add_from_buffer("robot.xml", model.mujoco.robot.as_bytes()).map_err(|error| failed(&error))?;
        files.add_from_buffer("world.xml", world.as_bytes()).map_err(|error| failed(&error))?;
        let built = MjModel::from_xml_vfs("world.xml", &files).map_err(|error| failed(&error))?;
        let mut model = Self::index(model, built)?;
        // MuJoCo would put everything to its start, print a warning, and go on.
        model.physics.opt_mut().disableflags |= MjtDisableBit::mjDSBL_AUTORESET as i32;
        for sole in ["LSole", "RSole"] {
            let id = find(&model.physics, MjtObjBase::mjOBJ_GEOM, sole)?;
            model.physics.geom_friction_mut()[id][0] = physics.friction.into();
        }
        Ok(model)
    }

    /// Builds the model of the robot alone on a floor.
    ///
    /// # Errors
    ///
    /// As for [`new`](Self::new).
    pub fn on_floor(model: &'static SimulatedModel, physics: &Physics) -> Result<Self, Error> {
        let world = format!("<mujoco><include file=\"robot.xml\"/><worldbody>{FLOOR}</worldbody></mujoco>");
        Self::new(model, &world, physics)
    }

    fn index(model: &'static SimulatedModel, physics: MjModel) -> Result<Self, Error> {
        let torso = FreeJoint::find(&physics, "Torso")?;
        let drive = |&joint: &Joint| -> Result<Drive, Error> {
            let name = joint_name(model, joint);
            let index = find(&physics, MjtObjBase::mjOBJ_JOINT, &name)?;
            let (position, velocity) = (physics.jnt_qposadr()[index] as usize, physics.jnt_dofadr()[index] as usize);
            let velocity_gain = if model.mujoco.motors_damp { physics.dof_damping()[velocity] as f32 } else { 0.0 };
            let actuator = find(&physics, MjtObjBase::mjOBJ_ACTUATOR, &name)?;
            Ok(Drive { joint, position, velocity, velocity_gain, actuator })
        };
        let drives = model.joints.iter().map(drive).collect::<Result<_, _>>()?;
        let foot = |side| find(&physics, MjtObjBase::mjOBJ_BODY, &body_name(Segment::Foot(side)));
        let feet = [foot(Side::Left)?, foot(Side::Right)?];
        Ok(Self { physics: Box::new(physics), torso, drives, feet })
    }
}

impl FreeJoint {
    /// Finds a free joint by its name.
    ///
    /// # Errors
    ///
    /// If the model has no such joint.
    pub fn find(physics: &MjModel, name: &str) -> Result<Self, Error> {
        let joint = find(physics, MjtObjBase::mjOBJ_JOINT, name)?;
        let (position, velocity) = (physics.jnt_qposadr()[joint], physics.jnt_dofadr()[joint]);
        Ok(Self { position: position as usize, velocity: velocity as usize })
    }
}

/// Finds an element of the model by its name.
///
/// # Errors
///
/// If the model has no such element.
pub fn find(model: &MjModel, kind: MjtObjBase, name: &str) -> Result<usize, Error> {
    model.name_to_id(kind, name).ok_or_else(|| Error::Model(format!("it has no element `{name}`")))
}

/// Returns the name of a joint and its motor, for example `LKneePitch`.
pub(crate) fn joint_name(model: &'static RobotModel, joint: Joint) -> String {
    let own = match joint {
        _ if model.leg.shares_hip_yaw() => None,
        Joint::LEFT_HIP_YAW => Some("LHipYaw"),
        Joint::RIGHT_HIP_YAW => Some("RHipYaw"),
        Joint::WAIST_YAW => Some("WaistYaw"),
        _ => None,
    };
    own.map_or_else(|| format!("{joint:?}"), ToOwned::to_owned)
}

/// Returns the name of a segment's body, for example `LFoot`.
#[must_use]
pub fn body_name(segment: Segment) -> String {
    let name = format!("{segment:?}");
    // Debug output of a paired segment: `Foot(Left)`.
    name.split_once('(').map(|(part, side)| format!("{}{part}", &side[..1])).unwrap_or(name)
}
