//! Extents, postures on the ground and looks in simulators. Without a source, numbers are our estimates from photographs.

use super::{NAO, actuators::ACTUATORS, dimensions::DIMENSIONS, mujoco::MUJOCO};
use crate::joints::{Joint, Joints};
use crate::model::simulation::Paint::{Joint as Inner, Shell, Team};
use crate::model::simulation::Solid::{Block, Sphere, Tube};
use crate::model::simulation::{Disc, Extents, Figure, Lying, Part, SimulatedModel};
use crate::model::{Actuator, Range};
use crate::segment::Segment::{Ankle, Biceps, Foot, Forearm, Hand, Head, Shoulder, Thigh, Tibia, Torso};
use crate::side::Side::Left;

/// The robot in simulators.
pub const SIMULATED: &SimulatedModel = &SimulatedModel {
    robot: NAO,
    extents: &Extents {
        standing: 0.15,
        lying: 0.4,
        torso: 0.09,
        foot_front: Disc { ahead: 0.035, radius: 0.065 },
        foot_height: 0.05,
        sole_middle: 0.0227,
        leg: Disc { ahead: 0.02, radius: 0.07 },
        trunk_length: 0.25,
        trunk_radius: 0.09,
        min_hip_height: 0.15,
    },
    lying: &LYING,
    figure: &Figure { trunk: &TRUNK, side: &SIDE, head: &HEAD, foot_shadow: Disc { ahead: 0.02, radius: 0.12 } },
    thermal_ratings: &RATINGS,
    mujoco: MUJOCO,
};

/// Postures on the ground.
///
/// A robot rises through a squat that balances on its soles. The lowest such squat has its hips 0.145 m above the ground with
/// knees at 1.8 rad, 0.177 m with knees at 1.2 rad, and 0.126 m with knees at their stop of 2.1 rad. A lying robot has its
/// hips at 0.08 to 0.11 m, and its arms lift them to about 0.15 m: with straighter knees it cannot rise.
const LYING: Lying = Lying {
    fall_length: 0.22,
    front_height: 0.08,
    back_height: 0.09,
    side_height: 0.11,
    sitting_hip: 1.05,
    sitting_lean: 0.8,
    folded_knee: 1.8,
    rising_knee: Range { min: 0.3, max: 1.4 },
};

/// Ratings of the data sheet, except for the shoulder pitch: its data sheet states 2.6 mNm, an eighth of the stall torque,
/// which is a loss of 0.4 W. The other motors of the arm, which are not larger, bear 3 W, so their rating is used.
const RATINGS: Joints<Actuator> = {
    let Joints(mut ratings) = ACTUATORS;
    ratings[Joint::LShoulderPitch.index()] = ratings[Joint::LShoulderRoll.index()];
    ratings[Joint::RShoulderPitch.index()] = ratings[Joint::RShoulderRoll.index()];
    Joints(ratings)
};

const TRUNK: [Part; 4] = [
    Part(Torso, Inner, Tube([[0.0, 0.0, -0.02], [0.0, 0.0, 0.035]], [0.045, 0.05])),
    Part(Torso, Team, Tube([[0.0, 0.0, 0.035], [0.0, 0.0, 0.065]], [0.056, 0.056])),
    Part(Torso, Shell, Tube([[0.0, 0.0, 0.065], [-0.005, 0.0, 0.185]], [0.054, 0.052])),
    Part(Torso, Inner, Tube([[-0.01, 0.0, 0.185], [-0.01, 0.0, 0.21]], [0.03, 0.022])),
];

const HEAD: [Part; 4] = [
    Part(Head, Shell, Sphere([-0.005, 0.0, 0.06], 0.062)),
    Part(Head, Inner, Tube([[0.045, 0.0, 0.062], [0.058, 0.0, 0.062]], [0.03, 0.016])),
    Part(Head, Team, Tube([[-0.005, 0.05, 0.06], [-0.005, 0.068, 0.06]], [0.03, 0.022])),
    Part(Head, Team, Tube([[-0.005, -0.05, 0.06], [-0.005, -0.068, 0.06]], [0.03, 0.022])),
];

const SIDE: [Part; 11] = {
    let elbow = [DIMENSIONS.upper_arm.x, DIMENSIONS.upper_arm.y, 0.0];
    let (thigh, tibia, sole) = (-DIMENSIONS.thigh, -DIMENSIONS.tibia, DIMENSIONS.foot_height);
    let toes = [[0.058, 0.0065, -sole], [0.058, 0.0065, 0.034 - sole]];
    [
        Part(Torso, Shell, Tube([[0.0, 0.03, 0.165], [0.0, 0.075, 0.18]], [0.04, 0.03])),
        Part(Shoulder(Left), Team, Sphere([0.0; 3], 0.036)),
        Part(Biceps(Left), Shell, Tube([[0.02, 0.0, 0.0], elbow], [0.028, 0.024])),
        Part(Forearm(Left), Shell, Tube([[0.0; 3], [0.085, 0.0, 0.0]], [0.026, 0.022])),
        Part(Hand(Left), Inner, Sphere([0.055, 0.0, 0.005], 0.022)),
        Part(Thigh(Left), Shell, Tube([[0.0; 3], [0.0, 0.0, thigh]], [0.042, 0.034])),
        Part(Tibia(Left), Inner, Sphere([0.0; 3], 0.033)),
        Part(Tibia(Left), Shell, Tube([[0.0, 0.0, -0.01], [0.0, 0.0, tibia]], [0.036, 0.034])),
        Part(Ankle(Left), Inner, Sphere([0.0; 3], 0.03)),
        Part(Foot(Left), Shell, Block([0.006, 0.0065, 0.018 - sole], [0.058, 0.042, 0.018])),
        Part(Foot(Left), Team, Tube(toes, [0.042, 0.036])),
    ]
};
