//! The league's server as a world of the forward on a T1.

use bica::Instant;
use bica::runner::World;
use bica_field::league_mark;
use bica_league::{Agent, Error, Game, Perception, Seen};
use bica_motion::joints::Joints;
use bica_motion::robot::{Buttons, Command, FootPressure, Inertial, Sensors};
use bica_motion::senses::SenseEstimator;
use bica_player_t1::input::{Object, Sight};
use bica_player_t1::{Forward, Model, Senses};
use glam::Vec3;

/// Duration of a cycle of the server, ms.
const CYCLE: u64 = 20;

/// A player in the server.
pub(crate) struct LeagueWorld {
    agent: Agent<Model>,
    number: u32,
    perception: Perception,
    estimator: SenseEstimator<Model>,
    sights: Option<Vec<Sight>>,
    cycles: u64,
    error: Option<Error>,
}

impl LeagueWorld {
    /// A player that has joined with this number, with its first perception.
    pub(crate) fn new(agent: Agent<Model>, number: u32, first: Perception) -> Self {
        let mut world = Self {
            agent,
            number,
            perception: Perception::default(),
            estimator: SenseEstimator::new(),
            sights: None,
            cycles: 0,
            error: None,
        };
        world.take(first);
        world
    }

    /// State of the game, as the server tells each player.
    pub(crate) const fn game(&self) -> &Game {
        &self.perception.game
    }

    /// Time since the player joined, s.
    pub(crate) const fn seconds(&self) -> f64 {
        (CYCLE * self.cycles) as f64 / 1000.0
    }

    /// Moves the joints to their targets for one cycle.
    ///
    /// # Errors
    /// If the connection broke.
    pub(crate) fn hold(&mut self, targets: &Joints) -> Result<(), Error> {
        self.move_joints(targets, &Joints::all(1.0));
        self.error.take().map_or(Ok(()), Err)
    }

    /// Takes the reason for which the world ended.
    pub(crate) const fn error(&mut self) -> Option<Error> {
        self.error.take()
    }

    fn move_joints(&mut self, targets: &Joints, stiffness: &Joints) {
        match self.agent.act(targets, stiffness).and_then(|()| self.agent.sense()) {
            Ok(perception) => self.take(perception),
            Err(error) => self.error = Some(error),
        }
        self.cycles += 1;
    }

    fn take(&mut self, perception: Perception) {
        let number = self.number;
        let sight = |sight: &bica_league::Sight| {
            let object = match &sight.what {
                Seen::Ball => Object::Ball,
                Seen::Mark(name) => Object::Mark(league_mark(name)?),
                Seen::Player { number: other, part, .. } if *other != number && part.ends_with("foot") => Object::Robot,
                Seen::Player { .. } => return None,
            };
            Some(Sight { object, at: vector(sight) })
        };
        self.sights = perception.sights.as_ref().map(|sights| sights.iter().filter_map(sight).collect());
        self.perception = perception;
    }
}

/// Vector from the camera to a sight, m.
fn vector(sight: &bica_league::Sight) -> Vec3 {
    let (up, along) = sight.elevation.sin_cos();
    let (left, ahead) = sight.azimuth.sin_cos();
    sight.distance * Vec3::new(along * ahead, along * left, up)
}

impl World<Forward> for LeagueWorld {
    fn now(&self) -> Instant {
        Instant::from_millis(CYCLE * self.cycles)
    }

    fn sensors(&mut self) -> Senses<'_> {
        let Perception { angles, gyro, acceleration, .. } = self.perception;
        let mut body = Sensors {
            angles,
            temperatures: Joints::all(f32::NAN),
            currents: Joints::all(f32::NAN),
            inertial: Inertial { gyro, acceleration, roll: 0.0, pitch: 0.0 },
            left_foot: FootPressure::default(),
            right_foot: FootPressure::default(),
            buttons: Buttons::default(),
            image: None,
        };
        self.estimator.complete(&mut body, CYCLE as f32 / 1000.0);
        Senses { body, sights: self.sights.as_deref() }
    }

    fn act(&mut self, command: &Command) {
        self.move_joints(&command.targets, &command.stiffness);
    }

    fn is_over(&self) -> bool {
        self.error.is_some()
    }
}
