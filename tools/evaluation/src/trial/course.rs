//! What each robot has to do in the trials of its walk.

use bica_motion::model::simulation::MujocoModel;
use bica_motion::model::{K1, Nao, T1};
use bica_motion::walk::Velocity;

use super::get_up::TIME_LIMIT;

/// A robot model with requirements for its walk.
pub(super) trait Course: MujocoModel {
    /// Commanded velocities.
    const VELOCITIES: &'static [VelocityCase];
    /// Pushes in walking.
    const PUSHES: &'static [PushCase];
    /// Forward velocity while it is pushed, m/s.
    const PUSHED_VELOCITY: f32;
    /// Least distance of a kicked ball if the kick counts, m; the robot must stand, too.
    const LEAST_KICK: f32 = 1.0;
    /// Least median distance of a ball kicked in the walk, m.
    const LEAST_DRIBBLE: f32 = 1.5;
    /// Time in which it has to get up, s.
    const TIME_TO_RISE: f32 = TIME_LIMIT;
}

/// A velocity, and what is required.
pub(super) struct VelocityCase {
    pub(super) name: &'static str,
    pub(super) velocity: Velocity,
    /// Whether the mean velocity has to be near the command; otherwise the robot only must not fall.
    pub(super) exact: bool,
    /// Number of 20 runs that must succeed.
    pub(super) needed: u32,
}

/// Pushes that change the velocity of the torso.
pub(super) struct PushCase {
    pub(super) name: &'static str,
    /// m/s.
    pub(super) speed: f32,
    /// Direction, degrees from ahead to the left; random if `None`.
    pub(super) direction: Option<f32>,
    pub(super) times: u32,
    /// Number of 20 runs that must succeed; 0 only reports.
    pub(super) needed: u32,
}

const fn exact(name: &'static str, forward: f32, left: f32, turn: f32) -> VelocityCase {
    VelocityCase { name, velocity: Velocity::new(forward, left, turn), exact: true, needed: 20 }
}

/// As `exact`, with two failures in 20 runs.
const fn mostly(name: &'static str, forward: f32, left: f32, turn: f32) -> VelocityCase {
    VelocityCase { needed: 18, ..exact(name, forward, left, turn) }
}

const fn upright(name: &'static str, forward: f32, left: f32, turn: f32, needed: u32) -> VelocityCase {
    VelocityCase { name, velocity: Velocity::new(forward, left, turn), exact: false, needed }
}

const fn once(name: &'static str, speed: f32, direction: f32, needed: u32) -> PushCase {
    PushCase { name, speed, direction: Some(direction), times: 1, needed }
}

const fn ten(name: &'static str, speed: f32, needed: u32) -> PushCase {
    PushCase { name, speed, direction: None, times: 10, needed }
}

impl Course for Nao {
    const VELOCITIES: &'static [VelocityCase] = &[
        exact("forward 0.2 m/s", 0.2, 0.0, 0.0),
        exact("backward 0.1 m/s", -0.1, 0.0, 0.0),
        exact("left 0.1 m/s", 0.0, 0.1, 0.0),
        exact("right 0.1 m/s", 0.0, -0.1, 0.0),
        exact("left turn 0.6 rad/s", 0.0, 0.0, 0.6),
        exact("right turn 0.6 rad/s", 0.0, 0.0, -0.6),
        exact("forward and left", 0.12, 0.05, 0.0),
        exact("forward, right turn", 0.12, 0.0, -0.3),
        exact("backward, left turn", -0.06, 0.0, 0.3),
        exact("all three", 0.1, 0.03, 0.2),
        upright("forward 0.3 m/s", 0.3, 0.0, 0.0, 20),
    ];
    const PUSHES: &'static [PushCase] = &[
        once("one of 0.6 m/s, behind", 0.6, 0.0, 18),
        ten("ten of 0.4 m/s", 0.4, 19),
        ten("ten of 0.5 m/s", 0.5, 15),
        ten("ten of 0.6 m/s", 0.6, 0),
        ten("ten of 0.8 m/s", 0.8, 0),
    ];
    const PUSHED_VELOCITY: f32 = 0.1;
    const LEAST_KICK: f32 = 0.0;
    const LEAST_DRIBBLE: f32 = 0.5;
}

/// Velocities and pushes of both Booster robots.
const BOOSTER_PUSHES: [PushCase; 6] = [
    once("one of 0.5 m/s, behind", 0.5, 0.0, 18),
    once("one of 0.5 m/s, ahead", 0.5, 180.0, 18),
    once("one of 0.5 m/s, right", 0.5, 90.0, 12),
    once("one of 0.5 m/s, left", 0.5, -90.0, 12),
    ten("ten of 0.3 m/s", 0.3, 0),
    ten("ten of 0.5 m/s", 0.5, 0),
];

impl Course for T1 {
    const VELOCITIES: &'static [VelocityCase] = &[
        exact("forward 0.4 m/s", 0.4, 0.0, 0.0),
        mostly("forward 0.6 m/s", 0.6, 0.0, 0.0),
        mostly("backward 0.2 m/s", -0.2, 0.0, 0.0),
        mostly("left 0.2 m/s", 0.0, 0.2, 0.0),
        mostly("right 0.2 m/s", 0.0, -0.2, 0.0),
        mostly("left turn 0.7 rad/s", 0.0, 0.0, 0.7),
        mostly("right turn 0.7 rad/s", 0.0, 0.0, -0.7),
    ];
    const PUSHES: &'static [PushCase] = &BOOSTER_PUSHES;
    const PUSHED_VELOCITY: f32 = 0.2;
    const TIME_TO_RISE: f32 = 4.0;
}

impl Course for K1 {
    const VELOCITIES: &'static [VelocityCase] = &[
        mostly("forward 0.3 m/s", 0.3, 0.0, 0.0),
        upright("backward 0.15 m/s", -0.15, 0.0, 0.0, 0),
        upright("left 0.15 m/s", 0.0, 0.15, 0.0, 0),
        upright("left turn 0.6 rad/s", 0.0, 0.0, 0.6, 0),
    ];
    const PUSHES: &'static [PushCase] = &BOOSTER_PUSHES;
    const PUSHED_VELOCITY: f32 = 0.2;
}
