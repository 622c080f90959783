//! A game in the league's server.

use bica::runner::Runner;
use bica::{Setting, Tree};
use bica_field::SSIM_2026;
use bica_league::{Agent, Body, Error, Monitor, Server};
use bica_motion::model::RobotModel;
use bica_player_t1::behaviour::Player;
use bica_player_t1::input::RobotProfile;
use bica_player_t1::perception::{BallDetector, FallDetector, Localization};
use bica_player_t1::{Forward, Model};
use glam::Vec2;
use serde::Serialize;

use super::start::Start;
use super::world::LeagueWorld;

/// Number of the player.
const NUMBER: u32 = 1;
/// Number of cycles in which the robot gets from straight joints to its stand.
const STANDING_UP: u32 = 100;
/// Time on the ground after which a game is lost, s: the robot cannot get up.
const LOST_AFTER: f64 = 3.0;

/// Result of a game.
#[derive(Clone, Debug, Serialize)]
pub(crate) struct LeagueGame {
    pub(crate) seed: u64,
    /// Goals of the robot's team and of the other one, by the server's count.
    pub(crate) score: [u32; 2],
    /// Time from the kick-off to the goal, s.
    pub(crate) goal_s: Option<f64>,
    /// Time of the fall that ended the game, s.
    pub(crate) fall_s: Option<f64>,
    /// Duration, s.
    pub(crate) seconds: f64,
}

/// A change of the player's state.
pub(crate) struct Change {
    /// Time since the kick-off, s.
    pub(crate) at: f64,
    /// Its new state.
    pub(crate) state: &'static str,
    /// Position on the field where it believes to be, m.
    pub(crate) place: Option<Vec2>,
    /// Position of the ball relative to it, m, as far as it knows.
    pub(crate) ball: Option<Vec2>,
}

/// Plays a game until a goal, a fall, its end after `seconds`, or as long as it `goes_on`, and tells each change of the player's
/// state. The server must be new.
///
/// # Errors
/// If the connection broke.
pub(crate) fn play(
    server: &Server,
    settings: &[Setting],
    seed: u64,
    seconds: f64,
    tell: &mut dyn FnMut(&Change),
    goes_on: &dyn Fn() -> bool,
) -> Result<LeagueGame, Error> {
    let Start { robot, ball } = Start::new(seed);
    let (agent, first) = Agent::<Model>::join(server.address(), "BICA", NUMBER)?;
    let mut world = LeagueWorld::new(agent, NUMBER, first);
    let mut monitor = Monitor::connect(server.address())?;
    monitor.place_player(NUMBER, robot, Model::STANDING_HEIGHT)?;
    monitor.place_ball(ball, SSIM_2026.ball_radius())?;
    for _ in 0..STANDING_UP {
        world.hold(&Model::STAND)?;
    }
    monitor.drop_ball()?;
    let mut forward = Box::new(Forward::new());
    forward.get_mut::<RobotProfile>().set(Model::PROFILE);
    // The caller has tried them on another tree.
    _ = forward.set_params(settings);
    let began = world.seconds();
    let mut runner = Runner::new(forward, world);
    let (mut state, mut down_since, mut goal_s) = ("", None, None);
    let (mut at, mut score) = (0.0, [0; 2]);
    while goes_on() && at < seconds && goal_s.is_none() && down_since.is_none_or(|since| at - since < LOST_AFTER) {
        // Infallible.
        _ = runner.cycle();
        if let Some(error) = runner.world_mut().error() {
            return Err(error);
        }
        at = runner.world().seconds() - began;
        score = runner.world().game().score;
        goal_s = (score[0] > 0).then_some(at);
        let robot = runner.robot();
        down_since = robot.get::<FallDetector>().is_down().then(|| down_since.unwrap_or(at));
        let now = robot.state_name::<Player>().unwrap_or_default();
        if core::mem::replace(&mut state, now) != now {
            let place = robot.get::<Localization>().pose().map(|pose| pose.position);
            tell(&Change { at, state, place, ball: robot.get::<BallDetector>().position() });
        }
    }
    Ok(LeagueGame { seed, score, goal_s, fall_s: down_since, seconds: at })
}
