//! World with the network of a player.

use std::fmt;

use bica::Instant;
use bica::action::Actions;
use bica::runner::World;
use bica::visual::Scene;
use bica_player::Forward;
use bica_player::referee::{TeamCommand, TeamForward, TeamSensors};

use super::network::PlayerNetwork;

/// World of a forward that a referee commands.
pub(super) struct RefereedWorld {
    world: Box<dyn World<Forward>>,
    network: PlayerNetwork,
}

impl RefereedWorld {
    /// Adds the network of a player to a world.
    pub(super) fn new(world: Box<dyn World<Forward>>, network: PlayerNetwork) -> Self {
        Self { world, network }
    }
}

impl World<TeamForward> for RefereedWorld {
    fn now(&self) -> Instant {
        self.world.now()
    }

    fn sensors(&mut self) -> TeamSensors<'_> {
        self.network.sensors(self.world.now().as_micros(), self.world.sensors())
    }

    fn act(&mut self, command: &TeamCommand) {
        self.world.act(&command.body);
        self.network.send(command);
    }

    fn actions(&mut self) -> Option<&mut dyn Actions> {
        self.world.actions()
    }

    fn is_over(&self) -> bool {
        self.world.is_over()
    }

    fn report(&self, out: &mut dyn fmt::Write) -> fmt::Result {
        self.world.report(out)?;
        let (sent, ignored) = (self.network.sent(), self.network.ignored());
        writeln!(out, "status messages sent: {sent}; other datagrams ignored: {ignored}")?;
        let (sent, refused) = self.network.team_counts();
        writeln!(out, "team messages sent: {sent}; other datagrams refused: {refused}")
    }

    fn scenery(&self, scene: &mut dyn Scene) {
        self.world.scenery(scene);
    }

    fn truth(&self, scene: &mut dyn Scene) {
        self.world.truth(scene);
    }
}
