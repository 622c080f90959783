//! Play as a team, with made-up perception.

mod comm;
mod message;
mod model;
mod play;

use bica::prelude::*;
use bica::runner::harness::Harness;
use bica_player::input::GameState;
use bica_player::referee::packet::{Control, PlayState, Team};
use bica_player::referee::{GameController, Identity, Received, Whistle};
use bica_player::roles::{Ball, Ears, Falls, Whereabouts};
use bica_player::team::{Heard, Roles, TeamBall, TeamComm, TeamMates, TeamMessage};

use super::Scene;

/// Number of the team.
const TEAM: u8 = 23;

activation_tree! {
    struct Mind {
        root: TeamComm,
        cycle_hz: 100,
        roles: { Ball: Scene, Falls: Scene, Whereabouts: Scene, Ears: Whistle },
        components: [TeamComm, Roles, TeamBall, TeamMates, GameController, GameState, Whistle, Scene],
    }
}

/// Packet of a game of three, without a goalkeeper.
fn playing(budget: u16) -> Control {
    let teams = [5, TEAM].map(|number| Team { number, message_budget: budget, ..Team::default() });
    Control { players_per_team: 3, seconds_remaining: 600, state: PlayState::Playing, teams, ..Control::default() }
}

/// Gives a packet to a player.
fn packet<T: Tree + Has<GameController>>(test: &mut Harness<T>, player: u8, control: Control, at_us: u64) {
    let received = Received { control, source: [10, 0, 1, 1], at_us };
    test.tree_mut().get_mut::<GameController>().receive(Identity { team: TEAM, player }, Some(&received), 0);
}

/// Gives a message to a player.
fn hear<T: Tree + Has<TeamMates>>(test: &mut Harness<T>, message: TeamMessage) {
    test.tree_mut().get_mut::<TeamMates>().receive(Some(&Heard { message, at_us: 0 }), 0);
}
