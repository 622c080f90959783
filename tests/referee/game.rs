//! Match of teams of three in the kinematic world, with messages that are lost and datagrams that must be ignored.

use std::collections::VecDeque;

use bica::prelude::*;
use bica::runner::Robot;
use bica_motion::model::simulation::NAO;
use bica_motion::pose::Pose2;
use bica_motion::robot::Command;
use bica_player::perception::GoalDetector;
use bica_player::referee::packet::{Control, PlayState, Team, Version};
use bica_player::referee::{Identity, Inbox, Received, TeamCommand, TeamForward, TeamPlayer, TeamSensors};
use bica_player::team::{Heard, Role, Roles, TeamInbox, TeamMates, TeamMessage};
use bica_sim::match_field::{Entrant, MatchField};
use bica_sim::setup::{Frame, Setup};

use super::sender::Sender;

/// The first team and the second one.
pub(super) const TEAMS: [u8; 2] = [5, 23];
/// Number of players of a team.
pub(super) const PLAYERS: usize = 3;
/// Number of the goalkeeper.
const KEEPER: u8 = 1;
/// Each message with a number that this divides is lost on its way to each player.
const LOST: u32 = 7;
/// Players of a team at their side lines, as x, y, m, and heading, rad.
const STARTS: [[f32; 3]; PLAYERS] = [[-2.4, 1.9, -1.57], [-1.6, -1.9, 1.57], [-1.0, 1.9, -1.57]];
/// Robots of an idle second team.
const IDLE: [[f32; 3]; 2] = [[-2.9, 0.2, 0.0], [-1.0, 1.5, 0.0]];

/// One player and what waits for it.
pub(super) struct Player {
    pub(super) robot: Box<TeamForward>,
    pub(super) me: Identity,
    packets: Inbox,
    messages: TeamInbox,
    heard: VecDeque<Heard>,
    /// Cycles of its status messages.
    pub(super) answers: Vec<u64>,
    /// First cycle of its program.
    since: u64,
    /// Whether its program runs.
    pub(super) runs: bool,
}

impl Player {
    fn new(index: usize, field: &MatchField) -> Self {
        let mut robot = Box::new(TeamForward::new());
        robot.get_mut::<GoalDetector>().attack(field.truth(index).attacks());
        let me = Identity { team: TEAMS[index / PLAYERS], player: (index % PLAYERS) as u8 + 1 };
        let (packets, messages) = (Inbox::new(me.team), TeamInbox::new(me));
        Self { robot, me, packets, messages, heard: VecDeque::new(), answers: Vec::new(), since: 0, runs: true }
    }

    pub(super) fn role(&self) -> Role {
        self.robot.get::<Roles>().role()
    }

    pub(super) fn state(&self) -> &'static str {
        self.robot.of::<TeamPlayer>().state_name().expect("a state")
    }

    fn cycle(&mut self, field: &mut MatchField, index: usize, cycle: u64, packet: Option<Received>) -> TeamCommand {
        let (body, heard) = (field.sensors(index), self.heard.pop_front());
        let ignored = self.packets.ignored().total();
        let sensors = TeamSensors { body, me: self.me, packet, ignored, heard, refused: 0 };
        self.robot.sense(&sensors).expect("the image fits");
        self.robot.tick(Instant::from_millis((cycle - self.since) * 10));
        let command = self.robot.act();
        self.answers.extend(command.answer.map(|_| cycle));
        command
    }
}

pub(super) struct Match {
    pub(super) field: MatchField,
    pub(super) players: Vec<Player>,
    pub(super) sender: Sender,
    pub(super) cycle: u64,
    messages: u32,
}

impl Match {
    /// A match against a team that stands.
    pub(super) fn against_idle(seed: u64) -> Self {
        Self::new(seed, Version::V20, PLAYERS, &IDLE, 12_000)
    }

    /// A match of two teams, each of which may send a number of messages.
    pub(super) fn of_both(seed: u64, version: Version, budget: u16) -> Self {
        Self::new(seed, version, 2 * PLAYERS, &STARTS, budget)
    }

