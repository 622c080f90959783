//! World of a robot's forward in the league's server.

use std::sync::PoisonError;

use bica::Instant;
use bica::runner::World;
use bica::visual::Scene;
use bica_field::{SSIM_2026, league_mark};
use bica_motion::joints::Joints;
use bica_motion::pose::Pose2;
use bica_motion::robot::{Command, Inertial, Sensors};
use bica_motion::senses::SenseEstimator;
use bica_player::league::Forward;
use bica_player::league::senses::{Object, Senses, Sight, View};
use bica_sim::show_field;
use glam::{Vec2, Vec3};
use serde::Serialize;

use super::client::{self, Agent, Error, Monitor, Perception, PlayMode, Seen, Server};
use super::entry::Entry;
use super::opponent::Opponent;
use super::robot::{Footballer, Standing};
use super::start::Start;

/// Duration of a cycle of the server, ms.
const CYCLE: u64 = 20;
/// Number of cycles in which the robot moves from straight joints to its standing posture.
const STANDING_UP: u32 = 100;
/// Tilt of the torso from which the robot counts as lying, rad.
const LYING: f32 = 1.0;
/// Time on the ground after which a game is lost, s: the referee then removes the robot from the field.
const LOST_AFTER: f64 = 15.0;
/// Distance of the players from the halfway line at a kick-off, and from each other, m.
const KICK_OFF: Vec2 = Vec2::new(2.5, 3.0);

/// Result of a game.
#[derive(Clone, Debug, Default, Serialize)]
pub(crate) struct LeagueGame {
    pub(crate) seed: u64,
    /// Goals of the robot's team and of the other team since the start, as counted by the server.
    pub(crate) score: [u32; 2],
    /// Time from the start to the first goal of the team, s.
    pub(crate) goal_s: Option<f64>,
    /// Time of the fall after which the robot stayed on the ground, s.
    pub(crate) fall_s: Option<f64>,
    /// Duration, s.
    pub(crate) seconds: f64,
}

/// A player in the server. Its parts end in this order: the server waits for each player.
pub(crate) struct LeagueWorld {
    robot: &'static Footballer,
    agent: Agent,
    opponent: Option<Opponent>,
    /// Monitor, kept to the end: the server may stop when a monitor leaves.
    monitor: Option<Monitor>,
    server: Option<Server>,
    team: String,
    number: u32,
    perception: Perception,
    estimator: SenseEstimator,
    body: Sensors<'static>,
    view: Option<View>,
    /// The newest view.
    #[cfg(feature = "mujoco")]
    last_view: View,
    cycles: u64,
    /// Cycle of the start, and the score at that time.
    start: (u64, [u32; 2]),
    standing: Standing,
}

impl LeagueWorld {
    /// Joins a running server, where the game begins by its rules; or starts a server, places robot and ball by the seed, and begins.
    ///
    /// # Errors
    /// If the server cannot be started or reached, or refuses the player.
    pub(crate) fn open(robot: &'static Footballer, entry: &Entry, standing: Standing) -> Result<Self, Error> {
        let server = entry.start()?;
        let address = server.as_ref().map(Server::address).or(entry.server.as_ref()).ok_or(Error::Refused)?.clone();
        let (agent, first) = Agent::join(robot.body, &address, &entry.team, entry.number)?;
        let mut world = Self {
            robot,
            agent,
            opponent: None,
            monitor: None,
            server,
            team: entry.team.clone(),
            number: entry.number,
            perception: Perception::default(),
            estimator: SenseEstimator::new(robot.body.model),
            body: Sensors::UNMEASURED,
            view: None,
            #[cfg(feature = "mujoco")]
            last_view: View::new(),
            cycles: 0,
            start: (0, [0; 2]),
            standing,
        };
        world.take(first);
        if world.server.is_some() {
            if entry.against {
                let opponent = Opponent::start(robot, address.clone(), entry)?;
                while !opponent.has_joined()? {
                    world.stand()?;
                }
                world.opponent = Some(opponent);
            }
            let mut monitor = Monitor::connect(&address)?;
            world.place(&mut monitor, entry.seed)?;
            world.monitor = Some(monitor);
        } else if !world.is_playing() {
            world.line_up()?;
        }
        world.start = (world.cycles, world.score());
        world.told(|(game, _)| *game = LeagueGame { seed: entry.seed, ..LeagueGame::default() });
        Ok(world)
    }

    /// Places ball and robot, waits until the robot stands, and begins the game.
    fn place(&mut self, monitor: &mut Monitor, seed: u64) -> Result<(), Error> {
        let Start { robot, ball } = Start::new(seed);
        monitor.place_player(self.number, robot, self.robot.body.standing_height)?;
        monitor.place_ball(ball, SSIM_2026.ball_radius())?;
        for _ in 0..STANDING_UP {
            self.stand()?;
        }
        monitor.drop_ball()
    }

    /// Moves the joints to the stand for one cycle.
    fn stand(&mut self) -> Result<(), Error> {
        self.agent.act(&self.robot.body.model.stand, &Joints::all(1.0))?;
        self.sense()
    }

    fn sense(&mut self) -> Result<(), Error> {
        let perception = self.agent.sense()?;
        self.cycles += 1;
        self.take(perception);
        Ok(())
    }

    fn take(&mut self, perception: Perception) {
        self.perception = perception;
        let sights = self.perception.sights.as_ref();
        self.view = sights.map(|sights| sights.iter().filter_map(|sight| self.sight(sight)).collect());
        #[cfg(feature = "mujoco")]
        if let Some(view) = &self.view {
            self.last_view.clone_from(view);
        }
        let Perception { angles, gyro, acceleration, .. } = self.perception;
        self.body.angles = angles;
        self.body.inertial = Inertial { gyro, acceleration, roll: 0.0, pitch: 0.0 };
        self.estimator.complete(&mut self.body, CYCLE as f32 / 1000.0);
    }

