//! The robot as data.
//!
//! It begins as a Booster K1. Replace what is different: the page `docs/new-robot.md` of BICA says where each number comes from. The
//! fields are those of `RobotModel`; `robot.xml` has the same lengths and masses for MuJoCo.

use bica_motion::model::simulation::{self, MujocoModel, SimulatedModel};
use bica_motion::model::{K1, RobotModel};

/// What the robot's own program knows of it.
pub const MODEL: &RobotModel = &RobotModel {
    id: "biped",
    name: "Biped",
    ..*K1
};

/// The robot in simulators.
pub const SIMULATED: &SimulatedModel = &SimulatedModel {
    robot: MODEL,
    mujoco: MujocoModel {
        robot: ROBOT,
        shells: ROBOT,
        ..simulation::K1.mujoco
    },
    ..*simulation::K1
};

const ROBOT: &str = include_str!("../robot.xml");
