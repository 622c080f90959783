//! Short half of a team of three in the kinematic world, against a team that stands.

use std::collections::VecDeque;

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_player::perception::GoalDetector;
use bica_player::referee::packet::{Control, Penalty, PlayState, Team};
use bica_player::referee::{Identity, Received, TeamForward, TeamSensors};
use bica_player::team::{Heard, Role, Roles, TeamInbox, TeamMates, TeamMessage};
use bica_sim::kinematic::{Entrant, MatchField};
use bica_sim::referee::Event;
use bica_sim::setup::{Frame, Setup};

const TEAM: u8 = 5;
/// Number of players of the team that plays.
const PLAYERS: usize = 3;
/// Number of the goalkeeper.
const KEEPER: u8 = 1;
/// Cycles between two packets.
const PERIOD: u64 = 50;
/// Each message with a number that this divides is lost on its way to each player.
const LOST: u32 = 7;
/// Cycles of the play.
const CYCLES: u32 = 6000;

/// One player and what waits for it.
struct Player {
    robot: Box<TeamForward>,
    me: Identity,
    inbox: TeamInbox,
    heard: VecDeque<Heard>,
    /// First cycle of its program.
    since: u64,
    /// Whether its program runs.
    runs: bool,
}

impl Player {
    fn new(number: u8, field: &MatchField) -> Self {
        let mut robot = Box::new(TeamForward::new());
        robot.get_mut::<GoalDetector>().attack(field.truth(usize::from(number) - 1).attacks());
        let me = Identity { team: TEAM, player: number };
        Self { robot, me, inbox: TeamInbox::new(me), heard: VecDeque::new(), since: 0, runs: true }
    }

    fn role(&self) -> Role {
        self.robot.get::<Roles>().role()
    }
}

struct Match {
    field: MatchField,
    players: Vec<Player>,
    control: Control,
    cycle: u64,
    messages: u32,
    budget: u16,
}

impl Match {
    fn new(seed: u64) -> Self {
        let start = |x: f32, y: f32, heading| Entrant { is_second: false, at: Pose2::new(x, y, heading) };
        let idle = |x: f32, y: f32| Entrant { is_second: true, at: Pose2::new(x, y, 0.0) };
        let entrants = [
            start(-2.4, 1.9, -1.57),
            start(-1.6, -1.9, 1.57),
            start(-1.0, 1.9, -1.57),
            idle(-2.9, 0.2),
            idle(-1.0, 1.5),
        ];
        let setup = Setup { seed, frame: Frame::Small, ..Setup::default() };
        let field = MatchField::new(NAO, &setup, &entrants).expect("there is room");
        let players = (1..=PLAYERS as u8).map(|number| Player::new(number, &field)).collect();
        let control =
            Control { players_per_team: 3, seconds_remaining: 600, kicking_team: Some(TEAM), ..Control::default() };
        Self { field, players, control, cycle: 0, messages: 0, budget: 12_000 }
    }

    fn packet(&mut self) -> Option<Received> {
        if !self.cycle.is_multiple_of(PERIOD) {
            return None;
        }
        self.control.number = self.control.number.wrapping_add(1);
        self.control.teams = [23, TEAM].map(|number| Team {
            number,
            goalkeeper: KEEPER,
            message_budget: self.budget,
            ..self.control.teams[usize::from(number == TEAM)]
        });
        Some(Received { control: self.control, source: [127, 0, 0, 1], at_us: self.cycle * 10_000 })
    }

    fn cycle(&mut self) {
        let packet = self.packet();
        let (mut commands, mut sent) = (Vec::new(), Vec::new());
        for (index, player) in self.players.iter_mut().enumerate() {
            if !player.runs {
                commands.push(Command::new(NAO.stand, 1.0));
                continue;
            }
            let now = Instant::from_millis((self.cycle - player.since) * 10);
            let (body, heard) = (self.field.sensors(index), player.heard.pop_front());
            let sensors = TeamSensors { body, me: player.me, packet, ignored: 0, heard, refused: 0 };
            player.robot.sense(&sensors).expect("the image fits");
            player.robot.tick(now);
            let command = player.robot.act();
            commands.push(command.body);
            sent.extend(command.message);
        }
        commands.resize(self.field.robots(), Command::new(NAO.stand, 1.0));
        self.field.act(&commands);
        self.cycle += 1;
        for message in &sent {
            self.send(message);
        }
    }

