//! The loop around a game.

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::robot::Command;
use bica_player::Forward;
use bica_player::perception::GoalDetector;
use bica_sim::World;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::Setup;

/// A forward in a world.
pub(crate) struct Game {
    pub(crate) world: KinematicWorld,
    pub(crate) robot: Box<Forward>,
}

impl Game {
    pub(crate) fn new(setup: &Setup) -> Self {
        let world = KinematicWorld::new(setup).expect("the setup is sound");
        let mut robot = Box::new(Forward::new());
        robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
        Self { world, robot }
    }

    pub(crate) fn now(&self) -> Instant {
        Instant::from_micros(self.world.now().as_micros() as u64)
    }

    /// One cycle: sense, think with a probe, act.
    pub(crate) fn cycle<P: Probe>(&mut self, probe: &mut P) -> Command {
        let now = self.now();
        self.robot.sense(&self.world.sensors()).expect("the eye is large enough");
        self.robot.tick_with(now, probe);
        let command = self.robot.act();
        self.world.act(&command);
        command
    }
}
