//! Options of trials of the body. Programs that are built without `MuJoCo` use them too.

use bica_motion::model::simulation::{HUMANOIDS, SimulatedModel, humanoid};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueEnum};

#[cfg(feature = "mujoco")]
pub use crate::trial::{KickResult, kick_ball, run};

/// Trials, number of runs, and physics.
#[derive(Clone, Debug, Args)]
pub struct TrialOptions {
    /// Trials to run [default: all]
    #[arg(value_name = "NAME")]
    pub names: Vec<Kind>,
    /// Robot; only a NAO has all trials
    #[arg(long, value_name = "ROBOT", default_value = "nao", value_parser = robot_parser())]
    pub robot: &'static SimulatedModel,
    /// Number of seeds of each trial
    #[arg(long, value_name = "N", default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    pub runs: u32,
    /// First seed
    #[arg(long, value_name = "N", default_value_t = 0)]
    pub seed: u64,
    /// Number of threads [default: one for each core]; the results do not depend on it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u32).range(1..=1024))]
    pub threads: Option<u32>,
    /// Friction coefficient of the soles, 0.05 to 3 [default: 1]
    #[arg(long, value_name = "F")]
    pub friction: Option<f32>,
    /// Factor on the position gain of the leg motors, 0.1 to 5 [default: 1]
    #[arg(long, value_name = "F")]
    pub leg_gain: Option<f32>,
    /// Largest torque of the knees, Nm, 0.5 to 100; those of other leg joints change in proportion [default: the robot's]
    #[arg(long, value_name = "NM")]
    pub torque_limit: Option<f32>,
    /// Time from a command to its first effect, s, 0 to 0.2 [default: the robot's]
    #[arg(long, value_name = "S")]
    pub dead_time: Option<f32>,
    /// Factor on the noise of the sensors, 0 to 100 [default: 1]
    #[arg(long, value_name = "F")]
    pub noise: Option<f32>,
    /// Print the tables as JSON on stdout; all other output goes to stderr
    #[arg(long)]
    pub json: bool,
}

/// Parser of the id of a humanoid.
fn robot_parser() -> impl TypedValueParser<Value = &'static SimulatedModel> {
    let known = HUMANOIDS.iter().map(|model| PossibleValue::new(model.id).help(model.name));
    PossibleValuesParser::new(known).try_map(|id| humanoid(&id).ok_or("no such robot"))
}

/// Kind of a trial.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Kind {
    /// Single and combined velocities: mean velocity and falls
    Walk,
    /// Random velocity commands for one minute: falls
    Commands,
    /// Pushes while walking, single and repeated: falls
    Pushes,
    /// Random commands with other friction, gains, torques and dead time: falls
    Bodies,
    /// Error of odometry after three metres
    Odometry,
    /// All six kicks and the in-walk kicks: distance and direction of the ball
    Kicks,
    /// Falls to eight sides: detected before the impact, joints relaxed, recovered
    Falls,
    /// Getting up after a fall to each side
    GetUp,
    /// Getting up beside a goal post, in the goal, beside the goalkeeper
    Obstacles,
    /// Games in which the robot is pushed over and still has to score
    Comeback,
}

/// Returns an error: this program was built without `MuJoCo`.
///
/// # Errors
/// Always.
#[cfg(not(feature = "mujoco"))]
pub fn run(_: &TrialOptions) -> Result<bica_app::Outcome, bica_app::Failure> {
    let help = "install its library with `cargo xtask mujoco`, then `cargo run --release --features mujoco -- trial`";
    Err(bica_app::Failure::new("this program was built without MuJoCo", help))
}