    /// Converts a sight for the robot: marks in its own field frame, and the feet of other players; `None` for other objects.
    fn sight(&self, sight: &client::Sight) -> Option<Sight> {
        let object = match &sight.what {
            Seen::Ball => Object::Ball,
            Seen::Mark(name) => {
                let Vec3 { x, y, z } = league_mark(name)?;
                let side = self.side();
                Object::Mark([side * x, side * y, z])
            }
            Seen::Player { team, number, .. } if (team, *number) == (&self.team, self.number) => return None,
            Seen::Player { part, .. } if part.ends_with("foot") => Object::Robot,
            Seen::Player { .. } => return None,
        };
        Some(Sight { object, at: vector(sight).into() })
    }

    /// Sensor values of the body.
    #[cfg(feature = "mujoco")]
    pub(crate) const fn body(&self) -> &Sensors<'static> {
        &self.body
    }

    /// The newest view.
    #[cfg(feature = "mujoco")]
    pub(crate) const fn last_view(&self) -> &View {
        &self.last_view
    }

    fn is_right(&self) -> bool {
        self.perception.game.teams[1] == self.team
    }

    /// Direction of the attacked goal along the x axis of the server: 1 or -1.
    fn side(&self) -> f32 {
        if self.is_right() { -1.0 } else { 1.0 }
    }

    /// Goals of the robot's team and of the other team.
    fn score(&self) -> [u32; 2] {
        let [left, right] = self.perception.game.score;
        if self.is_right() { [right, left] } else { [left, right] }
    }

    /// Returns whether the player may play: the ball is in play, or its own team restarts.
    fn is_playing(&self) -> bool {
        self.perception.game.mode.lets_play(usize::from(self.is_right()))
    }

    /// Time since the start, s.
    fn seconds(&self) -> f64 {
        (CYCLE * (self.cycles - self.start.0)) as f64 / 1000.0
    }

    /// Pose of the player before a kick-off, x towards the attacked goal, y in the direction that the server uses.
    fn kick_off(&self) -> Pose2 {
        let aside = f32::from(u8::try_from(self.number % 5).unwrap_or_default()) - 1.0;
        Pose2 { position: Vec2::new(-1.0, aside) * KICK_OFF, heading: 0.0 }
    }

    fn told<T>(&self, tell: impl FnOnce(&mut (LeagueGame, Option<Error>)) -> T) -> T {
        tell(&mut self.standing.lock().unwrap_or_else(PoisonError::into_inner))
    }

    fn tell(&self) {
        let (at, now, before) = (self.seconds(), self.score(), self.start.1);
        let Inertial { roll, pitch, .. } = self.body.inertial;
        let is_lying = roll.abs().max(pitch.abs()) > LYING;
        self.told(|(game, _)| {
            game.seconds = at;
            game.score = [0, 1].map(|team| now[team] - before[team]);
            game.goal_s = game.goal_s.or((game.score[0] > 0).then_some(at));
            game.fall_s = is_lying.then(|| game.fall_s.unwrap_or(at));
        });
    }

    /// Moves the player to its own place for the next kick-off.
    fn line_up(&mut self) -> Result<(), Error> {
        self.agent.place(self.kick_off(), &self.robot.body.model.stand, &Joints::all(1.0))?;
        self.sense()
    }

    /// Executes a command for one cycle and reads the new perception.
    fn act(&mut self, Command { targets, stiffness, .. }: &Command) -> Result<(), Error> {
        let before = self.perception.game.mode;
        self.agent.act(targets, stiffness)?;
        self.sense()?;
        let is_goal = self.perception.game.mode == PlayMode::Goal && before != PlayMode::Goal;
        if self.server.is_none() && is_goal {
            self.line_up()?;
        }
        Ok(())
    }
}

/// Vector from the camera to a sight, m.
fn vector(sight: &client::Sight) -> Vec3 {
    let (up, along) = sight.elevation.sin_cos();
    let (left, ahead) = sight.azimuth.sin_cos();
    sight.distance * Vec3::new(along * ahead, along * left, up)
}

impl World<Forward> for LeagueWorld {
    fn now(&self) -> Instant {
        Instant::from_millis(CYCLE * self.cycles)
    }

    fn sensors(&mut self) -> Senses<'_> {
        Senses { body: self.body, view: self.view.clone(), playing: self.is_playing() }
    }

    fn act(&mut self, command: &Command) {
        if let Err(error) = Self::act(self, command) {
            self.told(|(_, reason)| *reason = Some(error));
        }
        self.tell();
    }

    fn is_over(&self) -> bool {
        let is_own = self.server.is_some();
        self.told(|(game, error)| {
            let is_lost = game.fall_s.is_some_and(|fall| game.seconds - fall >= LOST_AFTER);
            error.is_some()
                || self.perception.game.mode == PlayMode::GameOver
                || (is_own && (is_lost || game.score != [0; 2]))
        })
    }

    fn report(&self, out: &mut dyn core::fmt::Write) -> core::fmt::Result {
        self.told(|(game, _)| write!(out, "{}", game.line()))
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        show_field(&SSIM_2026, scene);
    }
}

impl LeagueGame {
    /// Result of the game, one line.
    pub(crate) fn line(&self) -> String {
        let Self { seed, score: [ours, theirs], goal_s, fall_s, seconds } = self;
        let end = match (goal_s, fall_s) {
            (Some(at), _) => format!("goal after {at:.1} s"),
            (None, Some(at)) => format!("fell after {at:.1} s"),
            (None, None) => format!("no goal in {seconds:.0} s"),
        };
        format!("seed {seed}: {ours}:{theirs}, {end}")
    }
}
