//! Shots one after the other in one world, for monitors and recordings.

use std::fmt;
use std::time::Duration;

use bica::action::Actions;
use bica::runner::World;
use bica::visual::Scene;
use bica::{Instant, Tree};
use bica_app::Failure;
use bica_motion::robot::{Command, Sensors};
use bica_player::perception::GoalDetector;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::shot::Shot;
use glam::Vec2;

use crate::Keeper;
use crate::shots::{self, Attempt, Plan};

/// Additional time before a shot in which the goalkeeper finds the next ball.
const SEARCH: Duration = Duration::from_secs(8);

/// World in which the shots of a plan follow each other.
pub(crate) struct Series {
    world: KinematicWorld,
    plan: Plan,
    attempt: Attempt,
    /// Shots that were drawn, also those that were not possible because the robot stood where the ball begins.
    drawn: u32,
    shots: u32,
    let_in: u32,
}

impl Series {
    /// # Errors
    /// If the world refuses the first shot.
    pub(crate) fn new(plan: Plan) -> Result<Self, Failure> {
        let shot = plan.shot(plan.seed, 0);
        // The goalkeeper is not told its side: it is that of its defaults.
        let attacks = Keeper::new().get::<GoalDetector>().attacked();
        let world = shots::world(plan.seed, shot.from, Some(attacks))?;
        let attempt = Attempt::new(shot, Duration::ZERO);
        Ok(Self { world, plan, attempt, drawn: 1, shots: 0, let_in: 0 })
    }

    /// Counts the shot and puts the ball at the start of the next one that is possible.
    fn next(&mut self) {
        self.shots += 1;
        self.let_in += u32::from(self.attempt.result(self.plan.seed, &self.world).let_in);
        while !self.is_over() {
            let shot = self.plan.shot(self.plan.seed, self.drawn);
            self.drawn += 1;
            if self.world.set_ball(shot.from, Vec2::ZERO).is_ok() {
                let shot = Shot { rest: shot.rest + SEARCH, ..shot };
                self.attempt = Attempt::new(shot, bica_sim::World::now(&self.world));
                return;
            }
        }
    }
}

impl World<Keeper> for Series {
    fn now(&self) -> Instant {
        World::<Keeper>::now(&self.world)
    }

    fn sensors(&mut self) -> Sensors<'_> {
        World::<Keeper>::sensors(&mut self.world)
    }

    fn act(&mut self, command: &Command) {
        World::<Keeper>::act(&mut self.world, command);
        if !self.attempt.advance(&mut self.world).unwrap_or(false) {
            self.next();
        }
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        World::<Keeper>::actions(&mut self.world)
    }

    fn is_over(&self) -> bool {
        self.shots == self.plan.shots
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        write!(out, "{} shots, {} let in", self.shots, self.let_in)
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        World::<Keeper>::scenery(&self.world, scene);
    }

    fn truth(&self, scene: &mut dyn Scene) {
        World::<Keeper>::truth(&self.world, scene);
    }
}
