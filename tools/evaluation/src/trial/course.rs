//! Requirements for each robot in the trials of its walk.

use bica_motion::model::simulation::SimulatedModel;
use bica_motion::walk::Velocity;

use super::get_up::TIME_LIMIT;

/// What a robot has to do.
pub(super) struct Course {
    /// Commanded velocities.
    pub(super) velocities: &'static [VelocityCase],
    /// Pushes in walking.
    pub(super) pushes: &'static [PushCase],
    /// Forward velocity while it is pushed, m/s.
    pub(super) pushed_velocity: f32,
    /// Least distance of a kicked ball if the kick counts, m; the robot must stand, too.
    pub(super) least_kick: f32,
    /// Least median distance of a ball kicked in the walk, m.
    pub(super) least_dribble: f32,
    /// Time in which it has to get up, s.
    pub(super) time_to_rise: f32,
}

impl Course {
    /// The course of a robot; one without a course of its own has the [`K1`]'s.
    pub(super) fn of(model: &SimulatedModel) -> &'static Self {
        match model.id {
            "nao" => &NAO,
            "t1" => &T1,
            _ => &K1,
        }
    }
}

/// Commanded velocity, and its requirement.
pub(super) struct VelocityCase {
    pub(super) name: &'static str,
    pub(super) velocity: Velocity,
    /// Whether the mean velocity must be close to the command; otherwise the robot must only not fall.
    pub(super) exact: bool,
    /// Number of successful runs required of 20.
    pub(super) needed: u32,
}

/// Pushes that change the velocity of the torso.
pub(super) struct PushCase {
    pub(super) name: &'static str,
    /// Change of the torso's velocity, m/s.
    pub(super) speed: f32,
    /// Direction, degrees, counted from ahead to the left; random if `None`.
    pub(super) direction: Option<f32>,
    pub(super) times: u32,
    /// Number of successful runs required of 20; 0 only reports.
    pub(super) needed: u32,
}

const fn exact(name: &'static str, forward: f32, left: f32, turn: f32) -> VelocityCase {
    VelocityCase { name, velocity: Velocity::new(forward, left, turn), exact: true, needed: 20 }
}

/// Returns a case as `exact` does, but allows two failures in 20 runs.
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

const NAO: Course = Course {
    velocities: &[
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
    ],
    pushes: &[
        once("one of 0.6 m/s, behind", 0.6, 0.0, 18),
        ten("ten of 0.4 m/s", 0.4, 19),
        ten("ten of 0.5 m/s", 0.5, 15),
        ten("ten of 0.6 m/s", 0.6, 0),
        ten("ten of 0.8 m/s", 0.8, 0),
    ],
    pushed_velocity: 0.1,
    least_kick: 0.0,
    least_dribble: 0.5,
    time_to_rise: TIME_LIMIT,
};

/// Pushes of both Booster robots.
const BOOSTER_PUSHES: [PushCase; 6] = [
    once("one of 0.5 m/s, behind", 0.5, 0.0, 18),
    once("one of 0.5 m/s, ahead", 0.5, 180.0, 18),
    once("one of 0.5 m/s, right", 0.5, 90.0, 12),
    once("one of 0.5 m/s, left", 0.5, -90.0, 12),
    ten("ten of 0.3 m/s", 0.3, 0),
    ten("ten of 0.5 m/s", 0.5, 0),
];

const T1: Course = Course {
    velocities: &[
        exact("forward 0.4 m/s", 0.4, 0.0, 0.0),
        mostly("forward 0.6 m/s", 0.6, 0.0, 0.0),
        mostly("backward 0.2 m/s", -0.2, 0.0, 0.0),
        mostly("left 0.2 m/s", 0.0, 0.2, 0.0),
        mostly("right 0.2 m/s", 0.0, -0.2, 0.0),
        mostly("left turn 0.7 rad/s", 0.0, 0.0, 0.7),
        mostly("right turn 0.7 rad/s", 0.0, 0.0, -0.7),
    ],
    pushes: &BOOSTER_PUSHES,
    pushed_velocity: 0.2,
    time_to_rise: 4.0,
    least_kick: 1.0,
    least_dribble: 1.5,
};

const K1: Course = Course {
    velocities: &[
        mostly("forward 0.3 m/s", 0.3, 0.0, 0.0),
        upright("backward 0.15 m/s", -0.15, 0.0, 0.0, 0),
        upright("left 0.15 m/s", 0.0, 0.15, 0.0, 0),
        upright("left turn 0.6 rad/s", 0.0, 0.0, 0.6, 0),
    ],
    pushes: &BOOSTER_PUSHES,
    pushed_velocity: 0.2,
    least_kick: 1.0,
    least_dribble: 1.5,
    time_to_rise: TIME_LIMIT,
};