    /// Passes a message to the other players; some do not receive it.
    fn send(&mut self, message: &TeamMessage) {
        let (bytes, at_us) = (message.encode(), self.cycle * 10_000);
        self.budget = self.budget.checked_sub(1).expect("the budget is kept");
        for player in self.players.iter_mut().filter(|player| player.runs) {
            self.messages += 1;
            let message = player.inbox.take(&bytes, at_us).filter(|_| !self.messages.is_multiple_of(LOST));
            player.heard.extend(message.map(|message| Heard { message, at_us }));
        }
    }

    fn run(&mut self, seconds: u64) {
        (0..100 * seconds).for_each(|_| self.cycle());
    }

    fn strikers(&self) -> usize {
        self.players.iter().filter(|player| player.runs && player.role() == Role::Striker).count()
    }

    /// Begins to play, after the players have walked to their places.
    fn kick_off(&mut self) {
        (self.control.state, self.control.secondary_seconds) = (PlayState::Ready, 45);
        self.run(44);
        for index in 0..PLAYERS {
            let at = self.field.truth(index).robot().position;
            assert!(at.x < 0.0, "player {} at {at}", index + 1);
        }
        self.control.state = PlayState::Set;
        self.run(5);
        (self.control.state, self.control.secondary_seconds) = (PlayState::Playing, 0);
    }

    /// Seconds until there is one striker, and all running players that are not penalized are heard by the others and have a part.
    fn settles_within(&mut self, limit: u64) -> Option<f32> {
        let running = self.players.iter().filter(|player| player.runs).count() as u32;
        let settled = |player: &Player| {
            !player.runs || player.role() != Role::Absent && player.robot.get::<TeamMates>().count() + 1 == running
        };
        (0..100 * limit).find_map(|cycle| {
            self.cycle();
            let is_settled = self.strikers() == 1 && self.players.iter().all(settled);
            is_settled.then_some(cycle as f32 / 100.0)
        })
    }

    /// Starts the program of a player anew where its robot is.
    fn restart(&mut self, index: usize) {
        let since = self.cycle;
        self.players[index] = Player { since, ..Player::new(self.players[index].me.player, &self.field) };
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_team_of_three_plays_with_one_striker() {
    let mut game = Match::new(4);
    game.kick_off();
    let (mut one, mut keeper_moved) = (0, 0.0_f32);
    let goal = game.field.truth(0).robot().position;
    let mut out = None;
    for cycle in 0..CYCLES {
        // The striker is penalized, and let in again.
        if cycle == CYCLES / 3 {
            out = game.players.iter().position(|player| player.role() == Role::Striker);
        }
        let is_out = (CYCLES / 3..CYCLES / 2).contains(&cycle);
        if let Some(player) = out {
            game.control.teams[1].players[player].penalty = if is_out { Penalty::Pushing } else { Penalty::None };
        }
        game.cycle();
        one += u32::from(game.strikers() == 1);
        keeper_moved = keeper_moved.max(game.field.truth(0).robot().position.distance(goal));
    }
    assert!(out.is_some());
    let share = one as f32 / CYCLES as f32;
    let is_kick = |event: &Event| matches!(event, Event::Kick { .. });
    let kicks: usize = (0..PLAYERS).map(|index| game.field.truth(index).count(is_kick)).sum();
    assert!(share >= 0.95, "{share} of the time with one striker");
    assert!(kicks > 0 && game.field.score()[1] == 0);
    assert_eq!(game.players[0].role(), Role::Goalkeeper);
    assert!(keeper_moved < 1.5, "the goalkeeper has left its goal by {keeper_moved} m");
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_killed_players_return_within_ten_seconds() {
    let mut game = Match::new(6);
    game.kick_off();
    game.run(5);
    for role in [Role::Striker, Role::Goalkeeper, Role::Supporter, Role::Defender] {
        let Some(killed) = game.players.iter().position(|player| player.role() == role) else { continue };
        game.players[killed].runs = false;
        let without = game.settles_within(10);
        assert!(without.is_some(), "the others have no striker without the {role:?}");
        game.run(5);
        assert_eq!(game.strikers(), 1, "without the {role:?}");
        game.restart(killed);
        let after = game.settles_within(10);
        assert!(after.is_some(), "the {role:?} has no part");
        game.run(2);
    }
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_players_join_and_leave_a_match() {
    let mut game = Match::new(7);
    game.control.teams[1].players[2].penalty = Penalty::Substitute;
    game.kick_off();
    game.run(5);
    assert_eq!((game.strikers(), game.players[2].role()), (1, Role::Absent), "player 3 is a substitute");
    game.control.teams[1].players[2].penalty = Penalty::None;
    assert!(game.settles_within(10).is_some(), "player 3 has no part");
    game.control.teams[1].players[1].penalty = Penalty::Substitute;
    game.run(3);
    assert_eq!((game.players[1].role(), game.players[2].role()), (Role::Absent, Role::Striker));
}