    fn new(seed: u64, version: Version, players: usize, second: &[[f32; 3]], budget: u16) -> Self {
        let entrant =
            |is_second| move |[x, y, heading]: &[f32; 3]| Entrant { is_second, at: Pose2::new(*x, *y, *heading) };
        let entrants: Vec<_> = STARTS.iter().map(entrant(false)).chain(second.iter().map(entrant(true))).collect();
        let setup = Setup { seed, frame: Frame::Small, ..Setup::default() };
        let field = MatchField::new(NAO, &setup, &entrants).expect("there is room");
        let is_noisy = players > PLAYERS;
        let players = (0..players).map(|index| Player::new(index, &field)).collect();
        let teams = TEAMS.map(|number| Team { number, goalkeeper: KEEPER, message_budget: budget, ..Team::default() });
        let control = Control {
            version,
            players_per_team: PLAYERS as u8,
            seconds_remaining: 600,
            kicking_team: Some(TEAMS[0]),
            teams,
            ..Control::default()
        };
        Self { field, players, sender: Sender::new(control, is_noisy), cycle: 0, messages: 0 }
    }

    pub(super) fn cycle(&mut self) {
        let (mut commands, mut sent) = (Vec::new(), Vec::new());
        for (index, player) in self.players.iter_mut().enumerate() {
            let packet = self.sender.receive(&mut player.packets);
            if player.runs {
                let command = player.cycle(&mut self.field, index, self.cycle, packet);
                sent.extend(command.message);
                commands.push(command.body);
            } else {
                commands.push(Command::new(NAO.stand, 1.0));
            }
        }
        commands.resize(self.field.robots(), Command::new(NAO.stand, 1.0));
        self.field.act(&commands);
        self.cycle += 1;
        self.sender.advance();
        for message in &sent {
            self.send(message);
        }
    }

    /// Passes a message to the other players; some do not receive it.
    fn send(&mut self, message: &TeamMessage) {
        let (bytes, at_us) = (message.encode(), self.cycle * 10_000);
        assert!(bytes.len() <= 512);
        let budget = &mut self.sender.team(message.from.team).message_budget;
        *budget = budget.checked_sub(1).expect("the budget is kept");
        for player in self.players.iter_mut().filter(|player| player.runs) {
            self.messages += 1;
            let message = player.messages.take(&bytes, at_us).filter(|_| !self.messages.is_multiple_of(LOST));
            player.heard.extend(message.map(|message| Heard { message, at_us }));
        }
    }

    pub(super) fn run(&mut self, seconds: u64) {
        (0..100 * seconds).for_each(|_| self.cycle());
    }

    pub(super) fn pose(&self, player: usize) -> Pose2 {
        self.field.truth(player).robot()
    }

    /// Number of strikers of the first team.
    pub(super) fn strikers(&self) -> usize {
        let first = self.players.iter().take(PLAYERS);
        first.filter(|player| player.runs && player.role() == Role::Striker).count()
    }

    /// Plays the state ready, with the kick-off of a team; the players walk to their places.
    pub(super) fn ready(&mut self, kicking: u8) {
        let control = &mut self.sender.control;
        (control.state, control.kicking_team, control.secondary_seconds) = (PlayState::Ready, Some(kicking), 45);
        self.run(44);
        for (index, player) in self.players.iter().enumerate() {
            let at = self.pose(index).position;
            assert!(at.x < 0.0, "player {} of {} at {at}", player.me.player, player.me.team);
        }
    }

    /// Begins to play, after the players have walked to their places.
    pub(super) fn kick_off(&mut self) {
        self.ready(TEAMS[0]);
        self.sender.control.state = PlayState::Set;
        self.run(5);
        (self.sender.control.state, self.sender.control.secondary_seconds) = (PlayState::Playing, 0);
    }

    /// Seconds until there is one striker, and all running players that are not penalized are heard by the others and have a part.
    pub(super) fn settles_within(&mut self, limit: u64) -> Option<f32> {
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
    pub(super) fn restart(&mut self, index: usize) {
        self.players[index] = Player { since: self.cycle, ..Player::new(index, &self.field) };
    }
}
