//! Short half in the kinematic world: a referee commands one robot in simulated time.

use bica::prelude::*;
use bica::runner::World;
use bica::runner::harness::{Harness, InWorld};
use bica_motion::model::simulation::NAO;
use bica_motion::pose::{Pose2, wrap};
use bica_player::perception::GoalDetector;
use bica_player::referee::packet::{Control, Penalty, PlayState, Team, Version};
use bica_player::referee::{
    GameController, Identity, Inbox, Received, TeamCommand, TeamForward, TeamPlayer, TeamSensors,
};
use bica_sim::World as SimulatedWorld;
use bica_sim::kinematic::KinematicWorld;
use bica_sim::setup::{Frame, Setup, Start};
use glam::Vec2;

use super::sender::{SOURCE, Sender};

const ME: Identity = Identity { team: 23, player: 2 };

/// Kinematic world with a `GameController`, whose datagrams pass through the inbox of a player.
struct Refereed {
    world: KinematicWorld,
    sender: Sender,
    inbox: Inbox,
    packet: Option<Received>,
    /// Times of the status messages, ms.
    answers: Vec<u64>,
}

impl Refereed {
    fn now_ms(&self) -> u64 {
        SimulatedWorld::now(&self.world).as_millis() as u64
    }
}

impl World<TeamForward> for Refereed {
    fn now(&self) -> Instant {
        Instant::from_millis(self.now_ms())
    }

    fn sensors(&mut self) -> TeamSensors<'_> {
        let (packet, ignored) = (self.packet, self.inbox.ignored().total());
        TeamSensors { body: SimulatedWorld::sensors(&mut self.world), me: ME, packet, ignored, heard: None, refused: 0 }
    }

    fn act(&mut self, command: &TeamCommand) {
        SimulatedWorld::act(&mut self.world, &command.body);
        if let Some(answer) = command.answer {
            assert_eq!((answer.to, answer.status.team, answer.status.player), (SOURCE, ME.team, ME.player));
            self.answers.push(self.now_ms());
        }
        self.sender.advance();
        self.packet = self.sender.receive(&mut self.inbox);
    }
}

type Test = Harness<TeamForward, InWorld<Refereed>>;

/// Returns a robot in a world.
fn start(setup: &Setup, version: Version) -> Test {
    let world = KinematicWorld::new(NAO, setup).expect("the setup is valid");
    let mut robot = Box::new(TeamForward::new());
    robot.get_mut::<GoalDetector>().attack(world.referee().attacks());
    let teams = [5, 23].map(|number| Team { number, goalkeeper: 1, ..Team::default() });
    // The numbers of the packets wrap after some seconds.
    let control = Control { version, number: 240, teams, ..Control::default() };
    let sender = Sender::new(control, true);
    let world = Refereed { world, sender, inbox: Inbox::new(ME.team), packet: None, answers: Vec::new() };
    Harness::of_box(robot).in_world(world)
}

fn pose(test: &Test) -> Pose2 {
    test.world().world.referee().robot()
}

fn change(test: &mut Test, change: impl FnOnce(&mut Control)) {
    change(&mut test.world_mut().sender.control);
}

/// Checks that the robot reaches a state and stands from 2.5 s after that.
fn stands(test: &mut Test, state: &str) {
    test.reaches::<TeamPlayer>(state, Duration::from_secs(2));
    test.run_for(Duration::from_millis(2500));
    let before = pose(test);
    for _ in 0..8 {
        test.run_for(Duration::from_millis(500));
        let now = pose(test);
        assert!(now.position.distance(before.position) < 0.05, "{state}: {now:?}");
        assert!(wrap(now.heading - before.heading).abs() < 0.25, "{state}: {now:?}");
        assert_eq!(test.state::<TeamPlayer>(), Some(state));
    }
}

/// Checks that the robot walks.
fn moves(test: &mut Test) {
    let before = pose(test);
    test.until("it moves", Duration::from_secs(30), |test| {
        let now = pose(test);
        now.position.distance(before.position) > 0.1 || wrap(now.heading - before.heading).abs() > 0.5
    });
}

/// Starts the state ready, and checks that the robot walks to its place within 45 s; returns the place.
fn ready(test: &mut Test, kicking: u8) -> Vec2 {
    change(test, |control| {
        (control.state, control.stopped, control.kicking_team) = (PlayState::Ready, false, Some(kicking));
        control.secondary_seconds = 45;
    });
    test.reaches::<TeamPlayer>("ready", Duration::from_secs(2));
    test.run_for(Duration::from_secs(43));
    let place = test.tree().get::<GameController>().place().expect("a place");
    let at = pose(test);
    assert!(at.position.distance(place.position) < 0.35, "{at:?} is not at {place:?}");
    assert!(wrap(at.heading).abs() < 0.5, "{at:?} does not face the other goal");
    assert!(at.position.x < 0.0);
    at.position
}

fn half(version: Version) {
    // The robot starts at the side line of its own half.
    let at = Start { robot: Pose2::new(-1.6, -1.9, 1.57), ball: Vec2::ZERO };
    let setup = Setup { seed: 3, frame: Frame::Small, goalkeeper: false, start: Some(at), ..Setup::default() };
    let mut test = start(&setup, version);
    stands(&mut test, "initial");
    let outside = ready(&mut test, 5).length();
    assert!(outside > 0.7, "{outside} m from the centre");
    change(&mut test, |control| control.state = PlayState::Set);
    stands(&mut test, "set");
    change(&mut test, |control| (control.state, control.secondary_seconds) = (PlayState::Playing, 10));
    stands(&mut test, "wait");
    change(&mut test, |control| control.secondary_seconds = 0);
    moves(&mut test);
    change(&mut test, |control| control.stopped = true);
    stands(&mut test, "stopped");
    change(&mut test, |control| control.stopped = false);
    moves(&mut test);
    test.world_mut().sender.team(ME.team).players[1].penalty = Penalty::IllegalPositioning;
    stands(&mut test, "penalized");
    let side_line = Pose2::new(-1.0, 1.9, -1.57);
    test.world_mut().world.put_robot(side_line).expect("a free place");
    test.run_for(Duration::from_secs(1));
    test.world_mut().sender.team(ME.team).players[1].penalty = Penalty::None;
    test.reaches::<TeamPlayer>("playing", Duration::from_secs(12));
    moves(&mut test);
    ready(&mut test, 23);
    change(&mut test, |control| control.state = PlayState::Finished);
    stands(&mut test, "finished");
    let Refereed { answers, world, .. } = test.world();
    assert!(answers.windows(2).all(|pair| (500..=2000).contains(&(pair[1] - pair[0]))), "{answers:?}");
    let last = answers.last().expect("messages");
    assert!(answers[0] < 1500 && SimulatedWorld::now(world).as_millis() as u64 - last < 2000);
    let game = test.tree().get::<GameController>();
    assert!(game.late() > 100 && game.other_source() > 100 && game.ignored() > 1000);
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_half_is_played_by_version_nineteen() {
    half(Version::V19);
}

#[test]
fn half_is_played_by_version_twenty() {
    half(Version::V20);
}

#[test]
#[ignore = "slow: `cargo xtask ci` runs it"]
fn slow_place_is_reached_from_ten_random_starts() {
    for seed in 0..10 {
        let setup = Setup { seed, frame: Frame::Small, robots: 2, ..Setup::default() };
        let mut test = start(&setup, Version::V20);
        let outside = ready(&mut test, 5).length();
        assert!(outside > 0.7, "seed {seed}: {outside} m from the centre");
        assert_eq!(test.world().world.referee().falls(), 0, "seed {seed}");
    }
}
