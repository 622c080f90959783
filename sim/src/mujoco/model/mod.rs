//! The model that MuJoCo computes: the robot of `models/nao.xml` on a field made from the field's lengths.

pub(super) mod field;
pub(super) mod paint;
mod robots;
mod shadows;
#[cfg(test)]
mod tests;

use bica_field::FIELD;
use std::fmt::Write;

use bica_motion::joints::{JOINTS, Joint};
use mujoco_rs::prelude::{MjModel, MjtObjBase};
use mujoco_rs::wrappers::mj_auxiliary::MjVfs;

use self::paint::Paint;
pub(crate) use self::shadows::SHADOWS;
use super::error::Error;
use super::physics::Physics;
use crate::camera::light::Light;
use crate::camera::pinhole::FOCAL;
use crate::layout::Layout;
use crate::random::{Random, Stream};
use crate::sensor_model::GRAVITY;
use crate::setup::Setup;

const BALL_RADIUS: f32 = FIELD.ball_radius();

/// The robot.
const NAO: &str = include_str!("../../../models/nao.xml");
/// One step of the physics, s.
pub(crate) const STEP: f32 = 0.002;

/// A model, and where in its arrays things are.
pub(crate) struct Model {
    pub(crate) physics: Box<MjModel>,
    /// The torso's free joint: its place in positions and in velocities.
    pub(crate) torso: Place,
    pub(crate) ball: Place,
    /// Each joint's angle among the positions.
    pub(crate) joints: [usize; JOINTS],
    pub(crate) feet: [usize; 2],
}

/// Where a free joint is in the arrays.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    pub(crate) position: usize,
    pub(crate) velocity: usize,
}

impl Model {
    /// Builds the model of a game.
    pub(crate) fn new(setup: &Setup, layout: &Layout, physics: &Physics) -> Result<Self, Error> {
        let failed = |error: &dyn std::fmt::Display| Error::Model(error.to_string());
        let mut files = MjVfs::new();
        files.add_from_buffer("nao.xml", NAO.as_bytes()).map_err(|error| failed(&error))?;
        files.add_from_buffer("world.xml", world(setup, layout).as_bytes()).map_err(|error| failed(&error))?;
        let model = MjModel::from_xml_vfs("world.xml", &files).map_err(|error| failed(&error))?;
        let mut model = Self::index(model)?;
        model.adjust(layout, physics)?;
        model.focus(setup)?;
        Ok(model)
    }

    fn index(physics: MjModel) -> Result<Self, Error> {
        let free = |name| -> Result<Place, Error> {
            let joint = find(&physics, MjtObjBase::mjOBJ_JOINT, name)?;
            let (position, velocity) = (physics.jnt_qposadr()[joint], physics.jnt_dofadr()[joint]);
            Ok(Place { position: position as usize, velocity: velocity as usize })
        };
        let (torso, ball) = (free("Torso")?, free("Ball")?);
        let mut joints = [0; JOINTS];
        for joint in Joint::ALL {
            let id = find(&physics, MjtObjBase::mjOBJ_JOINT, &format!("{joint:?}"))?;
            joints[joint.index()] = physics.jnt_qposadr()[id] as usize;
        }
        let foot = |name| find(&physics, MjtObjBase::mjOBJ_BODY, name);
        let feet = [foot("LFoot")?, foot("RFoot")?];
        Ok(Self { physics: Box::new(physics), torso, ball, joints, feet })
    }

    /// Sets what differs from game to game.
    fn adjust(&mut self, layout: &Layout, physics: &Physics) -> Result<(), Error> {
        for sole in ["LSole", "RSole"] {
            let id = find(&self.physics, MjtObjBase::mjOBJ_GEOM, sole)?;
            self.physics.geom_friction_mut()[id][0] = physics.friction.into();
        }
        let ball = find(&self.physics, MjtObjBase::mjOBJ_GEOM, "Ball")?;
        self.physics.geom_friction_mut()[ball][2] = rolling_friction(layout.braking).into();
        let team = find(&self.physics, MjtObjBase::mjOBJ_MATERIAL, "team")?;
        self.physics.mat_rgba_mut()[team] = paint::team(layout).extend(1.0).to_array();
        Ok(())
    }

    /// Gives both cameras the focal lengths of the built-in world's. There the optical axis is at half the width and height
    /// where the first pixel's middle is 0, here where its edge is.
    fn focus(&mut self, setup: &Setup) -> Result<(), Error> {
        let (width, height) = setup.frame.size();
        let (width, height) = (width as f32, height as f32);
        for name in ["Top", "Bottom"] {
            let camera = find(&self.physics, MjtObjBase::mjOBJ_CAMERA, name)?;
            self.physics.cam_sensorsize_mut()[camera] = [width, height];
            self.physics.cam_intrinsic_mut()[camera] = [FOCAL.0 * width, FOCAL.1 * height, -0.5, -0.5];
        }
        Ok(())
    }
}

/// The arm of the torque, m, with which the carpet brakes the ball by `braking` m/s²: a solid ball slows down by 5/7 of
/// what the force at its rim would do to a point.
fn rolling_friction(braking: f32) -> f32 {
    1.4 * braking * BALL_RADIUS / GRAVITY
}

pub(crate) fn find(model: &MjModel, kind: MjtObjBase, name: &str) -> Result<usize, Error> {
    model.name_to_id(kind, name).ok_or_else(|| Error::Model(format!("it has no `{name}`")))
}

/// The world that includes the robot.
fn world(setup: &Setup, layout: &Layout) -> String {
    let light = Light::new(&mut Random::new(setup.seed, Stream::Hall));
    let paint = Paint::of(layout);
    let mut xml = String::from("<mujoco model=\"field\">\n<include file=\"nao.xml\"/>\n");
    xml.push_str(paint::DRAWN);
    let _ = writeln!(xml, "<asset>\n{}", paint::AROUND);
    paint.write(&mut xml);
    xml.push_str("</asset>\n<worldbody>\n");
    paint::lamps(&mut xml, light);
    shadows::write(&mut xml);
    field::write(&mut xml);
    for other in &layout.others {
        robots::write(&mut xml, other);
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
